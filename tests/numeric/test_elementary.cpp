#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/compensated.hpp>
#include <leadscrew/numeric/elementary.hpp>
#include <leadscrew/numeric/sine.hpp>
#include <quad.hpp>

// Judged by series and continued fractions of their own in quadruple precision (113 bits), and by identities.

namespace test_elementary {

using leadscrew::numeric::Compensated;
using leadscrew::numeric::DoubleDouble;
using leadscrew::numeric::Jet;
using leadscrew::numeric::SinePair;
using leadscrew::numeric::sines_of_degrees;
using testing_support::magnitude;
using testing_support::Quad;
using testing_support::quad;

/// By halving the angle twelve times, ten terms of the series of 1 − cos, and doubling: 1 − cos 2x = 2(1 − cos x)(1 + cos x).
struct QuadSines {
  Quad sine, cosine;
};
QuadSines quad_sines(Quad angle) {
  const Quad small = angle / 4096, square = small * small;
  Quad term = small, sine = small;
  for (int k = 2; k < 16; k += 2) sine += term *= -square / (k * (k + 1));
  Quad part = square / 2, versine = part;
  for (int k = 3; k < 17; k += 2) versine += part *= -square / (k * (k + 1));
  for (int i = 0; i < 12; ++i) {
    const Quad cosine = 1 - versine;
    versine = 2 * sine * sine;
    sine = 2 * sine * cosine;
  }
  return {sine, 1 - versine};
}

rc::Gen<double> doubles(double greatest) {
  return rc::gen::map(rc::gen::inRange<std::int64_t>(-(1LL << 52), 1LL << 52), [greatest](std::int64_t mantissa) {
    return greatest * std::ldexp(static_cast<double>(mantissa), -52);
  });
}
rc::Gen<DoubleDouble> fine_numbers(double greatest) {
  return rc::gen::map(rc::gen::pair(doubles(greatest), doubles(1)), [](const auto& parts) {
    return leadscrew::numeric::quick_two_sum(parts.first, parts.first * std::ldexp(parts.second, -54));
  });
}

const Quad hundred_bits = static_cast<Quad>(std::ldexp(1.0, -100));

RC_GTEST_PROP(FineSines, HaveAHundredBits, ()) {
  const DoubleDouble angle = *fine_numbers(*rc::gen::element(0.01, 0.8, 3.2, 25.0));
  const auto [sine, cosine] = leadscrew::numeric::sine_cosine(angle);
  const QuadSines right = quad_sines(quad(angle));
  RC_ASSERT(magnitude(quad(sine) - right.sine) <= hundred_bits);
  RC_ASSERT(magnitude(quad(cosine) - right.cosine) <= hundred_bits);
  RC_ASSERT(leadscrew::numeric::sin(angle).hi == sine.hi && leadscrew::numeric::cos(angle).hi == cosine.hi);
}

RC_GTEST_PROP(FineSines, OfSmallAnglesHaveAHundredBitsOfTheirOwn, ()) {
  const DoubleDouble angle = *fine_numbers(std::ldexp(1.0, *rc::gen::inRange(-40, -7)));
  const QuadSines right = quad_sines(quad(angle));
  RC_ASSERT(magnitude(quad(leadscrew::numeric::sin(angle)) - right.sine) <= hundred_bits * magnitude(right.sine));
}

/// 360° are 2π, however many turns there are.
RC_GTEST_PROP(SinesOfDegrees, AreThoseOfRadians, ()) {
  const DoubleDouble angle = *fine_numbers(200);
  const int turns = *rc::gen::inRange(-1000, 1000);
  const auto [sine, cosine] = sines_of_degrees(angle);
  const QuadSines right = quad_sines(quad(angle * leadscrew::numeric::radians_of_degree));
  RC_ASSERT(magnitude(quad(sine) - right.sine) <= 4 * hundred_bits);
  RC_ASSERT(magnitude(quad(cosine) - right.cosine) <= 4 * hundred_bits);
  const auto [far_sine, far_cosine] = sines_of_degrees(angle + 360.0 * turns);
  RC_ASSERT(magnitude(quad(far_sine - sine)) <= hundred_bits * 4096);
  RC_ASSERT(magnitude(quad(far_cosine - cosine)) <= hundred_bits * 4096);
  const SinePair<double> plain = sines_of_degrees(angle.hi);
  const auto [of_double, cosine_of_double] = sines_of_degrees(DoubleDouble(angle.hi));
  RC_ASSERT(std::abs((of_double - plain.sine).value()) <= std::ldexp(std::abs(plain.sine), -52));
  RC_ASSERT(std::abs((cosine_of_double - plain.cosine).value()) <= std::ldexp(std::abs(plain.cosine), -52));
}

/// The error that is carried along counts.
RC_GTEST_PROP(SinesOfDegrees, OfCompensatedNumbersHaveFiftyEightBits, ()) {
  const DoubleDouble angle = *fine_numbers(*rc::gen::element(1e-3, 1.0, 200.0, 1e5));
  const auto [sine, cosine] = sines_of_degrees(Compensated(angle.hi, angle.lo));
  const auto [right_sine, right_cosine] = sines_of_degrees(angle);
  const auto error = [](const Compensated& x, const DoubleDouble& right) {
    return std::abs((DoubleDouble(x.sum) - right + x.error).value());
  };
  RC_ASSERT(error(sine, right_sine) <= std::ldexp(1.0, -58));
  RC_ASSERT(error(cosine, right_cosine) <= std::ldexp(1.0, -58));
}

/// Sums that cancel leave what was rounded away.
TEST(CompensatedNumbers, KeepWhatCancels) {
  const Compensated tenth = 0.1, three = 3.0;
  EXPECT_EQ((tenth * three - Compensated(0.3)).value(), std::fma(0.1, 3.0, -0.3));
  EXPECT_EQ((Compensated(1.0) + 1e-30 - Compensated(1.0)).value(), 1e-30);
  EXPECT_EQ((tenth * 3.0 - tenth * three).value(), 0);
}

TEST(SinesOfDegrees, OfQuarterTurnsAreExact) {
  for (int k = -4000; k <= 4000; ++k) {
    const double sine = k % 2 == 0 ? 0 : ((k % 4 + 4) % 4 == 1 ? 1 : -1);
    const double cosine = k % 2 != 0 ? 0 : ((k % 4 + 4) % 4 == 0 ? 1 : -1);
    const SinePair<double> plain = sines_of_degrees(90.0 * k);
    const SinePair<DoubleDouble> fine = sines_of_degrees(DoubleDouble(90.0 * k));
    ASSERT_EQ(plain.sine, sine) << k;
    ASSERT_EQ(plain.cosine, cosine) << k;
    ASSERT_TRUE(fine.sine.hi == sine && fine.sine.lo == 0 && fine.cosine.hi == cosine && fine.cosine.lo == 0) << k;
    ASSERT_FALSE(std::signbit(plain.sine) && sine == 0) << k;
  }
  EXPECT_TRUE(std::isnan(sines_of_degrees(DoubleDouble(NAN)).sine.hi));
}

/// sin(πd/180)′ = π/180 cos …, of an angle that is itself a parabola.
TEST(SinesOfDegrees, HaveTheirDerivatives) {
  const Jet<> u = Jet<>::parameter(0.3);
  const Jet<> degrees = 20.0 + 70.0 * u - 33.0 * u * u;
  const Jet<> radians = degrees * leadscrew::numeric::radians_of_degree.hi;
  const auto [sine, cosine] = sines_of_degrees(degrees);
  const auto [five_sine, five_cosine] =
      sines_of_degrees(20.0 + 70.0 * Jet<5>::parameter(0.3) - 33.0 * Jet<5>::parameter(0.3) * Jet<5>::parameter(0.3));
  for (std::size_t k = 0; k <= 3; ++k) {
    EXPECT_NEAR(sine[k], sin(radians)[k], 1e-14);
    EXPECT_NEAR(cosine[k], cos(radians)[k], 1e-14);
    EXPECT_NEAR(five_sine[k], sine[k], 1e-14);
    EXPECT_NEAR(five_cosine[k], cosine[k], 1e-14);
  }
}

RC_GTEST_PROP(FineArcTangent, TurnsTheSinesBack, ()) {
  const double most = *rc::gen::element(1e-9, 0.01, 3.14);
  const DoubleDouble angle = *fine_numbers(most);
  const double radius = 1e-3 + std::abs(*doubles(1000));
  const auto [sine, cosine] = leadscrew::numeric::sine_cosine(angle);
  const DoubleDouble found = leadscrew::numeric::atan2(radius * sine, radius * cosine);
  RC_ASSERT(magnitude(quad(found - angle)) <= 4 * hundred_bits * magnitude(quad(angle)));
}

TEST(FineArcTangent, OfAxesIsThatOfDoubles) {
  using leadscrew::numeric::atan2;
  EXPECT_EQ(atan2(DoubleDouble(0), DoubleDouble(0)).value(), 0);
  EXPECT_EQ(atan2(DoubleDouble(0), DoubleDouble(5)).value(), 0);
  const DoubleDouble half = atan2(DoubleDouble(0), DoubleDouble(-5)) - leadscrew::numeric::two_pi * 0.5;
  const DoubleDouble quarter = atan2(DoubleDouble(-3), DoubleDouble(0)) + leadscrew::numeric::two_pi * 0.25;
  EXPECT_LT(std::abs(half.value()), 1e-31);
  EXPECT_LT(std::abs(quarter.value()), 1e-31);
}

RC_GTEST_PROP(FineRoot, SquaredIsItsArgument, ()) {
  const DoubleDouble number = *fine_numbers(std::ldexp(1.0, *rc::gen::inRange(-60, 60)));
  const DoubleDouble a = number.hi < 0 ? -number : number;
  const Quad root = quad(leadscrew::numeric::sqrt(a));
  RC_ASSERT(magnitude(root * root - quad(a)) <= 2 * hundred_bits * quad(a));
  const DoubleDouble three = a * 3.0, four = a * 4.0, twelve = a * 12.0;
  RC_ASSERT(magnitude(quad(leadscrew::numeric::hypot(three, four)) - 5 * quad(a)) <= 8 * hundred_bits * quad(a));
  RC_ASSERT(magnitude(quad(leadscrew::numeric::hypot(three, four, twelve)) - 13 * quad(a)) <=
            16 * hundred_bits * quad(a));
  RC_ASSERT(leadscrew::numeric::sqrt(DoubleDouble(0)).value() == 0);
}

/// Jets of double-doubles have the functions that jets of doubles have.
TEST(FineJets, HaveSinesAndArcTangents) {
  using Fine = Jet<3, DoubleDouble>;
  const Fine u = Fine::parameter(0.4), angle = u * u + DoubleDouble(0.1);
  const Fine back = atan2(sin(angle), cos(angle));
  for (std::size_t k = 0; k <= 3; ++k) EXPECT_NEAR((back[k] - angle[k]).value(), 0, 1e-28);
  const auto [sine, cosine] = sines_of_degrees(angle * DoubleDouble(leadscrew::numeric::degrees_of_radian));
  for (std::size_t k = 0; k <= 3; ++k) EXPECT_NEAR((sine[k] - sin(angle)[k]).value(), 0, 1e-29);
}

}  // namespace test_elementary
