#pragma once
// The time-optimal, jerk-limited speed along a section, from rest to rest.
//
// The unknown is x(s) = ṡ², a cubic spline with continuous second derivative. With b = x′/2 = s̈ and c = x″/2, s⃛ = c√x,
// every axis has
//
//     q̇ = q′√x        q̈ = A = q″x + q′b        q⃛ = g√x,   g = q‴x + 3q″b + q′c
//
// so that velocity and acceleration are linear in the spline's coefficients and jerk is nearly so. The profile
// minimises
//
//     T = ∫ x^(−1/2) ds     subject to     x ≤ X(s)     |A| ≤ a     g²x ≤ j²
//
// and whatever other rows the constraints give. Each part stands by itself:
//
//     speed_problem   where x is looked at, the rows and caps there: fixed once made
//     speed_bounds    what of them is in force: tightened, relaxed
//     barrier         the solver: iterates from strictly inside to the optimum
//     speed_profile   the profile itself, and how windows of it follow each other
//     emission        as motion in time
//     proof           that it keeps every limit
//
// In the first and the last interval path jerk is constant, x ∝ s^(4/3): the one way in which x leaves rest with finite
// jerk. The start is a creep profile, in closed form and strictly inside every limit.
//
// A long section is planned in windows. A window that begins in motion keeps x, x′ and x″ of where it begins; one that
// ends in motion ends in creep, a share of the creep profile that is a variable like the others. Whatever lies beyond,
// a creeping motion can go on into creep: so the optimum of one window, with creep added, is a start strictly inside
// the next.

#include <cstddef>
#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/planner/barrier.hpp>
#include <leadscrew/planner/continuation.hpp>
#include <leadscrew/planner/knots.hpp>
#include <leadscrew/planner/section.hpp>
#include <leadscrew/planner/speed_bounds.hpp>
#include <leadscrew/planner/speed_problem.hpp>
#include <optional>
#include <span>
#include <vector>

namespace leadscrew::planner {

class SpeedProfile {
 public:
  /// Creep along the section, from rest. Programmed feed is multiplied by `feed_factor`.
  SpeedProfile(const Section& section, const constraints::Constraints& constraints, Knots knots,
               double feed_factor = 1);
  /// Goes on in motion: first interval where the continuation begins, whose knots must be among these. Where that is
  /// faster than the greatest speed (the feed has been overridden since), limits are relaxed to its own speed and
  /// is_too_fast(). `previous`: of the window before, with the same constraints, if it is at hand: spares work.
  SpeedProfile(const Section& section, const constraints::Constraints& constraints, Knots knots, Continuation before,
               double feed_factor = 1, const SpeedProfile* previous = nullptr);
  bool is_too_fast() const { return too_fast_; }

  /// From the present profile down to the greatest speed, or to a creep, as fast as the limits allow; where it cannot
  /// be slower than that, limits are relaxed from then on.
  void descend();
  /// From `first_gap` to within `last_gap` of the cost of that, relative.
  void descend_to_creep(double first_gap, double last_gap);

  /// From the present profile, which must be strictly inside, to the optimum within `gap` of its time, relative.
  /// `first_gap` says how far from the optimum the present profile is.
  void optimize(double first_gap, double gap);

  /// Raises stretches at nearly the greatest speed to exactly that speed.
  void level_cruises();
  void unlevel();

  /// Lowers the limits of the interval by these factors; the present profile must be strictly inside what is left.
  void tighten(std::size_t interval, const Ratios& factors) { bounds_.tighten(interval, factors); }
  /// How far they can be lowered for the present profile to lie on what is left.
  Ratios margin(std::size_t interval) const { return bounds_.margin(problem_, c(), interval); }
  /// Back to the last profile that was at least so much of its time from the optimum, inside the limits.
  void retreat(double gap);
  /// From the present profile straight towards that which retreat(near_inside) would go back to, as far as it takes for what
  /// exceeds limits to come back inside them. `exceeding`: of each interval, by how much, else 1. False, and nothing is
  /// changed, if that is far.
  bool move_inside(std::span<const Ratios> exceeding);
  /// As deep inside the limits as the optimum within `gap` of its time is.
  void center(double gap);
  /// Back to creep; only if the window begins at rest.
  void creep();
  /// Slows the whole window down, v by `factor` < 1; only if it begins at rest.
  void slow_down(double factor);

  /// Gives back the memory that only planning takes: from then on it can be read and gone on from.
  void settle();
  /// Of memory, about, once it is settled.
  std::size_t bytes() const;

  /// To go on from u ∈ [0, 1) of an interval. None where fewer than three knots are left, or if a levelled cruise
  /// there cannot be left as it must be; unlevel() then.
  std::optional<Continuation> continuation(std::size_t interval, double u = 0) const;

  /// Every place on the section is less by `by`.
  void shift(double by) { problem_.shift(by); }

  const Knots& knots() const { return problem_.knots(); }
  std::size_t intervals() const { return problem_.intervals(); }
  bool starts_at_rest() const { return problem_.starts_at_rest(); }
  bool ends_at_rest() const { return problem_.ends_at_rest(); }
  double width(std::size_t interval) const { return basis(interval).h; }
  /// x and x′ at u ∈ [0, 1] of an interval.
  double square(std::size_t interval, double u) const { return dot(basis(interval).value(u), &c()[interval]); }
  double square_slope(std::size_t interval, double u) const { return dot(basis(interval).slope(u), &c()[interval]); }
  double square_bend(std::size_t interval, double u) const { return dot(basis(interval).bend(u), &c()[interval]); }
  /// Is the speed the same all over the interval?
  bool is_level(std::size_t interval) const;

  /// The largest ratio of the rows: below 1 strictly inside.
  double greatest_ratio() const { return bounds_.greatest_ratio(problem_, c()); }
  /// Newton steps so far.
  int newton_steps() const { return newton_steps_; }

 private:
  const CubicBasis& basis(std::size_t interval) const { return problem_.basis()[interval]; }
  const std::vector<double>& c() const { return levelled_.empty() ? iterate_.coefficients() : levelled_; }
  void set(std::vector<double> coefficients);
  void keep(double gap);
  BarrierSolver solver(const SpeedGoal& goal) { return {problem_, bounds_, goal, iterate_, ways_}; }
  void optimize(const SpeedGoal& goal, double first_gap, double gap);
  void clamp_at(Continuation& after, std::size_t interval, double u) const;

  SpeedProblem problem_;
  SpeedBounds bounds_;
  SpeedIterate iterate_;
  std::vector<double> levelled_;  ///< coefficients where cruises have been levelled, else none
  /// Profiles to retreat to, each nearer to the optimum than the last.
  struct Inside {
    double gap = 0;  ///< of the time, to the optimum
    std::vector<double> c;
  };
  std::vector<Inside> inside_;
  SpeedGoal goal_;  ///< creep, once descended to
  bool too_fast_ = false;
  BarrierSolver::Ways ways_;  ///< weighs caps where any of its pieces is under tool centre point control
  int newton_steps_ = 0;
};

}  // namespace leadscrew::planner
