#pragma once
// Moves as commands of motion_core.sv. Freestanding: integers, no memory from the heap, no exceptions.

#include "octants.hpp"

namespace leadscrew::driver {

inline constexpr int most_axes = 7;
inline constexpr int most_units = most_axes - 1;

/// What motion is to be made; the least of it that a machine needs is a line.
struct Move {
  enum class Kind : std::uint8_t { line, arc, dwell };
  enum class Speed : std::uint8_t {
    even_steps,  ///< feed is of the axis that drives, whatever the others do
    /// feed is along the path, of all axes of a line: 0.05 % less at most around circles of R ≥ 724 (260/R² below, up
    /// to 7.6 %), in no more than 14 commands to an octant. Arcs are slower where a step would be due within a tick: from
    /// 0.7 steps a tick on
    even_path,
  };

  Kind kind = Kind::line;
  Speed speed = Speed::even_steps;
  bool is_last = false;                ///< motion may end behind it; else that is an underflow
  std::uint16_t tag = 0;               ///< anything; shown while the move is made
  std::uint64_t feed = 0;              ///< steps a tick · 2^FEED_WIDTH, 1 … 2^FEED_WIDTH
  std::int32_t delta[most_axes] = {};  ///< of a line, steps
  pulse::Arc arc{};                    ///< of an arc, steps about its centre, in the plane of two axes
  std::uint8_t first_axis = 0, second_axis = 1;
  std::uint64_t ticks = 0;  ///< of a dwell
};

enum class Refusal : std::uint8_t {
  none,
  too_long,  ///< a line of more steps, or an arc of a greater radius, than the core's counters hold
  axis,      ///< one that the core does not have, or an arc in one axis
  no_arc,    ///< an arc that begins or ends at its centre
  feed,      ///< 0, or more than a step a tick
  busy,      ///< the move before is not cut to its end
};

/// A command, as the registers have it.
struct Command {
  std::uint32_t count = 0, source = 0, push = 0;
  std::uint64_t feed = 0, straight_feed = 0;
  std::int32_t decision[most_units] = {}, straight[most_units] = {}, diagonal[most_units] = {};
};

/// How the core was built: the register PARAMETERS.
struct CoreParameters {
  int axes = 0, width = 0, feed_width = 0, depth = 0;
};

class Cutter {
 public:
  void set(const CoreParameters& core) { core_ = core; }

  /// A move, once the one before is done.
  Refusal take(const Move& move);
  /// Is there no command left?
  bool done() const { return left_ == 0; }
  /// Its next command; not when done.
  Command next();
  void drop() { left_ = 0; }

 private:
  Refusal problem_of(const Move& move) const;
  Command line();
  Command octant();
  Command dwell();
  void set_feed(Command& command, const Pace& pace) const;
  std::uint32_t share_of_driving(std::uint32_t count) const;

  CoreParameters core_{};
  Move move_{};
  Octants octants_{pulse::Arc{{1, 0}, {1, 0}}};
  std::uint64_t left_ = 0;  // ticks of a dwell; of others 1 until the last command
};

}  // namespace leadscrew::driver
