#include <cmath>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/numeric/power.hpp>

namespace leadscrew::numeric {

namespace {

constexpr DoubleDouble fine_ln_2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

}  // namespace

/// Of r + k ln 2, |r| ≤ ln 2/2: 2ᵏ (1 + r (1 + r/2 (1 + r/3 (1 + …)))), to terms below 2⁻¹⁰⁶.
DoubleDouble exp(DoubleDouble x) {
  constexpr int terms = 28;
  const double k = std::floor(x.hi / fine_ln_2.hi + 0.5);
  const DoubleDouble r = x - fine_ln_2 * k;
  DoubleDouble sum = 1;
  for (int n = terms; n > 0; --n) sum = sum * r / DoubleDouble(n) + 1;
  const double power = std::ldexp(1.0, static_cast<int>(k));
  return {sum.hi * power, sum.lo * power};
}

/// From the nearest double y, by one step: ln x = y + ln(1 + d), d = x e⁻ʸ − 1, and d is so small that d − d²/2 is its logarithm.
DoubleDouble fine_log(double x) {
  const double near = log(x);
  const DoubleDouble d = exp(-near) * x - 1;
  return d - d * d * 0.5 + near;
}

double pow(double base, double x) {
  return exp(fine_log(base) * x).value();
}

}  // namespace leadscrew::numeric
