// No limit cycle: in a steady cut the override swings no more than the sensor's noise makes it.
//
// A limit cycle has an amplitude of its own, whatever the noise. What noise alone makes of a loop that settles has a
// bound. Be σ the standard deviation of one force over the limit, and N the forces in the mean that is controlled: that
// mean has σ/√N. The stiffness that is believed is that of this change, or lies between it and the last one believed:
// unrolled, a mean of such means, whose weights noise chooses but which have the sum 1. As a function of all the noise
// there was, its gradient is that mean of gradients of the length 1/√N each, no longer than these by the triangle
// inequality, so that by Poincaré's, for Gaussian noise, it deviates by at most σ/√N. Where edges rub with a share e of
// the limit, an override repeats e of the deviation of those before it (adaptive_feed.hpp): Δ ≤ σ/√N + e·Δ. So
//
//   Δ = standard deviation of the override over its mean ≤ σ/√N/(1 − e),
//
// to first order in noise, and at every depth, since the mean is of the limit at each. It is held to this with noise of
// 10 %, and with next to none, where nothing but a cycle would be left.

#include <gtest/gtest.h>

#include "adaptive_cut.hpp"

namespace leadscrew::servo::testing {
namespace test_adaptive_swing {

int tooth_of(const CutOptions& options) {
  return options.turn / options.teeth;
}

/// σ/√N/(1 − e); what no noise explains is below 1e-5.
double explained_swing(const CutOptions& options) {
  const int tooth = tooth_of(options), window = tooth % 4 == 0 ? tooth : tooth * ((4 + tooth - 1) / tooth);
  return options.noise / std::sqrt(window * parts_of(options)) / (1 - options.edge_share) + 1e-5;
}

/// Over 400 passings of a tooth and two seconds, after as many.
template <class Control>
double swing(ControlledCut<Control>& cut, const CutOptions& options, double depth) {
  const int settling = 2000 + 400 * tooth_of(options);
  cut.engagement.depth = depth;
  cut.run(2 * settling);
  const auto begin = cut.overrides.end() - settling, end = cut.overrides.end();
  const double mean = std::accumulate(begin, end, 0.0) / settling;
  const double squares =
      std::accumulate(begin, end, 0.0, [&](double sum, double s) { return sum + (s - mean) * (s - mean); });
  return std::sqrt(squares / settling) / mean;
}

struct Spindle {
  int turn = 0, teeth = 0;  // ms
};
constexpr Spindle spindles[] = {{12, 4}, {20, 4}, {8, 2}, {60, 3}, {16, 1}, {120, 1}};

TEST(AdaptiveSwing, IsNoMoreThanNoiseExplainsAtAnyDepthAndSpeed) {
  for (const Spindle& spindle : spindles) {
    for (const double noise : {1e-9, 0.1}) {
      for (const double edge_share : {0.0, 0.15, 0.3}) {
        for (const double lag : {0.002, 0.04}) {
          const CutOptions options{spindle.turn, spindle.teeth, lag, edge_share, noise, 7};
          AdaptiveCut cut(options);
          for (const double depth : {2.0, 4.0, 1.3, 3.0}) {
            // Edges rub with a greater share of the limit the deeper the cut is.
            CutOptions there = options;
            there.edge_share *= depth / 2;
            const double seen = swing(cut, options, depth), explained = explained_swing(there);
            EXPECT_LE(seen, explained) << spindle.turn << " ms, " << spindle.teeth << " teeth, noise " << noise
                                       << ", edges " << edge_share << ", lag " << lag << ", depth " << depth;
            EXPECT_GT(seen, 0.2 * (explained - 1e-5));  // it is noise that is seen
          }
          EXPECT_EQ(cut.adaptive().failure(), SensorFailure::none);
        }
      }
    }
  }
}

/// What adaptive control is without a measured stiffness: the override moves by a gain times the distance from the
/// limit, of the mean over a passing of a tooth.
class Integrator {
 public:
  Integrator(double gain, const CutOptions& options) : gain_(gain), samples_(tooth_of(options)) {}

  double sample(std::optional<double> force, double /*feed_share*/) {
    sum_ += force.value_or(0);
    if (++count_ < samples_) return override_;
    const double distance = 1 - sum_ / count_ / AdaptiveCut::limit;
    sum_ = count_ = 0;
    return override_ = std::clamp(override_ + gain_ * distance, 0.05, 2.0);
  }
  double feed_override() const { return override_; }

 private:
  double gain_, override_ = 1, sum_ = 0;
  int samples_, count_ = 0;
};

/// The bound is one that can be broken: an integrator that comes to rest in 2 mm cycles in 8 mm, with noise or without.
TEST(AdaptiveSwing, OfAnIntegratorIsFarMoreInAHeavyCut) {
  for (const double noise : {1e-9, 0.1}) {
    const CutOptions options{.turn = 80, .teeth = 4, .lag = 0.02, .noise = noise};
    ControlledCut<Integrator> cut(options, Integrator(1, options));
    if (noise < 0.01) {
      EXPECT_LE(swing(cut, options, 2), explained_swing(options));
    }
    EXPECT_GT(swing(cut, options, 8), 10 * explained_swing(options));
    AdaptiveCut ours(options);
    EXPECT_LE(swing(ours, options, 8), explained_swing(options));
  }
}

}  // namespace test_adaptive_swing
}  // namespace leadscrew::servo::testing
