#pragma once
// What a simulation found: what its summary and JSON show.

#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>
#include <leadscrew/servo/adaptive_cut.hpp>
#include <leadscrew/servo/tracking.hpp>
#include <optional>
#include <string>
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

using TrackedAxes = std::vector<std::pair<base::Axis, servo::AxisTracking>>;

struct SimulateFigures {
  pipeline::Summary summary;
  referee::Verdict verdict;  ///< on where the slides were; only its deviations count
  double tolerance = 0;      ///< mm, that slides are held to
  ContourFigures contour;
  servo::FeedTracking feed;
  TrackedAxes axes;
  std::optional<double> settling;  ///< s from the last word until every slide stays within a BLU; none: they do not
  std::optional<AdaptiveFigures> adaptive;
  std::vector<std::string> files{};  ///< written

  bool held_force() const { return !adaptive || adaptive->cut.held(adaptive->turn); }
  bool within_tolerance() const { return verdict.deviation_mm <= tolerance; }
  /// Did the slides keep the tolerance, and come to rest? Was the force held?
  bool kept() const { return settling && within_tolerance() && held_force(); }
};

}  // namespace leadscrew::cli
