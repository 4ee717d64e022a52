#pragma once
// Tool centre point control: what lies between a path of the tool's tip and the rotary axes, and the machine's axes.

#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/chain.hpp>
#include <leadscrew/kinematics/pose.hpp>
#include <leadscrew/numeric/compensated.hpp>

namespace leadscrew::kinematics {

/// A chain and the tool that it holds.
struct Transformation {
  Chain chain;
  Vector tool{};  ///< its offset in X, Y and Z, mm

  /// X Y Z of the tip in the workpiece become those of the axes; all others stay.
  template <typename T>
  Coordinates<T> axes_of(const Coordinates<T>& tip_and_rotary) const {
    return machine_of(chain, tip_and_rotary, tool);
  }
  /// Rounded once: within about one unit in the last place of the axes' own coordinates, as long as distances from the
  /// axes of rotation are below a hundred times those. Words are differenced three times.
  Coordinates<double> axes_of(const Coordinates<numeric::Compensated>& tip_and_rotary) const {
    const Coordinates<numeric::Compensated> axes = machine_of(chain, tip_and_rotary, tool);
    Coordinates<double> rounded;
    for (std::size_t i = 0; i < axes.size(); ++i) rounded[i] = axes[i].value();
    return rounded;
  }
  /// The same bits as of what has no rounding error.
  Coordinates<double> axes_of(const Coordinates<double>& tip_and_rotary) const {
    Coordinates<numeric::Compensated> exact;
    for (std::size_t i = 0; i < exact.size(); ++i) exact[i] = tip_and_rotary[i];
    return axes_of(exact);
  }
  /// The way back.
  template <typename T>
  Coordinates<T> tip_of(const Coordinates<T>& axes) const {
    return pose_of(chain, axes, tool);
  }
};

/// How much the tip's path bends against the one that it takes while every axis goes straight: what chords of axes between
/// words leave of the tip's path is (T·ṡ)²/8 times this (Lin and Koren, eq. 3). `axes` and `tip` are the same place, with
/// derivatives by the path's length. Per unit of that length squared, mm; ≥ 0.
///
/// An axis departs from its chord by q″(Tṡ)²/8, and the tip by J q″ of that, J = ∂tip/∂axes: across the path it counts,
/// along it there is no error.
inline double tip_bend(const Transformation& transformation, const Coordinates<numeric::Jet<>>& axes,
                       const Coordinates<numeric::Jet<>>& tip) {
  Coordinates<numeric::Jet<1>> departing;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    departing[i] = axes[i].value;
    departing[i][1] = axes[i].second;
  }
  const auto departed = transformation.tip_of(departing);
  double along = 0, square = 0, speed = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    along += departed[i][1] * tip[i].first;
    square += departed[i][1] * departed[i][1];
    speed += tip[i].first * tip[i].first;
  }
  if (speed > 0) square -= along * along / speed;
  return std::sqrt(std::max(square, 0.0));
}

}  // namespace leadscrew::kinematics
