#pragma once
// What every step of Newton's method does all along a window, in vectors of four: the barrier's value, its gradient and
// Hessian interval by interval, the multipliers. By the vectors that the processor has; the bits are the same, for each
// lane does the same operations in the same order.
//
// Of a row u ≤ 1 (u = A² or u = g²x, times the factor in force) with multiplier λ, which is 1/(1 − u) at a centre:
//
//     −log(1 − u)     gradient ∇u/(1 − u)     Hessian λ (∇u ∇uᵀ/(1 − u) + ∇²u)
//
// With p = ∇g and e = ∇x, ∇²(g²x) is modelled by 2x (p + (g/x) e)(p + (g/x) e)ᵀ, which is never indefinite; together they
// are one square in p + r e, r = g/(x (1 + u)), and what is left of e eᵀ:
//
//     2xλ (1 + u)/(1 − u) (p + r e)(p + r e)ᵀ + λ u²/(x² (1 + u)) e eᵀ
//
// All e eᵀ of one place are added up before they are multiplied out.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <leadscrew/planner/lanes.hpp>
#include <leadscrew/planner/speed_problem.hpp>
#include <span>
#include <vector>

namespace leadscrew::planner {

/// What x above the wanted costs at an interval's places, times t and its length there: derivatives by x.
struct ExcessTerms {
  Lanes slope{}, curvature{};
};

/// What caps may weigh, 2^(−i/2): few weights, so that the factors of each are multiplied before a logarithm is taken.
inline constexpr std::array<double, 16> cap_weights = [] {
  std::array<double, 16> powers{1, 0.70710678118654757};
  for (std::size_t i = 2; i < powers.size(); ++i) powers[i] = powers[i - 2] / 2;
  return powers;
}();
/// Index of the nearest, for a weight > 0.
std::uint8_t nearest_weight(double weight);

/// −Σ weight · log of factors > 0.
class WeighedLogarithms {
 public:
  void take(double factor, std::uint8_t weight) {
    double& product = products_[weight];
    product *= factor;
    if (product < 1e-200) flush(weight);
  }
  /// After which it begins anew.
  double sum();

 private:
  void flush(std::size_t weight);

  std::array<double, cap_weights.size()> products_ = [] {
    std::array<double, cap_weights.size()> ones{};
    ones.fill(1);
    return ones;
  }();
  double sum_ = 0;
};

/// What does not change from step to step.
struct BarrierTerms {
  std::span<const SpeedProblem::Places> places;
  std::span<const CubicBasis> basis;
  std::span<const SpeedProblem::Site> sites;
  std::span<const SpeedProblem::Block> blocks;
  double time_curvature = 0.75;       ///< of x^(−1/2), times x^(5/2)
  Lanes time_weights{};               ///< of an interval's places, per unit of its length
  std::vector<Lanes> inverse_caps;    ///< of x at the places; 0: no cap
  std::vector<std::uint8_t> weights;  ///< of the caps of each interval, by index; none: 1
  std::vector<double> factors;        ///< of the sites, squared
  std::vector<ExcessTerms> excess;    ///< of the intervals; none where time alone counts

  std::uint8_t weight(std::size_t interval) const { return weights.empty() ? 0 : weights[interval]; }
};

/// Values of one iterate.
struct BarrierValues {
  std::vector<Lanes> rows;      ///< A and g, of each block
  std::vector<double> squares;  ///< x at the sites
  std::vector<Lanes> places;    ///< x at the intervals' places
  double time = 0;              ///< ∫ x^(−1/2) ds without ramps, s
  double barrier = 0;           ///< −Σ log(1 − u) of rows and places
  std::size_t outside = 0;      ///< where a limit was passed: the first such interval
};

/// Multipliers of rows and of caps at places, times t.
struct BarrierDuals {
  std::vector<Lanes> rows, places;
};

/// Gradient and lower triangle of the Hessian, by rows, in the four coefficients of one interval.
struct LocalModel {
  Four gradient{};
  std::array<double, 10> hessian{};
};

/// How far a multiplier may be from 1/(1 − u), times.
inline constexpr double least_dual = 0.1, greatest_dual = 1e3;
inline double near_center(double dual, double free) {
  return std::min(std::max(dual, least_dual / free), greatest_dual / free);
}

struct BarrierKernel {
  /// False outside a limit.
  bool (*measure)(const BarrierTerms&, std::span<const double> c, BarrierValues&);
  /// A model for each interval.
  void (*assemble)(const BarrierTerms&, double t, const BarrierValues&, const BarrierDuals&, std::span<LocalModel>);
  /// After a step of `share` of Newton's.
  void (*step_duals)(const BarrierTerms&, const BarrierValues& before, const BarrierValues& after, double share,
                     BarrierDuals&);
  /// To those of a centre.
  void (*center_duals)(const BarrierTerms&, const BarrierValues&, BarrierDuals&);
};

/// By the widest vectors that this processor has.
const BarrierKernel& barrier_kernel();
/// By what every processor has.
const BarrierKernel& plain_barrier_kernel();

}  // namespace leadscrew::planner
