#pragma once
// A curve in six axes at once.

#include <cmath>
#include <leadscrew/geometry/nurbs.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/toolpath/path.hpp>

namespace leadscrew::testing_support {

/// The three-axis mill and three rotary axes.
inline machine::Machine mill_of_six_axes() {
  machine::Machine machine = machine::mill3();
  for (const base::Axis axis : {base::Axis::A, base::Axis::B, base::Axis::C}) {
    machine.axes[base::index(axis)] = machine::AxisLimits{-1e6, 1e6, 100, 2000, 50000, 0.001};
  }
  return machine;
}

/// A uniform cubic B-spline without an end, each piece one span of it.
class CurveInSixAxes {
 public:
  /// Feed in mm/s.
  explicit CurveInSixAxes(double feed) : feed_(feed) {}

  geometry::Point start() const {
    geometry::Point start{};
    for (std::size_t i = 0; i < start.size(); ++i) start[i] = (point(0)[i] + 4 * point(1)[i] + point(2)[i]) / 6;
    return start;
  }
  toolpath::Piece next() {
    geometry::NurbsForm form{3, {}, {}, {1, 1, 1, 1}};
    for (int k = 0; k < 4; ++k) form.points.push_back(point(spans_ + k));
    for (int k = 0; k < 8; ++k) form.knots.push_back(spans_ + k);
    ++spans_;
    return {geometry::smooth_pieces(form).at(0), feed_, base::Line{spans_}};
  }

 private:
  static geometry::Point point(int k) {
    const double angle = 0.3 * k, wave = 1 + 0.1 * std::sin(1.7 * k);
    geometry::Point p{};
    p[0] = 40 * wave * std::cos(angle), p[1] = 40 * wave * std::sin(angle), p[2] = 3 * std::sin(0.5 * angle);
    for (const std::size_t i : {3, 4, 5}) p[i] = 10 * std::sin(0.7 * angle + static_cast<double>(i));
    return p;
  }

  double feed_;
  int spans_ = 0;
};

}  // namespace leadscrew::testing_support
