#pragma once
// From moves to the tool path, streaming: moves are pushed, and elements come out once nothing ahead can change them.
//
// In exact-path and exact-stop mode (G61, G61.1) every move is kept as programmed, a NURBS curve as its smooth pieces
// (geometry::smooth_pieces). Where blending is asked for (G64), moves that follow one another without a dwell or an
// event that motion rests for are smoothed together, each within its tolerance (Smoother). All other events lie where
// the move begins that follows them, or stand by themselves where motion rests before there is one.

#include <deque>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <leadscrew/toolpath/smoother.hpp>
#include <optional>
#include <vector>

namespace leadscrew::toolpath {

class Builder {
 public:
  /// sampling: what is kept of tolerances for chords between words.
  explicit Builder(const Sampling& sampling = {}) : sampling_(sampling) {}

  void push(const gcode::Move& move);
  /// No more moves will come.
  void finish();
  /// The next element that is settled, if there is one.
  std::optional<Element> pop();

 private:
  void move_along(const gcode::Move& move);
  void flush();
  void settle_events(bool motion_follows);

  Sampling sampling_;
  std::optional<Smoother> smoother_;
  std::vector<EventMark> passed_;  ///< events where the next move begins
  std::deque<Element> settled_;
};

}  // namespace leadscrew::toolpath
