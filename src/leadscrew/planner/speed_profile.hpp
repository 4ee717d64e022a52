#pragma once
// The time-optimal, jerk-limited law of time along a section, from rest to rest.
//
// The unknown is x(s) = ṡ², a cubic spline with continuous second derivative. With b = x′/2 = s̈ and c = x″/2, s⃛ = c√x,
// every axis has
//
//     q̇ = q′√x        q̈ = A = q″x + q′b        q⃛ = g√x,   g = q‴x + 3q″b + q′c
//
// so that velocity and acceleration are linear in the spline's coefficients and jerk is nearly so. The law minimises
//
//     T = ∫ x^(−1/2) ds     subject to     x ≤ X(s)     |A| ≤ a     g²x ≤ j²
//
// at every knot and, as the middle ordinate of the parabola through an interval's ends and middle, between knots, by a
// logarithmic barrier and Newton's method (Boyd and Vandenberghe, "Convex Optimization", ch. 11) with a banded
// factorisation: linear in the number of knots. In the first and the last interval path jerk is constant, x ∝ s^(4/3):
// the one way in which x leaves rest with finite jerk. The start is a creep profile, in closed form and strictly inside
// every limit.
//
// A long section is planned in windows. A window that begins in motion keeps x, x′ and x″ of where it begins; one that
// ends in motion ends in creep, a share of the creep profile that is a variable like the others. Whatever lies beyond,
// a creeping motion can go on into creep: so the optimum of one window, with creep added, is a start strictly inside
// the next.

#include <algorithm>
#include <cstdint>
#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/numeric/banded.hpp>
#include <leadscrew/planner/cubic_basis.hpp>
#include <leadscrew/planner/knots.hpp>
#include <leadscrew/planner/section.hpp>
#include <optional>
#include <vector>

namespace leadscrew::planner {

/// What a window that begins in motion takes over from the one before.
struct Continuation {
  std::vector<double> s;          ///< knots from where it begins on, on the section
  std::vector<bool> breaks;       ///< of these
  double end_ramp = 0;            ///< after the last of them; 0 if it ends in motion
  std::vector<double> c;          ///< coefficients of the spline clamped where it begins, as far as they are known
  std::size_t creeping = 0;       ///< the first of them that may yet be lowered; those before must stay
  std::size_t loose = 0;          ///< intervals whose rows need not be tightened for a stop
  std::vector<double> tightened;  ///< of each interval, ≥ 1: how far its rows were
  double share = 1;               ///< of the creep profile, for what follows them

  /// A knot more, between the first and the last; the spline stays as it is. The parts of an interval that it divides
  /// are tightened as that was.
  void insert(double knot);
};

/// What motion takes of the limits, or what limits are lowered by.
struct Ratios {
  double speed = 1;  ///< of the feed and of axis velocities
  double rows = 1;   ///< of acceleration and jerk
  bool turns_back = false;
  double worst() const { return std::max(speed, rows); }
};

class SpeedProfile {
 public:
  /// Creep along the section, from rest. Programmed feed is multiplied by `feed_factor`.
  SpeedProfile(const Section& section, const constraints::Constraints& constraints, Knots knots,
               double feed_factor = 1);
  /// Goes on in motion: first interval where the continuation begins, whose knots must be among these. Where that is
  /// faster than the greatest speed (the feed has been overridden since), its own speed is granted and is_too_fast().
  SpeedProfile(const Section& section, const constraints::Constraints& constraints, Knots knots, Continuation before,
               double feed_factor = 1);
  bool is_too_fast() const { return too_fast_; }

  /// From the present profile down to the greatest speed, or to a creep, as fast as the limits allow; what it cannot be
  /// slower than is granted from then on.
  void descend();
  void descend_to_creep();

  /// From the present profile, which must be strictly inside, to the optimum within `gap` of its time, relative.
  /// `first_gap` says how far from the optimum the present profile is.
  void optimize(double first_gap, double gap);

  /// Raises stretches at nearly the greatest speed to exactly that speed.
  void level_cruises();
  void unlevel();

  /// Lowers the limits of the interval by these factors; the present profile must be strictly inside what is left.
  void tighten(std::size_t interval, const Ratios& factors);
  /// How far they can be lowered for the present profile to lie on what is left.
  Ratios room(std::size_t interval) const;
  /// Back to the last profile that was at least a tenth of its time from the optimum, far inside the limits.
  void retreat();
  /// As deep inside the limits as the optimum within `gap` of its time is.
  void center(double gap);
  /// Back to creep; only if the window begins at rest.
  void creep();
  /// Slows the whole window down, v by `factor` < 1; only if it begins at rest.
  void slow_down(double factor);

