#pragma once
// The published experiments, each a function that makes it again and returns a row for every figure.

#include <leadscrew/report/charts.hpp>
#include <leadscrew/study/host.hpp>
#include <leadscrew/study/row.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::study {

/// A file that a study can write beside its rows.
struct StudyFile {
  std::string name;  ///< such as "square.csv"
  std::string text;
};

struct Study {
  std::string_view name;   ///< as the command line takes it
  std::string_view title;  ///< one line
  Rows (*rows)(const Host&);
  report::ChartSheet (*picture)() = nullptr;  ///< quantities over time, where there are any; its title says which
  /// Programs and the words of each as a trace that `leadscrew verify` reads, where there are any.
  std::vector<StudyFile> (*words)(const Host&) = nullptr;
};

/// All there are, in the order in which they are listed.
std::span<const Study> studies();

/// The butterfly as a curve: length, sharpest bend, the map from length to parameter; and the times of travelling it.
Rows butterfly_rows(const Host& host);

/// Feed and chord errors of each rule of parameter steps on the plane cubic and the butterfly, at 1 … 10 ms.
Rows feed_fluctuation_rows(const Host& host);

/// Times, limits and effort of the motion along the plane cubic, a circle and the butterfly, beside the numerical
/// optima.
Rows curve_rows(const Host& host);

/// Those, and the same of short lines and corners blended within a tolerance.
Rows limits_rows(const Host& host);

/// Corners, polygons, zigzags, short lines and arcs: the least time in which any motion within the tolerance and every
/// limit can be through, found by optimisation, and the time of ours.
Rows tube_rows(const Host& host);
/// Each fragment and the words of its least time at 1 ms, named alike.
std::vector<StudyFile> tube_words(const Host& host);

/// Table I of "Interpolator for a computer numerical control system": the cosine after half a turn by four methods.
Rows table_1_rows(const Host& host);
/// Its orders of truncation errors, and that of its own method.
Rows orders_rows(const Host& host);
/// Its half circle by integers, and what other conventions make of it.
Rows half_circle_rows(const Host& host);
/// Its integrators, feed words and clocks: eqs. 1 to 5 and 14 to 21.
Rows feed_code_rows(const Host& host);

/// The comparison of "FPGA-based implementation of circular interpolation".
Rows fpga_rows(const Host& host);

/// The three problems of "Interpolators linear", lecture 12: rates of a pulse-driven axis, DDAs of a line, a timer.
Rows lecture_rows(const Host& host);

/// Its pulse-driven axis as it runs, and the contours of two such axes beside their closed forms.
Rows closed_loop_rows(const Host& host);

/// Lin and Koren's plane cubic as one block and as 92 lines with a stop at each, through their servo loops.
Rows real_time_rows(const Host& host);
/// The measured feed of each.
report::ChartSheet real_time_picture();

/// A pass over a curved patch by five axes: as lines between whose ends all axes go straight, and as a path of the tip and
/// the rotary axes. Errors of tip and direction, times, and the cycle's time beside that of the paper.
Rows five_axes_rows(const Host& host);
/// Errors, the tip's feed and C's of both, over time.
report::ChartSheet five_axes_picture();

/// A surface in one block beside the same passes in short lines: size, times with a stop at each line and blended, ridges,
/// how near the tool is to the surface, feed, and the cycle's time beside that of the paper.
Rows surface_rows(const Host& host);
/// The first seconds of each: feed, and the tool's distance from the surface.
report::ChartSheet surface_picture();

/// A slot of changing depth under adaptive control, from 50 to 200 % of the programmed feed: force held and time saved
/// by the planner's feed override and by that of the NC program; what becomes of the feed when the sensor fails.
Rows adaptive_rows(const Host& host);

/// What "Digital integral interpolator based on LabVIEW" says of n-bit registers.
Rows digital_integrals_rows(const Host& host);

/// Greatest errors, clocks and pulses of every interpolator: circles to R = 4096, arcs of R² ≤ 900, lines to 256.
Rows bounds_rows(const Host& host);

}  // namespace leadscrew::study
