#include <cmath>
#include <leadscrew/config/machine_keys.hpp>
#include <leadscrew/config/probe_keys.hpp>

namespace leadscrew::config {

namespace {

using machine::ProbeBody;
using Kind = ProbeBody::Kind;

/// Numbers of an entry: coordinates, and a radius behind them.
constexpr std::size_t count_of(Kind kind) {
  return kind == Kind::sphere ? 4 : kind == Kind::box || kind == Kind::pocket ? 6 : 7;
}

/// As many numbers; empty where it is anything else.
std::optional<std::vector<double>> numbers_of(const toml::node& node, std::size_t count) {
  const toml::array* list = node.as_array();
  if (list == nullptr || list->size() != count) return std::nullopt;
  std::vector<double> numbers;
  for (const toml::node& entry : *list) {
    const auto number = entry.value<double>();
    if (!entry.is_number() || !number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

ProbeBody body_of(Kind kind, const std::vector<double>& numbers) {
  ProbeBody body{.kind = kind, .from = {numbers[0], numbers[1], numbers[2]}};
  if (kind != Kind::sphere) body.to = {numbers[3], numbers[4], numbers[5]};
  if (count_of(kind) != 6) body.radius = numbers.back();
  return body;
}

void read_kind(const toml::table& table, Kind kind, const KeysTold& told, std::vector<ProbeBody>& bodies) {
  const auto index = static_cast<std::size_t>(kind);
  const std::string_view key = probe_body_keys[index];
  const toml::node* node = table.get(key);
  if (node == nullptr) return;
  const std::string hint = fmt::format("a list of {}", machine::probe_body_form(kind));
  if (!node->is_array()) {
    told.problem("machine-type", node->source().begin, fmt::format("{} is {}, not a list", key, type_text(*node)),
                 hint);
    return;
  }
  std::size_t entry = 0;
  for (const toml::node& each : *node->as_array()) {
    const auto numbers = numbers_of(each, count_of(kind));
    if (numbers) {
      told.place({.field = machine::probe_body_fields[index], .entry = entry}, each.source().begin);
      bodies.push_back(body_of(kind, *numbers));
    } else {
      told.problem("machine-type", each.source().begin,
                   fmt::format("entry {} of {} is not a list of {} numbers", entry + 1, key, count_of(kind)), hint);
      bodies.push_back({.kind = kind, .radius = NAN});
    }
    ++entry;
  }
}

}  // namespace

std::vector<ProbeBody> read_probe_bodies(const toml::table& table, const KeysTold& told) {
  std::vector<ProbeBody> bodies;
  for (const Kind kind : {Kind::box, Kind::pocket, Kind::sphere, Kind::cylinder, Kind::bore})
    read_kind(table, kind, told, bodies);
  return bodies;
}

}  // namespace leadscrew::config
