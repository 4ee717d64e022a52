#pragma once
// What a program asks of the machine besides motion, to happen at its place of the path.

#include <cstdint>
#include <leadscrew/base/line.hpp>

namespace leadscrew::base {

struct Event {
  enum class Kind : std::uint8_t {
    spindle_stop,              ///< M5
    spindle_clockwise,         ///< M3; value: revolutions per minute
    spindle_counterclockwise,  ///< M4; value: revolutions per minute
    spindle_speed,             ///< S; value: revolutions per minute
    coolant_mist,              ///< M7
    coolant_flood,             ///< M8
    coolant_off,               ///< M9
    tool_prepare,              ///< T; value: tool number
    tool_change,               ///< M6; value: tool number
    pause,                     ///< M0
    optional_pause,            ///< M1
    program_end,               ///< M2, M30 or the closing %
  };
  Kind kind = Kind::program_end;
  double value = 0;
  Line line{};

  friend bool operator==(const Event&, const Event&) = default;
};

}  // namespace leadscrew::base
