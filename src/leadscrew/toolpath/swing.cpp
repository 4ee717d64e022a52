#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/toolpath/swing.hpp>
#include <numbers>

namespace leadscrew::toolpath {

Swing::Swing(double turn) {
  constexpr double deepest = 6 + 4 * std::numbers::sqrt2;  // −min p / w³
  const double sine = turn / 2, cosine = std::sqrt((1 - sine) * (1 + sine));
  // Newton's method: the slope is near 1 all over the range.
  constexpr int most_steps = 20;
  w_ = 0.11;
  for (int k = 0; k < most_steps; ++k) {
    const double rest = 0.5 - w_;
    const double difference = deepest * w_ * w_ * w_ * cosine - (2 * rest * rest * rest - 0.125);
    const double step = difference / (3 * deepest * w_ * w_ * cosine + 6 * rest * rest);
    w_ -= step;
    if (std::abs(step) < 1e-15) break;
  }
  // Equal but for rounding.
  const double rest = 0.5 - w_, passing = (2 * rest * rest * rest - 0.125) * turn;
  deviation_ = std::max(deepest * w_ * w_ * w_ * 2 * sine * cosine, passing);
}

double Swing::reach() const {
  const double rest = 1 - w_;
  return 2 * rest * rest * rest - 1;
}

/// By the polar form of −u³, and of 2 (u − w)³ behind w.
std::array<double, 6> Swing::control_values() const {
  const double rest = 1 - w_;
  return {0, 0, 0, -w_ * rest, 2 * (1 - 2 * w_) * rest * rest - rest, reach()};
}

}  // namespace leadscrew::toolpath
