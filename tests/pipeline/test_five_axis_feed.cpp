#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/pose.hpp>
#include <map>
#include <string>
#include <vector>

#include "five_axes.hpp"
#include "random_programs.hpp"

// Where no limit binds, the tip goes as fast as programmed.

namespace test_five_axis_feed {

using namespace leadscrew;
using testing_support::any;
using testing_support::five_axes;
using testing_support::FiveAxisProgram;
using testing_support::two_tools;

/// Is an axis near a limit in the three periods behind a word?
bool is_bound(const std::vector<base::Word>& words, std::size_t k, const machine::Machine& machine) {
  const double period = machine.period.seconds();
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const machine::AxisLimits& limits = machine.limits(axis);
    const auto q = [&](std::size_t i) { return words[k - 3 + i].position[base::index(axis)]; };
    const double first = q(3) - q(2), second = q(3) - 2 * q(2) + q(1), third = q(3) - 3 * q(2) + 3 * q(1) - q(0);
    const bool is_free = std::abs(first) < 0.97 * limits.velocity * period &&
                         std::abs(second) < 0.97 * limits.acceleration * period * period &&
                         std::abs(third) < 0.97 * limits.jerk * period * period * period;
    if (!is_free) return true;
  }
  return false;
}

std::vector<base::Word> words_of(const std::string& text, const machine::Machine& machine) {
  const machine::ToolTable tools = two_tools();
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, nullptr);
  std::vector<base::Word> words;
  while (program.prepare()) words.push_back(program.cycle());
  return words;
}

/// Where the programmed feed asks an axis for more than it may, by path length: where a machine of a thousand times the
/// limits exceeds them.
std::vector<double> binding_places(const std::string& text, const machine::Machine& machine) {
  machine::Machine free = machine;
  for (auto& axis : free.axes) {
    if (!axis) continue;
    axis->velocity *= 1e3;
    axis->acceleration *= 1e3;
    axis->jerk *= 1e3;
  }
  const std::vector<base::Word> words = words_of(text, free);
  std::vector<double> places;
  for (std::size_t k = 3; k < words.size(); ++k) {
    if (is_bound(words, k, machine)) places.push_back(words[k].path_length);
  }
  return places;
}

/// Words in which the speed at one would rise from rest, each axis by its acceleration.
std::size_t rise(const std::vector<base::Word>& words, std::size_t k, const machine::Machine& machine) {
  const double period = machine.period.seconds();
  double longest = 0;
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const double way = words[k].position[base::index(axis)] - words[k - 1].position[base::index(axis)];
    longest = std::max(longest, std::abs(way) / (machine.limits(axis).acceleration * period * period));
  }
  return static_cast<std::size_t>(longest);
}

/// A word, and how many on both sides of it are on its block and bound by nothing.
struct UnboundWord {
  const base::Word* word = nullptr;
  std::size_t beside = 0;
};

/// In the middle of tenths of a second on one block in which no axis is near a limit, nor would be at the programmed feed: longer
/// than any change between limits takes, which is some of the 34 intervals between knots while speed rises from rest.
std::vector<UnboundWord> unbound_words(const std::vector<base::Word>& words, const std::vector<double>& binding,
                                       const machine::Machine& machine) {
  std::vector<UnboundWord> unbound;
  std::size_t free_for = 0;
  for (std::size_t k = 3; k < words.size(); ++k) {
    const bool goes_on = words[k].line == words[k - 1].line && words[k].state != base::MotionState::rest;
    free_for = goes_on && !is_bound(words, k, machine) ? free_for + 1 : 0;
    const std::size_t half = 50 + rise(words, k, machine) / 4;
    if (free_for < 2 * half) continue;
    const auto next = std::ranges::lower_bound(binding, words[k - 2 * half + 1].path_length);
    if (next == binding.end() || *next > words[k].path_length) unbound.push_back({&words[k - half], half});
  }
  return unbound;
}

/// What is programmed on a source line.
struct Programmed {
  gcode::Move move;
  double feed = 0;  ///< mm/s or degrees/s; 0: none, or it follows from a curve's length
};

std::map<base::Line, Programmed> programmed(const std::string& text, const machine::Machine& machine) {
  std::map<base::Line, Programmed> lines;
  const machine::ToolTable tools = two_tools();
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic&) {});
  for (gcode::Move move; reader.next(move);) {
    Programmed& line = lines[move.line];
    line.move = move;
    const double length =
        std::hypot(move.end[0] - move.start[0], move.end[1] - move.start[1], move.end[2] - move.start[2]);
    const bool is_line_of_tip = move.kind == gcode::Move::Kind::line && length > 1e-3;
    if (move.feed.mode == gcode::Feed::Mode::units_per_second) line.feed = move.feed.value;
    if (move.feed.mode == gcode::Feed::Mode::per_second && is_line_of_tip) line.feed = move.feed.value * length;
  }
  return lines;
}

double distance(const gcode::Move& line, const base::Word& word, const referee::Pose& pose) {
  const base::AxisVector place = pose.tip_of(word.position, line.tool);
  double along = 0, square = 0, off = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    const double way = line.end[i] - line.start[i];
    along += way * (place[i] - line.start[i]);
    square += way * way;
  }
  for (std::size_t i = 0; square > 0 && i < place.size(); ++i)
    off = std::max(off, std::abs(place[i] - line.start[i] - along / square * (line.end[i] - line.start[i])));
  return off;
}

/// Beside a line there is a blend or a fit, whose feed is between those of what it joins; where one joins degrees to millimetres
/// it has a feed of its own.
bool is_on(const gcode::Move& move, const UnboundWord& at, const referee::Pose& pose) {
  if (move.path_mode != gcode::PathMode::blend) return true;
  if (move.kind != gcode::Move::Kind::line) return false;
  return std::max(distance(move, *(at.word - at.beside), pose), distance(move, *(at.word + at.beside), pose)) <= 1e-9;
}

/// Chords between words may be as coarse as they like.
RC_GTEST_PROP(FiveAxes, KeepTheFeedWhereNoLimitBinds, ()) {
  machine::Machine machine = five_axes();
  machine.chord_error = 10;
  const std::string text = FiveAxisProgram(machine).make(any(1, 6));
  RC_LOG() << machine.kinematics << "\n" << text << testing_support::limits_of(machine);
  const auto lines = programmed(text, machine);
  const referee::Pose pose(machine);
  const std::vector<base::Word> words = words_of(text, machine);
  int judged = 0;
  for (const UnboundWord& at : unbound_words(words, binding_places(text, machine), machine)) {
    const base::Word* const word = at.word;
    const auto line = lines.find(word->line);
    if (line == lines.end() || line->second.feed == 0 || !is_on(line->second.move, at, pose)) continue;
    ++judged;
    const double least = (1 - 1e-3) * line->second.feed;
    if (word->feed < least)
      RC_LOG() << base::number(word->line) << ": " << word->path_length << "; " << word->feed / line->second.feed
               << "\n";
    RC_ASSERT(word->feed >= least);
  }
  RC_CLASSIFY(judged > 0, "a limit binds nowhere in a tenth of a second");
}

}  // namespace test_five_axis_feed
