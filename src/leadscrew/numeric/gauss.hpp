#pragma once
// Gauss-Legendre quadrature with three and with eight points: exact for polynomials of degree 5 and 15 (Abramowitz and
// Stegun, "Handbook of Mathematical Functions", 25.4.29 and table 25.4).

#include <array>

namespace leadscrew::numeric {

struct GaussPoint {
  double abscissa = 0;  ///< on [−1, 1]; its mirror image counts too
  double weight = 0;
};

inline constexpr std::array<GaussPoint, 4> gauss_8 = {{{0.18343464249564980, 0.36268378337836198},
                                                       {0.52553240991632899, 0.31370664587788729},
                                                       {0.79666647741362674, 0.22238103445337447},
                                                       {0.96028985649753623, 0.10122853629037626}}};

/// The same with 16 digits: four of these doubles differ from those of `gauss_8` in their last bit. Durations are told by
/// them, and every word that was recorded with them depends on the bits.
inline constexpr std::array<GaussPoint, 4> gauss_8_of_durations = {{{0.1834346424956498, 0.3626837833783620},
                                                                    {0.5255324099163290, 0.3137066458778873},
                                                                    {0.7966664774136267, 0.2223810344533745},
                                                                    {0.9602898564975363, 0.1012285362903763}}};

/// √0.6: with 0 and its mirror image the three points on [−1, 1].
inline constexpr double gauss_3_abscissa = 0.7745966692414834;
/// The three points on [0, 1], and their weights there.
inline constexpr std::array<double, 3> gauss_3_places = {0.1127016653792583, 0.5, 0.8872983346207417};
inline constexpr std::array<double, 3> gauss_3_weights = {5.0 / 18, 8.0 / 18, 5.0 / 18};

/// ∫ f over [a, b].
template <typename Function>
constexpr double integrate_gauss_8(const Function& f, double a, double b) {
  const double middle = (a + b) / 2, half = (b - a) / 2;
  double sum = 0;
  for (const GaussPoint& point : gauss_8) {
    const double offset = half * point.abscissa;
    sum += point.weight * (f(middle - offset) + f(middle + offset));
  }
  return sum * half;
}

}  // namespace leadscrew::numeric
