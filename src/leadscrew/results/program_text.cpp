#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/results/diagnostic_text.hpp>
#include <leadscrew/results/gouging.hpp>
#include <leadscrew/results/program_text.hpp>

namespace leadscrew::results {

namespace {

constexpr std::size_t most_violations = 5;

/// A ratio as a percentage of the limit, red where the limit is passed by more than 0.1 %.
std::string percent(double ratio, const Style& style) {
  const std::string text = fmt::format("{:8.1f} %", ratio * 100);
  return ratio > 1.001 ? style(Tone::error, text) : text;
}

std::string seconds_text(double seconds) {
  return seconds < 60 ? fmt::format("{:.4f} s", seconds) : fmt::format("{:.3f} s ({})", seconds, clock_text(seconds));
}

std::string counted(std::int64_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string feed_text(double programmed_mm_s, double max_ratio) {
  if (programmed_mm_s == 0) return "rapids only";
  return fmt::format("programmed up to {:g} mm/min, reached {:.1f} % of it", programmed_mm_s * 60, max_ratio * 100);
}

/// Of words that were made, of lines in step with the spindle too: the referee asks no feed of these.
std::string feed_text(const pipeline::Summary& summary, double max_ratio) {
  if (summary.threads.lines + summary.threads.out_of_step == 0 || max_ratio > 0)
    return feed_text(summary.feed_programmed_max, max_ratio);
  return fmt::format("in step with the spindle alone, by S up to {:g} mm/min", summary.feed_programmed_max * 60);
}

std::string threads_text(const interpolator::ThreadFigures& threads) {
  std::string text = counted(threads.lines, "line") + " in step with the spindle";
  if (threads.run_in > 0)
    text += fmt::format(", at the latest {:.3f} mm behind the beginning: {}", threads.run_in,
                        line_text(threads.run_in_line));
  if (threads.out_of_step > 0)
    text += fmt::format("; {} too short to get in step: {}", counted(threads.out_of_step, "line"),
                        line_text(threads.out_of_step_line));
  return text;
}

std::string axis_table(const referee::Verdict& verdict, const constraints::LimitRatios* plan, const Style& style) {
  std::string text = style(
      Tone::faint, plan == nullptr
                       ? "  axis    velocity   accel.     jerk    of its limit"
                       : "  axis    velocity   accel.     jerk    of its limit; by plan:  velocity   accel.     jerk");
  text += '\n';
  for (const referee::AxisVerdict& axis : verdict.axes) {
    text += fmt::format("  {:<4} {}{}{}", base::letter(axis.axis), percent(axis.velocity_ratio, style),
                        percent(axis.acceleration_ratio, style), percent(axis.jerk_ratio, style));
    if (plan != nullptr) {
      const machine::Derivatives ratios = plan->of_axis(axis.axis);
      text += fmt::format("{:24}{}{}{}", "", percent(ratios.velocity, style), percent(ratios.acceleration, style),
                          percent(ratios.jerk, style));
    }
    text += '\n';
  }
  return text;
}

/// A line for each limit of the path itself that the machine has.
std::string path_limits_text(const constraints::LimitRatios& plan, const Style& style) {
  std::string text;
  for (const auto& [name, ratio] : plan.of_path()) {
    if (ratio > 0) text += fmt::format("  {} {} of its limit, by plan\n", name, percent(ratio, style));
  }
  return text;
}

std::string violations_text(const referee::Verdict& verdict, const Style& style) {
  std::string text;
  for (std::size_t i = 0; i < std::min(verdict.violations.size(), most_violations); ++i) {
    const referee::Violation& violation = verdict.violations[i];
    text += fmt::format("  {} t = {:.4f} s, {}: {} is {:.6g}, limit {:.6g}\n", style(Tone::error, "!"), violation.t,
                        line_text(violation.line), violation.what, violation.value, violation.limit);
  }
  const auto shown = static_cast<std::int64_t>(std::min(verdict.violations.size(), most_violations));
  if (verdict.violation_count > shown) text += fmt::format("  … and {} more\n", verdict.violation_count - shown);
  return text;
}

std::string steps_text(const StepFigures& steps) {
  const std::string text = fmt::format("{} at a clock of {:g} kHz, the last at {}", steps.steps,
                                       static_cast<double>(steps.clock_hz) / 1e3, seconds_text(steps.time_s));
  if (!steps.error_blu) {
    return text + fmt::format("; by {}{}, {}: time and limits above are those of the words", steps.method,
                              steps.conventions.empty() ? "" : " (" + steps.conventions + ")",
                              steps.accelerates ? "within the acceleration of the axes but for a few steps"
                                                : "at the feed at once, without a limit of acceleration");
  }
  return text + fmt::format("; within {:.3f} BLU of the {}words", *steps.error_blu,
                            steps.corrections.empty() ? "" : "compensated ");
}

std::string corrections_text(const std::vector<Correction>& corrections) {
  std::string text = "made good by up to";
  for (const Correction& correction : corrections) {
    text += fmt::format("{} {:.3g} {} in {}", &correction == corrections.data() ? "" : ",", correction.greatest,
                        base::is_rotary(correction.axis) ? "degrees" : "mm", base::letter(correction.axis));
  }
  return text;
}

/// The dearest causes of what is lost against feed words, each above a hundredth of the time.
std::string lost_text(const pipeline::LostByCause& lost, double time) {
  constexpr std::size_t most_causes = 4;
  std::string text;
  double all = 0;
  for (const auto& [cause, seconds] : lost) all += seconds;
  std::size_t shown = 0;
  for (const auto& [cause, seconds] : pipeline::ranked(lost)) {
    if (shown == most_causes || seconds < 0.01 * time) break;
    text += fmt::format("{} {} {}", shown++ == 0 ? ":" : ",", pipeline::name(cause), seconds_text(seconds));
  }
  return fmt::format("{} against feed words{}", seconds_text(all), text);
}

std::string extents_text(const std::vector<Extent>& extents) {
  const auto rounded = [](double place) { return std::abs(place) < 5e-4 ? 0.0 : place; };  // without a sign of zero
  std::string text;
  for (const Extent& extent : extents) {
    text += fmt::format("{}{} {:.3f} to {:.3f}", text.empty() ? "" : ", ", base::letter(extent.axis),
                        rounded(extent.least), rounded(extent.greatest));
  }
  return text;
}

std::string verdict_text(bool kept, const Style& style) {
  return "  " +
         (kept ? style(Tone::good, "kept: every limit and the tolerance")
               : style(Tone::error, "NOT kept: a limit or the tolerance")) +
         "\n";
}

}  // namespace

std::string clock_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::llround(seconds));
  const auto hours = whole / 3600, minutes = whole / 60 % 60;
  if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
  return fmt::format("{}:{:02}", minutes, whole % 60);
}

