#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/study/motion_rows.hpp>
#include <leadscrew/study/studies.hpp>
#include <leadscrew/study/surface_pass.hpp>
#include <leadscrew/study/surface_patch.hpp>
#include <string>

// Lin and Koren's first claim: a whole surface is one block, and its passes are made while the machine moves. Beside it the
// same passes as an off-line program has them: lines by a chord tolerance, with a stop at each as the paper's controllers
// make, and blended as ours does.
//
// Expected figures are of another program. Their lines were as long as may be too; that with 0.01 mm looked at an inflection
// of some passes otherwise.

namespace leadscrew::study {

namespace {

constexpr double surface_feed = 50;  // mm/s
constexpr Scale plain = {"", 0}, micrometres = {"µm", 4}, bytes = {"bytes", 0};

constexpr std::array<double, 3> chords = {0.01, 0.005, 0.001}, expected_lines = {2068, 2902, 6446};
constexpr double few_lines = 5;

/// All passes, as they are and as lines.
struct PatchMachined {
  surfaces::Surface surface{patch_form()};
  std::vector<surfaces::Pass> passes = patch_passes();
  std::array<LinesOfPasses, chords.size()> lines = {lines_of(passes, chords[0]), lines_of(passes, chords[1]),
                                                    lines_of(passes, chords[2])};
};

PartProgram stopping_lines(const LinesOfPasses& lines) {
  return lines_program(lines, surface_feed, "G61.1");
}
PartProgram blended_lines(const LinesOfPasses& lines) {
  return lines_program(lines, surface_feed, "G64 P" + decimal(lines.chord, 3));
}

std::string of_chord(const LinesOfPasses& lines) {
  return "lines within " + decimal(lines.chord, 3) + " mm";
}

machine::Machine mill() {
  return machine_with({200, 1000, 20000}, {1'000'000});
}

Rows rows_of_passes(const std::vector<surfaces::Pass>& passes) {
  double contact = 0, tip = 0;
  std::size_t count = 0;
  for (const surfaces::Pass& pass : passes) {
    if (pass.is_link) continue;
    ++count;
    contact += length_of(pass, Of::contact);
    tip += length_of(pass, Of::tip);
  }
  const auto equal = patch_passes(true);
  const auto of_equal = std::ranges::count_if(equal, [](const surfaces::Pass& pass) { return !pass.is_link; });
  return under("passes", {exact_row("passes", plain, 100, static_cast<double>(count)),
                          exact_row("passes with equal steps", plain, 104, static_cast<double>(of_equal)),
                          reproduced_row("length on the surface", {"mm", 1}, 6061.9, contact, 0.1),
                          reproduced_row("length of the tip's path", {"mm", 1}, 6210.5, tip, 0.1)});
}

Rows rows_of_size(const PatchMachined& patch) {
  const double block = static_cast<double>(surface_blocks(surface_feed).size());
  Rows rows = {because(measured_row("one surface", bytes, block), "a definition of 17 lines, and one block"),
               measured_row("blocks that machine it", plain, 1)};
  for (std::size_t i = 0; i < chords.size(); ++i) {
    const LinesOfPasses& lines = patch.lines[i];
    rows.push_back(because(
        reproduced_row(of_chord(lines), plain, expected_lines[i], static_cast<double>(lines.of_passes), few_lines),
        "without the links between passes"));
    const double text = static_cast<double>(blended_lines(lines).text.size());
    rows.push_back(because(measured_row(of_chord(lines) + ", links too", bytes, text),
                           decimal(text / block, 0) + " times as many, to a ten-thousandth of a millimetre"));
  }
  return under("size of the program", std::move(rows));
}

Row time_row(const std::string& what, const PartProgram& program) {
  const base::Result<Planned> planned = plan(program, mill(), {});
  if (!planned) return not_run_row(what, planned.error().message);
  return measured_row(what, {"s", 2}, planned->seconds);
}

Rows rows_of_times(const PatchMachined& patch) {
  Rows rows = {
      because(time_row("one block", surface_program(surface_feed)), "exact: no tolerance is spent on its links")};
  for (const LinesOfPasses& lines : patch.lines) {
    rows.push_back(time_row(of_chord(lines) + ", blended", blended_lines(lines)));
    rows.push_back(time_row(of_chord(lines) + ", a stop at each", stopping_lines(lines)));
  }
  return under("times, 50 mm/s at the tip", std::move(rows));
}

/// How far words leave the ball from touching while it machines: below the clearance, and beyond the way down and up.
double contact_error_of_words(const PartProgram& program, const surfaces::Surface& surface) {
  const machine::Machine machine = mill();
  gcode::ReaderOptions options;
  options.start = program.start;
  pipeline::Program motion(gcode::text_source(program.text), machine, program.tools, options, nullptr);
  double most = 0;
  std::array<Vector, 2> before{};
  while (motion.prepare()) {
    const base::AxisVector& at = motion.cycle().position;
    const bool is_above =
        std::hypot(at[0] - before[1][0], at[1] - before[1][1]) < 1e-9;  // straight down, up, or at rest
    before = {before[1], {at[0], at[1], at[2]}};
    const bool is_over = at[0] > 3 && at[0] < 57 && at[1] > 1 && at[1] < 59;  // links are beyond
    if (is_above || !is_over || at[2] > 12) continue;
    most = std::max(most, contact_error(surface, {at[0], at[1], at[2]}));
  }
  return most;
}

Rows rows_of_accuracy(const PatchMachined& patch) {
  constexpr int sections = 12;
  double ridge = 0;
  for (std::size_t i = 0; i + 2 < patch.passes.size(); i += 2)  // links lie between
    ridge = std::max(ridge, ridge_between(patch.surface, patch.passes[i], patch.passes[i + 2], sections));
  Rows rows = {because(limit_row("highest ridge", micrometres, 1e3 * ridge_height, 1e3 * ridge, ridge_height),
                       "along the normal, from the balls as they sweep")};
  rows.push_back(limit_row("one block: ball off the surface", micrometres, 1e-3,
                           1e3 * contact_error_of_words(surface_program(surface_feed), patch.surface)));
  for (const LinesOfPasses& lines : patch.lines) {
    rows.push_back(measured_row(of_chord(lines) + ", blended: ball off the surface", micrometres,
                                1e3 * contact_error_of_words(blended_lines(lines), patch.surface)));
  }
  return under("accuracy", std::move(rows));
}

Rows rows_of_feed() {
  constexpr double period = 0.01;
  constexpr Scale per_cent = {"%", 4};
  constexpr Published of_paper(2, {Paper::real_time_interpolators, "section 4, rule of thumb"});
  const FeedErrors first = feed_errors(1, surface_feed, period), second = feed_errors(2, surface_feed, period);
  return under("feed along v = 0.5, words every 10 ms",
               {exact_row("u by its first derivative, least", per_cent, -0.0049, first.least),
                exact_row("u by its first derivative, greatest", per_cent, 0.0719, first.most),
                exact_row("u by two, least", per_cent, -0.0001, second.least),
                exact_row("u by two, greatest", per_cent, 0.0004, second.most),
                because(at_most_row("greatest of all", per_cent, of_paper, std::max(first.most, second.most)),
                        "the paper says less than 2 %")});
}

Rows rows_of_words(const std::string& what, const PartProgram& program, const machine::Machine& machine) {
  const base::Result<Judged> judged = judge(program, machine);
  if (!judged) return {not_run_row(what, judged.error().message)};
  Rows rows = ratio_rows(what + ": words at 1 ms", largest(judged->verdict.axes));
  rows.push_back(limit_row(what + ": greatest feed", {"%", 3}, 100, 100 * judged->verdict.feed_max_ratio, 0.1));
  if (judged->verdict.tip_deviation_mm) {
    rows.push_back(
        limit_row(what + ": tip off its path", micrometres, 10, 1e3 * *judged->verdict.tip_deviation_mm, 1e-3));
    rows.push_back(limit_row(what + ": tool off its direction", {"°", 4}, judged->verdict.orientation_tolerance_deg,
                             *judged->verdict.orientation_deviation_deg, 1e-6));
  }
  return rows;
}

Rows surface_cycle_rows(const Host& host) {
  constexpr Published of_paper(1, {Paper::real_time_interpolators, "section 3"});
  constexpr const char* what = "a word of a surface, median";
  if (!host.wall_seconds) {
    Row row = not_run_row(what, "no steady clock");
    row.published = of_paper;
    row.scale = {"ms", 5};
    return {row};
  }
  const base::Result<Planned> planned = plan(leaning_program(surface_feed), trunnion(), host);
  if (!planned) return {not_run_row(what, planned.error().message)};
  Rows rows = {because(at_most_row(what, {"ms", 5}, of_paper, 1e-6 * planned->cycle.p50),
                       "1 ms of a period of 10 ms for a surface and five axes, on an i486 of 33 MHz")};
  append(rows, cycle_rows(*planned, host));
  append(rows, planning_rows(*planned, host));
  return rows;
}

/// Words from the first touch on, for so many seconds: the tip's feed and how far the ball is off the surface.
struct SurfaceSamples {
  std::vector<double> feed, off;  ///< mm/s; µm, up to the greatest shown
};
SurfaceSamples surface_samples(const PartProgram& program, const surfaces::Surface& surface) {
  constexpr double shown_seconds = 4, touching = 0.02, greatest = 20;  // s, mm, µm
  const machine::Machine machine = mill();
  gcode::ReaderOptions options;
  options.start = program.start;
  pipeline::Program motion(gcode::text_source(program.text), machine, program.tools, options, nullptr);
  const double period = machine.period.seconds();
  SurfaceSamples samples;
  std::optional<Vector> last;
  while (motion.prepare() && static_cast<double>(samples.feed.size()) * period < shown_seconds) {
    const base::AxisVector& at = motion.cycle().position;
    const Vector tip = {at[0], at[1], at[2]};
    const double off = contact_error(surface, tip);
    if (!last && off > touching) continue;
    if (last) {
      samples.feed.push_back(std::hypot(tip[0] - (*last)[0], tip[1] - (*last)[1], tip[2] - (*last)[2]) / period);
      samples.off.push_back(std::min(1e3 * off, greatest));
    }
    last = tip;
  }
  return samples;
}

}  // namespace

report::ChartSheet surface_picture() {
  const PatchMachined patch;
  const double period = mill().period.seconds();
  const SurfaceSamples block = surface_samples(surface_program(surface_feed), patch.surface),
                       stops = surface_samples(stopping_lines(patch.lines[0]), patch.surface),
                       blended = surface_samples(blended_lines(patch.lines[0]), patch.surface);
  report::ChartSheet sheet;
  sheet.title = "the first seconds on a patch";
  sheet.keys = {{0, of_chord(patch.lines[0]) + ", a stop at each"}, {1, "the same, blended"}, {3, "one block"}};
  sheet.same_scale = false;
  const auto add = [&](std::string title, std::vector<double> SurfaceSamples::* part, std::vector<double> levels) {
    std::vector<report::Curve> curves;
    for (const auto& [samples, color] : {std::pair(&stops, 0), {&blended, 1}, {&block, 3}}) {
      curves.push_back(report::evenly_spaced(samples->*part, period));
      curves.back().color = static_cast<std::size_t>(color);
    }
    sheet.charts.push_back({std::move(title), std::move(curves), std::move(levels)});
  };
  add("feed of the tip, mm/s", &SurfaceSamples::feed, {surface_feed});
  add("ball off the surface, µm, up to 20: links lift it", &SurfaceSamples::off, {});
  return sheet;
}

Rows surface_rows(const Host& host) {
  const PatchMachined patch;
  Rows rows = rows_of_passes(patch.passes);
  append(rows, rows_of_size(patch));
  append(rows, rows_of_times(patch));
  append(rows, rows_of_accuracy(patch));
  append(rows, rows_of_feed());
  Rows judged = rows_of_words("one block, three axes", surface_program(surface_feed), mill());
  append(judged, rows_of_words("one block, five axes", leaning_program(surface_feed), trunnion()));
  append(rows, under("by the referee", std::move(judged)));
  append(rows, under("the cycle, five axes", surface_cycle_rows(host)));
  for (Row& row : rows) row.group = "patch of 60 by 60 mm, ball of 5 mm radius, ridges of 0.01 mm: " + row.group;
  return rows;
}

}  // namespace leadscrew::study
