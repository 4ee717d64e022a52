#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <leadscrew/kinematics/transformation.hpp>

#include "machines.hpp"

// The same formulas in other scalars: derivatives by jets are those of Richardson's differences, and double-doubles leave no
// rounding in differences of words.

namespace leadscrew::kinematics::testing {
namespace test_scalars {

using numeric::DoubleDouble;
using numeric::Jet;

constexpr Vector tool = {1, -2, 120};

/// Tip and angles along some path: smooth, and never near where angles have no derivatives.
template <typename T>
Coordinates<T> pose_at(const Chain& chain, const T& u) {
  using std::cos, std::sin;
  Coordinates<T> pose{};
  pose[0] = T(30.0) * sin(u) + T(5.0) * u;
  pose[1] = T(40.0) * cos(T(2.0) * u);
  pose[2] = T(-7.0) * u * u + T(12.0);
  pose[base::index(chain.turns()[0].axis)] = T(50.0) * sin(u) + T(20.0) * u;
  pose[base::index(chain.turns()[1].axis)] = T(35.0) + T(20.0) * cos(u);
  return pose;
}

/// Derivatives of three orders by central differences, step by step halved, and what steps leave taken out (Richardson). The
/// function is evaluated in double-double, so that small steps lose nothing.
std::array<double, 3> richardson(const std::function<DoubleDouble(DoubleDouble)>& f, double u) {
  std::array<double, 3> result{};
  for (std::size_t order = 1; order <= 3; ++order) {
    std::array<std::array<DoubleDouble, 5>, 5> table{};
    for (std::size_t n = 0; n < table.size(); ++n) {
      const double step = std::ldexp(0.02, -static_cast<int>(n));
      const auto at = [&](double k) { return f(DoubleDouble(u) + k * step); };
      DoubleDouble& d = table[n][0];
      if (order == 1) d = (at(1) - at(-1)) / DoubleDouble(2 * step);
      if (order == 2) d = (at(1) - at(0) * 2.0 + at(-1)) / DoubleDouble(step * step);
      if (order == 3) d = (at(2) - at(1) * 2.0 + at(-1) * 2.0 - at(-2)) / DoubleDouble(2 * step * step * step);
      double power = 1;
      for (std::size_t j = 1; j <= n; ++j) {
        power *= 4;
        table[n][j] = (table[n][j - 1] * power - table[n - 1][j - 1]) / DoubleDouble(power - 1);
      }
    }
    result[order - 1] = table[4][4].value();
  }
  return result;
}

void expect_derivatives(const Jet<>& jet, const std::array<double, 3>& right, const std::string& what) {
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(jet[k + 1], right[k], 1e-6 * std::max(1.0, std::abs(right[k]))) << what << ", order " << k + 1;
  }
}

TEST(JetsOfAxes, AreRichardsonsDifferences) {
  for (const NamedChain& named : all_chains()) {
    for (const double u : {-1.1, -0.3, 0.4, 0.9}) {
      const Coordinates<Jet<>> axes = machine_of(named.chain, pose_at(named.chain, Jet<>::parameter(u)), tool);
      const Coordinates<Jet<>> back = pose_of(named.chain, axes, tool);
      const Coordinates<Jet<>> pose = pose_at(named.chain, Jet<>::parameter(u));
      for (std::size_t i = 0; i < 3; ++i) {
        const auto of_axis = [&](DoubleDouble at) {
          return machine_of(named.chain, pose_at(named.chain, at), tool)[i];
        };
        expect_derivatives(axes[i], richardson(of_axis, u), named.name);
        for (std::size_t k = 0; k <= 3; ++k) EXPECT_NEAR(back[i][k], pose[i][k], 1e-10) << named.name;
      }
    }
  }
}

template <typename T>
Vector3<T> direction_at(const Chain& chain, const T& u) {
  return direction_of(chain, angles_of(chain, pose_at(chain, u)));
}

TEST(JetsOfDirections, AreRichardsonsDifferences) {
  for (const NamedChain& named : all_chains()) {
    for (const double u : {-1.1, -0.3, 0.4, 0.9}) {
      const Vector3<Jet<>> direction = direction_at(named.chain, Jet<>::parameter(u));
      for (std::size_t i = 0; i < 3; ++i) {
        const auto of_direction = [&](DoubleDouble at) { return direction_at(named.chain, at)[i]; };
        expect_derivatives(direction[i], richardson(of_direction, u), named.name);
      }
    }
  }
}

/// Angles that a direction came of come back with all their derivatives, as one of the solutions.
TEST(JetsOfSolutions, AreThoseOfTheAngles) {
  for (const NamedChain& named : all_chains()) {
    for (const double u : {-1.1, -0.3, 0.4, 0.9}) {
      const auto angles = angles_of(named.chain, pose_at(named.chain, Jet<>::parameter(u)));
      const auto found = solutions(named.chain, direction_at(named.chain, Jet<>::parameter(u)));
      ASSERT_EQ(found.count, 2u);
      int matches = 0;
      for (const Angles<Jet<>>& each : found.angles) {
        if (std::abs(std::remainder(each[1].value - angles[1].value, 360)) > 1e-9) continue;
        ++matches;
        for (std::size_t i = 0; i < 2; ++i) {
          for (std::size_t k = 1; k <= 3; ++k)
            EXPECT_NEAR(each[i][k], angles[i][k], 1e-8 * std::max(1.0, std::abs(angles[i][k]))) << named.name;
        }
      }
      EXPECT_EQ(matches, 1) << named.name;
    }
  }
}

/// Words are rounded once: half a unit in the last place, and next to nothing for what is lost on the way.
TEST(CompensatedNumbers, GiveAxesRoundedOnce) {
  for (const NamedChain& named : all_chains()) {
    const Transformation transformation{named.chain, tool};
    for (int k = -300; k <= 300; ++k) {
      const double u = k / 100.0 + 1e-5;
      const Coordinates<DoubleDouble> pose = pose_at(named.chain, DoubleDouble(u, 1e-18));
      Coordinates<numeric::Compensated> compensated;
      for (std::size_t i = 0; i < pose.size(); ++i) compensated[i] = {pose[i].hi, pose[i].lo};
      const Coordinates<DoubleDouble> right = machine_of(named.chain, pose, tool);
      const Coordinates<double> axes = transformation.axes_of(compensated);
      for (std::size_t i = 0; i < 3; ++i) {
        const double unit = std::nextafter(std::abs(axes[i]), INFINITY) - std::abs(axes[i]);
        const double lost =
            named.chain.turns()[0].principal < 3 && named.chain.turns()[1].principal < 3 ? 1e-15 : 1e-14;
        EXPECT_LE(std::abs((right[i] + -axes[i]).value()), unit / 2 + lost) << named.name << " " << u;
      }
    }
  }
}

/// Along coordinate directions nothing of 30 digits is lost; of oblique ones, which are doubles, none of 15.
TEST(DoubleDoubles, ComeBackToTheirLastDigits) {
  for (const NamedChain& named : all_chains()) {
    const bool is_along = named.chain.turns()[0].principal < 3 && named.chain.turns()[1].principal < 3;
    const double most = is_along ? 1e-28 : 1e-12;
    for (const double u : {-1.1, -0.3, 0.4, 0.9}) {
      const auto pose = pose_at(named.chain, DoubleDouble(u, 1e-18));
      const auto axes = machine_of(named.chain, pose, tool);
      const auto back = pose_of(named.chain, axes, tool);
      Coordinates<double> plain{};
      for (std::size_t i = 0; i < plain.size(); ++i) plain[i] = pose[i].value();
      const auto plain_axes = machine_of(named.chain, plain, tool);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LE(std::abs((back[i] - pose[i]).value()), most) << named.name;
        EXPECT_NEAR(axes[i].value(), plain_axes[i], 1e-12);
      }
      const auto angles = angles_of(named.chain, pose);
      const auto found = solutions(named.chain, direction_of(named.chain, angles));
      ASSERT_EQ(found.count, 2u);
      double nearest = 1;
      for (const auto& each : found.angles) {
        double apart = 0;
        for (std::size_t i = 0; i < 2; ++i) {
          const DoubleDouble off = each[i] - angles[i];
          apart = std::max(apart, std::abs((off + -360 * std::nearbyint(off.hi / 360)).value()));
        }
        nearest = std::min(nearest, apart);
      }
      EXPECT_LE(nearest, most) << named.name;
    }
  }
}

/// Words 10 µs apart, differenced three times and divided by T³: in double-double they say the jerk, in double a rounding
/// error of a unit in the last place says thousands of mm/s³.
TEST(DoubleDoubles, LeaveNoRoundingInDifferencesOfWords) {
  constexpr double period = 1e-5;
  for (const NamedChain& named : all_chains()) {
    const Jet<> at = Jet<>::parameter(0.3);
    const Coordinates<Jet<>> jets = machine_of(named.chain, pose_at(named.chain, at), tool);
    const auto word = [&](double k) {
      return machine_of(named.chain, pose_at(named.chain, DoubleDouble(0.3) + numeric::two_product(k, period)), tool);
    };
    const auto a = word(-1.5), b = word(-0.5), c = word(0.5), d = word(1.5);
    for (std::size_t i = 0; i < 3; ++i) {
      const double third = ((d[i] - a[i]) - (c[i] - b[i]) * 3.0).value() / (period * period * period);
      EXPECT_NEAR(third, jets[i].third, 1e-6 * std::max(1.0, std::abs(jets[i].third))) << named.name;
    }
  }
}

}  // namespace test_scalars
}  // namespace leadscrew::kinematics::testing
