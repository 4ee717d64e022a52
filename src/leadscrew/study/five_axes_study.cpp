#include <algorithm>
#include <cmath>
#include <leadscrew/study/five_axes_motion.hpp>
#include <leadscrew/study/motion_rows.hpp>
#include <leadscrew/study/studies.hpp>
#include <leadscrew/study/surface_pass.hpp>
#include <string>

// What interpolating off-line costs five axes: Lin and Koren's first drawback of it, made concrete. A pass over a patch is
// cut into lines by a chord tolerance, and all axes go straight from end to end of each. Between the ends nothing holds the
// tip: the rotary axes turn the part under it, by more than anyone looked at. Beside it the same pass as a path of the
// tip and the rotary axes, from which the axes are computed for every word.
//
// Expected figures are of another program, which looked at twenty places of each line.

namespace leadscrew::study {

namespace {

constexpr double five_axis_feed = 50, chord = 0.01;  // mm/s, mm
constexpr int twentieths = 20, finely = 2000;
constexpr double spline_direction = 0.01;  // degrees, that the curve of A and C may be off
constexpr Scale millimetres = {"mm", 3}, micrometres = {"µm", 4}, degrees = {"°", 3};
constexpr const char *stopping_control = "G61.1", *blending_control = "G64 P0.01 E0.05";

/// The pass in all its forms.
struct FiveAxisPass {
  machine::Machine machine = trunnion();
  kinematics::Chain chain = kinematics::chain_of(machine);
  SurfacePass pass{chain};
  std::vector<double> places = pass.chords(chord);
  std::vector<TipAndRotary> lines = pass.along(places);
  std::vector<TipAndRotary> fine_lines = pass.along(subdivided(chain, pass, places, chord));
  std::vector<TipAndRotary> control_points = fitted();

  FiveAxisPass() = default;
  FiveAxisPass(const FiveAxisPass&) = delete;  // the pass looks into the chain
  FiveAxisPass& operator=(const FiveAxisPass&) = delete;

