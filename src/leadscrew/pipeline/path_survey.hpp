#pragma once
// What can be told of a program before motion is planned: how far its path goes, a time that it takes at least, and F
// words that no motion can keep.

#include <leadscrew/base/borrowed.hpp>
#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/pipeline/feed_check.hpp>
#include <leadscrew/planner/time_bound.hpp>
#include <leadscrew/toolpath/builder.hpp>
#include <optional>

namespace leadscrew::pipeline {

class Survey {
 public:
  virtual ~Survey() = default;

  /// Each move of a program without errors, in order. Returns what FeedCheck does of it.
  virtual std::optional<FeedExcess> observe(const gcode::Move& move) = 0;
  /// No more moves will come.
  virtual void finish() {}
  /// Complete after finish().
  virtual double bound_seconds() const = 0;

  /// Complete after finish(). Greatest and least coordinates of the path, its start included, mm or degrees.
  const geometry::Point& least() const { return least_; }
  const geometry::Point& greatest() const { return greatest_; }

 protected:
  /// From `start`, mm or degrees.
  explicit Survey(const geometry::Point& start) : least_(start), greatest_(start) {}
  Survey(const Survey&) = delete;
  Survey& operator=(const Survey&) = delete;

  geometry::Point least_, greatest_;
};

/// Path and bound are those of a run (MotionSource, planner::TimeBound): the tool path with its blends and fits, whose
/// tables of arc length suffice for a time.
class PathSurvey : public Survey {
 public:
  /// The machine must outlive this.
  PathSurvey(base::Borrowed<machine::Machine> machine, const geometry::Point& start);

  std::optional<FeedExcess> observe(const gcode::Move& move) override;
  void finish() override;
  double bound_seconds() const override { return bound_.seconds(); }

 private:
  void take(const toolpath::Element& element);
  void settle();

  const machine::Machine& machine_;
  constraints::Constraints constraints_;
  FeedCheck feeds_;
  toolpath::Builder builder_;
  planner::TimeBound bound_;
};

/// The path as it was programmed, without blends and fits, and a bound by feed and the velocities of axes alone: as quick
/// as reading. A motion that passes within the tolerances of every joint of blocks takes no less time than this.
class QuickSurvey : public Survey {
 public:
  /// The machine must outlive this.
  QuickSurvey(base::Borrowed<machine::Machine> machine, const geometry::Point& start);

  std::optional<FeedExcess> observe(const gcode::Move& move) override;
  void finish() override { end_chain(); }
  double bound_seconds() const override { return seconds_; }

 private:
  void observe_tip(const gcode::Move& move);
  std::optional<FeedExcess> observe_move(const gcode::Move& move);
  std::optional<FeedExcess> observe_line(const gcode::Move& move);
  std::optional<FeedExcess> observe_curve(const gcode::Move& move);
  void chain_on(const gcode::Move& move);
  void end_chain();

  // Lines so short that tolerances at their ends are much of them, taken together: from where, to where, by the fastest
  // of their feeds, mm/s; 0 where there are none.
  struct Chain {
    geometry::Point start{}, end{};
    double feed = 0;
    double cut = 0;  // mm
  };

  const machine::Machine& machine_;
  toolpath::TransformationOfMoves transformations_;
  constraints::Constraints constraints_;
  FeedCheck feeds_;
  geometry::Point
      slowness_{};  ///< the reciprocal of each axis' velocity, s/mm or s/degree; 0 for an axis that is lacking
  Chain chain_;
  double seconds_ = 0;
  bool is_in_step_ = false;  ///< with a spindle
};

}  // namespace leadscrew::pipeline
