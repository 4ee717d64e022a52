#pragma once
// Structures of leadscrew.h: those of any version as this one knows them, and what they say in the words of the rooms.
//
//   an earlier caller's   |size|fields|          →  the fields that it lacks are 0: what they do is left undone
//   this version's        |size|fields|fields|
//   a later caller's      |size|fields|fields|0|  → understood as long as what this version does not know is 0

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <leadscrew/host/motion.hpp>
#include <optional>
#include <string_view>

#include "leadscrew.h"

namespace leadscrew::capi {

/// sizeof in the version that had it first.
template <class Struct>
inline constexpr std::size_t first_size = 0;
template <>
inline constexpr std::size_t first_size<leadscrew_error> = 848;
template <>
inline constexpr std::size_t first_size<leadscrew_options> = 120;
template <>
inline constexpr std::size_t first_size<leadscrew_move> = 168;
template <>
inline constexpr std::size_t first_size<leadscrew_state> = 336;

/// No version's structure is longer: a size beyond is a number that nobody has set.
inline constexpr std::size_t greatest_size = 4096;

/// What a caller gives, as this version knows it; empty where it is NULL, its size is none that a version had, or it
/// asks for what this version does not know.
template <class Struct>
std::optional<Struct> known(const Struct* given) {
  if (given == nullptr || given->size < first_size<Struct> || given->size > greatest_size) return std::nullopt;
  const auto* const bytes = reinterpret_cast<const char*>(given);
  const std::size_t common = std::min(given->size, sizeof(Struct));
  if (std::any_of(bytes + common, bytes + given->size, [](char byte) { return byte != 0; })) return std::nullopt;
  Struct result{};
  std::memcpy(&result, bytes, common);
  result.size = sizeof result;
  return result;
}

/// Fills the caller's structure as far as it reaches, all but its size; false where that is none that a version had.
template <class Struct>
bool fill(Struct* to, const Struct& from) {
  if (to == nullptr || to->size < first_size<Struct>) return false;
  constexpr std::size_t head = sizeof from.size;
  std::memcpy(reinterpret_cast<char*>(to) + head, reinterpret_cast<const char*>(&from) + head,
              std::min(to->size, sizeof from) - head);
  return true;
}

leadscrew_error error_of(const base::Diagnostic& diagnostic);
leadscrew_event event_of(const base::PassedEvent& from);
leadscrew_word word_of(const base::Word& from);
leadscrew_state state_of(const host::TrajectoryState& from);

base::AxisVector axes_of(const double* from);
/// Empty where a field is out of its range.
std::optional<gcode::Move> move_of(const leadscrew_move& given);
/// What options ask for, without tools. Errors: the slice or the start is not sound.
base::Result<host::MotionOptions> options_of(const leadscrew_options& given, const machine::Machine& machine);
gcode::DiagnosticSink sink_of(const leadscrew_options& options);

}  // namespace leadscrew::capi
