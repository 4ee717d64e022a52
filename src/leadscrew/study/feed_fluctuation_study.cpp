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

/// What has been published of one rule on one course.
struct Published {
  StepRule rule;
  double speed, period;  ///< mm/s, s
  double least, greatest;
  double accuracy;  ///< all in %
};

/// The plane cubic at 10 mm/s and 10 ms, to the digits printed.
constexpr std::array<Published, 4> published_cubic = {{
    {StepRule::uniform, 10, 0.010, -33, 28, 0.5},
    {StepRule::taylor1, 10, 0.010, -0.70, 0.53, 0.005},
    {StepRule::taylor2, 10, 0.010, -0.005, 0.016, 0.0005},
    {StepRule::newton, 10, 0.010, 0, 0, 0.0005},
}};

/// Whether a feed is told by the chord between words or by the curve between them: where bends are sharp, two figures.
enum class Measure : std::uint8_t { chord, curve };

/// Greatest size of the feed error, %. Which measure was meant is not told with either curve; these are the ones that
/// give the published figures, and the rows say what the other gives.
struct PublishedSize {
  StepRule rule;
  double speed, period;  ///< mm/s, s
  Measure measure;
  double size, accuracy;
};
constexpr std::array<PublishedSize, 2> published_slow = {{
    {StepRule::taylor1, 10, 0.020, Measure::chord, 1.4, 0.05},
    {StepRule::taylor1, 10, 0.050, Measure::chord, 3.3, 0.05},
}};
constexpr std::array<PublishedSize, 2> published_butterfly = {{
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
  row.why = "published: (VT)²/(8ρ) along the curve";
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

Rows published_cubic_rows(const geometry::Nurbs& cubic) {
  Rows rows;
  for (const Published& published : published_cubic) {
    const March marched = march(cubic, published.rule, published.speed, published.period);
    Row below = at_most_row("feed error, size, below", {"%", 3}, 2, size_of(marched));
    Rows ours = {reproduced_row("feed error, greatest", {"%", 3}, published.greatest, 100 * marched.feed_error_max,
                                published.accuracy),
                 reproduced_row("feed error, least", {"%", 3}, published.least, 100 * marched.feed_error_min,
                                published.accuracy),
                 std::move(below)};
    append(rows,
           under("published: " + heading({"plane cubic", cubic, published.speed}, published.period, published.rule),
                 std::move(ours)));
  }
  return rows;
}

Row size_row(const PublishedSize& published, const March& marched) {
  const double by_chord = size_of(marched), by_curve = 100 * marched.arc_error;
  const bool is_chord = published.measure == Measure::chord;
  Row row = reproduced_row(is_chord ? "feed error, size" : "feed error along the curve, size", {"%", 2}, published.size,
                           is_chord ? by_chord : by_curve, published.accuracy);
  row.why = is_chord ? "by the chord; along the curve " + decimal(by_curve, 2) + " %"
                     : "by the chord " + decimal(by_chord, 2) + " %; a march begun elsewhere meets the bends otherwise";
  return row;
}

template <std::size_t count>
Rows published_sizes(const std::string& name, const geometry::Nurbs& curve,
                     const std::array<PublishedSize, count>& figures) {
  Rows rows;
  for (const PublishedSize& published : figures) {
    const March marched = march(curve, published.rule, published.speed, published.period);
    append(rows, under("published: " + heading({name, curve, published.speed}, published.period, published.rule),
                       {size_row(published, marched)}));
  }
  return rows;
}

/// The curve itself; and two computers, T = 1.5 and 2 ms: the chord error falls with T², by 1 − (1.5/2)².
Rows curve_and_chord_rows(const geometry::Nurbs& cubic) {
  const double faster = march(cubic, StepRule::newton, 10, 0.0015).chord_error;
  const double slower = march(cubic, StepRule::newton, 10, 0.002).chord_error;
  Row row = exact_row("chord error saved by T = 1.5 ms in place of 2 ms", {"%", 0}, 44, 100 * (1 - faster / slower));
  row.why = "by eq. (3): 1 − (1.5/2)² = 43.75 %";
  Row sag = exact_row("chord error at T = 10 ms", {"µm", 3}, 0.444,
                      1e3 * march(cubic, StepRule::newton, 10, 0.010).chord_error);
  return under("published: plane cubic, V 10 mm/s",
               {exact_row("length", {"mm", 4}, 29.8413, cubic.length()),
                exact_row("smallest radius of curvature", {"mm", 4}, 2.8152, min_radius(cubic)), std::move(row),
                std::move(sag)});
}

}  // namespace

Rows feed_fluctuation_rows(const Host&) {
  // Both curves are smooth throughout: one piece each.
  const geometry::Nurbs cubic = geometry::smooth_pieces(plane_cubic()).front();
  const geometry::Nurbs insect = geometry::smooth_pieces(butterfly()).front();
  Rows rows = published_cubic_rows(cubic);
  append(rows, curve_and_chord_rows(cubic));
  append(rows, published_sizes("plane cubic", cubic, published_slow));
  append(rows, published_sizes("butterfly", insect, published_butterfly));
  for (const Course& course : {Course{"plane cubic", cubic, 10}, {"butterfly", insect, 10}, {"butterfly", insect, 100}})
    append(rows, course_rows(course));
  return rows;
}

}  // namespace leadscrew::study
