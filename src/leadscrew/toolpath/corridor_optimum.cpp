#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/toolpath/corridor_barrier.hpp>
#include <leadscrew/toolpath/corridor_optimum.hpp>
#include <leadscrew/toolpath/tuning.hpp>
#include <utility>

namespace leadscrew::toolpath {

namespace {

using namespace tuning::corridor;

template <std::size_t D>
class Descent {
 public:
  Descent(const Corridor<D>& corridor, const TimeSpline<D>& start)
      : barrier_(corridor, start.intervals(), inside * start.interval),
        at_{start.points, 1},
        passing_{start.passes, {}} {
    barrier_.assign(passing_);
  }

  bool is_inside() const { return std::isfinite(barrier_.value(0, at_, passing_)); }

  void optimize() {
    const double count = barrier_.inequalities();
    for (double t = count / (first_gap * at_.w);; t *= growth_of_weight) {
      follow(t);
      if (count / (t * at_.w) < last_gap) return;
    }
  }

  TimeSpline<D> result() const {
    return {at_.points, passing_.passes, barrier_.start_interval() * numeric::cbrt(at_.w)};
  }

 private:
  static constexpr double inside = 1.1;  // of the start's interval: inside every limit

  /// Towards the barrier's minimum at t.
  void follow(double t) {
    double before = barrier_.value(t, at_, passing_), last_looked = before;
    for (int k = 1; k <= most_steps; ++k) {
      barrier_.assemble(t, at_, passing_, model_);
      double w_step = 0;
      const double decrement = model_.solve(damping_, step_, w_step);
      const bool is_descent = std::isfinite(decrement) && decrement > 0;
      const double after = is_descent ? descend(t, w_step, decrement, before) : before;
      if (!(after < before)) {
        if (damping_ >= most_damping) return;
        damping_ = std::min(change_of_damping * change_of_damping * damping_, most_damping);
        continue;
      }
      before = after;
      if (decrement < enough_decrement) return;
      if (k % patience == 0 && std::exchange(last_looked, after) - after < least_fall) return;
    }
  }

  /// As long a step as the barrier falls; returns its value then.
  double descend(double t, double w_step, double decrement, double before) {
    constexpr double shortest = 1e-9, armijo = 1e-4;
    const auto falls = [&](double value, double length) { return value < before - armijo * length * decrement; };
    trial_.points.resize(at_.points.size());
    for (double length = 1; length > shortest; length /= 2) {
      for (std::size_t k = 0; k < trial_.points.size(); ++k) trial_.points[k] = along(at_.points[k], length, step_[k]);
      trial_.w = at_.w + length * w_step;
      followed_.passes = passing_.passes;
      barrier_.follow(trial_.points, followed_.passes);
      barrier_.assign(followed_);
      double after = barrier_.value(t, trial_, followed_);
      // A knot that comes to a slower leg may be too fast there yet.
      if (!falls(after, length)) {
        followed_ = passing_;
        after = barrier_.value(t, trial_, followed_);
      }
      if (!falls(after, length)) continue;
      std::swap(at_, trial_);
      std::swap(passing_, followed_);
      adapt_damping(length);
      return after;
    }
    return before;
  }

  /// As a step of that length says of the model.
  void adapt_damping(double length) {
    constexpr double long_step = 0.5, short_step = 0.1;
    if (length >= long_step) damping_ = std::max(damping_ / change_of_damping, least_damping);
    if (length < short_step) damping_ = std::min(damping_ * change_of_damping, most_damping);
  }

  CorridorBarrier<D> barrier_;
  CorridorPoint<D> at_, trial_;
  Passing passing_, followed_;
  NewtonModel<D> model_;
  std::vector<Vector<D>> step_;
  double damping_ = least_damping;
};

}  // namespace

template <std::size_t D>
std::optional<TimeSpline<D>> least_time(const Corridor<D>& corridor, const TimeSpline<D>& start) {
  Descent<D> descent(corridor, start);
  if (!descent.is_inside()) return std::nullopt;
  descent.optimize();
  return descent.result();
}

template std::optional<TimeSpline<2>> least_time<2>(const Corridor<2>&, const TimeSpline<2>&);
template std::optional<TimeSpline<3>> least_time<3>(const Corridor<3>&, const TimeSpline<3>&);

}  // namespace leadscrew::toolpath
