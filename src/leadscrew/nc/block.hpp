#pragma once
// A block of an NC program, ready for the registers: displacements on the lattice of single steps, and words of feed.

#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/line.hpp>
#include <leadscrew/pulse/arc.hpp>

namespace leadscrew::nc {

/// Steps of the nine axes at one clock.
using AxisPulse = pulse::Pulse<base::axis_count>;

/// A displacement or a position of each axis, BLU.
using LatticeVector = std::array<std::int64_t, base::axis_count>;

struct Block {
  enum class Kind : std::uint8_t {
    point_to_point,  ///< every axis for itself, one step a command, until it is there
    line,            ///< all axes together
    arc,             ///< two axes about a centre, all others evenly with them
    dwell,           ///< nothing, for `dwell_clocks`
  };

  Kind kind = Kind::line;
  base::Line line{};      ///< of the part program
  LatticeVector delta{};  ///< BLU, signed; of an arc: of the axes that are not in its plane
  /// Of an arc: about its centre. It is never one whose ends coincide but a full circle.
  pulse::Arc arc;
  std::size_t first_axis = 0, second_axis = 1;  ///< of the arc's x and y
  std::int64_t dwell_clocks = 0;

  std::int64_t commands = 0;         ///< of feed that the block takes (count_commands)
  std::int64_t uncertain = 0;        ///< commands that it may take less or more than that
  std::int64_t capacity = 1;         ///< q of the DDA of a line, or of the axes beside a circle
  std::int64_t circle_commands = 0;  ///< of an arc: that its circle alone takes
  std::int64_t feed_word = 0;        ///< f: so much of the feed register's capacity is a clock's share of a command
  std::int64_t greatest_word = 0;    ///< that an override may make of it; ≥ feed_word, ≤ the register's capacity
};

/// Steps that a block makes from its start to its end, BLU.
constexpr LatticeVector whole_delta(const Block& block) {
  LatticeVector delta = block.delta;
  if (block.kind == Block::Kind::dwell) delta = {};
  if (block.kind != Block::Kind::arc) return delta;
  delta[block.first_axis] = block.arc.end.x - block.arc.start.x;
  delta[block.second_axis] = block.arc.end.y - block.arc.start.y;
  return delta;
}

}  // namespace leadscrew::nc
