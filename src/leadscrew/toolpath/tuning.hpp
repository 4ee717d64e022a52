#pragma once
// The constants of fits and blends that were found by trial, in one place: a group for each source that uses it, and before
// each group what pulls its values one way and what the other. Whoever changes one measures both, by the times of the
// blended programs (`leadscrew study limits`, its last groups) and by `script/bench`. Whatever they are, each curve that is
// made is proven to lie inside the tolerance. Roundings stay where they are used.

#include <cstddef>

namespace leadscrew::toolpath::tuning {

/// Length of the spans of splines along short lines. Longer: smoother, faster motion and fewer pieces. Shorter: the spline
/// fits inside narrow tolerances, and details shorter than a span cost no speed.
namespace spans {
inline constexpr double long_leg = 15;  // lengths of a span
/// s at the programmed feed, within mm.
inline constexpr double span_time = 0.005, shortest_span = 0.1, longest_span = 1;
inline constexpr double span_of_tolerance = 10, longest_of_tolerance = 3;  // mm
inline constexpr double arc_sagitta = 0.02;                                // of the leg's tolerance
inline constexpr double kept_share = 0.98;  // of the tolerance; the rest is for the rounding of words and of samples
}  // namespace spans

inline constexpr double corner_turn = 1.3;  // |t⁺ − t⁻| = 2 sin(θ/2): 81°

/// Blends of corners. Longer blends are faster at the corner and slower where the next one is near.
namespace corner {
/// Blends that swing wide. Of the full length, that one must have at least: a shorter one is slower than one that only
/// cuts in; less from the turn |t_A − t_B| on that is a corner anyhow. Of what a leg has for its end, that one may take at
/// most, where the turn is still sharper (122°): there speed has to rise and fall again between two such corners. Zigzags
/// of legs of 0.5 … 8 mm, 45° … 160°, P 10 µm.
inline constexpr double least_swing = 0.5, least_swing_of_corner = 0.35;
inline constexpr double sharp_swing = 1.75, share_of_sharp = 0.7;
/// Of the full length, that there must be for two lines to be blended so where a spline would run through their joint.
inline constexpr double least_in_place_of_spline = 0.6;
/// Of a line, that may be left between two blends, or none: a shorter rest would only be another piece.
inline constexpr double least_rest = 0.05;
inline constexpr double turned_back = 1.99;            // |t_A − t_B|: from here on a stop is faster than any blend
inline constexpr std::size_t looks = 33;               // at a blend, for how it turns
inline constexpr double sharpest_between_looks = 1.5;  // |t⁺ − t⁻|; between lines it stays below
inline constexpr double shrinking = 0.8;
inline constexpr double nearly_whole = 0.8;
inline constexpr int most_tries = 40;
inline constexpr double polyline_share = 1.0 / 200;  // of the margin, for polylines that stand for curves
inline constexpr int deepest = 14;                   // halvings of a curve
inline constexpr double table_of_length = 1e-7;      // what a curve's length may be short of
inline constexpr double most_lengthened = 1.02;      // of the lengths a blend takes the place of: more is a detour
}  // namespace corner

/// How a tolerance is divided between curves and the chords between words (sampling.hpp), where the law that holds at
/// short periods would leave little to curves. A larger share: longer, gentler curves, passed more slowly for the chords'
/// sake. Below that of blends that swing wide, those that only cut are as fast: corners of 45° … 135°, P 3 … 50 µm, 20 ms.
namespace sampling {
inline constexpr double least_share_of_swing = 0.25, least_share_of_cut = 0.15, least_share_of_spline = 0.5;
}  // namespace sampling

/// Lines of the program in one leg. More of the tolerance spent here: fewer pieces. Less: more is left to smooth by.
namespace reduction {
inline constexpr std::size_t most_lines = 4096;  // of the program in one leg
inline constexpr double ball_share = 0.25;       // of the tolerance
}  // namespace reduction

/// Splines along runs of short lines: what is tried where one does not fit, and how long a feed is held.
namespace run {
inline constexpr double longest_smoothing = 2;  // lengths of a span
inline constexpr double least_corner = 0.2;     // |t⁺ − t⁻| of one that is made where no spline fits
inline constexpr double split_window = 32;      // tolerances: how far from there
inline constexpr double least_hold = 0.002;     // s that a feed is held: sooner than speed can change
}  // namespace run

/// Which joints are corners. Greater turns taken into splines: fewer blends, but a spline pays for a sharp corner along
/// its neighbours.
namespace smoother {
inline constexpr double sharp_turn = 1.4;  // a corner even if the path goes on turning
inline constexpr double concentrated = 1.5;
inline constexpr double turn_window = 8;    // tolerances
inline constexpr double widest_window = 4;  // turn windows, where the leg is as long
inline constexpr double reach_into = 6;     // lengths of a span
inline constexpr int most_shortened = 40;   // times
inline constexpr int most_tolerances = 4;   // tried at a corner
/// Of a curve that the blend at its end may take, if there was none at its start.
inline constexpr double uncut_share = 0.9;
/// Where a block is allowed so many times what the next one is, their joint may be a corner: where it turns by as many
/// margins over a span of the wide one, by this where that is shorter than a span, by that where one is narrow but for Q.
inline constexpr double much_wider = 8, tight_spans = 64, least_beside_short = 0.5, least_without_q = 0.02;
}  // namespace smoother

/// Motions of least time in a corridor.
namespace corridor {
/// mm: within less, splines are no slower, and found in far less time. Random programs at tolerances down to 0.3 µm, on machines
/// whose axes differ by a hundred times, set it: one in twenty was slower than with stops.
inline constexpr double finest_tolerance = 1e-3;
/// Of (P/j)^(1/3), and of P that motion may bulge between the places looked at. Longer intervals: less work. Shorter:
/// nearer to the least time.
inline constexpr double interval_of_corner = 0.5, interval_bulge = 0.05;
/// Of a window: at a low feed its time is that of its ways, and corners between them, which are not rounded as finely, cost
/// no more than an interval each.
inline constexpr double many_intervals = 3000, most_intervals_of_window = 12'000;
/// Of the tolerance, what a motion is proven to keep: the rest is for the rounding of words. Of that, what is planned in:
/// the rest is for the bulge. Where it is too little, less of it by what was reached.
inline constexpr double corridor_share = 0.988, planned_share = 0.992, less_than_reached = 0.995;
/// The start. Slower: less in the way of its corners, and more steps from there.
inline constexpr double start_acceleration = 0.6;  // of the machine's
inline constexpr double start_step = 2;            // margins by |t⁺ − t⁻|: between control points at a corner
/// The barrier. Smaller gaps and decrements: nearer to the least time. Larger: less work.
inline constexpr double first_gap = 2, last_gap = 0.01, growth_of_weight = 8;
inline constexpr double enough_decrement = 0.5;
/// Of the diagonal of the barrier's Hessian. Random programs of lines up to 50 mm at a tolerance of a micrometre set these.
inline constexpr double least_damping = 1e-12, most_damping = 1e-3, change_of_damping = 3;
/// Windows, in times to stop from the greatest speed: that one is planned ahead of what is kept of it, and that is kept.
/// Longer: less of the end's influence. Shorter: the path is known sooner.
inline constexpr double stops_ahead = 2.5, stops_planned = 12;
inline constexpr std::size_t most_legs = 400;
inline constexpr double reaches_of_long = 2.5, reach_in_margins = 10;
inline constexpr double far_back = 0.3, least_angle_back = 0.01;  // reaches, rad: reversals of 3 to 25 mm
inline constexpr double nearly_all = 0.95;        // of what an arc's curvature allows, where its middle is travelled
inline constexpr double merged_share = 0.15;      // of the margin, that short lines may take for being made one
inline constexpr int most_plans = 3;              // with smaller margins
inline constexpr int most_intervals = 2;          // tried for one window
inline constexpr double coarse_interval = 1.3;    // of the one that suits
inline constexpr double allowed_interval = 0.03;  // off the one that its ends were made for
/// The same where its ends lie on legs. The farther off, the more do limits pass what the first and last intervals need.
inline constexpr int most_intervals_on_legs = 4;
inline constexpr double allowed_interval_on_legs = 0.002;
inline constexpr int most_steps = 80, patience = 12;  // of Newton's method, at each t
inline constexpr double least_fall = 0.7;             // of the barrier, in so many
}  // namespace corridor

/// Knots of a motion of least time that its path does without, where it takes many intervals to stop. Where it takes few, the
/// planner's own knots lie best at all of them (`leadscrew study tube`: engraving lost 4.2 % instead of 2.6). More of jerk:
/// fewer knots, and speed follows jerk that is not quite the motion's. More of the tolerance: `corridor_share` must leave room
/// for it.
namespace knot_removal {
inline constexpr double many_to_stop = 100;       // intervals
inline constexpr double jerk_share = 0.01;        // of its limit, that it may differ by
inline constexpr double tolerance_share = 0.001;  // of the tolerance, that the path may
inline constexpr double bulges = 100;  // change of jerk times a span's cube, over what the path is off: a first guess
inline constexpr std::size_t most_in_one = 256;  // intervals
inline constexpr int most_rounds = 4;
}  // namespace knot_removal

/// s that what is made may cost more by feed than what it takes the place of.
inline constexpr double allowed_time = 0.005;

/// The smoothing lengths ℓ of a spline in its tube. Longer: faster. Shortened gently, in many rounds: nearer to the
/// longest that fit. In few: less work, and what is not settled yet is kept short.
namespace tube {
inline constexpr double cone_slope = 0.1;          // |dℓ/du|
inline constexpr double shortest_smoothing = 0.5;  // tolerances
inline constexpr std::size_t fewest_spans = 4;     // of a curve
inline constexpr double lengths_per_curve = 2.5;   // at least
inline constexpr int most_rounds = 40;             // of a window
inline constexpr double samples_per_span = 4;      // at least
inline constexpr double sample_sagitta = 0.16;     // of the margin, at curvature 1/ℓ or so
inline constexpr double shortened_most = 0.5;      // by a round
inline constexpr double shortened_least = 0.93;
inline constexpr double most_lengthened = 1.002;  // by feed, of the polyline's time: more is a detour
inline constexpr double least_share = 0.01;       // of the shortest ℓ, that is tried anywhere
inline constexpr double back = -0.7;              // cosine of the angle between chords that turn back
inline constexpr double least_advance = 0.3;      // of the parameter, of chords that do not
}  // namespace tube

}  // namespace leadscrew::toolpath::tuning
