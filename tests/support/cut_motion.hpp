#pragma once
// Chunks made by hand: a time law of constant jerks along a path, cut into chunks wherever one likes, each with a tail
// that brakes with the same jerk. Nothing here asks a planner.
//
//   rest to rest    jerk +j, −j, 0, −j, +j; distance = 2vt + v·(time at v), t = √(v/j)
//   to rest from v, a    jerk −j until the deceleration is d, then +j until it is 0:  d² = jv + a²/2

#include <algorithm>
#include <cmath>
#include <leadscrew/planner/motion.hpp>
#include <leadscrew/toolpath/travel.hpp>
#include <vector>

namespace leadscrew::testing_support {

struct AlongPath {
  double s = 0, speed = 0, acceleration = 0;
};

struct Phase {
  double begin = 0, duration = 0;  ///< seconds
  AlongPath from;
  double jerk = 0;

  double end() const { return begin + duration; }
  AlongPath at(double time) const {
    const double t = time - begin;
    return {from.s + t * (from.speed + t * (from.acceleration / 2 + t * jerk / 6)),
            from.speed + t * (from.acceleration + t * jerk / 2), from.acceleration + t * jerk};
  }
};

using Law = std::vector<Phase>;

inline void append(Law& law, double duration, double jerk) {
  Phase next = law.back();
  next.from = next.at(next.end());
  next.begin = next.end();
  next.duration = std::max(duration, 0.0);
  next.jerk = jerk;
  law.push_back(next);
}

inline Law rest_to_rest(double from, double to, double speed, double jerk) {
  const double v = std::min(speed, std::cbrt((to - from) * (to - from) * jerk / 4)), t = std::sqrt(v / jerk);
  Law law = {{0, t, {from, 0, 0}, jerk}};
  append(law, t, -jerk);
  append(law, (to - from) / v - 2 * t, 0);
  law.back().from = {from + v * t, v, 0};
  append(law, t, -jerk);
  append(law, t, jerk);
  return law;
}

inline AlongPath at(const Law& law, double time) {
  const auto later = std::find_if(law.begin(), law.end(), [&](const Phase& phase) { return time < phase.end(); });
  return (later == law.end() ? law.back() : *later).at(time);
}

inline Law braking(double begin, const AlongPath& from, double jerk) {
  const double d = std::sqrt(std::max(0.0, jerk * from.speed + from.acceleration * from.acceleration / 2));
  Law law = {{begin, std::max(0.0, (d + from.acceleration) / jerk), from, -jerk}};
  append(law, d / jerk, jerk);
  return law;
}

struct Path {
  std::vector<toolpath::Piece> pieces;
  machine::Machine machine = machine::mill3();  ///< inside whose travel they are

  double length() const { return offset(pieces.size()); }
  /// Length of the pieces before this one.
  double offset(std::size_t piece) const {
    double sum = 0;
    for (std::size_t k = 0; k < piece; ++k) sum += geometry::length(pieces[k].curve);
    return sum;
  }
  std::size_t piece_at(double s) const {
    std::size_t piece = 0;
    while (piece + 1 < pieces.size() && offset(piece + 1) <= s) ++piece;
    return piece;
  }
  geometry::Point at(double s) const {
    const std::size_t piece = piece_at(s);
    return pieces[piece].axes().position(s - offset(piece));
  }
};

struct CutChunk {
  planner::Chunk chunk;
  double begin = 0, end = 0;  ///< of the committed part, along the path
  double rest = 0;            ///< where it comes to rest, along the path
};

/// Lays laws out along a path, segment after segment, a segment ending where a piece does.
class Layer {
 public:
  /// Begins on the piece that holds s; time 0 is at `zero` of the laws.
  Layer(const Path& path, double s, double zero) : path_(path), first_(path.piece_at(s)), piece_(first_), zero_(zero) {}

  void lay(const Law& law, double from, double to, std::vector<planner::Segment>& segments) {
    for (const Phase& phase : law) {
      const double begin = std::max(from, phase.begin), end = &phase == &law.back() ? to : std::min(to, phase.end());
      if (begin < end) lay(phase, begin, end, segments);
    }
  }

