#include <fmt/format.h>

#include <algorithm>
#include <leadscrew/results/pulses.hpp>

namespace leadscrew::results {

namespace {

using nc::PulseConventions;
using nc::PulseCurve;
using nc::PulseRun;

constexpr std::int64_t most_clocks_shown = 64;    // unasked
constexpr std::int64_t most_clocks = 10'000'000;  // as text: half a gigabyte

std::string point_text(pulse::Point at) {
  return fmt::format("({}, {})", at.x, at.y);
}

Json point_list(pulse::Point at) {
  return Json::list({at.x, at.y});
}

/// Names and values of what is in force.
Json json_of(const PulseConventions& conventions) {
  Json options = Json::object();
  if (conventions.bits) options["bits"] = *conventions.bits;
  if (conventions.capacity) options["capacity"] = *conventions.capacity;
  if (conventions.scale) options["scale"] = *conventions.scale;
  if (conventions.preload) options["preload"] = nc::name(*conventions.preload);
  if (conventions.order) options["order"] = nc::name(*conventions.order);
  if (conventions.places) options["places"] = *conventions.places;
  if (conventions.accumulation) options["accumulation"] = nc::name(*conventions.accumulation);
  if (!conventions.tie.empty()) options["tie"] = conventions.tie;
  options["end_rule"] = conventions.end;
  return options;
}

std::string text_of(const PulseConventions& conventions) {
  const Json options = json_of(conventions);
  std::string text;
  for (const auto& [key, value] : *options.members())
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key,
                        value.text() != nullptr ? *value.text() : value.written_in_line());
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

/// The place after each pulse.
Json path_of(PulseRun run) {
  Json path = Json::list();
  while (!run.done()) {
    if (run.step() != pulse::Pulse<2>{}) path.push_back(point_list(run.at()));
  }
  return path;
}

Json json_of(const waves::MeasuredPulses& pulses, bool with_path) {
  const nc::PulseFigures& figures = pulses.figures;
  Json object = Json::object({{"method", nc::name(pulses.run.method())},
                              {"pulses", figures.pulses},
                              {"clocks", figures.clocks},
                              {"max_error_blu", figures.max_error},
                              {"rms_error_blu", figures.rms_error},
                              {"worst", point_list(figures.worst)},
                              {"end", point_list(figures.end)}});
  if (with_path) object["path"] = path_of(pulses.run);
  object["options"] = json_of(pulses.run.conventions());
  return object;
}

Json json_of(const PulseCurve& curve) {
  Json object = Json::object({{"schema", pulse_schema},
                              {"shape", curve.is_ellipse() ? "ellipse"
                                        : curve.is_arc()   ? "arc"
                                                           : "line"},
                              {"start", point_list(curve.start)},
                              {"end", point_list(curve.end)}});
  if (!curve.is_arc()) return object;
  if (curve.is_ellipse()) object["semi_axes"] = Json::list({curve.semi_axes->x, curve.semi_axes->y});
  object["center"] = point_list(curve.center);
  object["direction"] = curve.direction == pulse::Direction::clockwise ? "cw" : "ccw";
  return object;
}

std::size_t digits(std::int64_t value) {
  return std::to_string(value).size();
}

/// The columns behind clock, dx and dy.
std::vector<std::pair<std::string, std::size_t>> columns_of(const PulseCurve& curve, const nc::PulseFigures& figures) {
  std::vector<std::pair<std::string, std::size_t>> columns;
  const auto add = [&](std::string_view name, std::int64_t least, std::int64_t greatest) {
    columns.emplace_back(name, std::max({name.size(), digits(least), digits(greatest)}));
  };
  const pulse::Point origin = curve.origin();
  const auto& registers = figures.registers;
  if (origin != pulse::Point{}) {
    add("X", registers[0].least + origin.x, registers[0].greatest + origin.x);
    add("Y", registers[1].least + origin.y, registers[1].greatest + origin.y);
  }
  for (const nc::RegisterRange& each : registers) add(each.name, each.least, each.greatest);
  return columns;
}

/// A line of figures for each method, and the conventions that were in force.
std::string pulse_summary(const PulseCurve& curve, const AllPulses& pulses, const Style& style) {
  std::string title = waves::title_of(curve);
  if (curve.is_ellipse()) {
    title += fmt::format(", a = {}, b = {} BLU", curve.semi_axes->x, curve.semi_axes->y);
  } else if (curve.is_arc()) {
    title += fmt::format(", R = {:.6g} BLU", curve.radius());
  }
  std::string text = style(Tone::strong, title) + "\n";
  text += style(Tone::faint, fmt::format("  {:<18} {:>9} {:>9} {:>10} {:>10}  {:<14} {}", "method", "pulses", "clocks",
                                         "max error", "rms error", "at", "end")) +
          "\n";
  for (const waves::MeasuredPulses& each : pulses) {
    const nc::PulseFigures& figures = each.figures;
    text += fmt::format("  {:<18} {:>9} {:>9} {:>10.3f} {:>10.3f}  {:<14} {}\n", nc::name(each.run.method()),
                        figures.pulses, figures.clocks, figures.max_error, figures.rms_error, point_text(figures.worst),
                        point_text(figures.end));
    text += style(Tone::faint, "      " + text_of(each.run.conventions())) + "\n";
  }
  return text;
}

/// Every register at every clock.
std::string pulse_table(const PulseCurve& curve, const waves::MeasuredPulses& pulses, const Style& style) {
  const auto columns = columns_of(curve, pulses.figures);
  const std::size_t widest = std::max<std::size_t>(5, digits(pulses.figures.clocks));
  std::string text = style(Tone::strong, nc::name(pulses.run.method())) + "\n";
  std::string heading = fmt::format("  {:>{}}  dx  dy", "clock", widest);
  for (const auto& [name, width] : columns) heading += fmt::format("  {:>{}}", name, width);
  text += style(Tone::faint, heading) + "\n";
  PulseRun run = pulses.run;
  while (true) {
    text += fmt::format("  {:>{}}  {:>2}  {:>2}", run.clock(), widest, run.last().step[0], run.last().step[1]);
    const nc::Registers registers = nc::signals_of(run, curve);
    std::size_t column = columns.size() - registers.all().size();
    if (column > 0)
      text += fmt::format("  {:>{}}  {:>{}}", run.at().x, columns[0].second, run.at().y, columns[1].second);
    for (const nc::Register& each : registers.all())
      text += fmt::format("  {:>{}}", each.value, columns[column++].second);
    text += '\n';
    if (run.done()) return text;
    run.step();
  }
}

}  // namespace

std::string pulse_text(const PulseCurve& curve, const AllPulses& pulses, const Style& style, bool with_tables) {
  std::string text = pulse_summary(curve, pulses, style);
  const bool is_short = pulses.size() == 1 && pulses.front().figures.clocks <= most_clocks_shown;
  if (!with_tables && !is_short) return text;
  for (const waves::MeasuredPulses& each : pulses) text += "\n" + pulse_table(curve, each, style);
  return text;
}

base::Result<void> check_clocks(const AllPulses& pulses, std::string_view option) {
  std::int64_t clocks = 0;
  for (const waves::MeasuredPulses& each : pulses) clocks += each.figures.clocks;
  if (clocks <= most_clocks) return {};
  return base::failure(
      base::problem("too-many-clocks",
                    fmt::format("{} clocks are too many for {}, which gives up to {}", clocks, option, most_clocks),
                    "--vcd writes any number of them"));
}

Json json_of_pulses(const PulseCurve& curve, const AllPulses& pulses, bool with_path) {
  Json object = json_of(curve);
  object["methods"] = Json::list();
  for (const waves::MeasuredPulses& each : pulses) object["methods"].push_back(json_of(each, with_path));
  object["diagnostics"] = Json::list();
  return object;
}

Json json_of_rejected_pulses(const PulseCurve& curve, const Diagnostics& diagnostics) {
  Json object = json_of(curve);
  object["methods"] = Json::list();
  object["diagnostics"] = json_of_diagnostics(diagnostics);
  return object;
}

}  // namespace leadscrew::results