 private:
  /// The fewest spans, doubled each time, with which the tool is along the normal.
  std::vector<TipAndRotary> fitted() const {
    constexpr int most_spans = 1024;
    for (int spans = 8;; spans *= 2) {
      auto control = pass.control_points(spans);
      if (error_of_spline(chain, pass, control, finely).direction <= spline_direction || spans >= most_spans)
        return control;
    }
  }
};

double turned_by_c(const std::vector<TipAndRotary>& ends) {
  constexpr std::size_t c = base::index(base::Axis::C);
  double turned = 0;
  for (std::size_t i = 1; i < ends.size(); ++i) turned += std::abs(ends[i][c] - ends[i - 1][c]);
  return turned;
}

double count_of_lines(const std::vector<TipAndRotary>& ends) {
  return static_cast<double>(ends.size() - 1);
}

Rows rows_of_lines(const FiveAxisPass& five) {
  const PoseError coarse = error_of_lines(five.chain, five.lines, Straight::axes, twentieths);
  const PoseError most = error_of_lines(five.chain, five.lines, Straight::axes, finely);
  const PoseError fine = error_of_lines(five.chain, five.fine_lines, Straight::axes, finely);
  const PoseError controlled = error_of_lines(five.chain, five.lines, Straight::tip, finely);
  const PoseError curve = error_of_spline(five.chain, five.pass, five.control_points, finely);
  Rows rows = under("cut into lines by a chord tolerance of 0.01 mm",
                    {exact_row("lines", {"", 0}, 18, count_of_lines(five.lines)),
                     exact_row("C turns by", {"°", 1}, 252.6, turned_by_c(five.lines))});
  append(
      rows,
      under(
          "axes straight between the ends of lines, off-line",
          {because(exact_row("tip off its line, at twentieths of each", millimetres, 4.642, coarse.tip),
                   decimal(coarse.tip / chord, 0) + " times the tolerance by which the lines were cut"),
           measured_row("tip off its line, greatest", millimetres, most.tip),
           because(exact_row("tool off the great circle", degrees, 0.888, most.direction), "at the same share of both"),
           because(measured_row("lines with which the tip is within 0.01 mm", {"", 0}, count_of_lines(five.fine_lines)),
                   "each of those lines cut into equal parts"),
           measured_row("tip off its line with those", millimetres, fine.tip)}));
  append(rows, under("tip and rotary axes straight, axes from them for every word",
                     {limit_row("tip off its line", micrometres, 1e3 * chord, 1e3 * controlled.tip),
                      because(measured_row("tool off the great circle", degrees, controlled.direction),
                              "rotary words are interpolated linearly here too: the lines are as long")}));
  append(rows, under("one curve of tip and rotary axes",
                     {measured_row("control points", {"", 0}, static_cast<double>(five.control_points.size())),
                      limit_row("tip off the pass", micrometres, 1e3 * chord, 1e3 * curve.tip),
                      limit_row("tool off the normal", degrees, spline_direction, curve.direction)}));
  return rows;
}

/// Of the motion's words, at the machine's period.
Rows rows_of_words(const std::string& what, const PartProgram& program, const FiveAxisPass& five) {
  const auto samples = pose_samples(program, five.machine, five.pass);
  PoseSample most;
  for (const PoseSample& sample : samples) {
    most.tip = std::max(most.tip, sample.tip);
    most.direction = std::max(most.direction, sample.direction);
  }
  return {measured_row(what + ": tip off the pass", millimetres, most.tip),
          measured_row(what + ": tool off its normal", degrees, most.direction)};
}

Row time_of(const std::string& what, const PartProgram& program, const FiveAxisPass& five) {
  const base::Result<Planned> planned = plan(program, five.machine, {});
  if (!planned) return not_run_row(what, planned.error().message);
  return measured_row(what, {"s", 3}, planned->seconds);
}

Rows rows_of_times(const FiveAxisPass& five) {
  const std::string few = decimal(count_of_lines(five.lines), 0), many = decimal(count_of_lines(five.fine_lines), 0);
  const auto axes = [&](const std::vector<TipAndRotary>& ends, const char* control) {
    return program_of_axes(five.chain, ends, five_axis_feed, control);
  };
  const auto tip = [&](const char* control) { return program_of_tip(five.chain, five.lines, five_axis_feed, control); };
  return under("times, 50 mm/s at the tip",
               {time_of(few + " lines of axes, a stop at each", axes(five.lines, stopping_control), five),
                time_of(few + " lines of axes, blended", axes(five.lines, blending_control), five),
                time_of(many + " lines of axes, a stop at each", axes(five.fine_lines, stopping_control), five),
                time_of(many + " lines of axes, blended", axes(five.fine_lines, blending_control), five),
                time_of(few + " lines of the tip, a stop at each", tip(stopping_control), five),
                time_of(few + " lines of the tip, blended", tip(blending_control), five),
                time_of("one curve", program_of_pass(five.chain, five.control_points, five_axis_feed), five)});
}

/// Against the program and the limits, by the referee.
Rows judged_rows(const std::string& what, const PartProgram& program, double tolerance, const FiveAxisPass& five) {
  const base::Result<Judged> judged = judge(program, five.machine);
  if (!judged) return {not_run_row(what, judged.error().message)};
  Rows rows = ratio_rows(what + ": words at 1 ms", largest(judged->verdict.axes));
  rows.push_back(limit_row(what + ": tip off the program", micrometres, 1e3 * tolerance,
                           1e3 * judged->verdict.deviation_mm, 1e-3));
  return rows;
}

Rows rows_of_cycle(const PartProgram& program, const FiveAxisPass& five, const Host& host) {
  constexpr Published of_paper(1, {Paper::real_time_interpolators, "section 3"});
  constexpr const char* what = "a word of five axes, median";
  const auto not_run = [&](const std::string& why) {
    Row row = not_run_row(what, why);
    row.published = of_paper;
    row.scale = {"ms", 5};
    return Rows{row};
  };
  if (!host.wall_seconds) return not_run("no steady clock");
  const base::Result<Planned> planned = plan(program, five.machine, host);
  if (!planned) return not_run(planned.error().message);
  Rows rows = {because(at_most_row(what, {"ms", 5}, of_paper, 1e-6 * planned->cycle.p50),
                       "1 ms of a period of 10 ms, on an i486 of 33 MHz, from a surface")};
  append(rows, cycle_rows(*planned, host));
  return rows;
}

report::Curve curve_of(const std::vector<PoseSample>& samples, double PoseSample::* part, std::size_t color,
                       double period) {
  std::vector<double> values;
  for (const PoseSample& sample : samples) values.push_back(sample.*part);
  report::Curve curve = report::evenly_spaced(values, period);
  curve.color = color;
  return curve;
}

}  // namespace

Rows five_axes_rows(const Host& host) {
  const FiveAxisPass five;
  const PartProgram curve = program_of_pass(five.chain, five.control_points, five_axis_feed);
  Rows rows = rows_of_lines(five);
  append(rows, rows_of_times(five));
  const std::string few = decimal(count_of_lines(five.lines), 0);
  Rows words = rows_of_words(few + " lines of axes, blended",
                             program_of_axes(five.chain, five.lines, five_axis_feed, blending_control), five);
  append(words, rows_of_words("one curve", curve, five));
  append(rows, under("words every millisecond", std::move(words)));
  Rows judged = judged_rows(few + " lines of the tip, blended",
                            program_of_tip(five.chain, five.lines, five_axis_feed, blending_control), chord, five);
  append(judged, judged_rows("one curve", curve, 0, five));
  append(rows, under("by the referee", std::move(judged)));
  append(rows, under("the cycle", rows_of_cycle(curve, five, host)));
  for (Row& row : rows) row.group = "pass over a patch, tool along the normal, A and C of a trunnion: " + row.group;
  return rows;
}

report::ChartSheet five_axes_picture() {
  const FiveAxisPass five;
  const double period = five.machine.period.seconds();
  const auto lines =
      pose_samples(program_of_axes(five.chain, five.lines, five_axis_feed, stopping_control), five.machine, five.pass);
  const auto curve =
      pose_samples(program_of_pass(five.chain, five.control_points, five_axis_feed), five.machine, five.pass);
  report::ChartSheet sheet;
  sheet.title = "a pass over a patch, by five axes";
  sheet.keys = {{0, decimal(count_of_lines(five.lines), 0) + " lines, axes straight, a stop at each"},
                {3, "one curve of tip and rotary axes"}};
  sheet.same_scale = false;
  const auto add = [&](std::string title, double PoseSample::* part, std::vector<double> levels) {
    sheet.charts.push_back(
        {std::move(title), {curve_of(curve, part, 3, period), curve_of(lines, part, 0, period)}, std::move(levels)});
  };
  add("tip off the pass, mm", &PoseSample::tip, {});
  add("tool off the normal, degrees", &PoseSample::direction, {});
  add("feed of the tip, mm/s", &PoseSample::feed, {five_axis_feed});
  add("C, degrees/s", &PoseSample::turning, {});
  return sheet;
}

}  // namespace leadscrew::study
