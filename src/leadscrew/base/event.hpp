#pragma once
// What a program asks of the machine besides motion, to happen at its place of the path.
//
// Some of it motion rests for; all else travels with the path: it happens where motion passes the place between two
// blocks at which the program asks for it.

#include <array>
#include <cstddef>
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
    tool_change,               ///< M6; value: tool number; the spindle stops
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
    /// M19; value: angle, degrees; output: direction, 0 the shorter, 1 clockwise, 2 counterclockwise; q: s that it may
    /// take, 0: as long as it takes.
    spindle_orientation,
    overrides_on,      ///< M48: those of feed and spindle are obeyed
    overrides_off,     ///< M49: they are not
    feed_override,     ///< M50; value: 1 obeyed, 0 not
    spindle_override,  ///< M51; likewise
    adaptive_feed,     ///< M52; likewise
    feed_hold,         ///< M53; likewise
    /// M66 P; output: number of the input; value: L, what is waited for: 0 nothing, 1 that it rises, 2 that it falls, 3
    /// that it is on, 4 that it is off; q: s that this may take.
    digital_input,
    analog_input,  ///< M66 E; output: number of the input, which is read at once
    /// M100 … M199, of Fanuc's and Haas' machines also lower ones; output: that number; value: P; q: Q; -1 where there is
    /// none.
    user_function,
    /// G33, G76; value: mm of path in a revolution of the spindle, from its index on where motion rests for it (`waits`) and was
    /// not in step; 0: motion is no longer in step. Degrees where only rotary axes move. Of G84 and G74 (output: in_tapping_cycle) it is F / S,
    /// and motion waits for no index but where the machine simulates its spindle.
    spindle_in_step,
    rigid_tap,  ///< G33.1; likewise, in and, behind the spindle's reversal, out again
    /// G43 and the like; output: 0, 1 or 2 of X, Y or Z; value: offset of the tool along it, mm, of the block that motion
    /// enters. Only where somebody asks for it (toolpath::Builder::tell_tool), and where it is another than before.
    tool_offset,
    tip_control,  ///< G43.4 and the like; likewise; value: 1 where feed is that of the tool's tip, 0 where that of the axes
    /// G95; value: S for which the feeds of the blocks are planned that motion enters, revolutions per minute; 0 of other feeds.
    /// Only where a simulated spindle is followed (toolpath::Builder::tell_revolutions).
    feed_per_revolution,
    turret_indexing,  ///< T of Fanuc's lathes: another tool, the spindle turns on; value: tool number
  };
  Kind kind = Kind::program_end;  ///< what
  double value = 0;               ///< as Kind says; else 0
  Line line{};                    ///< of the block
  std::int32_t output = 0;        ///< number of an output or input, 0 … most_outputs − 1, or as Kind says
  bool waits = true;              ///< motion rests for it
  double q = 0;                   ///< as Kind says; else 0

  friend bool operator==(const Event&, const Event&) = default;
};

/// Output of spindle_in_step: of a tapping cycle, 0 of a thread.
inline constexpr std::int32_t in_tapping_cycle = 1;

/// Digital outputs there are, analog ones, and inputs of either kind (LinuxCNC, "motion" component: at most 64 of each).
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

/// Is another tool at the work behind it?
constexpr bool changes_tool(Event::Kind kind) {
  return kind == Event::Kind::tool_change || kind == Event::Kind::turret_indexing;
}

/// Does the spindle stand behind it?
constexpr bool stops_spindle(Event::Kind kind) {
  using Kind = Event::Kind;
  return kind == Kind::spindle_stop || kind == Kind::spindle_orientation || kind == Kind::tool_change ||
         kind == Kind::program_end;
}

/// Does a program ask for the value of an input?
constexpr bool is_input(Event::Kind kind) {
  return kind == Event::Kind::digital_input || kind == Event::Kind::analog_input;
}

/// Does motion come in step with the spindle by it (value > 0), or out of it?
constexpr bool is_in_step(Event::Kind kind) {
  return kind == Event::Kind::spindle_in_step || kind == Event::Kind::rigid_tap;
}

/// Does a block ask for it? Not where it only says how motion was programmed.
constexpr bool is_of_program(Event::Kind kind) {
  return kind != Event::Kind::programmed_feed && kind != Event::Kind::tool_offset && kind != Event::Kind::tip_control &&
         kind != Event::Kind::feed_per_revolution;
}

/// Does its output say more than its kind and code?
constexpr bool has_output(Event::Kind kind) {
  using Kind = Event::Kind;
  return (kind >= Kind::digital_output_on_with_motion && kind <= Kind::spindle_orientation) || is_input(kind) ||
         kind == Kind::tool_offset;
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
    case Kind::spindle_orientation:
    case Kind::feed_override:
    case Kind::spindle_override:
    case Kind::adaptive_feed:
    case Kind::feed_hold:
    case Kind::digital_input:
    case Kind::user_function:
    case Kind::spindle_in_step:
    case Kind::rigid_tap:
    case Kind::tool_offset:
    case Kind::tip_control:
    case Kind::feed_per_revolution:
    case Kind::turret_indexing:
      return true;
    default:
      return false;
  }
}

/// Does its q say more than its kind?
constexpr bool has_q(Event::Kind kind) {
  using Kind = Event::Kind;
  return kind == Kind::spindle_orientation || kind == Kind::digital_input || kind == Kind::user_function;
}

namespace detail {
inline constexpr std::size_t user_functions = 200;  // M0 … M199, each in as many characters as the longest
inline constexpr std::size_t longest_code = 4;
constexpr std::array<char, user_functions * longest_code> make_user_codes() {
  std::array<char, user_functions * longest_code> codes{};
  for (std::size_t number = 0; number < user_functions; ++number) {
    char* code = &codes[number * longest_code];
    *code++ = 'M';
    if (number >= 100) *code++ = static_cast<char>('0' + number / 100);
    if (number >= 10) *code++ = static_cast<char>('0' + number / 10 % 10);
    *code = static_cast<char>('0' + number % 10);
  }
  return codes;
}
inline constexpr std::array<char, user_functions * longest_code> user_codes = make_user_codes();
}  // namespace detail

/// As a program writes it: "M8", "S", "M101".
constexpr std::string_view code_of(const Event& event) {
  constexpr std::string_view codes[] = {"M5",  "M3",  "M4",   "S",   "M7",    "M8",  "M9",    "T",   "M6",
                                        "M0",  "M1",  "M60",  "M2",  "F",     "M62", "M63",   "M64", "M65",
                                        "M67", "M68", "M19",  "M48", "M49",   "M50", "M51",   "M52", "M53",
                                        "M66", "M66", "M100", "G33", "G33.1", "G43", "G43.4", "G95", "T"};
  if (event.kind != Event::Kind::user_function) return codes[static_cast<std::size_t>(event.kind)];
  const auto number = static_cast<std::size_t>(event.output);
  if (number >= detail::user_functions) return "M";
  return {&detail::user_codes[number * detail::longest_code], number < 10 ? 2U : number < 100 ? 3U : 4U};
}

/// An event that has happened: in the period that ends with the word of `tick`.
struct PassedEvent : Event {
  Tick tick{};             ///< of the word in whose period it happens
  double path_length = 0;  ///< where, as Word::path_length
};

}  // namespace leadscrew::base
