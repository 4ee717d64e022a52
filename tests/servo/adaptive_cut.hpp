#pragma once
// A cut under adaptive control, millisecond by millisecond: the feed follows the override with a lag, the sensor gives
// the force's mean over each millisecond.

#include <algorithm>
#include <cmath>
#include <leadscrew/servo/adaptive_feed.hpp>
#include <leadscrew/servo/cutting_force.hpp>
#include <leadscrew/servo/motion.hpp>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace leadscrew::servo::testing {

struct CutOptions {
  int turn = 20;          ///< of the spindle, ms
  int teeth = 4;          ///< a whole number of ms each
  double lag = 0.02;      ///< of the feed behind the override, seconds
  double edge_share = 0;  ///< of the force at the programmed feed that does not depend on it
  double noise = 0.05;    ///< of the limit
  std::uint64_t seed = 1;
};

/// Of a millisecond, each with a force and noise of its own: at least 32 while a tooth passes.
inline int parts_of(const CutOptions& options) {
  return std::max(4, 32 * options.teeth / options.turn);
}

/// Control: sample(force, feed_share) gives the override, feed_override() repeats it; as AdaptiveFeed.
template <class Control>
class ControlledCut {
 public:
  static constexpr double feed = 10;    // mm/s, programmed
  static constexpr double limit = 400;  // N: what the programmed feed gives at a depth of 2 mm

  ControlledCut(const CutOptions& options, Control control)
      : options_(options), mill_(MillingForce::create(milling(options)).value()), control_(std::move(control)) {}

  /// One millisecond. What the sensor says is what `sense` makes of the force.
  template <class Sense>
  void step(Sense&& sense) {
    const int parts = parts_of(options_);
    double force = 0, travelled = 0;
    for (int part = 0; part < parts; ++part) {
      const double before = motion_.position;
      motion_ = servo::after(motion_, {feed * control_.feed_override() / options_.lag, 1 / options_.lag}, 1e-3 / parts);
      travelled += motion_.position - before;
      force += mill_.after(1e-3 / parts, motion_.velocity, engagement) / parts;
    }
    forces.push_back(force);
    overrides.push_back(control_.sample(sense(force), travelled / (feed * 1e-3)));
  }
  void run(int milliseconds) {
    for (int k = 0; k < milliseconds; ++k) step([](double force) { return std::optional(force); });
  }

  /// Over the turn that ends now, N.
  double mean_force() const { return std::accumulate(forces.end() - options_.turn, forces.end(), 0.0) / options_.turn; }

  const Control& adaptive() const { return control_; }
  Control& adaptive() { return control_; }
  const MillingForce& mill() const { return mill_; }

  Engagement engagement{2, 4};
  std::vector<double> forces;     // N, of each millisecond
  std::vector<double> overrides;  // after it

 private:
  static MillingOptions milling(const CutOptions& options) {
    MillingOptions milling{.teeth = options.teeth, .diameter = 10, .spindle_speed = 1000.0 / options.turn};
    milling.noise = options.noise * limit;
    milling.seed = options.seed;
    const double engaged = std::acos(1 - 2 * 4 / 10.0), shape = options.teeth * 2 / (2 * 3.14159265358979323846);
    const double feed_per_tooth = feed / (milling.spindle_speed * options.teeth);
    milling.cutting_coefficient = limit * (1 - options.edge_share) / (shape * feed_per_tooth * (1 - std::cos(engaged)));
    milling.edge_coefficient = limit * options.edge_share / (shape * engaged);
    return milling;
  }

  CutOptions options_;
  MillingForce mill_;
  Control control_;
  Motion motion_{0, feed};
};

class AdaptiveCut : public ControlledCut<AdaptiveFeed> {
 public:
  explicit AdaptiveCut(const CutOptions& options) : ControlledCut(options, adaptive_for(options)) {}

  static AdaptiveFeed adaptive_for(const CutOptions& options) {
    const int tooth = options.turn / options.teeth;
    AdaptiveFeedOptions adaptive{.limit = limit};
    if (tooth % 4 == 0) {
      adaptive.samples = tooth / 4;
      adaptive.window = 4;
    } else {
      adaptive.samples = tooth * ((4 + tooth - 1) / tooth);
    }
    return AdaptiveFeed::create(adaptive).value();
  }
};

}  // namespace leadscrew::servo::testing
