#pragma once
// Least time in a corridor, by a logarithmic barrier (Boyd and Vandenberghe, "Convex Optimization", ch. 11). Unknown are
// the control points c of a TimeSpline and w = (h/h₀)³, the cube of its interval over that of the start:
//
//     minimise  t·w − Σ log(slack)     |Δ³c| ≤ j h₀³ w     |Δ²c| ≤ a h₀² w^(2/3)     |Δc| ≤ v h₀ w^(1/3)
//
// and each knot, and two places to the next, within the margin of its leg, each joint passed within it. The
// right-hand sides are concave in w, so that this is convex where it is fixed which leg each knot belongs to and when
// each joint is passed; here both follow the motion (corridor_optimum.hpp). A place near a leg may move along it.

#include <cstdint>
#include <leadscrew/toolpath/corridor.hpp>
#include <leadscrew/toolpath/newton_model.hpp>
#include <vector>

namespace leadscrew::toolpath {

/// That are looked at in each interval: its knot and two more, a third of it apart.
inline constexpr std::size_t places = 3;

/// What belongs where.
struct Passing {
  std::vector<double> passes;       ///< when each joint is passed, in intervals
  std::vector<std::uint32_t> legs;  ///< of each place: knot k is place 3k
};

template <std::size_t D>
struct CorridorPoint {
  std::vector<Vector<D>> points;
  double w = 1;
};

template <std::size_t D>
class CorridorBarrier {
 public:
  CorridorBarrier(const Corridor<D>& corridor, std::size_t intervals, double start_interval);

  double inequalities() const { return inequalities_; }
  double start_interval() const { return start_interval_; }
  /// Infinite outside.
  double value(double t, const CorridorPoint<D>& at, const Passing& passing) const;
  void assemble(double t, const CorridorPoint<D>& at, const Passing& passing, NewtonModel<D>& model) const;
  /// Each place belongs to the leg that is travelled at its time.
  void assign(Passing& passing) const;
  /// When the motion comes nearest to each joint, from where it was before.
  void follow(const std::vector<Vector<D>>& points, std::vector<double>& passes) const;

 private:
  /// How much more is allowed where control points are given that a motion of another interval had.
  double relaxed(std::size_t k) const;
  double feed_of(std::size_t k, const Passing& passing) const;

  const Corridor<D>& corridor_;
  std::size_t intervals_;
  double start_interval_;
  double inequalities_ = 0;
  bool has_velocity_limit_ = false;
};

}  // namespace leadscrew::toolpath
