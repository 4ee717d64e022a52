#pragma once
// The constants of planning that were found by trial, in one place: a group for each source that uses it, and before each
// group what pulls its values one way and what the other. Whoever changes one measures both: `leadscrew study limits` says
// what time it costs beside the least there is, `script/bench` (plan/…) what planning takes. Roundings and guards against division by zero stay where they
// are used.

#include <cstddef>

namespace leadscrew::planner::tuning {

/// Where knots lie. Closer: nearer to the least time (a row of `study limits` each), and fewer repairs by the proof.
/// Wider: fewer unknowns, and planning takes in proportion to them.
namespace knots {
inline constexpr double per_ramp = 34;         // knots while speed rises from rest or falls to it
inline constexpr double cruise_knots = 8;      // of a cruise, while speed could rise from rest
inline constexpr double cruise_time = 0.02;    // s between knots of a cruise that need not lie closer
inline constexpr double cruise_grading = 0.1;  // of the distance from where the cruise begins or ends
inline constexpr double slow_change = 0.05;    // of x, sample to sample, where feed asks for another speed slowly
inline constexpr double slow_tangent = 0.02;   // of the tangent acceleration that this may take
inline constexpr double change_of_knot = 0.1;  // of x between knots there
inline constexpr double grading = 0.25;        // |dh/ds|
inline constexpr double ramp_grading = 0.25;   // h over distance from rest
inline constexpr double noticed_step = 0.002;  // of the limit of jerk, at a break of q‴
inline constexpr double merged_breaks = 1e-5;  // of the width around them
inline constexpr int deepest = 40;             // bisections
/// Polynomials of a curve between samples; where there are more, a bend may lie between them.
inline constexpr std::size_t most_between_samples = 8;
/// Samples are for so many times the knots of a window: speed where it ends feels what lies beyond.
inline constexpr double sampled_beyond = 1.3;
inline constexpr std::size_t kept_seen = 30;    // of the knots that are there already, as many are seen by new ones
inline constexpr double unknown_margin = 0.03;  // of a ramp's length, free before the end of what is known
inline constexpr double shortest_ramp = 1e-13;  // of the place on the section: what rounding leaves of its knots
/// It takes about as many to come to rest: a window that would end so few knots before rest goes on to it.
inline constexpr std::size_t rest_knots = 100;
inline constexpr double first_change = 0.15;    // of the usual width, where jerk changes at once
inline constexpr double change_grading = 0.15;  // of the distance from there
inline constexpr std::size_t more_knots = 24;   // after what is kept, if more is known
inline constexpr std::size_t more_windows = 2;  // in the place of one where much is kept and speed changes
inline constexpr std::size_t knots_at_end = 8;  // that nothing comes between
inline constexpr std::size_t knots_beyond = 3;  // after the last interval of a window that ends in motion
}  // namespace knots

/// Along paths of least time, where jerk jumps every few milliseconds as it did in the motion that they were found as: that so
/// much closer knots follow, in windows of as many as usual, which reach less far. Closer: nearer to that motion's time
/// (`leadscrew study tube`: 0.8 % of it is lost, of engraving 2.6; at 1.5 0.7 and 2.3, at 2, in windows of twice as many, 0.6
/// and one and a half). Farther apart: less work, in shorter calls: a fifth more at 1.5, twice as much at 2.
namespace least_time {
inline constexpr double closeness = 1.3;
/// Intervals at least that are left to the next. Fewer: it is refused where jerk has no room to change, and the end is crept along.
inline constexpr std::size_t least_ahead = 100;
/// Of t, as of the barrier method below. Slower: their optimum is followed more closely to where it bends away from the
/// centre before, in fewer steps than a stage takes that has lost it.
inline constexpr double growth = 5;
}  // namespace least_time

/// One window. Smaller gaps and more repairs: nearer to the least time and fewer windows refused
/// (`Planner::refused_windows`, held at almost none by tests of random programs). Larger and fewer: less work.
namespace window {
inline constexpr double gap = 5e-4;        // of the time, to the optimum
inline constexpr double cold_gap = 20;     // of creep
inline constexpr double warm_gap = 0.3;    // of a window whose beginning is nearly optimal already
inline constexpr double repair_gap = 0.1;  // of a profile that is planned again
inline constexpr double deep_gap = 10;     // of a profile from which limits can be tightened
/// Of the time, to the optimum, where a profile that is to be repaired goes back to; the nearer where it has room for that.
inline constexpr double far_inside = 0.1, near_inside = 0.015;
inline constexpr int repairs = 7, repairs_of_change = 5;  // knots come between soon where feed has changed
inline constexpr double repair_margin = 2e-4;
/// Of the way to the nearer of these, at most, that a profile is moved instead of planned again; below the limits, where it ends.
inline constexpr double most_inside = 0.1, inside_margin = 5e-5;
inline constexpr int refinements = 3;
inline constexpr double coarse_knots = 1.005;  // ratios above tell that knots lie too far apart
inline constexpr double cruising = 0.02;       // of the acceleration
inline constexpr double most_parts = 32;       // of an interval, at once
inline constexpr double steepest = 2.5;        // ratio of the widths of neighbours
inline constexpr double widest = 8;
inline constexpr std::size_t most_refined = 600, intervals_at_end = 8;
inline constexpr std::size_t stopping_intervals = 20;
inline constexpr double allowed_slowing = 1.0002;  // below, slowing time costs less than planning again
/// The end of a window has influence over so many stopping distances before it, and over so many times to stop before
/// those.
inline constexpr double stops_felt = 2.5, stops_before = 1.2;
inline constexpr std::size_t least_ahead = 16;  // intervals
inline constexpr double committed = 0.4;        // of them, at least: more is planned less often, and nearer to its end
inline constexpr double effort_of_proof = 3;    // units, of a segment
}  // namespace window

/// Cruises that are levelled. Nearer and longer: fewer levelled, and feed some parts in ten thousand lower there. Shorter
/// blends: more whose levelling would break a limit, and is taken back.
namespace cruises {
inline constexpr double near = 4e-3;         // below the cap, of x, where one begins and ends
inline constexpr std::size_t shortest = 40;  // coefficients
inline constexpr std::size_t blend = 16;     // over which one is reached and left
}  // namespace cruises

/// The barrier method. Faster growth: fewer stages, of more steps each. More that is negligible: fewer steps a stage, until
/// the next begins too far from its centre. Shorter steps at the next attempt: fewer attempts; longer: fewer steps.
namespace barrier {
inline constexpr double growth = 20;             // of t, from stage to stage
inline constexpr double negligible = 0.06;       // decrement of a step, of the number of inequalities
inline constexpr double negligible_first = 0.1;  // in the first stage
inline constexpr double shorter = 0.7;           // each attempt at a step
/// Not convex, the problem may have another optimum than the one that was followed. A stage goes over to it once its decrement is so
/// many times the first, and so much of the number of inequalities; from there it is found sooner from this far inside.
inline constexpr double lost = 2, times_first = 4, found_again = 0.1;
inline constexpr double first_time_curvature = 0.2,
                        first_floor_curvature = 0.1;  // of the first stage; 0.75 and 1 are exact
}  // namespace barrier

/// How far windows reach, and how much of one is committed. Longer: less of a stop's influence in what is committed
/// (LookAhead.LosesNothingToTheNumberOfPieces), fewer windows. Shorter: no window takes longer than a few milliseconds to plan.
namespace look_ahead {
inline constexpr double longest_segment = 0.02;  // s, where a change of speed may have to begin
inline constexpr double most_parts = 1000;       // of a segment
inline constexpr int few_looks = 4;              // of a part of a segment that was looked at
/// Times to stop, where speed is greatest: that are committed, and that a window looks ahead of those.
inline constexpr double stops_committed = 3, stops_ahead = 4.5;
inline constexpr double least_reach = 0.25;  // s
/// Intervals times axes that move: so long does a window take to plan.
inline constexpr std::size_t rows_of_a_window = 900;
/// More: a greater part of each window is committed, two fifths of it where it reaches no farther than stops do.
inline constexpr std::size_t least_intervals = 180, greatest_intervals = 300;
inline constexpr double few_share = 0.6;           // of the intervals that a window may have
inline constexpr std::size_t least_to_change = 8;  // intervals left of a window for a change of speed to begin in it
inline constexpr std::size_t most_pieces = 900;
inline constexpr std::size_t most_patience = 16;  // segments
/// Of sections that may come again. More: patterns of more shapes. The planner stays below 2 MB.
inline constexpr std::size_t remembered_bytes = 500'000;
inline constexpr std::size_t most_remembered_pieces = 8, most_remembered_numbers = 1000;
inline constexpr double hardly_moves = 1e-3;  // |q′| of an axis whose velocity does not count yet
}  // namespace look_ahead

/// Gentler limits: acceleration is reached no sooner than in this time, and the greatest speed by it no sooner either.
/// Where limits of jerk and acceleration are far greater than speeds are, knots lie so close that a window of them is
/// over within microseconds. Held by the tests of effort (machines whose limits span four decades, a jerk limit of 1e14).
namespace gentle {
inline constexpr double time = 0.01;              // s
inline constexpr double slower = 4;               // each time that this does not help
inline constexpr int most_lowerings = 10;         // times
inline constexpr double between_lowerings = 1e6;  // units of effort
}  // namespace gentle

/// Rows of a window. Nearer to 1: nearer to the least time. Farther: fewer windows planned again, since what lies between
/// the places looked at, and the step from spline to quintics, take that much of the limits.
namespace rows {
inline constexpr double limit_margin = 0.9992;           // of acceleration and jerk
inline constexpr double feed_margin = 1 - 1e-7;          // of the programmed speed, squared
inline constexpr double varying_feed_margin = 1 - 1e-4;  // of the same, where it varies from knot to knot
inline constexpr double same_cap = 1e-9;                 // of the same, below which it does not differ
inline constexpr std::size_t intervals_begun = 4;   // of a window that begins in motion: they are travelled as they are
inline constexpr double turning_margin = 1 - 3e-4;  // of the speed, squared, where axes trade it with others
inline constexpr double least_peak = 0.01;          // of a limit, by the curve alone at the greatest speed
inline constexpr std::size_t most_borders = 7;      // between polynomials, that an interval has sites for
inline constexpr std::size_t creep_tail = 3;        // intervals at an end in motion whose coefficients all creep
inline constexpr double stopping_factor = 1.08;     // of the rows of the intervals before an end in motion
inline constexpr std::size_t last_intervals = 6;    // of these, over which speed falls to less than half in each
inline constexpr double last_factor = 1.1;          // of theirs
inline constexpr double greatest_relaxed = 1.1, relaxed_margin = 1e-4;
}  // namespace rows

/// Down to a lower feed. A greater weight and a smaller floor come down sooner (a change of feed is in force within 50 ms,
/// by tests of interventions); too great a one, and Newton's method takes many steps along the bend of its cost.
namespace descent {
inline constexpr double too_fast_margin = 0.002, descended_margin = 0.0005;  // of x, where limits are relaxed
inline constexpr double floor = 0.9;                                         // of the wanted x
inline constexpr double first_gap = 3, cold_gap = 20, last_gap = 0.02;
inline constexpr double weight = 4;        // of speed above what is wanted, against time
inline constexpr double softness = 0.004;  // of the wanted x
}  // namespace descent

/// Stops of slices. More attempts: shorter stops (tests of `early_stop`). Fewer: less of each slice's time.
namespace early_stop {
inline constexpr double first_wait = 0.005, later = 1.4;  // s after the slice, and each time so many times later
inline constexpr double last_brake = 0.015;               // s after the slice, where a stop of several segments begins
inline constexpr int attempts = 14;
inline constexpr double longer = 1.12;           // each than the last
inline constexpr std::size_t sparse_knots = 20;  // before the end of a window in motion: they lie far apart for a stop
}  // namespace early_stop

/// Stops of slices by several segments. A greater reach and smaller gaps: tails nearer to the shortest
/// (Tails.AreAsShortAsTheLimitsAllow). Smaller and greater: Newton's method takes less of each slice's time.
namespace braking {
inline constexpr double reach = 1.3;  // of the shortest stop along the tangent
inline constexpr double first_gap = 3, last_gap = 0.1, deep_gap = 30;
inline constexpr int most_parts = 3;  // each reaches twice as far as the last
inline constexpr int repairs = 2;     // with rows tightened where the proof fails
inline constexpr std::size_t fewest_intervals = 8;
inline constexpr int attempts = 3;          // at a stop by one cubic, from each place
inline constexpr double longer = 1.15;      // each than the last
inline constexpr double worthwhile = 0.01;  // of the tail, by which a later place must end it sooner
inline constexpr int first_looks = 8;       // most attempts are seen to fail by the first
}  // namespace braking

/// The proof. More looks find more of what lies between them: what random programs showed beyond 1.0005 of a limit, seen
/// by the referee, set these. Each look is an evaluation of a curve.
namespace proof {
inline constexpr int looks_per_polynomial = 3;
inline constexpr std::size_t few_polynomials = 8;     // of a segment, that are looked at so often
inline constexpr int looks_per_more = 2;              // of those beyond
inline constexpr std::size_t most_polynomials = 600;  // that are looked at so closely
inline constexpr int most_closer = 2;                 // times, each twice as close, where a cubic may exceed a limit
inline constexpr double between_looks = 1 + 1e-5;     // of what is no parabola
}  // namespace proof

/// The bound of the time without jerk. Finer: nearer to the closed forms and published times of test_time_bound.
namespace bound {
inline constexpr std::size_t most_waiting = 2048;  // intervals
inline constexpr double finest_turn = 0.005;       // rad, of a curve between knots; and change of curvature times step
inline constexpr double finest_time = 1e-5;        // of the time between knots, by which the mean of speeds may be off
inline constexpr int fewest_intervals = 32;        // of a curve
inline constexpr double first_interval = 1e-3;     // of the longest, at a curve's ends
inline constexpr int most_halvings = 20;
inline constexpr double grading = 0.1;         // h over the distance from the nearer end
inline constexpr double turning_place = 1e-6;  // of a step, by which a knot may be beside where an axis turns back
inline constexpr int most_newton_steps = 30;
/// Of a unit tangent: less is taken as smooth, which can only lower the bound.
inline constexpr double negligible_kink = 1e-6;
inline constexpr double negligible_tip_kink = 1e-4;  // where kinematics stretch what tables of arc length are off by
}  // namespace bound

}  // namespace leadscrew::planner::tuning
