#pragma once
// Adaptive control with a constraint: the feed override that holds a mean cutting force at its limit.
//
//   force ───▶ mean ──F̄──┐
//                         ÷ ──▶ stiffness ĉ = F̄/s̄ ──▶ override s = limit/ĉ, within its range
//   feed ────▶ mean ──s̄──┘      more: at once; less: a share of it         s̄ = ΣF·s/ΣF
//
// Force is the process' gain times the feed, and the gain changes with depth and width at any moment: an integrator
// with a gain of its own is slow in a light cut and unstable in a heavy one. So the gain is measured, as force over the
// feed that really was while there was force: what the feed lags behind the override is in both, and does not matter.
// Where teeth rub with a force Fe that does not depend on feed, F = Fe + c·s, the override goes on as
//
//   s ← limit/(c + Fe/s),   whose slope at its fixed point is Fe/limit:
//
// it settles there, from either side, without a limit cycle, as long as the limit can be held at all. The mean is
// taken over a whole number of tooth passings, or the passing of teeth would be taken for a change of the cut. Next to
// no force, as in braking to rest, is not believed to tell of a heavier cut.
//
// After a depth that doubles, the mean force over a turn is above 1.25 times the limit for no more than two turns or
// 150 ms, whichever is longer, where the feed follows the override with a time constant of at most 40 ms, Fe is at most
// 15 % of the limit, noise 10 %, and the override changes at least four times a tooth passing or every 4 ms.
//
// A sensor that fails is not believed: the override goes to a safe share of the programmed feed and stays there until
// restart(). Which failure it was is told.

#include <array>
#include <cstddef>
#include <cstdint>
#include <leadscrew/base/result.hpp>
#include <optional>
#include <string_view>

namespace leadscrew::servo {

enum class SensorFailure : std::uint8_t { none, not_a_number, out_of_range, stuck, silent };

/// "none", "not a number", "out of range", "stuck" or "silent".
std::string_view name(SensorFailure failure);

struct AdaptiveFeedOptions {
  double limit = 0;              ///< of the mean force, N; > 0
  double sample_period = 0.001;  ///< seconds; > 0
  int samples = 20;              ///< to each change of the override; 1 … 100000
  int window = 1;                ///< times these samples, some whole tooth passings: what the mean is over; 1 … 16
  double share = 0.5;            ///< of a lesser stiffness that is believed at once; above 0, ≤ 1
  double least = 0.05;           ///< override; > 0
  double most = 2;               ///< override; least … 2
  double rise = 4;               ///< of the override in a second, at most; falling is not held back; > 0
  double safe = 0.5;             ///< override after a failure; 0 … 1
  double sensor_range = 10000;   ///< N: beyond ± that no force is measured; above the limit
  double silent_after = 0.02;    ///< seconds without a sample that can be believed; ≥ sample_period
  int stuck_after = 20;  ///< samples alike, in the last bit: a live sensor has noise; ≥ 2. 0: never, it has none
};

class AdaptiveFeed {
 public:
  /// Code: `servo-adaptive-feed`.
  static base::Result<AdaptiveFeed> create(const AdaptiveFeedOptions& options);

  /// Once a sample period. force: N; empty when none came. feed_share: the feed that was really travelled over the
  /// programmed one; ≥ 0. The override for the feed from now on. No allocation; the only loop is over the window.
  double sample(std::optional<double> force, double feed_share);

  double feed_override() const { return override_; }
  SensorFailure failure() const { return failure_; }
  /// Would the force be above its limit even at the least override?
  bool above_limit_at_least() const { return wanted_ < options_.least; }
  /// Believes the sensor again, and begins anew with the programmed feed.
  void restart();

 private:
  /// Of the samples between two changes of the override.
  struct Sums {
    double force = 0, feed = 0, force_and_feed = 0;
    int samples = 0;
  };
  static constexpr std::size_t longest_window = 16;

  explicit AdaptiveFeed(const AdaptiveFeedOptions& options) : options_(options) {}
  std::optional<double> stiffness_seen() const;
  SensorFailure examine(std::optional<double> force);
  void change_override();

  AdaptiveFeedOptions options_;
  double override_ = 1;
  double wanted_ = 1;                // limit/ĉ, before it is kept within the range
  std::optional<double> stiffness_;  // ĉ, N
  std::array<Sums, longest_window> sums_{};
  std::size_t newest_ = 0;
  int alike_ = 0;   // samples like the last one
  int silent_ = 0;  // sample periods since a sample could be believed
  double last_force_ = 0;
  SensorFailure failure_ = SensorFailure::none;
};

}  // namespace leadscrew::servo
