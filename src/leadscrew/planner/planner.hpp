#pragma once
// From path to motion: the fastest speed along each piece that keeps every limit of every axis.
//
// Every piece goes from rest to rest in seven phases of constant jerk (rest_to_rest.hpp). Along a line the limits of
// the axes become limits of the path and the law is the fastest there is; along an arc or helix its bounds are chosen
// so that centripetal and tangential parts together stay inside (piece_limits.hpp).

#include <array>
#include <deque>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/planner/motion.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <optional>

namespace leadscrew::planner {

/// Streaming: elements of the path are pushed, chunks come out once nothing ahead can change them. The machine must
/// outlive the planner and have every axis that the path moves.
class Planner {
 public:
  /// Stands at `start`, mm or degrees.
  Planner(const machine::Machine& machine, const geometry::Point& start) : machine_(machine), position_(start) {}

  void push(const toolpath::Element& element);
  /// No more elements will come.
  void finish();
  /// The next chunk that is settled, if there is one.
  std::optional<Chunk> pop();

 private:
  Chunk& begin_chunk();

  const machine::Machine& machine_;
  std::vector<base::Event> events_;  ///< waiting for the chunk they come before
  std::deque<Chunk> settled_;
  geometry::Point position_;
  base::Line line_{};
};

/// Largest value over limit of one axis.
struct AxisRatios {
  double velocity = 0, acceleration = 0, jerk = 0;

  friend bool operator==(const AxisRatios&, const AxisRatios&) = default;
};
using LimitRatios = std::array<AxisRatios, base::axis_count>;

/// What a chunk's motion asks of each axis over what the axis can, evaluated from jets of the path and the polynomials
/// of time, at both ends of every segment, and inside where curvature couples the two. Raises `ratios` where it is
/// larger.
void raise_limit_ratios(const Chunk& chunk, const machine::Machine& machine, LimitRatios& ratios);

}  // namespace leadscrew::planner
