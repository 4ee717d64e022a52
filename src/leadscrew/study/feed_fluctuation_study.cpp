#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/study/butterfly.hpp>
#include <leadscrew/study/curves.hpp>
#include <leadscrew/study/marching.hpp>
#include <leadscrew/study/studies.hpp>

namespace leadscrew::study {

namespace {

using interpolator::StepRule;

constexpr std::array<double, 4> periods = {0.001, 0.002, 0.005, 0.010};  // s
constexpr Scale percent = {"%", 4};
constexpr Scale micrometre = {"µm", 4};

/// A curve travelled at constant speed.
struct Course {
  std::string name;
  geometry::Nurbs curve;
  double speed;  ///< mm/s
};

/// What is expected of one rule on one course.
struct ExpectedErrors {
  StepRule rule;
  double speed, period;  ///< mm/s, s
  double least, greatest;
  double accuracy;  ///< all in %
};

/// The plane cubic at 10 mm/s and 10 ms, by other computations, to the digits given.
constexpr std::array<ExpectedErrors, 4> expected_cubic = {{
    {StepRule::uniform, 10, 0.010, -33, 28, 0.5},
    {StepRule::taylor1, 10, 0.010, -0.70, 0.53, 0.005},
    {StepRule::taylor2, 10, 0.010, -0.005, 0.016, 0.0005},
    {StepRule::newton, 10, 0.010, 0, 0, 0.0005},
}};

/// Whether a feed is told by the chord between words or by the curve between them: where bends are sharp, two figures.
enum class Measure : std::uint8_t { chord, curve };

/// Greatest size of the feed error, %, by other computations. Which measure was meant is not told with either curve;
/// these are the ones that give the figures, and the rows say what the other gives.
struct ExpectedSize {
  StepRule rule;
  double speed, period;  ///< mm/s, s
  Measure measure;
  double size, accuracy;
};
constexpr std::array<ExpectedSize, 2> expected_slow = {{
    {StepRule::taylor1, 10, 0.020, Measure::chord, 1.4, 0.05},
    {StepRule::taylor1, 10, 0.050, Measure::chord, 3.3, 0.05},
}};
constexpr std::array<ExpectedSize, 2> expected_butterfly = {{
    {StepRule::taylor1, 100, 0.001, Measure::curve, 78, 0.5},
    {StepRule::taylor2, 100, 0.001, Measure::curve, 75, 0.5},
}};

/// Greatest size of the feed error, by the chord, %.
double size_of(const March& march) {
  return 100 * std::max(std::abs(march.feed_error_min), std::abs(march.feed_error_max));
}

std::string heading(const Course& course, double period, StepRule rule) {
  return course.name + ", V " + decimal(course.speed, 0) + " mm/s, T " + decimal(1e3 * period, 0) + " ms, " +
         std::string(interpolator::name(rule));
}

Row chord_row(const Course& course, const March& marched, StepRule rule, double period, double sharpest) {
  const double formula = 1e3 * marched.chord_error_rule;
  Row row = reproduced_row("chord error", micrometre, formula, 1e3 * marched.chord_error, 0.02 * formula);
  row.why = "eq. (3) of Lin and Koren, (VT)²/(8ρ), along the curve";
  if (rule == StepRule::uniform) row.why += "; these steps are not VT long";
  if (course.speed * period > sharpest / 2) {
    row.why += "; VT = " + decimal(course.speed * period, 3) + " mm is not small beside ρ = " + decimal(sharpest, 4);
  }
  return row;
}

Rows rows_of(const Course& course, const March& marched, StepRule rule, double period, double sharpest) {
  Rows rows = {measured_row("feed error, greatest", percent, 100 * marched.feed_error_max),
               measured_row("feed error, least", percent, 100 * marched.feed_error_min),
               chord_row(course, marched, rule, period, sharpest)};
  return under(heading(course, period, rule), std::move(rows));
}

Rows course_rows(const Course& course) {
  const double sharpest = min_radius(course.curve);
  Rows rows;
  for (const double period : periods) {
    for (const StepRule rule : interpolator::all_step_rules) {
      const March marched = march(course.curve, rule, course.speed, period);
      append(rows, rows_of(course, marched, rule, period, sharpest));
    }
  }
  return rows;
}

Rows expected_cubic_rows(const geometry::Nurbs& cubic) {
  constexpr Published rule_of_thumb(2, {Paper::real_time_interpolators, "section 4, rule of thumb"});
  Rows rows;
  for (const ExpectedErrors& expected : expected_cubic) {
    const March marched = march(cubic, expected.rule, expected.speed, expected.period);
    Rows ours = {
        reproduced_row("feed error, greatest", {"%", 3}, expected.greatest, 100 * marched.feed_error_max,
                       expected.accuracy),
        reproduced_row("feed error, least", {"%", 3}, expected.least, 100 * marched.feed_error_min, expected.accuracy),
        at_most_row("feed error, size, below", {"%", 3}, rule_of_thumb, size_of(marched))};
    append(rows, under("expected: " + heading({"plane cubic", cubic, expected.speed}, expected.period, expected.rule),
                       std::move(ours)));
  }
  return rows;
}

Row size_row(const ExpectedSize& expected, const March& marched) {
  const double by_chord = size_of(marched), by_curve = 100 * marched.arc_error;
  const bool is_chord = expected.measure == Measure::chord;
  Row row = reproduced_row(is_chord ? "feed error, size" : "feed error along the curve, size", {"%", 2}, expected.size,
                           is_chord ? by_chord : by_curve, expected.accuracy);
  row.why = is_chord ? "by the chord; along the curve " + decimal(by_curve, 2) + " %"
                     : "by the chord " + decimal(by_chord, 2) + " %; a march begun elsewhere meets the bends otherwise";
  return row;
}

template <std::size_t count>
Rows expected_sizes(const std::string& name, const geometry::Nurbs& curve,
                    const std::array<ExpectedSize, count>& figures) {
  Rows rows;
  for (const ExpectedSize& expected : figures) {
    const March marched = march(curve, expected.rule, expected.speed, expected.period);
    append(rows, under("expected: " + heading({name, curve, expected.speed}, expected.period, expected.rule),
                       {size_row(expected, marched)}));
  }
  return rows;
}

Rows curve_figure_rows(const geometry::Nurbs& cubic) {
  return under("expected: plane cubic, V 10 mm/s",
               {exact_row("length", {"mm", 4}, 29.8413, cubic.length()),
                exact_row("smallest radius of curvature", {"mm", 4}, 2.8152, min_radius(cubic)),
                exact_row("chord error at T = 10 ms", {"µm", 3}, 0.444,
                          1e3 * march(cubic, StepRule::newton, 10, 0.010).chord_error)});
}

/// The chord error falls with T²: a millisecond for the interface and the control, and the time of the interpolation,
/// 1 ms by the slower one.
Rows sampling_rows(const geometry::Nurbs& cubic) {
  const auto chord_error = [&](double interpolation) {
    return march(cubic, StepRule::newton, 10, 1e-3 * (1 + interpolation)).chord_error;
  };
  const auto saved = [&](double interpolation) { return 100 * (1 - chord_error(interpolation) / chord_error(1)); };
  constexpr Published algorithm(44, {Paper::real_time_interpolators, "section 4, algorithms A and B"});
  constexpr Published computer(44, {Paper::real_time_interpolators, "section 4, the faster computer"});
  Row faster = exact_row("chord error saved by a computer 50 % faster", {"%", 1}, computer, saved(1 / 1.5));
  return under("plane cubic, V 10 mm/s, 1 ms and the time of interpolation as T",
               {because(exact_row("chord error saved by T = 1.5 ms in place of 2 ms", {"%", 0}, algorithm, saved(0.5)),
                        "by eq. (3): 1 − (1.5/2)² = 43.75 %"),
                because(expecting(std::move(faster), 100 * (1 - std::pow((1 + 1 / 1.5) / 2, 2))),
                        "1.5 times as fast gives T = 1.667 ms and 30.6 %; 44 % needs a computer twice as fast")});
}

}  // namespace

Rows feed_fluctuation_rows(const Host&) {
  // Both curves are smooth throughout: one piece each.
  const geometry::Nurbs cubic = geometry::smooth_pieces(plane_cubic()).front();
  const geometry::Nurbs insect = geometry::smooth_pieces(butterfly()).front();
  Rows rows = expected_cubic_rows(cubic);
  append(rows, curve_figure_rows(cubic));
  append(rows, sampling_rows(cubic));
  append(rows, expected_sizes("plane cubic", cubic, expected_slow));
  append(rows, expected_sizes("butterfly", insect, expected_butterfly));
  for (const Course& course : {Course{"plane cubic", cubic, 10}, {"butterfly", insect, 10}, {"butterfly", insect, 100}})
    append(rows, course_rows(course));
  return rows;
}

}  // namespace leadscrew::study
