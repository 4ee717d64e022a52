#include <algorithm>
#include <cmath>
#include <leadscrew/study/tube_barrier.hpp>
#include <leadscrew/study/tube_optimum.hpp>
#include <utility>

namespace leadscrew::study {

namespace {

using Passes = TubeBarrier::Passes;

constexpr double first_gap = 1, growth_of_weight = 6;
constexpr double enough_decrement = 0.1;

class TubeDescent {
 public:
  TubeDescent(const Tube& tube, const TubeMotion& start)
      : tube_(tube),
        barrier_(tube, start.interval * inside),
        interval_(start.interval * inside),
        at_{start.points, 1},
        assignment_(assigned(tube, start.points, start.passes)) {}

  void optimize(double gap) {
    const double count = barrier_.inequalities(at_.points.size() - 3);
    for (double t = count / first_gap;; t *= growth_of_weight) {
      follow(t);
      if (count / (t * at_.w) < gap) break;
    }
  }

  TubeOptimum result() const { return {{at_.points, assignment_.passes, interval_ * std::cbrt(at_.w)}, newton_steps_}; }

 private:
  static constexpr double inside = 1.1;  // of the start's interval: inside every limit

  enum class Outcome : bool { converged, stuck };

  /// To the barrier's minimum at t.
  void follow(double t) {
    constexpr int rounds = 20, most_following = 1000, most_fixed = 60;
    constexpr double little = 0.3;  // of the barrier: 1 is what a step at its end gains
    for (int round = 0; round < rounds; ++round) {
      const double before = barrier_.value(t, at_, assignment_);
      follow_passes(t);
      const auto [following, steps] = newton(t, Passes::following, most_following);
      const auto [fixed, more] = newton(t, Passes::fixed, most_fixed);
      if (following == Outcome::converged && more <= 1) return;
      if (before - barrier_.value(t, at_, assignment_) < little) return;
    }
  }

  /// Takes over the nearest passes where that leaves no knot outside.
  void follow_passes(double t) {
    TubeAssignment followed = followed_by(at_.points);
    if (barrier_.value(t, at_, followed) <= barrier_.value(t, at_, assignment_) + 1e-9)
      assignment_ = std::move(followed);
  }

  TubeAssignment followed_by(const std::vector<PlaneVector>& points) const {
    return assigned(tube_, points, nearest_passes(tube_, points, assignment_.passes));
  }

  /// Returns how it ended and after how many steps.
  std::pair<Outcome, int> newton(double t, Passes passes, int most) {
    constexpr int patience = 40;
    constexpr double fall = 4;  // of the barrier, in so many steps
    double before = barrier_.value(t, at_, assignment_);
    for (int steps = 1; steps <= most; ++steps) {
      ++newton_steps_;
      if (steps % patience == 0) {
        const double now = barrier_.value(t, at_, assignment_);
        if (std::exchange(before, now) - now < fall) return {Outcome::stuck, steps};
      }
      barrier_.assemble(t, at_, assignment_, passes, model_);
      const TubeModel::Step step = model_.newton_step();
      if (!std::isfinite(step.decrement) || !descend(t, step, passes)) return {Outcome::stuck, steps};
      if (step.decrement < enough_decrement) return {Outcome::converged, steps};
    }
    return {Outcome::stuck, most};
  }

  /// As long a step as the barrier falls; false where none is.
  bool descend(double t, const TubeModel::Step& step, Passes passes) {
    const double before = barrier_.value(t, at_, assignment_);
    const std::vector<double> slacks = pass_slacks(tube_, at_.points, assignment_);
    TubeIterate trial = at_;
    for (double length = 1; length > 1e-18; length /= 2) {
      for (std::size_t k = 0; k < trial.points.size(); ++k) trial.points[k] = at_.points[k] + length * step.points[k];
      trial.w = at_.w + length * step.w;
      TubeAssignment assignment = passes == Passes::following ? followed_by(trial.points) : assignment_;
      if (passes == Passes::following && comes_too_near(slacks, trial.points, assignment)) continue;
      const double after = barrier_.value(t, trial, assignment);
      if (!(after < before - 1e-4 * length * step.decrement + 1e-15 * std::abs(before))) continue;
      at_ = std::move(trial);
      assignment_ = std::move(assignment);
      return true;
    }
    return false;
  }

  /// Whether a joint would be passed so near the tolerance at once that the next steps are lost on leaving it.
  bool comes_too_near(const std::vector<double>& before, const std::vector<PlaneVector>& points,
                      const TubeAssignment& assignment) const {
    constexpr double least_share = 0.2;
    const std::vector<double> after = pass_slacks(tube_, points, assignment);
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (!(after[i] >= least_share * before[i])) return true;
    }
    return false;
  }

  const Tube& tube_;
  TubeBarrier barrier_;
  double interval_;
  TubeIterate at_;
  TubeAssignment assignment_;
  TubeModel model_;
  int newton_steps_ = 0;
};

/// About what each leg takes with a stop at its ends: by jerk, acceleration or feed, whichever holds it back most.
std::vector<double> shares_of(const Tube& tube) {
  std::vector<double> shares;
  for (const TubeLeg& leg : tube.legs) {
    const double length = leg.length();
    shares.push_back(std::max(
        {std::cbrt(32 * length / tube.jerk), 2 * std::sqrt(length / tube.acceleration), 1.2 * length / tube.feed}));
  }
  return shares;
}

TubeOptimum optimum_from(const Tube& tube, const std::vector<double>& shares, std::size_t intervals, double gap) {
  TubeDescent descent(tube, stopping_motion(tube, intervals, shares));
  descent.optimize(gap);
  return descent.result();
}

/// Of each leg, as the motion passes the joints.
std::vector<double> shares_of(const TubeMotion& motion) {
  std::vector<double> shares;
  double before = 0;
  for (const double pass : motion.passes) shares.push_back(pass - std::exchange(before, pass));
  shares.push_back(static_cast<double>(motion.intervals()) - before);
  return shares;
}

}  // namespace

TubeOptimum least_time_motion(const Tube& tube, const TubeOptions& options) {
  const std::vector<double> shares = options.shares.empty() ? shares_of(tube) : options.shares;
  if (options.intervals > 0) return optimum_from(tube, shares, options.intervals, options.gap);

  // A coarse motion says how long it takes and when it passes the joints.
  constexpr double millisecond = 1e-3, stop_share = 0.7, coarse_gap = 1e-3;
  double stopping = 0;
  for (const double share : shares_of(tube)) stopping += share;
  const auto few = static_cast<std::size_t>(std::ceil(stop_share * stopping / millisecond));
  const TubeOptimum coarse = optimum_from(tube, shares, std::max(few, 8 * tube.legs.size()), coarse_gap);
  const auto words = static_cast<std::size_t>(std::ceil(1.002 * coarse.motion.seconds() / millisecond));
  TubeOptimum fine = optimum_from(tube, shares_of(coarse.motion), 2 * words, options.gap);
  fine.newton_steps += coarse.newton_steps;
  return fine;
}

}  // namespace leadscrew::study
