#include <Vby_point_comparison_6.h>
#include <Vdda_6.h>
#include <Vimproved_minimum_error_6.h>
#include <Vminimum_error_6.h>
#include <gtest/gtest.h>

#include <vector>

#include "arc_bench.hpp"

// Figs. 5 to 8: the quarter of radius 5 from (5, 0) to (0, 5), clock by clock from Syn on, and its mirror image, for which
// the paper's formulas are written: clockwise from (0, 5) to (5, 0).

namespace leadscrew::hardware {
namespace test_waveforms {

using pulse::Arc;
using pulse::Direction;
using Wave = std::vector<std::int64_t>;

constexpr Arc quarter{{5, 0}, {0, 5}, Direction::counterclockwise};
constexpr Arc mirrored{{0, 5}, {5, 0}, Direction::clockwise};

/// While it is busy; `look` at the core after each clock.
template <typename Model, typename Reference, typename Look>
Wave wave_of(const Arc& arc, const Look& look) {
  ArcBench<Model, Reference> bench(6);
  Wave wave;
  bench.start(arc);
  for (; bench.core()->Busy && wave.size() < 100; bench.core().clock())
    wave.push_back(look(*bench.core().operator->()));
  return wave;
}

template <typename Model, typename Reference>
void expect_path(const Wave& shrinking, const Wave& growing) {
  const auto x = [](const Model& core) { return signed_of(core.Val_x, 6); };
  const auto z = [](const Model& core) { return signed_of(core.Val_z, 6); };
  EXPECT_EQ((wave_of<Model, Reference>(quarter, x)), shrinking);
  EXPECT_EQ((wave_of<Model, Reference>(quarter, z)), growing);
  EXPECT_EQ((wave_of<Model, Reference>(mirrored, z)), shrinking);
  EXPECT_EQ((wave_of<Model, Reference>(mirrored, x)), growing);
}

template <typename Model, typename Reference, typename Look>
void expect_both_ways(const Look& look, const Wave& wave) {
  EXPECT_EQ((wave_of<Model, Reference>(quarter, look)), wave);
  EXPECT_EQ((wave_of<Model, Reference>(mirrored, look)), wave);
}

TEST(Waveforms, OfFig5ArePointComparison) {
  using Model = Vby_point_comparison_6;
  expect_path<Model, PointComparisonReference>({5, 5, 4, 4, 4, 4, 3, 3, 2, 1, 0}, {0, 1, 1, 2, 3, 4, 4, 5, 5, 5, 5});
  expect_both_ways<Model, PointComparisonReference>([](const Model& core) { return signed_of(core.Val_f, 9); },
                                                    {0, 1, -8, -5, 0, 7, 0, 9, 4, 1, 0});
}

TEST(Waveforms, OfFig6AreTheDda) {
  using Model = Vdda_6;
  expect_path<Model, DdaReference>({5, 5, 5, 4, 4, 3, 2, 1, 0}, {0, 1, 2, 3, 3, 4, 5, 5, 5});
  const Wave lagging{2, 2, 3, 0, 3, 1, 0, 0, 0}, leading{0, 0, 0, 0, 4, 3, 1, 1, 1};
  const auto sum_x = [](const Model& core) { return std::int64_t{core.Sum_X}; };
  const auto sum_z = [](const Model& core) { return std::int64_t{core.Sum_Z}; };
  EXPECT_EQ((wave_of<Model, DdaReference>(quarter, sum_x)), lagging);
  EXPECT_EQ((wave_of<Model, DdaReference>(quarter, sum_z)), leading);
  EXPECT_EQ((wave_of<Model, DdaReference>(mirrored, sum_z)), lagging);
  EXPECT_EQ((wave_of<Model, DdaReference>(mirrored, sum_x)), leading);
}

const Wave least_error_x{5, 5, 5, 4, 3, 2, 1, 0}, least_error_z{0, 1, 2, 3, 4, 5, 5, 5},
    least_error_f{0, 1, 4, 0, 0, 4, 1, 0};

TEST(Waveforms, OfFig7AreMinimumError) {
  using Model = Vminimum_error_6;
  using Reference = LeastErrorReference;
  expect_path<Model, Reference>(least_error_x, least_error_z);
  const Wave n1{-8, -5, 0, 0, 4, 12, 11, -8}, n2{1, 4, 9, 7, 9, 15, 12, -9}, n3{-9, -8, -5, -7, -5, 1, 0, 1};
  const auto both = [](const Model& core) { return signed_of(core.Val_n1, 9); };
  const auto z_alone = [](const Model& core) { return signed_of(core.Val_n2, 9); };
  const auto x_alone = [](const Model& core) { return signed_of(core.Val_n3, 9); };
  expect_both_ways<Model, Reference>([](const Model& core) { return signed_of(core.Val_f, 9); }, least_error_f);
  expect_both_ways<Model, Reference>(both, n1);
  EXPECT_EQ((wave_of<Model, Reference>(quarter, z_alone)), n2);
  EXPECT_EQ((wave_of<Model, Reference>(quarter, x_alone)), n3);
  EXPECT_EQ((wave_of<Model, Reference>(mirrored, x_alone)), n2);
  EXPECT_EQ((wave_of<Model, Reference>(mirrored, z_alone)), n3);
}

TEST(Waveforms, OfFig8AreImprovedMinimumError) {
  using Model = Vimproved_minimum_error_6;
  using Reference = ImprovedLeastErrorReference;
  expect_path<Model, Reference>(least_error_x, least_error_z);
  expect_both_ways<Model, Reference>([](const Model& core) { return signed_of(core.Val_f, 9); }, least_error_f);
  expect_both_ways<Model, Reference>([](const Model& core) { return signed_of(core.Val_d, 11); },
                                     {15, 3, -17, -13, 3, -25, -21, 15});
}

/// The candidates are F where their steps would lead, all round every circle.
TEST(Waveforms, OfCandidatesAreWhatTheStepsWouldMakeOfF) {
  ArcBench<Vminimum_error_6, LeastErrorReference> bench(6);
  for (std::int64_t radius = 1; radius <= 29; ++radius) {
    for (const Direction direction : {Direction::clockwise, Direction::counterclockwise}) {
      bench.start({{0, -radius}, {0, -radius}, direction});
      while (bench.core()->Busy && !(bench.at() == pulse::Point{0, -radius} && bench.core()->X_Pwm_Out)) {
        const auto [x, z] = bench.at();
        const auto [dx, dz] = pulse::tangent(pulse::quadrant(pulse::Point{x, z}, direction), direction).step;
        const auto f = [&](std::int64_t u, std::int64_t v) { return u * u + v * v - radius * radius; };
        ASSERT_EQ(signed_of(bench.core()->Val_n1, 9), f(x + dx, z + dz)) << radius << ": " << x << ' ' << z;
        ASSERT_EQ(signed_of(bench.core()->Val_n2, 9), f(x, z + dz)) << radius << ": " << x << ' ' << z;
        ASSERT_EQ(signed_of(bench.core()->Val_n3, 9), f(x + dx, z)) << radius << ": " << x << ' ' << z;
        bench.core().clock();
      }
    }
  }
}

}  // namespace test_waveforms
}  // namespace leadscrew::hardware
