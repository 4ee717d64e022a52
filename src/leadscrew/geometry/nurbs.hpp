#pragma once
// NURBS curves by arc length.
//
//        u(s)         C(u)
//   s ─────────▶ u ─────────▶ q          C(u) = Σ w_i N_i,p(u) P_i / Σ w_i N_i,p(u)
//                                        (Piegl and Tiller, "The NURBS Book", eq. 4.1)
//
// The length of a rational B-spline has no closed form, and neither has its inverse. u(s) is therefore a table, made
// once: on each of its pieces, none of which crosses a knot, a quintic polynomial that has at both ends the value and
// two derivatives of the true inverse (arc_length_map.hpp). What the cycle evaluates and the planner differentiates is
// the composition q(u(s)) with that table. It lies on the curve whatever the table says; only the speed along it is
// inexact, |dq/ds| = 1 within the tolerance the table was made with.
//
// A path is planned by its three derivatives, so a curve is cut into smooth pieces where it has none: at corners, at
// steps of the curvature, at cusps (smooth_pieces).

#include <cstddef>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/geometry/point.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace leadscrew::geometry {

/// A rational B-spline as programmed, knots[p] ≤ u ≤ knots[n] for n control points of degree p.
struct NurbsForm {
  int degree = 0;               ///< p, 1 … 5
  std::vector<double> knots;    ///< n + p + 1, not decreasing; no inner one more than p times
  std::vector<Point> points;    ///< n > p, mm or degrees
  std::vector<double> weights;  ///< n, > 0
};

/// Of a curve with degree, knots and points, each with position and weight, as the reader gives it.
template <class Programmed>
NurbsForm form_of(const Programmed& curve) {
  NurbsForm form{curve.degree, curve.knots, {}, {}};
  for (const auto& point : curve.points) {
    form.points.push_back(point.position);
    form.weights.push_back(point.weight);
  }
  return form;
}

/// Tolerances of the table of u(s), > 0, for the speed g = |dq/ds| and its derivatives by s; k is the larger of
/// the curvature and the reciprocal of the length of a span. g″ has a step where two pieces of the table meet, and so
/// has q‴: jerk by about as much, relative, where motion along a bend is as fast as jerk allows.
struct MapTolerance {
  double speed = 1e-7;    ///< |g − 1|
  double first = 1e-5;    ///< |g′| / k
  double second = 1e-4;   ///< |g″| / k²
  double length = 1e-13;  ///< of a piece of the table, relative
};

struct NurbsTable;

/// One smooth piece of a NURBS curve. Copies share the table, which is never changed.
class Nurbs {
 public:
  /// By the weighted coordinates, if it was made with weights; else by X Y Z where they move on the piece, else U V W,
  /// else A B C (degrees); > 0.
  double length() const { return length_; }
  const Point& start() const { return start_; }
  const Point& end() const { return end_; }
  /// Coordinates that move on the piece.
  base::AxisSet moving() const { return moving_; }

  /// No allocation; bounded work: a search among the table's pieces and three polynomials.
  Point evaluate(numeric::DoubleDouble s) const;
  UnroundedPoint evaluate_unrounded(numeric::DoubleDouble s) const;
  /// Of exactly what evaluate() computes; 0 ≤ s ≤ length.
  PointJet jets(double s) const;
  /// At two places side by side, each to the last bit as alone.
  PointJetOf<numeric::Pair> jets(numeric::Pair s) const;
  Rates rates(double s, std::size_t first) const;

  /// u at arc length s, 0 ≤ s ≤ length.
  double parameter(double s) const;
  /// du/ds there. No allocation, as evaluate().
  double parameter_rate(double s) const;
  /// Position and three derivatives by u, first_parameter() ≤ u ≤ last_parameter().
  PointJet jets_at(double u) const;
  double first_parameter() const { return first_parameter_; }
  double last_parameter() const { return last_parameter_; }

  /// Arc lengths inside (0, length), ascending, where q‴ has a step or a bend: knots at which the B-spline is only C2
  /// or C3. Valid as long as the curve.
  std::span<const double> breaks() const;
  /// As geometry::append_shape() has it.
  void append_shape(std::vector<double>& numbers) const;
  /// What lies between two arc lengths, 0 ≤ from < to ≤ length. There its table is exact, as it is where its pieces
  /// meet: whatever goes on with the curve's own direction and curvature joins it without a step.
  Nurbs part(double from, double to) const;
  /// Turned and shifted. Length is told by X, Y and Z alike, or by none of them.
  Nurbs moved(const RigidMotion& motion) const;
  /// Pieces of the table u(s).
  std::size_t map_pieces() const { return record_count_; }
  /// Borders of them from one arc length to another, 0 ≤ from ≤ to ≤ length: there q‴ bends.
  std::size_t map_borders(double from, double to) const { return record_at(to) - record_at(from); }
  /// A border: where it is, and by how much q‴ steps there, as a multiple of q′ (1/mm²), which is what the table's
  /// tolerance leaves. A step that the curve itself has there, one of breaks(), may count in it or not.
  struct Border {
    double s = 0, step = 0;
  };
  /// The first behind an arc length, if index is 0, and so on; index < map_borders(from, to).
  Border map_border(double from, std::size_t index) const;

 private:
  friend class NurbsAssembly;
  struct Located;
  std::size_t record_at(double s) const;
  Located locate(double s) const;
  template <typename T>
  void go_along(std::array<T, base::axis_count>& position, numeric::DoubleDouble s) const;
  void add_part(std::size_t record, double from, double to, NurbsTable& table) const;
  void add_buckets(NurbsTable& table);

  std::shared_ptr<const NurbsTable> table_;
  double length_ = 0;
  double buckets_per_length_ = 0;
  std::uint32_t first_record_ = 0, record_count_ = 0;
  std::uint32_t first_bucket_ = 0, bucket_count_ = 0;
  std::uint32_t first_break_ = 0, break_count_ = 0;
  double first_parameter_ = 0, last_parameter_ = 0;
  base::AxisSet moving_;
  Point start_{};
  Point end_{};
};

/// The curve in smooth pieces, in order, each beginning exactly where the one before ends; none where nothing moves.
/// The first begins at the first control point if the curve is clamped there, and so for the last. It is cut
///
///   - where the tangent by arc length turns by a step, and where the curvature does (steps below 1e-9 of the tangent,
///     and of the larger of curvature and the reciprocal of the neighbouring spans' lengths, are taken as none),
///   - where |dC/du| vanishes: cusps, reversals, coinciding control points; and where the radius of curvature falls
///     below about 1e-5 mm, which no machine tells from a corner,
///   - where other coordinates are the first to move in the order X Y Z, U V W, A B C.
///
/// tolerance: of u(s). weights: length is that of all coordinates, each times its weight > 0. The work is
/// linear in the number of control points. A form that is none (counts, degree, knots, weights not as said above) gives
/// no piece.
std::vector<Nurbs> smooth_pieces(const NurbsForm& form, const MapTolerance& tolerance = {},
                                 const std::optional<Point>& weights = std::nullopt);

}  // namespace leadscrew::geometry
