#pragma once
// Rates of a block, from the feed of its move and from what the axes can do, and the words that make them.
//
// A command of feed moves an axis by at most one step, so that rates are commands a second: n commands in T seconds
// take the word f = q0 n/(w0 T).

#include <leadscrew/base/result.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/nc/programmed_rate.hpp>
#include <leadscrew/nc/pulse_options.hpp>
#include <string_view>

namespace leadscrew::nc {

/// base::Subject::field of problems with a program's pulses, which tells them from errors in its text.
inline constexpr std::string_view pulses_field = "pulses";

/// A block and what planning its rate needs.
struct PlannedBlock {
  Block block;
  std::array<double, base::axis_count> entry{}, exit{};  ///< steps of each axis a command, where it begins and ends
  /// Unit vectors along the path in steps, there: of a programmed line its own, whatever direction the lattice gives
  /// it.
  std::array<double, base::axis_count> entry_course{}, exit_course{};
  double acceleration = 0;   ///< of the command rate, commands/s²
  double greatest_rate = 0;  ///< commands/s: that no axis exceeds its velocity, nor its acceleration in the curve
  double rate = 0;           ///< commands/s, programmed
  bool stops = false;        ///< at its end, whatever follows
  bool from_rest = false;    ///< at its start, whatever comes before
  bool goes_on = false;      ///< along the curve whose chord the block before was
};

/// Gives a block with counted commands its words. A programmed feed that clock or step length
/// cannot give is a diagnostic, pulse-rate or pulse-step-length; so is one beyond an axis' velocity, pulse-velocity,
/// unless the feed is shaped to what the axes can do; and so is a register too narrow for a word, pulse-feed-word.
/// Rapids go as fast as clock, steps and axes allow.
base::Result<PlannedBlock> with_words(const Block& block, const gcode::Move& move, const Part& part,
                                      const machine::Machine& machine, const PulseOptions& options);

/// The word of a rate in commands/s, rounded.
std::int64_t word_of(double rate, const PulseOptions& options);

/// What an acceleration of the rate, commands/s², adds to the word at every clock, rounded down.
std::int64_t acceleration_word(double acceleration, const PulseOptions& options);

}  // namespace leadscrew::nc
