#pragma once
// A logarithmic barrier inside the tube and the limits (Boyd and Vandenberghe, "Convex Optimization", ch. 11). Unknown
// are the control points c of a TubeMotion and w = (h/h₀)³, the interval's cube over that of the start:
//
//     minimise  t·w − Σ log(slack)     |Δ³c| ≤ j h₀³ w     |Δ²c| ≤ a h₀² w^(2/3)     |Δc| ≤ F h₀ w^(1/3)
//
// and each knot within P of its leg, each joint passed within P of it. The right-hand sides are concave in w, so that
// the problem is convex where it is fixed which leg each knot belongs to and when each joint is passed: its optimum is
// the least time of all motions that pass the joints then. A knot near an arc stays on the near side of the tangent to
// the inner wall, which moves with the knot from step to step.

#include <cstddef>
#include <leadscrew/numeric/banded.hpp>
#include <leadscrew/study/tube_motion.hpp>
#include <span>
#include <vector>

namespace leadscrew::study {

/// What the convex problem takes for given.
struct TubeAssignment {
  std::vector<double> passes;        ///< when each joint is passed, in intervals
  std::vector<std::size_t> legs;     ///< of each knot
  std::vector<PlaneVector> outward;  ///< of each knot near an arc: from the arc's centre, length 1
};

/// The unknowns.
struct TubeIterate {
  std::vector<PlaneVector> points;
  double w = 1;
};

/// Each knot belongs to the leg that is travelled at its time.
TubeAssignment assigned(const Tube& tube, const std::vector<PlaneVector>& points, std::vector<double> passes);
/// When the motion comes nearest to each joint, found from `passes` downhill; half an interval apart at least.
std::vector<double> nearest_passes(const Tube& tube, const std::vector<PlaneVector>& points,
                                   std::vector<double> passes);

/// Of the distances from the joints when they are passed: 1 − (distance/P)².
std::vector<double> pass_slacks(const Tube& tube, const std::vector<PlaneVector>& points,
                                const TubeAssignment& assignment);

/// The quadratic model of the barrier: gradient and Hessian in the free control points, bordered by those in w.
class TubeModel {
 public:
  void reset(std::size_t points);
  /// A term of one axis, Σ factor_i c_(first + i): its first and second derivative, and the mixed one in w.
  void add(std::size_t first, std::span<const double> factors, std::size_t axis, double slope, double curvature,
           double mixed);
  /// A term of both axes.
  struct Hessian {
    double xx = 0, xy = 0, yy = 0;
  };
  void add(std::size_t first, std::span<const double> factors, PlaneVector slope, Hessian curvature, PlaneVector mixed);
  void add_to_w(double slope, double curvature);

  struct Step {
    std::vector<PlaneVector> points;  ///< of every control point, 0 of the fixed ones
    double w = 0;
    double decrement = 0;  ///< by which the model's value falls, twice; not finite where the model could not be solved
  };
  Step newton_step();

 private:
  bool is_free(std::size_t point) const { return point >= 3 && point + 3 < points_; }

  std::size_t points_ = 0;
  numeric::BandedMatrix<7> hessian_;
  std::vector<double> slope_, border_;
  double w_slope_ = 0, w_curvature_ = 0;
};

class TubeBarrier {
 public:
  /// Both must outlive it.
  TubeBarrier(const Tube& tube, double start_interval) : tube_(tube), start_interval_(start_interval) {}

  /// Number of inequalities, by which the gap of the optimum is known: this over t.
  double inequalities(std::size_t intervals) const;
  /// t·w plus barrier; infinite outside.
  double value(double t, const TubeIterate& at, const TubeAssignment& assignment) const;
  /// Whether the model takes it that passing times follow the motion: then a joint's distance changes only across it.
  enum class Passes : bool { fixed, following };
  void assemble(double t, const TubeIterate& at, const TubeAssignment& assignment, Passes passes,
                TubeModel& model) const;

 private:
  struct Bounds {
    double jerk = 0, acceleration = 0, velocity = 0;  // mm
  };
  Bounds bounds(double w) const;
  void assemble_limits(const TubeIterate& at, TubeModel& model) const;
  void assemble_knots(const TubeIterate& at, const TubeAssignment& assignment, TubeModel& model) const;
  void assemble_passes(const TubeIterate& at, const TubeAssignment& assignment, Passes passes, TubeModel& model) const;

  const Tube& tube_;
  double start_interval_;
};

}  // namespace leadscrew::study
