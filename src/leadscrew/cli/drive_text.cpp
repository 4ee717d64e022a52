#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <leadscrew/cli/diagnostic_text.hpp>
#include <leadscrew/cli/drive_text.hpp>
#include <leadscrew/cli/simulate_form.hpp>
#include <nlohmann/json.hpp>

namespace leadscrew::cli {

namespace {

std::string_view name(DriveFigures::End end) {
  constexpr std::array<std::string_view, 4> names = {"done", "stopped", "abandoned", "tripped"};
  return names[static_cast<std::size_t>(end)];
}

/// Servo periods, as `run` counts them: the first word stands at their beginning.
std::int64_t periods(std::int64_t words) {
  return std::max<std::int64_t>(0, words - 1);
}

double seconds(const DriveFigures& figures, const Job& job) {
  return job.machine.period.seconds() * static_cast<double>(periods(figures.counters.words));
}

}  // namespace

Json json_of_drive(const std::string& program, const Job& job, const DriveFigures& figures, const DiagnosticLog& log) {
  const realtime::Counters& counters = figures.counters;
  Json position = Json::object();
  for (const base::Axis axis : base::all_axes) {
    if (job.machine.has(axis)) position[std::string(1, base::letter(axis))] = figures.last.position[base::index(axis)];
  }
  return {
      {"schema", drive_schema},
      {"program", program},
      {"machine", job.machine.name},
      {"period_s", job.machine.period.seconds()},
      {"end", name(figures.end)},
      {"real_time", figures.real_time},
      {"words", periods(counters.words)},
      {"words_taken", periods(figures.taken)},
      {"time_s", seconds(figures, job)},
      {"line", base::number(figures.last.line)},
      {"path_length_mm", figures.last.path_length},
      {"position", position},
      {"axes", json_of_axes(figures.axes)},
      {"feed", {{"measured_max_mm_s", figures.feed.measured_max}, {"measured_mean_mm_s", figures.feed.measured_mean}}},
      {"overruns", counters.overruns},
      {"slips", counters.slips},
      {"late_chunks", counters.late_chunks},
      {"starvations", counters.starvations},
      {"drives", {{"late_periods", figures.drives_late}, {"braked_periods", figures.braked}}},
      {"latency_ns",
       {{"p50", figures.latencies.percentile(0.5)},
        {"p99", figures.latencies.percentile(0.99)},
        {"p999", figures.latencies.percentile(0.999)},
        {"max", figures.latencies.longest()}}},
      {"diagnostics", json_of_diagnostics(log)}};
}

std::string drive_summary(const std::string& program, const Job& job, const DriveFigures& figures, const Style& style) {
  const realtime::Counters& counters = figures.counters;
  const auto micro = [&](double part) { return static_cast<double>(figures.latencies.percentile(part)) / 1e3; };
  std::string text = fmt::format("{} on {}, period {}: {}\n", style(Tone::strong, printable(program)),
                                 printable(job.machine.name), period_text(job.machine.period),
                                 figures.end == DriveFigures::End::done ? style(Tone::good, name(figures.end))
                                                                        : style(Tone::warning, name(figures.end)));
  text += fmt::format("  words      {} made, {} taken by the drives; {:.3f} s\n", periods(counters.words),
                      periods(figures.taken), seconds(figures, job));
  text += fmt::format("  came to    line {}, {:.3f} mm of the path\n", base::number(figures.last.line),
                      figures.last.path_length);
  text += fmt::format(
      "  on time    {} periods slept through, {} given way; planner late {} times, {} of its chunks too late\n",
      counters.overruns, counters.slips, counters.starvations, counters.late_chunks);
  text += fmt::format(
      "  latency    50 % below {:.0f} us, 99 % below {:.0f} us, 99.9 % below {:.0f} us, at most {:.0f} us\n",
      micro(0.5), micro(0.99), micro(0.999), micro(1));
  text += fmt::format("  drives     their process late by {} periods; {} periods braked without words\n",
                      figures.drives_late, figures.braked);
  text += fmt::format("  slides     measured up to {:.6g} mm/min, {:.6g} on average\n", figures.feed.measured_max * 60,
                      figures.feed.measured_mean * 60);
  return text + axis_rows(figures.axes, style);
}

}  // namespace leadscrew::cli
