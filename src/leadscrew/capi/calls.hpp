#pragma once
// What all calls of leadscrew.h are made of: structures of any version as this one knows them, codes, errors.
//
//   an earlier caller's   |size|fields|          →  the fields that it lacks are 0: what they do is left undone
//   this version's        |size|fields|fields|
//   a later caller's      |size|fields|fields|0|  → understood as long as what this version does not know is 0

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <leadscrew/base/result.hpp>
#include <new>
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
template <>
inline constexpr std::size_t first_size<leadscrew_limits> = offsetof(leadscrew_limits, period);
template <>
inline constexpr std::size_t first_size<leadscrew_checked> = sizeof(leadscrew_checked);
template <>
inline constexpr std::size_t first_size<leadscrew_figures> = sizeof(leadscrew_figures);
template <>
inline constexpr std::size_t first_size<leadscrew_pose> = sizeof(leadscrew_pose);
template <>
inline constexpr std::size_t first_size<leadscrew_hold> = sizeof(leadscrew_hold);
template <>
inline constexpr std::size_t first_size<leadscrew_loop_options> = sizeof(leadscrew_loop_options);
template <>
inline constexpr std::size_t first_size<leadscrew_followed> = sizeof(leadscrew_followed);
template <>
inline constexpr std::size_t first_size<leadscrew_loop_figures> = sizeof(leadscrew_loop_figures);
template <>
inline constexpr std::size_t first_size<leadscrew_judged> = sizeof(leadscrew_judged);
template <>
inline constexpr std::size_t first_size<leadscrew_verdict> = sizeof(leadscrew_verdict);
template <>
inline constexpr std::size_t first_size<leadscrew_pulse_task> = offsetof(leadscrew_pulse_task, semi_axes);
template <>
inline constexpr std::size_t first_size<leadscrew_pulse_conventions> = offsetof(leadscrew_pulse_conventions, scale);
template <>
inline constexpr std::size_t first_size<leadscrew_pulse_figures> = sizeof(leadscrew_pulse_figures);

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

/// Is it sizeof(Struct) in one of the versions that there were, or are to come?
template <class Struct>
constexpr bool is_size(std::size_t size) {
  return size >= first_size<Struct> && size <= greatest_size;
}

/// The i-th of an array of the caller's structures, each `size` bytes long: its size, and all else as far as it reaches.
template <class Struct>
void put(Struct* array, std::size_t size, std::size_t i, Struct from) {
  from.size = size;
  std::memcpy(reinterpret_cast<char*>(array) + i * size, &from, std::min(size, sizeof from));
}

/// As much of it as fits, and a 0 behind.
template <std::size_t size>
void copy_text(char (&to)[size], std::string_view from) {
  const std::size_t length = std::min(from.size(), size - 1);
  std::copy_n(from.begin(), length, to);
  to[length] = '\0';
}

leadscrew_error error_of(const base::Diagnostic& diagnostic);

void tell(leadscrew_error* error, const base::Diagnostic& diagnostic);
int misuse(leadscrew_error* error, const char* message);
/// Of what is wrong with what was given, or of work that somebody ended.
int rejected(leadscrew_error* error, const base::Diagnostic& diagnostic);

/// What `work` returns, unless there is no memory for it.
template <class Work>
int guarded(leadscrew_error* error, const Work& work) {
#ifdef __cpp_exceptions
  try {
    return work();
  } catch (const std::bad_alloc&) {
    tell(error, base::problem("memory", "out of memory", {}));
    return LEADSCREW_OUT_OF_MEMORY;
  }
#else
  static_cast<void>(error);  // where there are no exceptions a program ends for want of memory
  return work();
#endif
}

}  // namespace leadscrew::capi
