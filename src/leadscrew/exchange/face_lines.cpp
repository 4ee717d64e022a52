#include <leadscrew/exchange/face_lines.hpp>

namespace leadscrew::exchange {

namespace {

using json::Json;
using surfaces::SurfaceForm;

std::string line_text(const Json& value) {
  return value.written_in_line() + "\n";
}

Json json_of(const surfaces::Vector& vector) {
  return Json::list({vector[0], vector[1], vector[2]});
}

void add_form(Json& face, const SurfaceForm& form) {
  face["degree"] = Json::list({form.degree[0], form.degree[1]});
  face["points"] = Json::list({form.count[0], form.count[1]});
  face["knots"] = Json::list({form.knots[0], form.knots[1]});
  Json net = Json::list();
  for (const surfaces::NetPoint& point : form.net) {
    for (const double x : point.position) net.push_back(x);
    net.push_back(point.weight);
  }
  face["net"] = std::move(net);
}

std::string text_in(const Json& object, std::string_view key) {
  const Json* value = object.find(key);
  return value != nullptr && value->text() != nullptr ? *value->text() : std::string();
}

std::optional<double> number_in(const Json& object, std::string_view key) {
  const Json* value = object.find(key);
  return value != nullptr ? value->number() : std::nullopt;
}

/// Empty where one is no number.
std::optional<std::vector<double>> numbers_of(const Json* list) {
  if (list == nullptr || list->values() == nullptr) return std::nullopt;
  std::vector<double> numbers;
  for (const Json& value : *list->values()) {
    const auto number = value.number();
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<surfaces::Vector> vector_in(const Json& object, std::string_view key) {
  const auto numbers = numbers_of(object.find(key));
  if (!numbers || numbers->size() != 3) return std::nullopt;
  return surfaces::Vector{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

std::optional<Refusal> refusal_in(const Json& object, std::string_view key) {
  const Json* value = object.find(key);
  if (value == nullptr || value->members() == nullptr) return std::nullopt;
  return Refusal{text_in(*value, "code"), text_in(*value, "why"), text_in(*value, "hint")};
}

/// Not one with as many numbers as it says; any other fault is found by fault_of().
std::optional<SurfaceForm> form_of(const Json& face) {
  const auto degree = numbers_of(face.find("degree")), points = numbers_of(face.find("points")),
             net = numbers_of(face.find("net"));
  const Json* knots = face.find("knots");
  const auto* lists = knots != nullptr ? knots->values() : nullptr;
  if (!degree || !points || !net || lists == nullptr) return std::nullopt;
  if (degree->size() != 2 || points->size() != 2 || lists->size() != 2 || net->size() % 4 != 0) return std::nullopt;
  SurfaceForm form;
  for (std::size_t d = 0; d < 2; ++d) {
    const auto numbers = numbers_of(&(*lists)[d]);
    const double p = (*degree)[d], n = (*points)[d];
    if (!numbers || !(p >= 1 && p <= 100) || !(n >= 2 && n <= 1e9)) return std::nullopt;
    form.degree[d] = static_cast<int>(p);
    form.count[d] = static_cast<std::size_t>(n);
    form.knots[d] = *numbers;
  }
  for (std::size_t i = 0; i < net->size(); i += 4) {
    form.net.push_back({{(*net)[i], (*net)[i + 1], (*net)[i + 2]}, (*net)[i + 3]});
  }
  return form;
}

std::optional<Face> face_of(const Json& object) {
  Face face;
  const auto number = number_in(object, "number");
  const auto low = vector_in(object, "low"), high = vector_in(object, "high");
  if (!number || !(*number >= 1 && *number <= 1e9) || !low || !high) return std::nullopt;
  face.number = static_cast<std::size_t>(*number);
  face.type = text_in(object, "type");
  const Json* reversed = object.find("reversed");
  face.is_reversed = reversed != nullptr && reversed->written_in_line() == "true";
  face.deviation = number_in(object, "deviation");
  face.area = number_in(object, "area");
  face.low = *low;
  face.high = *high;
  face.refusal = refusal_in(object, "refusal");
  face.form = form_of(object);
  if (!face.form && !face.refusal) return std::nullopt;
  return face;
}

}  // namespace

std::string line_of_header(const std::string& format, const std::string& unit) {
  return line_text(Json::object({{"format", format}, {"unit", unit}}));
}

std::string line_of(const Face& face) {
  Json object = Json::object({{"number", face.number},
                              {"type", face.type},
                              {"reversed", face.is_reversed},
                              {"deviation", face.deviation},
                              {"area", face.area},
                              {"low", json_of(face.low)},
                              {"high", json_of(face.high)}});
  if (face.form) add_form(object, *face.form);
  if (face.refusal) {
    object["refusal"] =
        Json::object({{"code", face.refusal->code}, {"why", face.refusal->why}, {"hint", face.refusal->hint}});
  }
  return line_text(Json::object({{"face", std::move(object)}}));
}

std::string line_of_end() {
  return line_text(Json::object({{"end", true}}));
}

std::string line_of_problem(std::string_view code, const std::string& message, const std::string& hint) {
  return line_text(Json::object({{"problem", Json::object({{"code", code}, {"why", message}, {"hint", hint}})}}));
}

bool FaceLines::take(std::string_view line) {
  const auto value = Json::parse(line);
  if (!value || value->members() == nullptr || ended_ || problem_) return false;
  if (auto problem = refusal_in(*value, "problem")) {
    problem_ = std::move(problem);
    return true;
  }
  if (!has_header_) {
    faces.format = text_in(*value, "format");
    faces.length_unit = text_in(*value, "unit");
    has_header_ = !faces.format.empty();
    return has_header_;
  }
  if (value->find("end") != nullptr) return ended_ = true;
  const Json* object = value->find("face");
  if (object == nullptr) return false;
  auto face = face_of(*object);
  if (face) faces.faces.push_back(std::move(*face));
  return face.has_value();
}

}  // namespace leadscrew::exchange
