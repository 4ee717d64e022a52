#include <algorithm>
#include <leadscrew/json/json.hpp>
#include <limits>
#include <nlohmann/json.hpp>

namespace leadscrew::json {

namespace {

using Written = nlohmann::ordered_json;

constexpr int deepest = 64;

struct Writer {
  Written operator()(const std::vector<Json>& values) const {
    Written list = Written::array();
    for (const Json& value : values) list.push_back(value.visit(*this));
    return list;
  }
  Written operator()(const std::vector<Json::Member>& members) const {
    Written object = Written::object();
    for (const auto& [key, value] : members) object.emplace(key, value.visit(*this));
    return object;
  }
  Written operator()(const auto& value) const { return Written(value); }
};

std::optional<Json> json_of(const Written& read, int depth) {
  if (depth > deepest) return std::nullopt;
  switch (read.type()) {
    case Written::value_t::boolean:
      return Json(read.get<bool>());
    case Written::value_t::number_integer:
      return Json(read.get<std::int64_t>());
    case Written::value_t::number_unsigned:
      return Json(read.get<std::uint64_t>());
    case Written::value_t::number_float:
      return Json(read.get<double>());
    case Written::value_t::string:
      return Json(read.get<std::string>());
    case Written::value_t::array: {
      Json list = Json::list();
      for (const Written& value : read) {
        auto taken = json_of(value, depth + 1);
        if (!taken) return std::nullopt;
        list.push_back(std::move(*taken));
      }
      return list;
    }
    case Written::value_t::object: {
      Json object = Json::object();
      for (const auto& [key, value] : read.items()) {
        auto taken = json_of(value, depth + 1);
        if (!taken) return std::nullopt;
        object[key] = std::move(*taken);
      }
      return object;
    }
    default:
      return Json();
  }
}

}  // namespace

Json Json::list(std::initializer_list<Json> values) {
  Json list;
  list.value_ = List(values);
  return list;
}

Json Json::object(std::initializer_list<Member> members) {
  Json object;
  object.value_ = Object(members);
  return object;
}

Json& Json::operator[](std::string_view key) {
  if (!std::holds_alternative<Object>(value_)) value_ = Object();
  Object& members = std::get<Object>(value_);
  const auto found = std::ranges::find(members, key, &Member::first);
  return found != members.end() ? found->second : members.emplace_back(key, Json()).second;
}

void Json::push_back(Json value) {
  if (!std::holds_alternative<List>(value_)) value_ = List();
  std::get<List>(value_).push_back(std::move(value));
}

const Json* Json::find(std::string_view key) const {
  const auto* found = members();
  if (found == nullptr) return nullptr;
  const auto member = std::ranges::find(*found, key, &Member::first);
  return member == found->end() ? nullptr : &member->second;
}

const std::vector<Json>* Json::values() const {
  return std::get_if<List>(&value_);
}

const std::vector<Json::Member>* Json::members() const {
  return std::get_if<Object>(&value_);
}

const std::string* Json::text() const {
  return std::get_if<std::string>(&value_);
}

std::optional<double> Json::number() const {
  if (const auto* value = std::get_if<double>(&value_)) return *value;
  if (const auto* value = std::get_if<std::int64_t>(&value_)) return static_cast<double>(*value);
  if (const auto* value = std::get_if<std::uint64_t>(&value_)) return static_cast<double>(*value);
  return std::nullopt;
}

std::optional<std::int64_t> Json::integer() const {
  if (const auto* value = std::get_if<std::int64_t>(&value_)) return *value;
  const auto* value = std::get_if<std::uint64_t>(&value_);
  if (value == nullptr || *value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) return {};
  return static_cast<std::int64_t>(*value);
}

std::string Json::written() const {
  return visit(Writer()).dump(2, ' ', false, Written::error_handler_t::replace);
}

std::string Json::written_in_line() const {
  return visit(Writer()).dump(-1, ' ', false, Written::error_handler_t::replace);
}

std::optional<Json> Json::parse(std::string_view text) {
  const Written read = Written::parse(text, nullptr, false);
  if (read.is_discarded()) return std::nullopt;
  return json_of(read, 0);
}

}  // namespace leadscrew::json
