#pragma once
// What runs hand over in rows, and how NumPy finds its fields.

#include <array>
#include <cstddef>
#include <leadscrew/base/word.hpp>
#include <leadscrew/pipeline/lost_time.hpp>
#include <leadscrew/pipeline/trajectory.hpp>
#include <leadscrew/servo/servo.hpp>
#include <vector>

#include "arrays.hpp"

namespace leadscrew::python {

using Words = std::vector<base::Word>;

/// Of words that stand so many bytes behind the beginning of a row. `line` is the number in its text; `block` has its text
/// and its visit beside (base::Line).
inline std::vector<Field> word_fields(std::size_t at = 0) {
  return {{"tick", "<i8", at + offsetof(base::Word, tick)},
          {"position", "(9,)<f8", at + offsetof(base::Word, position)},
          {"path_length", "<f8", at + offsetof(base::Word, path_length)},
          {"speed", "<f8", at + offsetof(base::Word, speed)},
          {"feed", "<f8", at + offsetof(base::Word, feed)},
          {"line", "<u4", at + offsetof(base::Word, line)},
          {"block", "<i8", at + offsetof(base::Word, line)},
          {"state", "u1", at + offsetof(base::Word, state)}};
}

inline std::vector<Field> followed_fields() {
  std::vector<Field> fields = word_fields(offsetof(servo::Followed, word));
  fields.push_back({"actual", "(9,)<f8", offsetof(servo::Followed, position)});
  fields.push_back({"velocity", "(9,)<f8", offsetof(servo::Followed, velocity)});
  fields.push_back({"control", "(9,)<f8", offsetof(servo::Followed, control)});
  fields.push_back({"current", "(9,)<f8", offsetof(servo::Followed, current)});
  return fields;
}

inline std::vector<Field> state_fields() {
  using State = pipeline::TrajectoryState;
  return {{"position", "(9,)<f8", offsetof(State, position)},
          {"velocity", "(9,)<f8", offsetof(State, velocity)},
          {"acceleration", "(9,)<f8", offsetof(State, acceleration)},
          {"jerk", "(9,)<f8", offsetof(State, jerk)},
          {"path_length", "<f8", offsetof(State, path_length)},
          {"speed", "<f8", offsetof(State, speed)},
          {"feed", "<f8", offsetof(State, feed)},
          {"line", "<u4", offsetof(State, line)},
          {"block", "<i8", offsetof(State, line)},
          {"state", "u1", offsetof(State, state)}};
}

/// What one move of a block took.
struct BlockRow {
  pipeline::BlockTime time;
  std::array<char, 24> cause{};  ///< of most of what is lost; empty where nothing is
};

inline std::vector<Field> block_fields() {
  using Time = pipeline::BlockTime;
  const std::size_t at = offsetof(BlockRow, time);
  return {{"line", "<u4", at + offsetof(Time, line)},
          {"block", "<i8", at + offsetof(Time, line)},
          {"begin", "<f8", at + offsetof(Time, begin)},
          {"seconds", "<f8", at + offsetof(Time, seconds)},
          {"least_seconds", "<f8", at + offsetof(Time, least_seconds)},
          {"length", "<f8", at + offsetof(Time, length)},
          {"feed_asked", "<f8", at + offsetof(Time, feed_asked)},
          {"feed_reached", "<f8", at + offsetof(Time, feed_reached)},
          {"from", "(9,)<f8", at + offsetof(Time, from)},
          {"to", "(9,)<f8", at + offsetof(Time, to)},
          {"middle", "(9,)<f8", at + offsetof(Time, middle)},
          {"cause", "S24", offsetof(BlockRow, cause)}};
}

}  // namespace leadscrew::python
