#pragma once
// Feed where a tool touches a surface, while its tip goes another way: on a convex surface the tip is faster than the contact,
// on a concave one slower (Lin and Koren: a constant feed is that of the cutter's position; here either can be asked for).

#include <array>
#include <leadscrew/geometry/nurbs.hpp>
#include <vector>

namespace leadscrew::gcode {
struct NurbsCurve;
}

namespace leadscrew::toolpath {

class ContactRate {
 public:
  /// Of a curve that has contact points.
  explicit ContactRate(const gcode::NurbsCurve& curve);

  /// mm of the contact's way in one of the piece's length, at 0 ≤ s ≤ its length. The piece is one of the curve's, or a part
  /// of one. No allocation; bounded work.
  double at(const geometry::Nurbs& piece, double s) const;

 private:
  static constexpr std::size_t most_powers = 5;  // of a derivative
  struct Span {
    double begin = 0;
    std::array<std::array<double, most_powers>, 3> rate{};  ///< dC/du by powers of u − begin
  };
  std::vector<Span> spans_;
};

}  // namespace leadscrew::toolpath