  /// Gives back the memory that only planning takes: from then on it can be read and gone on from.
  void settle();

  /// To go on from u ∈ [0, 1) of an interval. None where fewer than three knots are left, or if a levelled cruise
  /// there cannot be left as it must be; unlevel() then.
  std::optional<Continuation> continuation(std::size_t interval, double u = 0) const;

  /// Every place on the section is less by `by`.
  void shift(double by);

  const Knots& knots() const { return knots_; }
  std::size_t intervals() const { return knots_.intervals; }
  bool starts_at_rest() const { return knots_.start_ramp > 0; }
  bool ends_at_rest() const { return knots_.end_ramp > 0; }
  double width(std::size_t interval) const { return basis_[interval].h; }
  /// x and x′ at u ∈ [0, 1] of an interval.
  double square(std::size_t interval, double u) const { return dot(basis_[interval].value(u), &c_[interval]); }
  double square_slope(std::size_t interval, double u) const { return dot(basis_[interval].slope(u), &c_[interval]); }
  double square_bend(std::size_t interval, double u) const { return dot(basis_[interval].bend(u), &c_[interval]); }
  /// Is the speed the same all over the interval?
  bool is_level(std::size_t interval) const;

  /// The largest ratio of the rows: below 1 strictly inside.
  double greatest_ratio() const { return greatest_ratio(c_, 0); }
  /// Newton steps so far.
  int newton_steps() const { return newton_steps_; }

 private:
  /// A (by limit) and g (by limit) of one axis, as functions of the four coefficients of the interval.
  struct Row {
    Four acceleration{}, jerk{};
  };
  /// A place of an interval where limits are kept; `x` is what g² is multiplied by.
  struct Site {
    std::uint32_t interval = 0, first_row = 0, end_row = 0;
    bool hull = false;
    double factor = 1;  ///< of its rows, ≤ 1: a little more may have been granted
    Four x{};
  };
  double greatest_of_rows(const Site& site, const std::vector<double>& c) const;
  double greatest_ratio(const std::vector<double>& c, std::size_t from) const;
  struct Step {
    double value = 0;      ///< t·T plus barrier; infinite outside
    double objective = 0;  ///< T, and what is above the wanted speed
  };

  void build(const Section& section, const constraints::Constraints& constraints, const Continuation& before,
             double feed_factor);
  bool grant(double margin);
  void loosen();
  void find_creep();
  void tie_variables();
  void read_variables();
  void add_site(std::size_t interval, double u, const constraints::RowPairs& at);
  void add_hull(std::size_t interval, const std::array<const constraints::RowPairs*, 3>& at);
  Step measure(const std::vector<double>& c, double t) const;
  void assemble(double t);
  bool newton(double t, Step& at, double& decrement);
  Step follow(double t);
  void keep_far_inside();
  std::size_t constraints() const { return 2 * (rows_.size() + caps_.size() + intervals()) + 1; }
  bool is_free(std::size_t coefficient) const { return variable_[coefficient] >= 0; }

  Knots knots_;
  std::vector<CubicBasis> basis_;
  std::vector<Four> gauss_;  ///< three places an interval
  std::vector<Site> sites_;
  std::vector<Row> rows_;
  std::vector<double> caps_;                                              ///< of the coefficients: greatest x around
  std::vector<double> asked_caps_, asked_knot_caps_, asked_middle_caps_;  ///< before anything was granted
  std::vector<double> wanted_;  ///< x at the Gauss places, while it is descended to
  bool too_fast_ = false;
  std::vector<double> floors_;       ///< of the coefficients, while a lower speed is descended to
  std::vector<double> knot_caps_;    ///< of x at the knots
  std::vector<double> middle_caps_;  ///< of x in the middle of the intervals
  std::vector<double> tightened_;    ///< of each interval, ≥ 1
  std::array<double, 3> start_tie_{}, end_tie_{};
  std::vector<double> creep_;  ///< coefficients; any between 0 and these are inside, those tied kept in proportion
  std::vector<std::int32_t> variable_;  ///< of each coefficient; −1 if it is given
  std::vector<double> weight_;          ///< coefficient over variable
  std::vector<double> c_, far_inside_, before_levelling_;
  std::vector<double> variables_, trial_, trial_c_, step_;
  numeric::BandedMatrix<3> hessian_;
  std::vector<double> gradient_;
  int newton_steps_ = 0;
};

}  // namespace leadscrew::planner
