#pragma once
// The least time by a logarithmic barrier and Newton's method (Boyd and Vandenberghe, "Convex Optimization", ch. 11)
// with a banded factorisation: linear in the number of knots.
//
//     minimise  t·(T + E) − Σ log(1 − ratio)        T = ∫ x^(−1/2) ds, ratios of caps c/C, of rows A² and g²x
//
// for t that grows until the distance from the optimum, at most the number of inequalities over t, is small enough. The
// Hessian is that of the primal-dual method (ibid., 11.7): a limit that is to be approached pulls by its multiplier, not
// by how near it is, and t may grow faster. Every step is still one down the barrier's value, inside every limit. E is 0 but where a speed is wanted that lies below the present one: what is above it costs more than time.

#include <cstddef>
#include <leadscrew/numeric/banded.hpp>
#include <leadscrew/planner/barrier_kernels.hpp>
#include <leadscrew/planner/speed_bounds.hpp>
#include <leadscrew/planner/speed_problem.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <span>
#include <vector>

namespace leadscrew::planner {

/// The speed that is wanted; time alone counts where nothing is said.
struct SpeedGoal {
  std::vector<double> wanted;  ///< x at the problem's Gauss places; none: as great as can be
  std::vector<double> floors;  ///< of the coefficients, which stay strictly above; none: 0
};

/// Coefficients of x, and the variables that they come from.
class SpeedIterate {
 public:
  /// Coefficients that are given stay as they are here.
  void set(const SpeedProblem& problem, std::vector<double> coefficients);

  const std::vector<double>& coefficients() const { return c_; }
  const std::vector<double>& variables() const { return variables_; }
  /// Less `length` times the direction, a number for each variable.
  void step_back(const SpeedProblem& problem, std::span<const double> direction, double length, SpeedIterate& to) const;

 private:
  std::vector<double> c_, variables_;
};

/// One use: from a start strictly inside the bounds. What it is given must outlive it; the bounds may be relaxed less
/// between stages.
class BarrierSolver {
 public:
  struct Ways {
    /// Caps of intervals that are passed in less than the mean of their times, and caps and floors of the coefficients there,
    /// weigh as much less in the barrier. All the same, they would keep x the farther off the cap the closer knots lie.
    bool weighs_caps = false;
    /// Along a path of least time: t grows slower, and where a stage loses the optimum that was followed, the next one is
    /// sought from far inside.
    bool is_of_least_time = false;
  };
  BarrierSolver(const SpeedProblem& problem, const SpeedBounds& bounds, const SpeedGoal& goal, SpeedIterate& iterate,
                Ways ways);

  /// From `first_gap` of the objective, relative, to within `gap` of the optimum. stage_ended(left) is called after every
  /// stage but the last, `left` of the objective from it.
  template <typename StageEnded>
  void optimize(double first_gap, double gap, const StageEnded& stage_ended) {
    double t = begin(first_gap);
    for (int stage = 0; stage < most_stages; ++stage) {
      const double left = inequalities_ / t / follow(t);
      if (is_lost_ && !was_lost_) {
        was_lost_ = true;
        t = begin(tuning::barrier::found_again);
        continue;
      }
      if (left < gap) break;
      stage_ended(left);
      t = grown(t, 1.01 * left / gap);
    }
  }
  /// As deep inside the bounds as the optimum within `gap` is.
  void center(double gap) { follow(begin(gap)); }

  int newton_steps() const { return newton_steps_; }

 private:
  struct Step {
    double value = 0;      ///< t·objective plus barrier; infinite outside
    double objective = 0;  ///< T + E
  };
  class Product;
  static constexpr int most_stages = 40, most_attempts = 60;

  void weigh_caps();
  std::uint8_t weight_index(std::size_t coefficient) const { return weights_.empty() ? 0 : weights_[coefficient]; }
  double weight(std::size_t coefficient) const { return cap_weights[weight_index(coefficient)]; }
  double begin(double gap);
  double grown(double t, double most);
  double follow(double t);
  bool newton(double t, Step& at, double& decrement);
  bool is_inside(std::size_t interval, double length) const;
  void find_direction(double t);
  Step measure(std::span<const double> c, double t, BarrierValues& values) const;
  bool measure_coefficients(std::span<const double> c, Product& barrier) const;
  double measure_excess(const BarrierValues& values) const;
  void find_excess(double t);
  void find_factors();
  void assemble(double t);
  void add_to_variables(std::size_t interval, const LocalModel& model);
  void assemble_coefficients(double t);
  void add_single(std::size_t coefficient, double slope, double curvature);
  void keep_below(std::size_t coefficient, double greatest, double dual, double weight);
  void spend_on_ramp(std::size_t coefficient, double ramp, double t);
  void center_duals();
  void step_duals(std::span<const double> before, const BarrierValues& values, double share);

  const SpeedProblem& problem_;
  const SpeedBounds& bounds_;
  const SpeedGoal& goal_;
  const BarrierKernel& kernel_;
  SpeedIterate& iterate_;
  SpeedIterate trial_;
  std::vector<double> floors_;
  std::vector<std::uint8_t> weights_;  ///< of the coefficients' caps and floors, by index; none: 1
  Ways ways_;
  double inequalities_;
  std::size_t first_free_, first_single_, end_single_;  ///< coefficients: the first free one; those that are a variable
  BarrierTerms terms_;
  BarrierValues values_, trial_values_;
  BarrierDuals duals_;
  std::vector<double> cap_duals_;  ///< of the coefficients
  double creep_dual_ = 1;
  bool is_lost_ = false, was_lost_ = false;  ///< has a stage left the optimum that was followed; and has one before it?
  bool is_first_ = true;                     ///< stage: its multipliers are those of centres
  std::vector<LocalModel> models_;
  numeric::BandedMatrix<3> hessian_;
  std::vector<double> gradient_, direction_;
  int newton_steps_ = 0;
};

}  // namespace leadscrew::planner
