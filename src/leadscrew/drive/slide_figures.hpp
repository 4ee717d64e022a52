#pragma once
// What is measured of the slides of a simulated machine.

#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/referee/referee.hpp>
#include <leadscrew/servo/tracking.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace leadscrew::drive {

/// Distance of the slides from the path of the words, mm; on a machine with a chain of rotary axes of the tool's tip in the
/// workpiece, from the place that tip and rotary axes are matched to.
struct ContourFigures {
  double greatest = 0;
  double rms = 0;
  double at = 0;  ///< of the greatest, seconds
  /// Greatest angle between the tool's direction and that at the place it is matched to, degrees; none without a chain.
  std::optional<double> orientation;
};

/// Of a pulse-driven loop, at the end.
struct PulseCounts {
  std::int64_t commanded = 0;        ///< steps up less steps down
  std::int64_t commanded_gross = 0;  ///< steps up and steps down
  std::int64_t encoder = 0;          ///< pulses forward less pulses backward
  std::int64_t encoder_gross = 0;    ///< pulses forward and pulses backward
  std::int64_t overflows = 0;        ///< pulses that the up-down counter had no room for
  std::int64_t lost = 0;             ///< what is missing for them: those up less those down
};

using TrackedAxes = std::vector<std::pair<base::Axis, servo::AxisTracking>>;

/// Of words that slides have followed to their rest.
struct SlideFigures {
  referee::Verdict verdict;  ///< on where the slides were; only its deviations count
  ContourFigures contour;
  servo::FeedTracking feed;
  TrackedAxes axes;
  std::vector<std::pair<base::Axis, PulseCounts>> pulses;  ///< of pulse-driven loops
  std::optional<double> settling;  ///< s from the last word until every slide stays within a BLU; none: they do not
};

}  // namespace leadscrew::drive
