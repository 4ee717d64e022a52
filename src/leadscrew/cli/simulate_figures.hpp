#pragma once
// What a simulation found: what its summary and JSON show.

#include <algorithm>
#include <cstdint>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>
#include <leadscrew/servo/adaptive_cut.hpp>
#include <leadscrew/servo/tracking.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace leadscrew::cli {

/// Distance of the slides from the path of the words, mm.
struct ContourFigures {
  double greatest = 0;
  double rms = 0;
  double at = 0;  ///< of the greatest, seconds
};

/// Of --adaptive.
struct AdaptiveFigures {
  servo::CutFigures cut;
  double limit = 0;  ///< of the mean force, N
  double turn = 0;   ///< of the spindle, s
  double safe = 0;   ///< override
  servo::SensorFailure failure = servo::SensorFailure::none;
  double safe_time = 0;  ///< s, that the words take at the programmed feed times `safe` throughout
};

/// Of a pulse-driven loop, at the end.
struct PulseCounts {
  std::int64_t commanded = 0;  ///< steps up less steps down
  std::int64_t encoder = 0;    ///< pulses one way less those the other
  std::int64_t lost = 0;       ///< for which the up-down counter had no room
};

using TrackedAxes = std::vector<std::pair<base::Axis, servo::AxisTracking>>;

struct SimulateFigures {
  pipeline::Summary summary;
  referee::Verdict verdict;  ///< on where the slides were; only its deviations count
  double tolerance = 0;      ///< mm, that slides are held to
  ContourFigures contour;
  servo::FeedTracking feed;
  TrackedAxes axes;
  std::vector<std::pair<base::Axis, PulseCounts>> pulses;  ///< of --pulses
  std::optional<double> settling;  ///< s from the last word until every slide stays within a BLU; none: they do not
  std::optional<AdaptiveFigures> adaptive;
  std::vector<std::string> files{};  ///< written

  bool held_force() const { return !adaptive || adaptive->cut.held(adaptive->turn); }
  bool within_tolerance() const { return verdict.deviation_mm <= tolerance; }
  bool kept_pulses() const {
    return std::all_of(pulses.begin(), pulses.end(), [](const auto& axis) { return axis.second.lost == 0; });
  }
  /// Did the slides keep the tolerance, and come to rest? Was the force held, and no pulse lost?
  bool kept() const { return settling && within_tolerance() && held_force() && kept_pulses(); }
};

}  // namespace leadscrew::cli
