#pragma once
// A straight slot, milled under adaptive control, by either of two motions with a feed override:
//
//   planner      Planner::override_feed ─▶ words ─▶ loops of the machine's drives ─▶ slide ─▶ feed, position
//   NC program   NcProgram::override_feed ─▶ steps ─▶ pulse-driven axis ─▶ slide ─▶ feed, position
//
// Feed is what the tachogenerator tells. The depth of the cut depends on the place of the slide.

#include <cstdint>
#include <leadscrew/base/result.hpp>
#include <leadscrew/servo/adaptive_cut.hpp>
#include <vector>

namespace leadscrew::study {

inline constexpr double slot_feed = 10;      ///< programmed, mm/s
inline constexpr double slot_period = 1e-3;  ///< s

enum class Overridden : std::uint8_t { planner, nc_program };

/// After a period of motion.
struct SlotPeriod {
  double position = 0;    ///< mm
  double feed = 0;        ///< mm/s
  double mean_force = 0;  ///< over the last turn, N
  double factor = 1;      ///< override from now on
};

struct MilledSlot {
  std::vector<SlotPeriod> periods;  ///< from the first on
  servo::CutFigures cut;
  servo::SensorFailure failure = servo::SensorFailure::none;

  double time() const { return static_cast<double>(periods.size()) * slot_period; }  ///< s
};

/// A slot so long, mm. Errors: those of servo::AdaptiveCut; `study-slot` where motion cannot be made or does not end.
base::Result<MilledSlot> mill_slot(Overridden overridden, double length, const servo::AdaptiveCutOptions& options);

/// s, that it takes at one override; above 0 … 2. Errors: `study-slot`.
base::Result<double> slot_time(Overridden overridden, double length, double factor);

}  // namespace leadscrew::study
