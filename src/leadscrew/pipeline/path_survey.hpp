#pragma once
// What can be told of a program before motion is planned: how far its path goes, the least time it takes, and F words
// that no motion can keep, because an axis is slower.
//
// Path and bound are those of a run (MotionSource, planner::TimeBound): the tool path with its blends and fits.

#include <cstdint>
#include <leadscrew/base/borrowed.hpp>
#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/planner/time_bound.hpp>
#include <leadscrew/toolpath/builder.hpp>
#include <optional>
#include <set>

namespace leadscrew::pipeline {

/// A feed that an axis does not keep up with somewhere in a block, mm/s; degrees/s where rotary axes alone are fed.
struct FeedExcess {
  base::Axis axis{};
  bool is_rotary = false;  ///< degrees/s
  double asked = 0;
  double possible = 0;  ///< the least of the block by velocities of axes
};

class PathSurvey {
 public:
  /// From `start`, mm or degrees. The machine must outlive this.
  PathSurvey(base::Borrowed<machine::Machine> machine, const geometry::Point& start);

  /// Each move of a program without errors, in order. Returns an excess of its feed by more than 0.1 %, once for each
  /// line of the program, and of no more than 50 lines.
  std::optional<FeedExcess> observe(const gcode::Move& move);
  /// No more moves will come.
  void finish();

  /// Complete after finish(). Greatest and least coordinates of the tool path, its start included, mm or degrees.
  const geometry::Point& least() const { return least_; }
  const geometry::Point& greatest() const { return greatest_; }
  double bound_seconds() const { return bound_.seconds(); }

 private:
  std::optional<FeedExcess> excess_of(const gcode::Move& move) const;
  void lower(const geometry::PointJet& jet, double rate, FeedExcess& excess) const;
  void take(const toolpath::Element& element);
  void settle();

  const machine::Machine& machine_;
  constraints::Constraints constraints_;
  toolpath::Builder builder_;
  planner::TimeBound bound_;
  geometry::Point least_, greatest_;
  std::set<base::Line> lines_;  ///< whose excess was returned
};

}  // namespace leadscrew::pipeline