std::string period_text(base::Period period) {
  const auto nanoseconds = static_cast<double>(period.nanoseconds);
  return period.nanoseconds >= 1'000'000 ? fmt::format("{} ms", nanoseconds / 1e6)
                                         : fmt::format("{} us", nanoseconds / 1e3);
}

std::string row(std::string_view name, const std::string& value) {
  return fmt::format("  {:<10} {}\n", name, value);
}

std::string heading(const std::string& program, const std::string& machine, base::Period period, const Style& style) {
  return fmt::format("{} on {}, period {}\n", style(Tone::strong, printable(program)), printable(machine),
                     period_text(period));
}

std::string deviation_text(double deviation, double tolerance) {
  return fmt::format("{:.3g} mm, tolerance {:g} mm", deviation, tolerance);
}

std::string tip_row(const referee::Verdict& verdict) {
  if (!verdict.tip_deviation_mm) return "";
  return row("tip", fmt::format("{:.3g} mm off its path; the tool {:.3g}° off its direction, tolerance {:g}°",
                                *verdict.tip_deviation_mm, *verdict.orientation_deviation_deg,
                                verdict.orientation_tolerance_deg));
}

std::string run_summary(const std::string& program, const machine::Machine& machine, const RunFigures& figures,
                        const Style& style) {
  const pipeline::Summary& summary = figures.summary;
  const referee::Verdict& verdict = figures.verdict;
  std::string time = seconds_text(summary.time_s);
  if (summary.dwell_s > 0) time += fmt::format(", {:g} s of it dwell", summary.dwell_s);
  time += fmt::format("; at least {} without a limit of jerk", seconds_text(summary.bound_s));
  std::string text = heading(program, machine.name, machine.period, style);
  text += row("time", time);
  text += row("lost", lost_text(figures.lost, summary.time_s));
  text += row("extents", extents_text(figures.extents));
  text += row("length", fmt::format("{:.3f} mm: {}, {}", summary.length_mm, counted(summary.blocks, "block"),
                                    counted(summary.moves, "move")));
  text += row("words", fmt::format("{}", summary.words));
  text += row("feed", feed_text(summary, verdict.feed_max_ratio));
  if (summary.threads.lines + summary.threads.out_of_step > 0) text += row("threads", threads_text(summary.threads));
  text += row("deviation", deviation_text(verdict.deviation_mm, summary.tolerance_mm));
  text += tip_row(verdict);
  text += axis_table(verdict, &summary.plan, style) + path_limits_text(summary.plan, style);
  text += violations_text(verdict, style);
  text += verdict_text(figures.kept(), style);
  if (figures.steps) text += row("steps", steps_text(*figures.steps));
  if (figures.steps && !figures.steps->corrections.empty())
    text += row("screws", corrections_text(figures.steps->corrections));
  for (const std::string& file : figures.files) text += row("wrote", printable(file));
  return text;
}

