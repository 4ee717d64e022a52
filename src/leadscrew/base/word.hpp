#pragma once
// The reference word: what leaves for the axes at every servo period.

#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/line.hpp>
#include <leadscrew/base/time.hpp>

namespace leadscrew::base {

/// What the plan does at the instant of a word.
enum class MotionState : std::uint8_t {
  rest,      ///< standing still: before the start, in a dwell, after the end
  changing,  ///< the speed along the path changes
  constant,  ///< the plan says constant speed along the path
};

/// One servo period.
struct Word {
  Tick tick{};            ///< number of the period
  AxisVector position{};  ///< axis positions, mm or degrees
  /// Travelled along the tool path since the program's start, mm; degrees where only rotary axes move. On a smoothed
  /// path (G64), where a rotary axis moves, a degree counts as its arc at a radius of 50 mm.
  double path_length = 0;
  double speed = 0;  ///< along the path, units of path_length per second
  double feed = 0;   ///< speed by the axes that feed is counted by, mm/s (degrees/s where only rotary axes move)
  Line line{};       ///< source line of the block in motion
  MotionState state = MotionState::rest;  ///< of the plan at this instant
};

/// Where axes are along the tool path.
struct PathPlace {
  AxisVector position{};   ///< mm or degrees
  double path_length = 0;  ///< as in Word
};

}  // namespace leadscrew::base
