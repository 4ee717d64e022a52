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

#include <cstdint>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/numeric/banded.hpp>
#include <leadscrew/planner/cubic_basis.hpp>
#include <leadscrew/planner/knots.hpp>
#include <leadscrew/planner/section.hpp>
#include <vector>

namespace leadscrew::planner {

class SpeedProfile {
 public:
  /// Creep along the section. The machine must outlive this.
  SpeedProfile(const Section& section, const machine::Machine& machine, Knots knots);

  /// From the present profile, which must be strictly inside, to the optimum within `gap` of its time, relative.
  void optimize(double gap);

  /// Raises stretches at nearly the greatest speed to exactly that speed.
  void level_cruises();

  /// Multiplies the limit rows of the interval by `factor` ≥ 1; creep() must follow.
  void tighten(std::size_t interval, double factor);
  /// The start: a profile strictly inside every limit.
  void creep();

  const Knots& knots() const { return knots_; }
  std::size_t intervals() const { return knots_.s.size() - 1; }
  double width(std::size_t interval) const { return basis_[interval].h; }
  /// x and x′ at u ∈ [0, 1] of an interval.
  double square(std::size_t interval, double u) const { return dot(basis_[interval].value(u), &c_[interval]); }
  double square_slope(std::size_t interval, double u) const { return dot(basis_[interval].slope(u), &c_[interval]); }
  /// Is the speed the same all over the interval?
  bool is_level(std::size_t interval) const;

  /// The largest ratio of the rows: below 1 strictly inside.
  double greatest_ratio() const;
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
    Four x{};
  };
  struct Step {
    double value = 0;  ///< t·T plus barrier; infinite outside
    double time = 0;
  };

  void add_site(std::size_t interval, double u, const geometry::PointJet& jet);
  void add_hull(std::size_t interval, const std::array<const geometry::PointJet*, 3>& jets);
  std::size_t variable(std::size_t coefficient) const;
  double weight(std::size_t coefficient) const;
  void apply(const std::vector<double>& variables);
  Step measure(const std::vector<double>& c, double t) const;
  void assemble(double t);
  bool newton(double t, double& decrement);
  std::size_t constraints() const { return 2 * rows_.size() + caps_.size() + knots_.s.size(); }

  const machine::Machine& machine_;
  Knots knots_;
  std::vector<CubicBasis> basis_;
  std::vector<Four> gauss_;  ///< three places an interval
  std::vector<Site> sites_;
  std::vector<Row> rows_;
  std::vector<double> caps_;       ///< of the coefficients: greatest x around
  std::vector<double> knot_caps_;  ///< of x at the knots
  std::vector<double> tightened_;  ///< of each interval, ≥ 1
  std::array<double, 3> start_tie_{}, end_tie_{};
  std::vector<double> c_;
  std::vector<double> variables_, trial_, trial_c_, step_;
  numeric::BandedMatrix hessian_;
  std::vector<double> gradient_;
  int newton_steps_ = 0;
};

}  // namespace leadscrew::planner
