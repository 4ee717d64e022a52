#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/results/diagnostic_text.hpp>
#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/surface_list.hpp>
#include <leadscrew/surfaces/surface_text.hpp>

namespace leadscrew::results {

namespace {

using exchange::Face;
using exchange::Faces;

/// Codes of refusals, which come as text from another program, as diagnostics have them.
constexpr std::array<std::string_view, 6> refusal_codes = {"face-trimmed", "face-degree", "face-inexact",
                                                           "face-size",    "face-normal", "face-net"};

std::string_view code_of(const exchange::Refusal& refusal) {
  const auto found = std::ranges::find(refusal_codes, refusal.code);
  return found != refusal_codes.end() ? *found : std::string_view("face-net");
}

std::string pair_of(const Face& face, auto (*value)(const surfaces::SurfaceForm&)) {
  if (!face.form) return "-";
  const auto both = value(*face.form);
  return fmt::format("{} x {}", both[0], both[1]);
}

Json both_of(const Face& face, auto (*value)(const surfaces::SurfaceForm&)) {
  if (!face.form) return {};
  const auto both = value(*face.form);
  return Json::list({both[0], both[1]});
}

std::array<int, 2> degrees(const surfaces::SurfaceForm& form) {
  return form.degree;
}
std::array<std::size_t, 2> counts(const surfaces::SurfaceForm& form) {
  return form.count;
}

std::string size_of(const Face& face) {
  if (!face.area) return "-";
  return fmt::format("{:.6g} x {:.6g} x {:.6g}", face.high[0] - face.low[0], face.high[1] - face.low[1],
                     face.high[2] - face.low[2]);
}

std::string remark_of(const Face& face) {
  if (face.refusal) return face.refusal->why;
  std::string remark;
  if (face.deviation) remark = fmt::format("approximated within {:.2g} mm", *face.deviation);
  if (face.is_reversed) remark += remark.empty() ? "u and v exchanged" : "; u and v exchanged";
  return remark;
}

std::string row(std::string_view number, std::string_view type, std::string_view degree, std::string_view points,
                std::string_view area, std::string_view size, std::string_view remark) {
  std::string line = fmt::format("  {:>5}  {:<10}  {:<6}  {:<9}  {:>12}  {:<28}  {}", number, type, degree, points,
                                 area, size, remark);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

Json json_of(const Face& face) {
  const auto corner = [&](const surfaces::Vector& at) {
    return face.area ? Json::list({at[0], at[1], at[2]}) : Json();
  };
  Json refusal;
  if (face.refusal) refusal = Json::object({{"code", code_of(*face.refusal)}, {"why", face.refusal->why}});
  return Json::object({{"number", face.number},
                       {"type", face.type},
                       {"degree", both_of(face, degrees)},
                       {"points", both_of(face, counts)},
                       {"area_mm2", face.area},
                       {"low_mm", corner(face.low)},
                       {"high_mm", corner(face.high)},
                       {"exchanged", face.is_reversed},
                       {"deviation_mm", face.deviation},
                       {"refusal", std::move(refusal)}});
}

/// Comments end with their parenthesis or line, and a ; begins one.
std::string comment_text(std::string text) {
  text = printable(text);
  std::ranges::replace_if(text, [](char c) { return c == '(' || c == ')' || c == ';' || c == '%'; }, '_');
  return text;
}

}  // namespace

std::string surfaces_text(const std::string& file, const Faces& faces, const Style& style) {
  const auto able = std::ranges::count_if(faces.faces, [](const Face& face) { return !face.refusal; });
  std::string text = style(Tone::strong, printable(file)) + ": " + faces.format;
  if (!faces.length_unit.empty()) text += " in " + printable(faces.length_unit);
  text += fmt::format(", {} {}, {} of which can be machined\n", faces.faces.size(),
                      faces.faces.size() == 1 ? "face" : "faces", able);
  text += style(Tone::faint, row("face", "type", "degree", "points", "area mm2", "size mm", ""));
  for (const Face& face : faces.faces) {
    const std::string line =
        row(std::to_string(face.number), printable(face.type), pair_of(face, degrees), pair_of(face, counts),
            face.area ? fmt::format("{:.8g}", *face.area) : "-", size_of(face), printable(remark_of(face)));
    text += face.refusal ? style(Tone::faint, line) : line;
  }
  return text;
}

std::string surfaces_json(const std::string& file, const Faces* faces, const std::vector<std::size_t>& written,
                          const Diagnostics& diagnostics) {
  Json list = Json::list();
  if (faces != nullptr) {
    for (const Face& face : faces->faces) list.push_back(json_of(face));
  }
  const auto text_or_null = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
  return Json::object({{"schema", surfaces_schema},
                       {"file", file},
                       {"format", faces != nullptr ? Json(faces->format) : Json()},
                       {"unit", faces != nullptr ? text_or_null(faces->length_unit) : Json()},
                       {"faces", std::move(list)},
                       {"written", written},
                       {"diagnostics", json_of_diagnostics(diagnostics)}})
             .written() +
         "\n";
}

std::string surface_blocks(const std::string& file, const Faces& faces, const std::vector<std::size_t>& numbers) {
  std::string text = "(" + comment_text(file) + ")\nG21\n";
  for (const Face& face : faces.faces) {
    if (face.refusal || !face.form) continue;
    if (!numbers.empty() && std::ranges::find(numbers, face.number) == numbers.end()) continue;
    const std::string remark = remark_of(face);
    text += fmt::format("(face {}, {}{})\n", face.number, comment_text(face.type), remark.empty() ? "" : ", " + remark);
    text += surfaces::definition_text(*face.form, static_cast<int>(face.number));
  }
  return text;
}

base::Diagnostic refusal_of(const std::string& file, const Face& face, base::Severity severity) {
  base::Diagnostic diagnostic = base::problem(
      code_of(*face.refusal), fmt::format("face {} {}", face.number, face.refusal->why), face.refusal->hint);
  diagnostic.severity = severity;
  diagnostic.place.file = file;
  return diagnostic;
}

}  // namespace leadscrew::results
