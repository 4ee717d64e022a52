#pragma once
// JSON values: put together, written and read. Members keep the order in which they were added. nlohmann's library
// reads and writes the text; json.cpp alone includes it, since it is slow to compile.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace leadscrew::json {

class Json {
 public:
  using Member = std::pair<std::string, Json>;

  Json() = default;  ///< null
  Json(std::nullptr_t) {}
  Json(bool value) : value_(value) {}
  Json(std::signed_integral auto value) : value_(static_cast<std::int64_t>(value)) {}
  Json(std::unsigned_integral auto value) : value_(static_cast<std::uint64_t>(value)) {}
  Json(double value) : value_(value) {}  ///< NaN and infinite are written as null
  Json(std::string value) : value_(std::move(value)) {}
  Json(std::string_view value) : value_(std::string(value)) {}
  Json(const char* value) : value_(std::string(value)) {}
  /// Null where it is empty.
  template <class T>
  Json(const std::optional<T>& value) : Json(value ? Json(*value) : Json()) {}
  template <class T>
  Json(const std::vector<T>& values) : value_(List(values.begin(), values.end())) {}

  static Json list(std::initializer_list<Json> values = {});
  static Json object(std::initializer_list<Member> members = {});

  /// Of an object: the member, added as null where there is none.
  Json& operator[](std::string_view key);
  /// At the end of a list; null becomes a list.
  void push_back(Json value);

  /// The parts of what was read; empty, or null, where the value is of another kind.
  const Json* find(std::string_view key) const;
  const std::vector<Json>* values() const;
  const std::vector<Member>* members() const;
  const std::string* text() const;
  std::optional<double> number() const;  ///< integers too
  std::optional<std::int64_t> integer() const;

  /// As text: in lines, indented by two blanks, without an end of line behind; or in one line. Bytes that are no UTF-8
  /// are replaced.
  std::string written() const;
  std::string written_in_line() const;

  /// Calls with what it holds: nullptr, bool, std::int64_t, std::uint64_t, double, std::string, values or members.
  auto visit(const auto& visitor) const { return std::visit(visitor, value_); }

  /// Empty where the text is no JSON, or nests deeper than 64.
  static std::optional<Json> parse(std::string_view text);

 private:
  using List = std::vector<Json>;
  using Object = std::vector<Member>;

  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, List, Object> value_ = nullptr;
};

}  // namespace leadscrew::json
