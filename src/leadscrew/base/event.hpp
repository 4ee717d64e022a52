#pragma once
// What a program asks of the machine besides motion, to happen at its place of the path.
//
// Some of it motion rests for; all else travels with the path: it happens where motion passes the place between two
// blocks at which the program asks for it.

#include <cstdint>
#include <leadscrew/base/line.hpp>
#include <leadscrew/base/time.hpp>
#include <string_view>

namespace leadscrew::base {

/// What a block asks for.
struct Event {
  /// By code.
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
    pallet_pause,              ///< M60: a pause in which the pallet is changed
    program_end,               ///< M2, M30 or the closing %
    /// F; value: of the block that motion enters, mm/s (degrees/s where only rotary axes move), 0 of a rapid. Only where
    /// somebody asks for it (toolpath::Builder::tell_feed).
    programmed_feed,
    digital_output_on_with_motion,   ///< M62; output: its number; value: 1
    digital_output_off_with_motion,  ///< M63; likewise; value: 0
    digital_output_on,               ///< M64; as M62
    digital_output_off,              ///< M65; as M63
    analog_output_with_motion,       ///< M67; output: its number; value: what it is set to
    analog_output,                   ///< M68; likewise
    /// G33, G76; value: mm of path in a revolution of the spindle, from its index on where motion rests for it (`waits`); 0:
    /// motion is no longer in step. Degrees where only rotary axes move.
    spindle_in_step,
    rigid_tap,  ///< G33.1; likewise, in and, behind the spindle's reversal, out again
  };
  Kind kind = Kind::program_end;  ///< what
  double value = 0;               ///< as Kind says; else 0
  Line line{};                    ///< of the block
  std::int32_t output = 0;        ///< number of an output, 0 … most_outputs − 1
  bool waits = true;              ///< motion rests for it

  friend bool operator==(const Event&, const Event&) = default;
};

/// Digital outputs there are, and analog ones (LinuxCNC, "motion" component: at most 64 of each).
inline constexpr std::int32_t most_outputs = 64;

/// Does it take effect as the next motion begins, however long that takes (M62, M63, M67)?
constexpr bool is_with_motion(Event::Kind kind) {
  using Kind = Event::Kind;
  return kind == Kind::digital_output_on_with_motion || kind == Kind::digital_output_off_with_motion ||
         kind == Kind::analog_output_with_motion;
}

/// Does motion rest until somebody says to go on?
constexpr bool is_pause(Event::Kind kind) {
  using Kind = Event::Kind;
  return kind == Kind::pause || kind == Kind::optional_pause || kind == Kind::pallet_pause;
}

/// Does a block ask for it? Not where it only says how motion was programmed.
constexpr bool is_of_program(Event::Kind kind) {
  return kind != Event::Kind::programmed_feed;
}

/// Is it of an output that has a number?
constexpr bool has_output(Event::Kind kind) {
  return kind >= Event::Kind::digital_output_on_with_motion && kind <= Event::Kind::analog_output;
}

/// Does its value say more than its kind?
constexpr bool has_value(Event::Kind kind) {
  using Kind = Event::Kind;
  switch (kind) {
    case Kind::spindle_clockwise:
    case Kind::spindle_counterclockwise:
    case Kind::spindle_speed:
    case Kind::tool_prepare:
    case Kind::tool_change:
    case Kind::programmed_feed:
    case Kind::analog_output_with_motion:
    case Kind::analog_output:
    case Kind::spindle_in_step:
    case Kind::rigid_tap:
      return true;
    default:
      return false;
  }
}

/// As a program writes it: "M8", "S".
constexpr std::string_view code_of(Event::Kind kind) {
  constexpr std::string_view codes[] = {"M5",  "M3", "M4", "S",   "M7",  "M8",  "M9",  "T",   "M6",  "M0",  "M1",
                                        "M60", "M2", "F",  "M62", "M63", "M64", "M65", "M67", "M68", "G33", "G33.1"};
  return codes[static_cast<std::size_t>(kind)];
}

/// An event that has happened: in the period that ends with the word of `tick`.
struct PassedEvent : Event {
  Tick tick{};             ///< of the word in whose period it happens
  double path_length = 0;  ///< where, as Word::path_length
};

}  // namespace leadscrew::base
