#pragma once
// Motion: s(t) in chunks, each ready for the cycle to evaluate and each ending in a stop.
//
//      s' ^        .--------.            A chunk holds its pieces of path and the law of time along them, as
//      polynomials
//         |      /           \           between knots. If no successor has come when its committed part ends, the
//         cycle |    /    committed  \  tail   runs its stop tail and the machine comes to rest on the path within its
//         limits.
//         +--'------------------'---> t  Chunks that end at rest have no tail.

#include <cstdint>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/numeric/double_double.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <variant>
#include <vector>

namespace leadscrew::planner {

/// s(τ) = s0 + τ(v0 + τ(c2 + τ(c3 + τ(c4 + τ c5)))) along one piece, τ the time since the segment began, 0 ≤ τ ≤
/// duration.
struct Segment {
  numeric::DoubleDouble begin;     ///< seconds since the chunk began
  numeric::DoubleDouble duration;  ///< seconds, ≥ 0
  numeric::DoubleDouble s0;        ///< path length on the piece, units of the piece's length
  numeric::DoubleDouble v0;        ///< speed, units/s
  double c2 = 0, c3 = 0, c4 = 0, c5 = 0;
  std::uint32_t piece = 0;  ///< index into Chunk::pieces
  base::MotionState state = base::MotionState::changing;
};

struct Chunk {
  std::vector<base::Event> events;      ///< to happen before this chunk begins, in order
  std::vector<toolpath::Piece> pieces;  ///< empty for a dwell
  std::vector<Segment> segments;        ///< the committed part, contiguous in time; for a dwell one segment at rest
  std::vector<Segment> stop_tail;       ///< from the committed part's end to rest; empty where that is at rest
  geometry::Point rest{};               ///< where the chunk comes to rest
  base::Line rest_line{};
  numeric::DoubleDouble duration;  ///< seconds, of the committed part
  double length = 0;               ///< travelled by the committed part
};

/// Speed, acceleration and jerk along the path at a time within a segment.
struct PathState {
  double s = 0, speed = 0, acceleration = 0, jerk = 0;  ///< units of length and seconds
};
PathState evaluate(const Segment& segment, double tau);

}  // namespace leadscrew::planner
