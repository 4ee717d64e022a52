#include <cstdint>
#include <leadscrew/config/machine_keys.hpp>
#include <leadscrew/config/spindle_keys.hpp>

namespace leadscrew::config {

namespace {

namespace field = machine::field;

void take(const toml::table& table, std::string_view key, std::string_view field, const KeysTold& told, double& value) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return;
  told.place({.field = field}, node->source().begin);
  const auto number = node->value<double>();
  if (node->is_number() && number) {
    value = *number;
    return;
  }
  told.problem("machine-type", node->source().begin, fmt::format("{} is {}, not a number", key, type_text(*node)), "");
}

void take_seed(const toml::table& table, std::string_view key, const KeysTold& told, std::uint64_t& value) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return;
  told.place({.field = field::spindle_seed}, node->source().begin);
  const auto number = node->value_exact<std::int64_t>();
  if (!number) {
    told.problem("machine-type", node->source().begin,
                 fmt::format("{} is {}, not a whole number", key, type_text(*node)), fmt::format("write {} = 0", key));
    return;
  }
  if (*number < 0) {
    told.problem("machine-spindle", node->source().begin, fmt::format("{} is {}", key, *number),
                 "a whole number from 0 up");
    return;
  }
  value = static_cast<std::uint64_t>(*number);
}

}  // namespace

machine::Spindle read_spindle_keys(const toml::table& table, const KeysTold& told) {
  machine::Spindle spindle;
  take(table, spindle_keys[0], field::spindle_acceleration, told, spindle.acceleration);
  take(table, spindle_keys[1], field::spindle_noise, told, spindle.wander);
  take(table, spindle_keys[2], field::spindle_noise_period, told, spindle.wander_period);
  take_seed(table, spindle_keys[3], told, spindle.seed);
  return spindle;
}

}  // namespace leadscrew::config
