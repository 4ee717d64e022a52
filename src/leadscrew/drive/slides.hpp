#pragma once
// The slides of a simulated machine, and what is measured of them.

#include <leadscrew/drive/slide_figures.hpp>
#include <leadscrew/drive/tip_motions.hpp>
#include <leadscrew/kinematics/word_poses.hpp>
#include <leadscrew/referee/referee.hpp>
#include <leadscrew/servo/contour_matcher.hpp>
#include <leadscrew/servo/follower.hpp>
#include <leadscrew/servo/tracking.hpp>

namespace leadscrew::drive {

using servo::LoopKind;

class Slides {
 public:
  /// moves: of the program, for the referee. The machine must outlive the slides. Errors: those of
  /// servo::Follower.
  static base::Result<Slides> create(const machine::Machine& machine, LoopKind kind, referee::MoveSource moves);

  /// What the plan tells of the tool (pipeline::Program::tell_tool), before the word in whose period it happens.
  void observe(const base::PassedEvent& event) { poses_.observe(event); }
  /// The next word. What came of the word before the last; nothing for the first two. Errors: `servo-unstable`.
  base::Result<std::optional<servo::Followed>> follow(const base::Word& word);

  /// After the last word, whose `tick` goes on: has every slide come to rest, or is it hopeless?
  bool has_ended() const { return rests_ || since_end_ > most_after_; }
  /// Call before the word is repeated.
  void end_words() { ending_ = true; }

  double measured_feed() const { return tracking_.measured_feed(); }
  /// Of the periods that have been matched since the last call.
  std::vector<servo::Contour> take_contour();
  /// After the last word: the rest of them.
  std::vector<servo::Contour> finish_contour() {
    matcher_.finish();
    return take_contour();
  }
  std::int64_t contour_stride() const { return matcher_.stride(); }

  /// After finish_contour().
  SlideFigures conclude();

 private:
  Slides(const machine::Machine& machine, referee::MoveSource moves, servo::Follower follower);
  void watch_rest(const servo::Followed& followed);
  void observe_contour(const servo::Followed& followed);
  void note_contour(servo::Contour& contour);
  std::optional<double> settling() const;
  std::vector<std::pair<base::Axis, PulseCounts>> pulses() const;

  const machine::Machine* machine_;
  base::AxisSet axes_;
  servo::Follower follower_;
  servo::Tracking tracking_;
  servo::ContourMatcher matcher_;
  referee::Referee referee_;
  kinematics::WordPoses poses_;
  TipMotions tip_motions_;
  ContourFigures contour_;
  double contour_squares_ = 0;
  std::int64_t contour_count_ = 0;

  bool ending_ = false, rests_ = false;
  std::int64_t quiet_, most_after_;          // periods: of standing that count as rest; after the end, at most
  std::int64_t since_end_ = 0;               // periods
  std::vector<base::AxisVector> after_end_;  // positions
};

}  // namespace leadscrew::drive
