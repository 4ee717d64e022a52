#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/numeric/double_double.hpp>
#include <quad.hpp>

// Quadruple precision (113 bits) by the compiler's own arithmetic is the judge.

namespace test_double_double {

using leadscrew::numeric::DoubleDouble;
using testing_support::magnitude;
using testing_support::Quad;
using testing_support::quad;

rc::Gen<double> numbers() {
  return rc::gen::map(rc::gen::pair(rc::gen::inRange<std::int64_t>(-(1LL << 53), 1LL << 53), rc::gen::inRange(-90, 30)),
                      [](const auto& parts) { return std::ldexp(static_cast<double>(parts.first), parts.second); });
}

rc::Gen<DoubleDouble> wide_numbers() {
  return rc::gen::map(rc::gen::pair(numbers(), rc::gen::inRange<std::int64_t>(-(1LL << 52), 1LL << 52)),
                      [](const auto& parts) {
                        const double low = parts.first * std::ldexp(static_cast<double>(parts.second), -106);
                        return leadscrew::numeric::quick_two_sum(parts.first, low);
                      });
}

RC_GTEST_PROP(DoubleDouble, SumOfTwoIsExact, ()) {
  const double a = *numbers(), b = *numbers();
  RC_ASSERT(quad(leadscrew::numeric::two_sum(a, b)) == static_cast<Quad>(a) + static_cast<Quad>(b));
}

RC_GTEST_PROP(DoubleDouble, ProductOfTwoIsExact, ()) {
  const double a = *numbers(), b = *numbers();
  RC_ASSERT(quad(leadscrew::numeric::two_product(a, b)) == static_cast<Quad>(a) * static_cast<Quad>(b));
}

RC_GTEST_PROP(DoubleDouble, ArithmeticKeepsAHundredBits, ()) {
  const DoubleDouble a = *wide_numbers(), b = *wide_numbers();
  const Quad tolerance = static_cast<Quad>(std::ldexp(1.0, -100));
  const Quad sum = quad(a) + quad(b);
  RC_ASSERT(magnitude(quad(a + b) - sum) <= tolerance * (magnitude(quad(a)) + magnitude(quad(b))));
  RC_ASSERT(magnitude(quad(a - b) - (quad(a) - quad(b))) <= tolerance * (magnitude(quad(a)) + magnitude(quad(b))));
  const Quad product = quad(a) * quad(b);
  RC_ASSERT(magnitude(quad(a * b) - product) <= tolerance * magnitude(product));
  RC_ASSERT(magnitude(quad(a * b.hi) - quad(a) * static_cast<Quad>(b.hi)) <= tolerance * magnitude(product));
  RC_PRE(b.hi != 0);
  const Quad quotient = quad(a) / quad(b);
  RC_ASSERT(magnitude(quad(a / b) - quotient) <= tolerance * magnitude(quotient));
}

TEST(DoubleDouble, TwoPiHasThirtyTwoDigits) {
  // 2π = 6.28318530717958647692528676655900576839…; the literal is quadruple precision by the sum of its parts.
  const Quad two_pi = static_cast<Quad>(6283185307179586476LL) / 1000000000000000000LL +
                      static_cast<Quad>(925286766559005768LL) / 1000000000000000000LL / 1000000000000000000LL;
  EXPECT_LT(static_cast<double>(magnitude(quad(leadscrew::numeric::two_pi) - two_pi)), 1e-31);
}

TEST(DoubleDouble, OrderLooksAtBothParts) {
  const DoubleDouble one{1, 0}, more{1, 1e-20};
  EXPECT_TRUE(one < more);
  EXPECT_FALSE(more < one);
  EXPECT_FALSE(one < one);
  EXPECT_TRUE(one <= one);
}

}  // namespace test_double_double
