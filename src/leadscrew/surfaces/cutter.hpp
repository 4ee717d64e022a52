#pragma once
// A tool on a surface: where its tip is while it touches at a place, how it is held there, how it bends.
//
//                  O  towards the spindle
//                  │                     ball        r = R
//             R    │                     bull nose   0 < r < R
//          ├───────┤                     flat        r = 0
//          │       │
//          ╰r      │      the tip: where the axis meets the plane that the tool stands on
//           ‾‾‾‾‾‾‾•‾‾‾

#include <cmath>
#include <cstdint>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/surfaces/frame.hpp>

namespace leadscrew::surfaces {

/// Of a cutter with a round edge: all three shapes.
struct Cutter {
  double radius = 0;         ///< R, mm; > 0
  double corner_radius = 0;  ///< r, mm; 0 … R

  bool is_ball() const { return corner_radius == radius; }

  friend bool operator==(const Cutter&, const Cutter&) = default;
};

/// A vector of any scalar.
template <typename T>
using VectorOf = std::array<T, 3>;

/// |n across O|² below which an axis is taken as along the normal: the tool then touches with all of its bottom.
inline constexpr double least_lean = 1e-20;

/// The tip while the tool touches at s: S + r n + (R − r) t − r O, t = the part of n across O, of length 1. Where n is along O, a
/// tool that is no ball touches anywhere on its flat bottom, and t = f. Any scalar that has arithmetic and sqrt; n, O and f are
/// unit vectors.
template <typename T>
VectorOf<T> tip_of(const Cutter& cutter, const VectorOf<T>& s, const VectorOf<T>& n, const VectorOf<T>& axis,
                   const VectorOf<T>& f) {
  using std::sqrt;
  const T r = cutter.corner_radius, flat = cutter.radius - cutter.corner_radius;
  VectorOf<T> tip;
  for (std::size_t k = 0; k < 3; ++k) tip[k] = s[k] + r * n[k] - r * axis[k];
  if (cutter.is_ball()) return tip;
  const T along = n[0] * axis[0] + n[1] * axis[1] + n[2] * axis[2];
  VectorOf<T> across;
  for (std::size_t k = 0; k < 3; ++k) across[k] = n[k] - along * axis[k];
  const T square = across[0] * across[0] + across[1] * across[1] + across[2] * across[2];
  const bool leans = square > T(least_lean);
  const T length = leans ? T(sqrt(square)) : T(1.0);
  for (std::size_t k = 0; k < 3; ++k) tip[k] = tip[k] + flat * (leans ? across[k] / length : f[k]);
  return tip;
}

/// How the tool is held.
struct Orientation {
  enum class Rule : std::uint8_t {
    fixed,   ///< along `axis`
    normal,  ///< along n
    leaned,  ///< O = cos α (cos β n − sin β b) + sin α f: α forward along the pass, β sideways
  };
  Rule rule = Rule::fixed;
  /// A unit vector: of fixed along X, Y and Z, of leaned along f, b and n; of normal without meaning.
  Vector axis = {0, 0, 1};

  /// Leaned by α and β, radians, −π/2 < each < π/2.
  static Orientation leaning(double lead, double tilt) {
    const numeric::Sines forward = numeric::sines(lead), aside = numeric::sines(tilt);
    return {Rule::leaned, {forward.sine, -forward.cosine * aside.sine, forward.cosine * aside.cosine}};
  }

  friend bool operator==(const Orientation&, const Orientation&) = default;
};

/// O where n is the normal and f the unit tangent along the pass. Any scalar with arithmetic.
template <typename T>
VectorOf<T> axis_of(const Orientation& orientation, const VectorOf<T>& n, const VectorOf<T>& f) {
  if (orientation.rule == Orientation::Rule::normal) return n;
  if (orientation.rule == Orientation::Rule::fixed)
    return {T(orientation.axis[0]), T(orientation.axis[1]), T(orientation.axis[2])};
  const T along = orientation.axis[0], aside = orientation.axis[1], up = orientation.axis[2];
  const VectorOf<T> b = {n[1] * f[2] - n[2] * f[1], n[2] * f[0] - n[0] * f[2], n[0] * f[1] - n[1] * f[0]};
  VectorOf<T> axis;
  for (std::size_t k = 0; k < 3; ++k) axis[k] = up * n[k] + aside * b[k] + along * f[k];
  return axis;
}

/// Curvature of the tool where it touches, by f and b; greatest_curvature stands for infinite. `n`: the surface's normal.
///
/// Along m, in the plane of n and O: 1/r. Along c = O × n: sin θ/((R − r) + r sin θ), θ the angle from n to O.
Tensor curvature_of(const Cutter& cutter, const Vector& n, const Vector& axis, const TangentPair& tangents);
inline constexpr double greatest_curvature = 1e12;

/// By how much the tool bends more than the surface, 1/mm, in the direction where that is least: below 0 it gouges in the
/// neighbourhood of its contact (K_tool − K_surface ⪰ 0 is free of gouging, exact to second order).
double local_clearance(const Tensor& tool, const Tensor& surface);

/// The radius by which the tool's swept shape is round across a pass along f: 1/R_e = K_bb − K_fb²/K_ff; infinite where it is
/// flat across. For a ball R; leaning along f by θ: (R − r)/sin θ + r.
double effective_radius(const Tensor& tool);

}  // namespace leadscrew::surfaces
