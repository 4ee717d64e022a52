#pragma once
// Rational B-spline surfaces:
//
//               Σ w_ij N_i,p(u) N_j,q(v) P_ij
//     S(u, v) = ─────────────────────────────        (Piegl and Tiller, "The NURBS Book", eq. 4.11)
//               Σ w_ij N_i,p(u) N_j,q(v)
//
// Basis functions are kept as polynomials of each span, so that a place costs two short searches, Horner's rule and the sum
// over (p + 1)(q + 1) control points.

#include <array>
#include <cstddef>
#include <leadscrew/kinematics/chain.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::surfaces {

using kinematics::Vector;

inline constexpr int highest_degree = 5;
inline constexpr std::size_t most_control_points = 1 << 16;  ///< of one surface

/// A point of the net.
struct NetPoint {
  Vector position{};  ///< mm
  double weight = 1;  ///< > 0

  friend bool operator==(const NetPoint&, const NetPoint&) = default;
};

/// One of the two directions of parameters.
enum class Direction : std::uint8_t { u, v };

/// A surface as programmed.
struct SurfaceForm {
  std::array<int, 2> degree{};  ///< in u and v, 1 … highest_degree
  std::array<std::vector<double>, 2>
      knots;                           ///< n + p + 1 each, not decreasing, clamped; no inner one more than p times
  std::array<std::size_t, 2> count{};  ///< n: points along u and v, more than the degree
  std::vector<NetPoint> net;           ///< count[0] · count[1], u fastest

  const NetPoint& point(std::size_t i, std::size_t j) const { return net[i + j * count[0]]; }

  friend bool operator==(const SurfaceForm&, const SurfaceForm&) = default;
};

/// Clamped, evenly spaced knots from 0 to 1; degree < points.
std::vector<double> uniform_knots(std::size_t points, int degree);

/// Why a form is no surface that can be machined.
struct SurfaceFault {
  enum class Kind : std::uint8_t {
    counts,      ///< degree, or numbers of points or knots, are not as SurfaceForm says
    not_finite,  ///< a coordinate, weight or knot
    weight,      ///< of a point, not above 0
    knots,       ///< decrease, are not clamped, or one inside is repeated more often than the degree
    rows,    ///< two neighbouring rows of the net coincide, so that the surface has a fold or a hole in its parameters
    normal,  ///< Su × Sv vanishes
  };
  Kind kind = Kind::counts;
  Direction direction = Direction::u;  ///< of counts, knots and rows: in which
  std::size_t index = 0;               ///< of the knot, point or row, from 0
  double u = 0, v = 0;                 ///< of normal: where
};
/// The first fault there is. Whether the normal vanishes is tried at the middles, ends and quarters of all spans.
std::optional<SurfaceFault> fault_of(const SurfaceForm& form);

/// The place of a surface and all partial derivatives to the third order, mm.
struct SurfaceJet {
  Vector s{}, u{}, v{}, uu{}, uv{}, vv{}, uuu{}, uuv{}, uvv{}, vvv{};
};

/// Parameters from … to.
struct Range {
  double from = 0, to = 1;

  friend bool operator==(const Range&, const Range&) = default;
};

class Surface {
 public:
  /// Of a form that has no fault.
  explicit Surface(SurfaceForm form);

  const SurfaceForm& form() const { return form_; }
  /// All parameters there are.
  Range range(Direction direction) const;
  /// Where two polynomials meet, in ascending order, both ends among them.
  const std::vector<double>& breaks(Direction direction) const { return axes_[direction == Direction::v].breaks; }

  /// Parameters beyond a range are taken as its ends. No allocation; bounded work.
  Vector at(double u, double v) const;
  SurfaceJet jet(double u, double v) const;
  /// The third derivatives are 0: curvature needs none of them.
  SurfaceJet jet_of_second_order(double u, double v) const;
  /// All but the first are 0.
  SurfaceJet jet_of_first_order(double u, double v) const;

 private:
  static constexpr std::size_t most_terms = highest_degree + 1;
  /// By the power of x, the parameter counted from the beginning of a span; of one function, or of all for one power.
  using Powers = std::array<double, most_terms>;
  /// One direction: its spans, and the polynomials of all basis functions that are not 0 there.
  struct Axis {
    std::vector<double> breaks;
    std::vector<std::size_t> first;                     // of each span: index of the first control point
    std::vector<std::array<Powers, most_terms>> basis;  // of each span and power: its factor in each function
    std::size_t terms = 0;                              // degree + 1
  };
  /// Values and three derivatives of the functions at one place.
  struct Weights {
    std::size_t first = 0;
    std::array<std::array<double, most_terms>, 4> derivative;  // by order, then function
  };
  static Axis axis_of(int degree, const std::vector<double>& knots);
  /// Derivatives to the highest order; others are not set.
  template <std::size_t highest>
  static Weights weights_of(const Axis& axis, double parameter);
  template <std::size_t highest>
  SurfaceJet jet_of(double u, double v) const;

  SurfaceForm form_;
  std::array<Axis, 2> axes_;
  std::vector<std::array<double, 4>> homogeneous_;  // w x, w y, w z, w of the net
  bool is_rational_ = false;
};

}  // namespace leadscrew::surfaces
