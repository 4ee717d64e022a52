#pragma once
// What a simulation found: what its summary and JSON show.

#include <algorithm>
#include <leadscrew/drive/slide_figures.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/servo/adaptive_cut.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::results {

/// Of --adaptive.
struct AdaptiveFigures {
  servo::CutFigures cut;
  double limit = 0;  ///< of the mean force, N
  double turn = 0;   ///< of the spindle, s
  double safe = 0;   ///< override
  servo::SensorFailure failure = servo::SensorFailure::none;
  double safe_time = 0;  ///< s, that the words take at the programmed feed times `safe` throughout
};

struct SimulateFigures : drive::SlideFigures {
  pipeline::Summary summary;
  double tolerance = 0;  ///< mm, that slides are held to
  std::optional<AdaptiveFigures> adaptive;
  std::vector<std::string> files{};  ///< written

  bool held_force() const { return !adaptive || adaptive->cut.held(adaptive->turn); }
  bool within_tolerance() const { return verdict.deviation_mm <= tolerance; }
  bool kept_pulses() const {
    return std::all_of(pulses.begin(), pulses.end(), [](const auto& axis) { return axis.second.overflows == 0; });
  }
  /// Did the slides keep the tolerance, and come to rest? Was the force held, and room for every pulse?
  bool kept() const { return settling && within_tolerance() && held_force() && kept_pulses(); }
};

}  // namespace leadscrew::results
