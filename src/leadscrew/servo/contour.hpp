#pragma once
// What two position loops make of a contour, in closed form: loops of a proportional gain around a drive with one time
// constant, without sampling,
//
//   H(s) = Kv/(τs² + s + Kv).
//
// Line at the angle α: in the steady state each axis lags Vᵢ/Kᵢ behind its reference, and what of it lies across the
// line is (V/2)·sin 2α·(1/Kx − 1/Ky). With equal gains there is none.
//
// Circle, ω = V/R: each axis swings with R·|H(jω)| and lags by its phase. With equal loops it is a circle of the radius
// R·|H|: smaller, about R·ω²/(2Kv²), while Kv·τ < 1/2, and greater above. With unequal ones it is an ellipse, whose
// axes lie at 45° where only the phases differ; there its error is that of the line, (V/2)·(1/Kx − 1/Ky).

#include <cmath>
#include <numbers>

namespace leadscrew::servo {

struct PositionLoop {
  double gain = 0;           ///< Kv, 1/s; > 0
  double time_constant = 0;  ///< τ, seconds; ≥ 0

  friend bool operator==(const PositionLoop&, const PositionLoop&) = default;
};

/// Distance of the path from the line, mm; positive to the left of the motion. speed: V, mm/s; angle: α, radians.
inline double line_contour_error(double speed, double angle, const PositionLoop& x, const PositionLoop& y) {
  return speed / 2 * std::sin(2 * angle) * (1 / x.gain - 1 / y.gain);
}

/// What inputs within ±1 can move its output by, whatever their course: ∫|h| dt of the impulse response h. That is 1
/// while Kv·τ ≤ 1/4, where the loop never overshoots. Above, each swing of its step response is ρ of the one before,
/// and their sum 1 + 2(ρ + ρ² + …).
inline double greatest_gain(const PositionLoop& loop) {
  const double product = 4 * loop.gain * loop.time_constant;
  if (product <= 1) return 1;
  const double overshoot = std::exp(-std::numbers::pi / std::sqrt(product - 1));
  return (1 + overshoot) / (1 - overshoot);
}

/// To a sine of the frequency ω.
struct Response {
  double amplitude = 0;  ///< |H(jω)|
  double phase = 0;      ///< of H(jω), radians; −π … 0
};

/// frequency: ω, rad/s; ≥ 0
inline Response response(const PositionLoop& loop, double frequency) {
  const double real = loop.gain - loop.time_constant * frequency * frequency;
  return {loop.gain / std::hypot(real, frequency), -std::atan2(frequency, real)};
}

struct SemiAxes {
  double major = 0;  ///< mm
  double minor = 0;  ///< mm
};

/// Of what a circle becomes. radius: mm; frequency: V/R, rad/s.
///
/// x = a·cos(ωt + φ), y = b·sin(ωt + ψ) is a circle under a matrix whose squares sum to a² + b² and whose determinant
/// is a·b·cos(φ − ψ): these are the sum of the squares and the product of the semi-axes.
inline SemiAxes circle_semi_axes(double radius, double frequency, const PositionLoop& x, const PositionLoop& y) {
  const Response of_x = response(x, frequency), of_y = response(y, frequency);
  const double squares = of_x.amplitude * of_x.amplitude + of_y.amplitude * of_y.amplitude;
  const double product = of_x.amplitude * of_y.amplitude * std::fabs(std::cos(of_x.phase - of_y.phase));
  const double sum = std::sqrt(squares + 2 * product), difference = std::sqrt(std::fmax(squares - 2 * product, 0));
  return {radius * (sum + difference) / 2, radius * (sum - difference) / 2};
}

}  // namespace leadscrew::servo
