#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/results/diagnostic_text.hpp>
#include <leadscrew/results/drive.hpp>
#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/program_text.hpp>
#include <leadscrew/results/simulation.hpp>

namespace leadscrew::results {

namespace {

std::string_view name(drive::Figures::End end) {
  constexpr std::array<std::string_view, 5> names = {"done", "stopped", "abandoned", "tripped", "failed"};
  return names[static_cast<std::size_t>(end)];
}

/// Servo periods, as `run` counts them: the first word stands at their beginning.
std::int64_t periods(std::int64_t words) {
  return std::max<std::int64_t>(0, words - 1);
}

std::string duration_text(std::uint64_t nanoseconds) {
  const auto value = static_cast<double>(nanoseconds);
  if (value < 1e3) return fmt::format("{:.0f} ns", value);
  if (value < 1e6) return fmt::format("{:.3g} us", value / 1e3);
  if (value < 1e9) return fmt::format("{:.3g} ms", value / 1e6);
  return fmt::format("{:.3g} s", value / 1e9);
}

double seconds(const drive::Figures& figures, const machine::Machine& machine) {
  return machine.period.seconds() * static_cast<double>(periods(figures.counters.words));
}

/// "histogram": how many lay within each power of two, from the first to the last that any lay in.
Json json_of(const realtime::Histogram& latencies) {
  Json histogram = Json::list();
  for (const realtime::Histogram::Octave& octave : latencies.octaves())
    histogram.push_back(Json::object({{"below", octave.end}, {"count", octave.count}}));
  return Json::object({{"p50", latencies.percentile(0.5)},
                       {"p99", latencies.percentile(0.99)},
                       {"p999", latencies.percentile(0.999)},
                       {"max", latencies.longest()},
                       {"histogram", histogram}});
}

/// A bar for each power of two, by the logarithm of the count: one late word among millions is seen.
std::string bars(const realtime::Histogram& latencies) {
  constexpr std::array<std::string_view, 9> heights = {"·", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  const auto octaves = latencies.octaves();
  if (octaves.empty()) return "none";
  double most = 1;
  for (const auto& octave : octaves) most = std::max(most, std::log2(1 + static_cast<double>(octave.count)));
  std::string text = fmt::format("{} ", octaves.front().end > 32 ? duration_text(octaves.front().end / 2) : "0");
  for (const auto& octave : octaves) {
    const double share = std::log2(1 + static_cast<double>(octave.count)) / most;
    text += heights[octave.count == 0 ? 0 : 1 + static_cast<std::size_t>(std::lround(share * 7))];
  }
  return text + fmt::format(" {}", duration_text(octaves.back().end));
}

}  // namespace

Json json_of_drive(const std::string& program, const machine::Machine& machine, const drive::Figures& figures,
                   const Diagnostics& diagnostics) {
  const realtime::Counters& counters = figures.counters;
  Json position = Json::object();
  for (const base::Axis axis : base::all_axes) {
    if (machine.has(axis)) position[std::string(1, base::letter(axis))] = figures.last.position[base::index(axis)];
  }
  Json json = Json::object({{"schema", drive_schema},
                            {"program", program},
                            {"machine", machine.name},
                            {"period_s", machine.period.seconds()},
                            {"end", name(figures.end)},
                            {"real_time", figures.real_time},
                            {"words", periods(counters.words)},
                            {"words_taken", periods(figures.taken)},
                            {"time_s", seconds(figures, machine)},
                            {"line", base::number(figures.last.line)},
                            {"path_length_mm", figures.last.path_length},
                            {"position", position},
                            {"overruns", counters.overruns},
                            {"slips", counters.slips},
                            {"late_chunks", counters.late_chunks},
                            {"starvations", counters.starvations},
                            {"latency_ns", json_of(figures.latencies)},
                            {"diagnostics", json_of_diagnostics(diagnostics)}});
  put_file_and_visit(json, figures.last.line);
  if (machine.threads_follow()) add_threads(json, counters.threads);
  if (!figures.has_drives) return json;
  json["axes"] = json_of_axes(figures.axes);
  json["feed"] = Json::object(
      {{"measured_max_mm_s", figures.feed.measured_max}, {"measured_mean_mm_s", figures.feed.measured_mean}});
  json["drives"] = Json::object({{"late_periods", figures.drives_late}, {"braked_periods", figures.braked}});
  return json;
}

std::string drive_summary(const std::string& program, const machine::Machine& machine, const drive::Figures& figures,
                          const Style& style) {
  const realtime::Counters& counters = figures.counters;
  const auto micro = [&](double part) { return static_cast<double>(figures.latencies.percentile(part)) / 1e3; };
  std::string text = fmt::format("{} on {}, period {}: {}\n", style(Tone::strong, printable(program)),
                                 printable(machine.name), period_text(machine.period),
                                 figures.end == drive::Figures::End::done ? style(Tone::good, name(figures.end))
                                                                          : style(Tone::warning, name(figures.end)));
  text += fmt::format("  words      {} made, {} taken{}; {:.3f} s\n", periods(counters.words), periods(figures.taken),
                      figures.has_drives ? " by the drives" : "", seconds(figures, machine));
  text +=
      fmt::format("  came to    {}, {:.3f} mm of the path\n", line_text(figures.last.line), figures.last.path_length);
  text += fmt::format(
      "  on time    {} periods slept through, {} given way; planner late {} times, {} of its chunks too late\n",
      counters.overruns, counters.slips, counters.starvations, counters.late_chunks);
  text += fmt::format(
      "  latency    50 % below {:.0f} us, 99 % below {:.0f} us, 99.9 % below {:.0f} us, at most {:.0f} us\n",
      micro(0.5), micro(0.99), micro(0.999), micro(1));
  text += fmt::format("             {}, each power of two by the logarithm of its count\n", bars(figures.latencies));
  if (!figures.has_drives) return text;
  text += fmt::format("  drives     their process late by {} periods; {} periods braked without words\n",
                      figures.drives_late, figures.braked);
  text += fmt::format("  slides     measured up to {:.6g} mm/min, {:.6g} on average\n", figures.feed.measured_max * 60,
                      figures.feed.measured_mean * 60);
  return text + axis_rows(figures.axes, style);
}

}  // namespace leadscrew::results
