#include <array>
#include <cmath>
#include <cstddef>
#include <leadscrew/numeric/compensated.hpp>
#include <leadscrew/numeric/elementary.hpp>

namespace leadscrew::numeric {

namespace {

// sin(t + r) and cos(t + r) by the addition theorems, with t the multiple of 1/64 next to the angle, so that |r| ≤ 1/128
// and few terms of the series of r count. What a term adds is made in double as soon as that is exact enough.

constexpr int steps_of_radian = 64;
constexpr std::size_t node_count = 52;  ///< up to 51/64 > π/4

/// sin x = x − x³/3! + …, 0 ≤ x < 1, to all digits.
constexpr DoubleDouble sine_by_series(DoubleDouble x) {
  const DoubleDouble square = x * x;
  DoubleDouble term = x, sum = x;
  for (int k = 2; k < 34; k += 2) {
    term = -(term * square) / DoubleDouble(k * (k + 1));
    sum = sum + term;
  }
  return sum;
}

/// cos x = 1 − x²/2! + …, 0 ≤ x < 1, to all digits.
constexpr DoubleDouble cosine_by_series(DoubleDouble x) {
  const DoubleDouble square = x * x;
  DoubleDouble term = 1, sum = 1;
  for (int k = 1; k < 33; k += 2) {
    term = -(term * square) / DoubleDouble(k * (k + 1));
    sum = sum + term;
  }
  return sum;
}

/// Sines and cosines of 0, 1/64, 2/64, …
constexpr auto nodes = [] {
  std::array<SinePair<DoubleDouble>, node_count> all{};
  for (std::size_t j = 0; j < node_count; ++j) {
    const double t = static_cast<double>(j) / steps_of_radian;
    all[j] = {sine_by_series(t), cosine_by_series(t)};
  }
  return all;
}();

constexpr DoubleDouble one_sixth = DoubleDouble(1) / DoubleDouble(6);
constexpr DoubleDouble one_120th = DoubleDouble(1) / DoubleDouble(120);
constexpr DoubleDouble one_24th = DoubleDouble(1) / DoubleDouble(24);

/// Of |r| ≤ 1/128: sin r and cos r − 1.
SinePair<DoubleDouble> small_sines(DoubleDouble r) {
  const DoubleDouble z = r * r;
  const double small = z.hi;
  const double sine_tail = small * (-1.0 / 5040 + small * (1.0 / 362880 - small * (1.0 / 39916800)));
  const double cosine_tail = small * (-1.0 / 720 + small * (1.0 / 40320 - small * (1.0 / 3628800)));
  const DoubleDouble sine_factor = z * (z * (one_120th + sine_tail) - one_sixth);
  const DoubleDouble cosine_rest = z * (z * (one_24th + cosine_tail) - DoubleDouble(0.5));
  return {r + r * sine_factor, cosine_rest};
}

/// Of |angle| ≤ π/4, and what rounding adds.
SinePair<DoubleDouble> sines_near_zero(DoubleDouble angle) {
  if (!(std::abs(angle.hi) < 0.79)) return {NAN, NAN};
  const bool is_negative = angle.hi < 0;
  const DoubleDouble positive = is_negative ? -angle : angle;
  const double node = std::floor(positive.hi * steps_of_radian + 0.5);
  const auto [sine, cosine] = nodes[static_cast<std::size_t>(node)];
  const auto [rest_sine, rest_cosine] = small_sines(positive + -node / steps_of_radian);
  const DoubleDouble s = sine + (cosine * rest_sine + sine * rest_cosine);
  const DoubleDouble c = cosine + (cosine * rest_cosine - sine * rest_sine);
  return {is_negative ? -s : s, c};
}

/// −x, but 0 of 0.
DoubleDouble negated(DoubleDouble x) {
  return {0 - x.hi, 0 - x.lo};
}
Compensated negated(Compensated x) {
  return {0 - x.sum, 0 - x.error};
}
double negated(double x) {
  return 0 - x;
}

/// Turned by so many quarters.
template <typename T>
SinePair<T> turned(const SinePair<T>& sines, double quarters) {
  const double quadrant = quarters - 4 * std::floor(quarters * 0.25);
  if (quadrant == 0) return sines;
  if (quadrant == 1) return {sines.cosine, negated(sines.sine)};
  if (quadrant == 2) return {negated(sines.sine), negated(sines.cosine)};
  return {negated(sines.cosine), sines.sine};
}

/// π/2 behind the digits that a double-double has of it.
constexpr double quarter_third_part = 1.4973849048591833e-33;

/// |x| < 2⁵¹. Without a call: the cycle makes none of the library's.
double nearest_whole(double x) {
  constexpr double units = 0x1.8p52;  // from here on doubles are whole
  return (x + units) - units;
}

}  // namespace

DoubleDouble sqrt(DoubleDouble a) {
  if (!(a.hi > 0)) return 0;
  const double root = std::sqrt(a.hi);
  return two_sum(root, ((a - two_product(root, root)) * (0.5 / root)).value());
}

DoubleDouble hypot(DoubleDouble x, DoubleDouble y) {
  return sqrt(x * x + y * y);
}

DoubleDouble hypot(DoubleDouble x, DoubleDouble y, DoubleDouble z) {
  return sqrt(x * x + y * y + z * z);
}

SinePair<DoubleDouble> sine_cosine(DoubleDouble angle) {
  const DoubleDouble quarter = two_pi * 0.25;
  const double quarters = nearest_whole(angle.hi / quarter.hi);
  const DoubleDouble rest = angle - two_product(quarters, quarter.hi) - two_product(quarters, quarter.lo);
  return turned(sines_near_zero(rest + -quarters * quarter_third_part), quarters);
}

DoubleDouble sin(DoubleDouble angle) {
  return sine_cosine(angle).sine;
}

DoubleDouble cos(DoubleDouble angle) {
  return sine_cosine(angle).cosine;
}

/// From the nearest double a, by one step: the angle of (x, y) is a + atan((y cos a − x sin a)/(x cos a + y sin a)), and
/// that arc tangent is so small that its argument is it.
DoubleDouble atan2(DoubleDouble y, DoubleDouble x) {
  const double near = atan2(y.hi, x.hi);
  if (x.hi == 0 && y.hi == 0) return near;
  const auto [s, c] = sine_cosine(near);
  return (y * c - x * s) / (x * c + y * s) + near;
}

SinePair<DoubleDouble> sines_of_degrees(DoubleDouble angle) {
  const double quarters = nearest_whole(angle.hi * (1.0 / 90));
  return turned(sines_near_zero((angle + -90 * quarters) * radians_of_degree), quarters);
}

/// As sines_near_zero(), with what the rest of the angle adds in double: it is below 2⁻⁷, its rounding errors below 2⁻⁶⁰.
SinePair<Compensated> sines_of_degrees(Compensated angle) {
  const double quarters = nearest_whole(angle.sum * (1.0 / 90));
  const double degrees = angle.sum - 90 * quarters;
  const DoubleDouble product = two_product(degrees, radians_of_degree.hi);
  const double low = product.lo + (degrees * radians_of_degree.lo + angle.error * radians_of_degree.hi);
  if (!(std::abs(product.hi) < 0.79)) return {NAN, NAN};
  const double steps = nearest_whole(product.hi * steps_of_radian);
  const auto& [sine, cosine] = nodes[static_cast<std::size_t>(std::abs(steps))];
  const double s = steps < 0 ? -sine.hi : sine.hi, s_low = steps < 0 ? -sine.lo : sine.lo;
  const double r = product.hi - steps / steps_of_radian, z = r * r;
  const double tail =
      low * (1 - 0.5 * z) + r * (z * (-1.0 / 6 + z * (1.0 / 120 - z * (1.0 / 5040))));  // of sin(r + low)
  const double less_one = z * (-0.5 + z * (1.0 / 24 - z * (1.0 / 720))) - r * low;      // cos(r + low) − 1
  const double sine_rest = cosine.hi * r + (cosine.hi * tail + s * less_one);
  const double cosine_rest = cosine.hi * less_one - s * (r + tail);
  const DoubleDouble both[] = {quick_two_sum(s, sine_rest + s_low), quick_two_sum(cosine.hi, cosine_rest + cosine.lo)};
  return turned<Compensated>({{both[0].hi, both[0].lo}, {both[1].hi, both[1].lo}}, quarters);
}

SinePair<double> sines_of_degrees(double angle) {
  const double quarters = nearest_whole(angle * (1.0 / 90)), degrees = angle - 90 * quarters;
  const DoubleDouble radians = two_product(degrees, radians_of_degree.hi);
  const Sines rest = sines({radians.hi, radians.lo + degrees * radians_of_degree.lo});
  return turned<double>({rest.sine, rest.cosine}, quarters);
}

SinePair<Pair> sines_of_degrees(Pair angles) {
  constexpr double units = 0x1.8p52;
  const Pair quarters = (angles * (1.0 / 90) + units) - units, degrees = angles - 90 * quarters;
  const DoubleDouble first = two_product(degrees[0], radians_of_degree.hi);
  const DoubleDouble second = two_product(degrees[1], radians_of_degree.hi);
  const Pair low = Pair{first.lo, second.lo} + degrees * radians_of_degree.lo;
  const auto [sine, cosine] = near_sines(Pair{first.hi, second.hi}, low);
  const SinePair<double> one = turned<double>({sine[0], cosine[0]}, quarters[0]);
  const SinePair<double> other = turned<double>({sine[1], cosine[1]}, quarters[1]);
  return {Pair{one.sine, other.sine}, Pair{one.cosine, other.cosine}};
}

}  // namespace leadscrew::numeric