std::string check_summary(const std::string& program, const CheckFigures& reading, const Diagnostics& diagnostics,
                          const Style& style) {
  const std::string problems =
      count(diagnostics, base::Severity::error) > 0
          ? style(Tone::error, fmt::format("{}, {}", counted(count(diagnostics, base::Severity::error), "error"),
                                           counted(count(diagnostics, base::Severity::warning), "warning")))
      : count(diagnostics, base::Severity::warning) > 0
          ? style(Tone::warning, counted(count(diagnostics, base::Severity::warning), "warning"))
          : style(Tone::good, "no problem");
  std::string text = fmt::format("{}: {}, {}: {}\n", style(Tone::strong, printable(program)),
                                 counted(reading.blocks, "block"), counted(reading.moves, "move"), problems);
  if (reading.gouging) text += row("gouging", gouging_text(*reading.gouging, style));
  if (!reading.bound_s) return text;
  text += row("time", fmt::format("at least {} by feed and velocities alone", seconds_text(*reading.bound_s)));
  return text + row("extents", extents_text(reading.extents));
}

std::string verify_summary(const std::string& program, const machine::Machine& machine, const VerifyFigures& figures,
                           const Style& style) {
  const referee::Verdict& verdict = figures.verdict;
  std::string text = heading(figures.trace + " against " + program, machine.name, figures.period, style);
  text += row("time", seconds_text(verdict.time_s));
  text += row("feed", feed_text(verdict.feed_programmed_max, verdict.feed_max_ratio));
  text += row("deviation", deviation_text(verdict.deviation_mm, verdict.tolerance_mm));
  text += tip_row(verdict);
  text += row("ends", fmt::format("{:.3g} mm off at the start, {:.3g} mm at the end", verdict.start_error_mm,
                                  verdict.end_error_mm));
  text += axis_table(verdict, nullptr, style);
  text += violations_text(verdict, style);
  text += verdict_text(!verdict.objects(), style);
  for (const std::string& file : figures.files) text += row("wrote", printable(file));
  return text;
}

}  // namespace leadscrew::results
