#pragma once
// From a profile of speed over path length to motion in time: segments, and the shortest stop.

#include <cstddef>
#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/planner/knots.hpp>
#include <leadscrew/planner/motion.hpp>
#include <leadscrew/planner/section.hpp>
#include <leadscrew/planner/speed_profile.hpp>
#include <optional>
#include <span>
#include <vector>

namespace leadscrew::planner {

/// Segments along a section, contiguous, and where on the profile each begins.
struct Emission {
  std::vector<Segment> segments;
  std::vector<std::size_t> intervals;  ///< of the profile
  std::vector<double> places;          ///< u ∈ [0, 1] of that interval
};

/// All of the profile, a segment for each interval and each ramp: from `begin`, where it begins at rest, to `end`, if
/// it ends at rest.
Emission emit(const SpeedProfile& profile, double begin, double end);

/// At u ∈ [0, 1] of an interval; without the jerk.
PathState state_at(const SpeedProfile& profile, std::size_t interval, double u);
/// Between two places of an interval: ∫ x^(−1/2) ds by eight-point Gauss, s.
double travel_time(const SpeedProfile& profile, std::size_t interval, double from = 0, double to = 1);
/// Along a part of an interval, from `from` on, which becomes where it ends.
Segment along_interval(const SpeedProfile& profile, std::size_t interval, double begin, double end, PathState& from);

/// From motion to rest in t seconds: speed falls by a cubic from the speed and the acceleration there are to 0 and 0,
/// v(u) = (1 − u)²(v + u(2v + at)), u = τ/t. Jerk is (4at + 6v)/t² against the motion at first and (6v + 2at)/t² at
/// last; it goes back nowhere where 3v + at ≥ 0.
Segment stop_within(const PathState& from, double t);
/// The shortest t, s, that the limits along the tangent may allow; the speed there is must be > 0.
double shortest_stop(const PathState& from, const machine::Derivatives& limits);

/// From motion to rest within `distance_left`, in no more than `longest` seconds: the first such stop found that keeps
/// every limit of every axis. Nothing if there is none.
std::optional<Segment> come_to_rest(const PathState& from, double distance_left, double longest, const Section& section,
                                    const constraints::Constraints& constraints);

/// A segment, parted at those of these places along the section that lie inside it. They ascend.
std::vector<Segment> cut_at(const Segment& segment, std::span<const double> places);

/// Segments along a section, which end at `end`, cut where pieces meet; s is counted from each piece's beginning and
/// pieces from `first_piece`, on which the first segment begins.
std::vector<Segment> along_pieces(const std::vector<Segment>& segments, const Section& section, double end,
                                  std::size_t first_piece);

}  // namespace leadscrew::planner
