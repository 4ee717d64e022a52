#pragma once
// A cut under adaptive control: the cutter in the work, the sensor of its force, and who moves the override.
//
//   tachogenerators ──feed──▶ MillingForce ──N──▶ sensor ──▶ AdaptiveFeed ──override──▶ planner or NC program
//                                 ▲                 ▲            once a millisecond, or a period if that is longer
//                          depth, by the travel   fails, if told
//
// The mean that is controlled is over whole passings of teeth, as nearly as a number of samples can be that. Rapid
// motion does not cut. Force is reckoned 32 times a tooth.

#include <cstdint>
#include <leadscrew/base/result.hpp>
#include <leadscrew/servo/adaptive_feed.hpp>
#include <leadscrew/servo/cutting_force.hpp>
#include <optional>
#include <vector>

namespace leadscrew::servo {

/// The depth of the cut from a position on the path on.
struct DepthStep {
  double from = 0;   ///< mm along the path, ≥ 0
  double depth = 0;  ///< mm, ≥ 0
};

/// A sensor that fails: from a time on it is silent, gives NaN, or repeats its last value.
struct SensorFault {
  SensorFailure kind = SensorFailure::silent;  ///< silent, not_a_number or stuck
  double at = 0;                               ///< seconds
};

struct AdaptiveCutOptions {
  MillingOptions milling;         ///< without noise the sensor is ideal, and that it is stuck cannot be seen
  double width = 0;               ///< ae, mm; 0 … diameter
  std::vector<DepthStep> depths;  ///< in the order of places, the first from 0
  double limit = 0;               ///< of the mean force, N; > 0
  double safe = 0.5;              ///< override when the sensor has failed; above 0, ≤ 1
  std::optional<SensorFault> fault;
};

struct CutFigures {
  double greatest_mean = 0;   ///< N, over a turn
  double longest_excess = 0;  ///< s, that the mean over a turn was beyond 1.25 limits without a break
  double unreachable = 0;     ///< s of cutting where the least override there is would be above the limit
  double least_override = 1, greatest_override = 1;
  double mean_override = 1;         ///< over the time of cutting
  std::optional<double> failed_at;  ///< s: the sensor was no longer believed

  /// No longer than two turns or 150 ms, whichever is longer.
  bool held(double turn) const { return longest_excess <= (turn > 0.075 ? 2 * turn : 0.15); }
};

class AdaptiveCut {
 public:
  /// period: of motion, seconds. Codes: `servo-cut`, `servo-milling`, `servo-adaptive-feed`.
  static base::Result<AdaptiveCut> create(const AdaptiveCutOptions& options, double period);

  /// One period of motion. feed: mm/s; programmed: mm/s, 0 for rapid; travel: along the path since its beginning, mm.
  /// Returns the override from now on.
  double follow(double feed, double programmed, double travel);

  double mean_force() const { return mean_; }  ///< over the last turn, N
  double feed_override() const { return control_.feed_override(); }
  const AdaptiveFeed& control() const { return control_; }
  CutFigures figures() const;
  double turn() const { return 1 / options_.milling.spindle_speed; }  ///< s

 private:
  AdaptiveCut(const AdaptiveCutOptions& options, MillingForce mill, AdaptiveFeed control, double period);
  double cut(double feed, double travel);
  void judge(double force);
  std::optional<double> sensed(double force);
  void account();

  AdaptiveCutOptions options_;
  MillingForce mill_;
  AdaptiveFeed control_;
  double period_;
  int parts_;  // of a period, for the force
  int periods_a_sample_;
  std::size_t depth_ = 0;  // of the steps
  std::int64_t periods_ = 0;
  double force_sum_ = 0, share_sum_ = 0;  // since the last sample
  int gathered_ = 0;
  std::optional<double> last_sensed_;

  std::vector<double> turn_;  // ring: forces of the last turn's periods
  double turn_sum_ = 0, mean_ = 0;
  double excess_ = 0;
  double override_sum_ = 0;
  std::int64_t cutting_ = 0;
  CutFigures figures_;
};

}  // namespace leadscrew::servo
