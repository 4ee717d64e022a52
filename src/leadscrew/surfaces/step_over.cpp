#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/surfaces/step_over.hpp>
#include <limits>
#include <numbers>

namespace leadscrew::surfaces {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// 1 − R/ρ below which a tool fills a concave surface, but for rounding.
constexpr double least_opening = 1e-9;

}  // namespace

/// arccos(1 − x) with 1 − cos φ = 2 sin² φ/2: exact for small steps too. 1 − (D² + t² − R²)/(2 D t) = (R² − (D − t)²)/(2 D t),
/// and R² − (D − t)² = (R − s(D − t))(R + s(D − t)) = h (2 R − h), for s(D − t) = R − h. With k = s/ρ: D t/ρ² = (1 + k R)(1 + k h).
double step_over(double radius, double curvature, double height) {
  if (!(height > 0)) return 0;
  const double k = -curvature;
  if (std::isinf(radius)) {
    if (!(k > 0)) return infinite;
    // A flat across a convex surface: D − t and D are infinite, cos φ = 1/(1 + k h).
    return 2 / k * numeric::asin(std::sqrt(k * height * (2 + k * height)) / (1 + k * height));
  }
  const double h = std::min(height, radius);
  const double square = h * (2 * radius - h);
  const double both = (1 + k * radius) * (1 + k * h);
  if (!(1 + k * radius > least_opening)) return 0;
  if (k == 0) return 2 * std::sqrt(square);
  const double half_sine = std::sqrt(square / both) * std::abs(k) / 2;
  if (half_sine >= 1) return std::numbers::pi * 2 / std::abs(k);
  return 4 / std::abs(k) * numeric::asin(half_sine);
}

/// From the same: h² − 2 b h + q c = 0 with q = 4 sin² φ/2/k², c = 1 + k R, b = R − k q c/2; the smaller root, without
/// cancellation.
double scallop_height(double radius, double curvature, double step) {
  const double k = -curvature;
  if (std::isinf(radius)) return k > 0 ? (1 / numeric::cos(k * step / 2) - 1) / k : 0;
  const double sine = k == 0 ? step / 4 : numeric::sin(std::abs(k) * step / 4) / std::abs(k);
  const double c = 1 + k * radius, qc = 4 * sine * sine * c, b = radius - k * qc / 2;
  const double square = b * b - qc;
  if (!(square > 0)) return radius;
  return std::min(qc / (b + std::sqrt(square)), radius);
}

namespace {

/// One side of a tool's outline above a surface of constant curvature.
class OutlineSide {
 public:
  OutlineSide(const Cutter& cutter, const Vector& axis, const Tensor& surface, double side)
      : disc_(cutter.radius - cutter.corner_radius),
        edge_(cutter.corner_radius),
        ahead_(axis[0]),
        across_(side * axis[1]),
        up_(axis[2]),
        surface_{surface.ff, side * surface.fb, surface.bb} {
    const Offset bottom = at(0);
    contact_ = leans() ? bottom : Offset{0, 0, -edge_};
  }

  bool leans() const { return up_ * up_ < 1 - least_lean; }
  /// Where the outline is h above the surface, as an arc of the surface; where it is widest if it is nowhere so high.
  double arc(double height) const;

 private:
  struct Offset {
    double ahead = 0, across = 0, up = 0;
  };
  struct Above {
    double root = 0, arc = 0;  // of the height; on the surface
  };
  double arc_on_line(const Offset& from, const Offset& to, double wanted) const;
  Offset at(double angle) const {
    const auto [sine, cosine, cosine_less_one] = numeric::sines(angle);
    const double along = sine * across_ - cosine * up_;
    const double length = std::sqrt(std::max(1 - along * along, 0.0));
    const double part = length > 0 ? disc_ / length : 0;
    return {-part * along * ahead_, part * (sine - along * across_) + edge_ * sine,
            -part * (cosine + along * up_) - edge_ * cosine};
  }
  /// Above a circle through the contact: its centre lies at 1/κ upwards.
  Above above(const Offset& offset) const {
    const double x = offset.ahead - contact_.ahead, y = offset.across - contact_.across, k = surface_.bb;
    const double z = offset.up - contact_.up - x * (surface_.ff * x / 2 + surface_.fb * y);
    const double bent = k * (2 * z - k * (y * y + z * z));
    const double height = (2 * z - k * (y * y + z * z)) / (1 + std::sqrt(std::max(1 - bent, 0.0)));
    return {std::sqrt(std::max(height, 0.0)),
            std::abs(k * y) < 1e-9 ? y / (1 - k * z) : numeric::atan2(k * y, 1 - k * z) / k};
  }

  double disc_, edge_, ahead_, across_, up_;
  Tensor surface_;
  Offset contact_;
};

/// Regula falsi with halved ends (Illinois) on the height's root, which near the contact grows as the angle does. Where the tool is met
/// along a straight line, at one angle, the place on that line.
double OutlineSide::arc(double height) const {
  double low = 0, high = std::numbers::pi / 2;
  const double wanted = std::sqrt(height);
  const Above widest = above(at(high));
  double below = -wanted, beyond = widest.root - wanted;
  if (!(beyond > 0)) return widest.arc;
  int last = 0;
  for (int round = 0; round < 80 && high - low > 1e-13; ++round) {
    const double angle = round % 4 == 3 ? (low + high) / 2 : (low * beyond - high * below) / (beyond - below);
    const Above found = above(at(angle));
    const double off = found.root - wanted;
    if (std::abs(off) < 1e-7 * wanted) return found.arc;
    if (off < 0) {
      low = angle, below = off;
      if (last < 0) beyond /= 2;
      last = -1;
    } else {
      high = angle, beyond = off;
      if (last > 0) below /= 2;
      last = 1;
    }
  }
  return arc_on_line(low > 0 ? at(low) : contact_, at(high), wanted);
}

double OutlineSide::arc_on_line(const Offset& from, const Offset& to, double wanted) const {
  double low = 0, high = 1;
  Above found;
  for (int round = 0; round < 50; ++round) {
    const double share = (low + high) / 2;
    found = above({from.ahead + share * (to.ahead - from.ahead), from.across + share * (to.across - from.across),
                   from.up + share * (to.up - from.up)});
    (found.root < wanted ? low : high) = share;
  }
  return found.arc;
}

}  // namespace

/// A tool that stands on its bottom has its ridge on the bottom, where that is as high as is asked for.
double outline_arc(const Cutter& cutter, const Vector& axis, const Tensor& surface, double height, double side) {
  const OutlineSide outline(cutter, axis, surface, side);
  const double arc = outline.arc(height);
  return outline.leans() ? arc : std::min(arc, step_over(infinite, surface.bb, height) / 2);
}

}  // namespace leadscrew::surfaces
