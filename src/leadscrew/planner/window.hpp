#pragma once
// One window of a section: the optimum along it, as motion, with the proof that it keeps every limit. Where it does
// not, it is planned again with tightened rows, and on finer knots.

#include <cstddef>
#include <cstdint>
#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/planner/effort.hpp>
#include <leadscrew/planner/knots.hpp>
#include <leadscrew/planner/motion.hpp>
#include <leadscrew/planner/section.hpp>
#include <leadscrew/planner/speed_profile.hpp>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace leadscrew::planner {

/// A window that has been planned, on the section.
struct Window {
  explicit Window(SpeedProfile speed) : profile(std::move(speed)) {}

  SpeedProfile profile;
  std::vector<Segment> segments;       ///< to rest
  std::vector<std::size_t> intervals;  ///< of the segments
  std::vector<double> places;          ///< u ∈ [0, 1) of the interval where each segment begins
  double worst = 0;                    ///< ratio of any limit
  bool turns_back = false;             ///< does its motion, anywhere?
  std::vector<Ratios> factors;         ///< of each interval: of what exceeds limits there or beside it; else 1
  std::size_t last_interval = 0;       ///< where the next window begins, unless all is committed
  bool to_rest = false;                ///< is all of it committed?
  std::optional<Continuation> after;   ///< what goes on at last_interval
  double end = 0;                      ///< where it comes to rest
  std::size_t next = 0;                ///< segment that is handed out next
  std::size_t unchanged_until = 0;     ///< a change of speed waits: not tried again before this segment is next
  std::size_t patience = 2;            ///< segments until it is tried again
  std::vector<double> stops;           ///< from where segments begin: duration, s; 0: not tried, less: none found
};

/// As fast as the limits allow, or to rest as soon as they allow.
enum class Aim : std::uint8_t { fastest, rest };

/// Plans the stretch: from rest, or in motion from where `continuation` begins. At most about `most_intervals` between
/// knots, more where speed is to change. Nothing if no motion is found that keeps every limit and can come to rest, or
/// if the effort of one window does not find it. `before`: the window that it goes on from, if it is at hand.
std::unique_ptr<Window> plan_window(const Section& section, const constraints::Constraints& constraints,
                                    const PlannedRange& range, const std::optional<Continuation>& continuation, Aim aim,
                                    std::size_t most_intervals, Effort& effort, const Window* before = nullptr);

}  // namespace leadscrew::planner
