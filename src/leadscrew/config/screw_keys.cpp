#include <cmath>
#include <leadscrew/config/machine_keys.hpp>
#include <leadscrew/config/screw_keys.hpp>

namespace leadscrew::config {

namespace {

constexpr const char* pitch_hint = "entries [position, error], such as [[-100, 0], [100, 0.012]]";

}  // namespace

std::vector<machine::PitchError> read_pitch_errors(const toml::table& table, base::Axis axis, std::string_view field,
                                                   const KeysTold& told) {
  std::vector<machine::PitchError> errors;
  const std::string_view key = axis_key_of(axis, field);
  const toml::node* node = table.get(key);
  if (node == nullptr) return errors;
  if (!node->is_array()) {
    told.problem("machine-type", node->source().begin, fmt::format("{} is {}, not a list", key, type_text(*node)),
                 pitch_hint);
    return errors;
  }
  for (const toml::node& entry : *node->as_array()) {
    const std::size_t index = errors.size();
    const auto pair = pair_of(entry);
    if (pair) {
      told.place({.axis = axis, .field = field, .entry = index}, entry.source().begin);
    } else {
      auto [message, hint] = not_a_pair(fmt::format("entry {} of {}", index + 1, key), entry, pitch_hint);
      told.problem("machine-type", entry.source().begin, std::move(message), std::move(hint));
    }
    errors.push_back(pair ? machine::PitchError{pair->front(), pair->back()} : machine::PitchError{NAN, NAN});
  }
  return errors;
}

}  // namespace leadscrew::config
