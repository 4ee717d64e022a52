#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/elementary.hpp>
#include <leadscrew/numeric/jet.hpp>
#include <leadscrew/numeric/pair.hpp>
#include <leadscrew/numeric/sine.hpp>
#include <limits>
#include <numbers>

// Against the functions of the C library in extended precision, 64 bits of mantissa, which reduce any angle exactly.

namespace test_sine {

using leadscrew::numeric::DoubleDouble;
using leadscrew::numeric::Jet;
using leadscrew::numeric::Pair;
using leadscrew::numeric::Sines;
using leadscrew::numeric::sines;

/// In units in the last place of the exact value.
double ulps(double found, long double exact) {
  if (exact == 0) return found == 0 ? 0 : std::numeric_limits<double>::infinity();
  const int exponent = std::max(std::ilogb(exact), -1022);
  return static_cast<double>(std::abs(found - exact) / std::ldexp(1.0L, exponent - 52));
}

struct Errors {
  double sine, cosine;
};
Errors errors_at(DoubleDouble angle) {
  const Sines found = sines(angle);
  const long double high = angle.hi, low = angle.lo;
  const long double sine = std::sin(high), cosine = std::cos(high);
  return {ulps(found.sine, sine + low * cosine), ulps(found.cosine, cosine - low * sine)};
}

void expect_right(DoubleDouble angle) {
  const Errors errors = errors_at(angle);
  EXPECT_LE(errors.sine, 0.75) << angle.hi;
  EXPECT_LE(errors.cosine, 0.75) << angle.hi;
}

TEST(Sines, AreRightAtEvenSteps) {
  double greatest = 0;
  for (int i = -400'000; i <= 400'000; ++i) {
    const Errors errors = errors_at(i * 0x1.0000bp-14);
    greatest = std::max({greatest, errors.sine, errors.cosine});
  }
  EXPECT_LE(greatest, 0.75);
  EXPECT_GT(greatest, 0.5);  // not all are rounded as they should be: the comparison sees what there is
}

TEST(Sines, AreRightNextToMultiplesOfAQuarterTurn) {
  for (double k = 1; k < 660'000; k = std::ceil(k * 1.01)) {
    const double near = k * (std::numbers::pi / 2);
    for (const double angle : {near, std::nextafter(near, 0.0), std::nextafter(near, 1e9), near * 0.5, -near})
      expect_right(angle);
  }
}

TEST(Sines, AreRightOnBothSidesOfTheGreatestNearAngle) {
  const double greatest = leadscrew::numeric::greatest_near_angle;
  for (double step = -1000; step < 1000; step += 0.37) expect_right(greatest + step), expect_right(-greatest - step);
}

RC_GTEST_PROP(Sines, AreRightAtAnyAngle, ()) {
  const double mantissa =
      static_cast<double>(*rc::gen::inRange<std::int64_t>(std::int64_t{1} << 52, std::int64_t{1} << 53));
  const double sign = *rc::gen::element(-1.0, 1.0);
  const double angle = sign * std::ldexp(mantissa, *rc::gen::inRange(-52 - 60, 970));
  const DoubleDouble both(angle, std::ldexp(angle, -54) * *rc::gen::inRange(-100, 100) / 100.0);
  const Errors alone = errors_at(angle);
  RC_ASSERT(alone.sine <= 0.75 && alone.cosine <= 0.75);
  if (std::abs(angle) < 0x1p20) {
    const Errors errors = errors_at(both);
    RC_ASSERT(errors.sine <= 0.75 && errors.cosine <= 0.75);
  }
}

RC_GTEST_PROP(Sines, OfTwoAnglesAtOnceHaveTheBitsOfEachAlone, ()) {
  Pair angles, low;
  for (const std::size_t i : {0, 1}) {
    angles[i] = *rc::gen::inRange(-1'000'000'000, 1'000'000'000) * *rc::gen::element(1e-12, 1e-9, 1e-3);
    low[i] = angles[i] * *rc::gen::element(0.0, 1e-17, -1e-16);
  }
  const auto [sine, cosine] = leadscrew::numeric::near_sines(angles, low);
  const Pair degrees = angles * 100;
  const auto turned = leadscrew::numeric::sines_of_degrees(degrees);
  const auto both = leadscrew::numeric::sines_of_both_degrees<Jet<>>({degrees[0], 1, 2, 3}, {degrees[1], -3, 2, 1});
  for (const std::size_t i : {0, 1}) {
    const Sines alone = sines({angles[i], low[i]});
    RC_ASSERT(sine[i] == alone.sine && cosine[i] == alone.cosine);
    const auto turned_alone = leadscrew::numeric::sines_of_degrees(degrees[i]);
    RC_ASSERT(turned.sine[i] == turned_alone.sine && turned.cosine[i] == turned_alone.cosine);
    const auto jets_alone =
        leadscrew::numeric::sines_of_degrees(i == 0 ? Jet<>(degrees[0], 1, 2, 3) : Jet<>(degrees[1], -3, 2, 1));
    RC_ASSERT(both[i].sine == jets_alone.sine && both[i].cosine == jets_alone.cosine);
  }
}

TEST(Sines, OfSmallAnglesHaveTheCosineLessOne) {
  for (double angle = 1e-300; angle < 0.785; angle *= 1.003) {
    const long double half = std::sin(0.5L * angle);
    if (angle > 1e-150) {
      EXPECT_LE(ulps(sines(angle).cosine_less_one, -2 * half * half), 1.7) << angle;
    }
    EXPECT_EQ(sines(-angle).cosine_less_one, sines(angle).cosine_less_one);
    EXPECT_EQ(sines(-angle).sine, -sines(angle).sine);
  }
}

TEST(Sines, OfNoAngle) {
  EXPECT_EQ(sines(0.0).sine, 0);
  EXPECT_EQ(sines(-0.0).sine, 0);
  EXPECT_EQ(sines(0.0).cosine, 1);
  EXPECT_EQ(sines(0.0).cosine_less_one, 0);
  for (const double angle : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    EXPECT_TRUE(std::isnan(sines(angle).sine));
    EXPECT_TRUE(std::isnan(sines(angle).cosine));
  }
}

}  // namespace test_sine
