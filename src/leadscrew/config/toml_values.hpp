#pragma once
// Values of TOML as machine files need them: what a node is, and what is wrong with it. For machine_file.cpp, and
// the parts of it that read keys of one kind; with it they are all that includes toml++.

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace leadscrew::config {

inline constexpr const char* exact_hint =
    "integers are exact up to 9007199254740992; write others with a decimal point";

/// What the text holds, or the first error of its syntax. toml++ throws that, but where exceptions are off, as for WebAssembly.
inline tl::expected<toml::table, toml::parse_error> parse_toml(std::string_view text, std::string_view file) {
#if TOML_EXCEPTIONS
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    return tl::unexpected(error);
  }
#else
  toml::parse_result root = toml::parse(text, file);
  if (!root) return tl::unexpected(std::move(root).error());
  return std::move(root).table();
#endif
}

inline std::string_view type_text(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::none:
      return "nothing";
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

/// Is it an integer that no double holds exactly?
inline bool is_inexact(const toml::node& node) {
  return node.is_integer() && !node.value<double>();
}

/// Two numbers; empty where it is anything else.
inline std::optional<std::array<double, 2>> pair_of(const toml::node& node) {
  const toml::array* pair = node.as_array();
  if (pair == nullptr || pair->size() != 2) return std::nullopt;
  // Of an integer that no double holds there is no value.
  const auto first = (*pair)[0].value<double>(), second = (*pair)[1].value<double>();
  if (!(*pair)[0].is_number() || !(*pair)[1].is_number() || !first || !second) return std::nullopt;
  return std::array{*first, *second};
}

/// What is wrong where pair_of() is empty, and what would be right.
inline std::pair<std::string, std::string> not_a_pair(std::string_view what, const toml::node& node, const char* hint) {
  const toml::array* list = node.as_array();
  if (list == nullptr) return {fmt::format("{} is {}, not a list of two numbers", what, type_text(node)), hint};
  const auto inexact = std::find_if(list->begin(), list->end(), is_inexact);
  if (list->size() == 2 && inexact != list->end()) {
    return {fmt::format("{} holds {}, which no double-precision number is", what, *inexact->value<std::int64_t>()),
            exact_hint};
  }
  return {fmt::format("{} is a list, but not of two numbers", what), hint};
}

/// In the order of the file.
inline std::vector<const toml::key*> unknown_keys(const toml::table& table, std::span<const std::string_view> known) {
  std::vector<const toml::key*> unknown;
  for (const auto& [key, node] : table) {
    if (std::find(known.begin(), known.end(), key.str()) == known.end()) unknown.push_back(&key);
  }
  std::sort(unknown.begin(), unknown.end(),
            [](const toml::key* a, const toml::key* b) { return a->source().begin < b->source().begin; });
  return unknown;
}

}  // namespace leadscrew::config