  /// Of all that was laid out.
  std::vector<toolpath::Piece> pieces() const {
    std::vector<toolpath::Piece> pieces(path_.pieces.begin() + static_cast<std::ptrdiff_t>(first_),
                                        path_.pieces.begin() + static_cast<std::ptrdiff_t>(piece_) + 1);
    for (toolpath::Piece& piece : pieces) toolpath::check_travel(piece, path_.machine, {}, 0);
    return pieces;
  }

 private:
  void lay(const Phase& phase, double begin, double end, std::vector<planner::Segment>& segments) {
    bool is_at_start = false;
    while (piece_ + 1 < path_.pieces.size() && path_.offset(piece_ + 1) < phase.at(end).s) {
      double before = begin, after = end;
      for (int halving = 0; halving < 100; ++halving) {
        const double middle = (before + after) / 2;
        (phase.at(middle).s < path_.offset(piece_ + 1) ? before : after) = middle;
      }
      if (begin < after) push(phase, begin, after, is_at_start, segments);
      begin = after;
      ++piece_;
      is_at_start = true;
    }
    push(phase, begin, end, is_at_start, segments);
  }

  void push(const Phase& phase, double begin, double end, bool is_at_start, std::vector<planner::Segment>& segments) {
    const AlongPath at = phase.at(begin);
    planner::Segment segment;
    segment.begin = begin - zero_;
    segment.duration = end - begin;
    segment.s0 = is_at_start ? 0 : std::max(0.0, at.s - path_.offset(piece_));
    segment.v0 = at.speed;
    segment.c2 = at.acceleration / 2;
    segment.c3 = phase.jerk / 6;
    segment.piece = static_cast<std::uint32_t>(piece_ - first_);
    const bool is_constant = at.acceleration == 0 && phase.jerk == 0;
    segment.state = is_constant ? base::MotionState::constant : base::MotionState::changing;
    segments.push_back(segment);
  }

  const Path& path_;
  std::size_t first_, piece_;
  double zero_;
};

/// From rest to rest along a part of the path, in chunks of `seconds` each; all but the last have a tail.
inline std::vector<CutChunk> cut_motion(const Path& path, double from, double to, double speed, double jerk,
                                        double seconds) {
  const Law law = rest_to_rest(from, to, speed, jerk);
  const double whole = law.back().end();
  const int count = std::max(1, static_cast<int>(whole / seconds));
  std::vector<CutChunk> cuts;
  for (int k = 0; k < count; ++k) {
    const double begin = k * whole / count, end = k + 1 == count ? whole : (k + 1) * whole / count;
    const AlongPath there = at(law, end);
    CutChunk cut;
    planner::Chunk& chunk = cut.chunk;
    cut.begin = cuts.empty() ? from : cuts.back().end;
    cut.end = cut.rest = k + 1 == count ? to : there.s;
    Layer layer(path, cut.begin, begin);
    layer.lay(law, begin, end, chunk.segments);
    chunk.duration = end - begin;
    if (k + 1 < count) {
      const Law tail = braking(end, there, jerk);
      layer.lay(tail, end, tail.back().end(), chunk.stop_tail);
      cut.rest = std::min(to, tail.back().at(tail.back().end()).s);
    }
    chunk.pieces = layer.pieces();
    chunk.length = cut.end - cut.begin;
    chunk.tail_length = cut.rest - cut.end;
    chunk.rest = path.at(cut.rest);
    chunk.rest_line = chunk.pieces.back().line;
    cuts.push_back(std::move(cut));
  }
  return cuts;
}

inline planner::Chunk dwell(const geometry::Point& where, double seconds) {
  planner::Segment standing;
  standing.duration = seconds;
  standing.state = base::MotionState::rest;
  planner::Chunk chunk;
  chunk.segments = {standing};
  chunk.duration = seconds;
  chunk.rest = where;
  return chunk;
}

}  // namespace leadscrew::testing_support
