#include <leadscrew/cli/outputs.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/cli/pulse.hpp>
#include <leadscrew/cli/pulse_text.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/files/output_file.hpp>
#include <memory>
#include <nlohmann/json.hpp>

namespace leadscrew::cli {

namespace {

constexpr std::int64_t most_clocks_shown = 64;  // unasked
constexpr std::int64_t clocks_between_looks = 1 << 16;
constexpr std::int64_t most_places = 10'000'000;  // that --path and --table give: half a gigabyte of text

base::Diagnostic problem(std::string_view code, std::string message, std::string hint) {
  return {base::Severity::error, code, std::move(message), std::move(hint), {}, {}};
}

base::Result<AllPulses> measured(const PulseArguments& arguments) {
  AllPulses all;
  for (const nc::PulseMethod method : arguments.methods) {
    const nc::PulseRun run(method, arguments.curve, arguments.options);
    nc::PulseMeasurement measurement(run, arguments.curve);
    while (!measurement.done()) {
      measurement.step();
      if (measurement.run().clock() % clocks_between_looks == 0 && files::interrupted())
        return base::failure(files::interruption());
    }
    all.push_back({run, measurement.figures()});
  }
  return all;
}

/// Every clock as text is for curves of some size.
base::Result<void> check_length(const PulseArguments& arguments, const AllPulses& pulses) {
  if (!arguments.path && !arguments.table) return {};
  std::int64_t clocks = 0;
  for (const waves::MeasuredPulses& each : pulses) clocks += each.figures.clocks;
  if (clocks <= most_places) return {};
  return base::failure(problem("too-many-clocks",
                               std::to_string(clocks) + " clocks are too many for " +
                                   (arguments.path ? "--path" : "--table") + ", which gives up to " +
                                   std::to_string(most_places),
                               "--vcd writes any number of them"));
}

/// The files that were asked for. They appear together, or not at all.
class PulseFiles {
 public:
  base::Result<void> write(const PulseArguments& arguments, const AllPulses& pulses) {
    if (arguments.vcd && arguments.svg && is_same_output(*arguments.vcd, *arguments.svg))
      return base::failure(problem("usage", *arguments.vcd + " and " + *arguments.svg + " name the same file",
                                   "give each output a name of its own"));
    return write_one(arguments.vcd,
                     [&](const auto& sink) { return waves::write_pulse_dump(arguments.curve, pulses, sink); })
        .and_then([&] {
          return write_one(arguments.svg,
                           [&](const auto& sink) { return waves::write_pulse_picture(arguments.curve, pulses, sink); });
        })
        .and_then([&] { return publish(); });
  }

 private:
  template <class Write>
  base::Result<void> write_one(const std::optional<std::string>& path, const Write& write) {
    if (!path) return {};
    auto file = files::OutputFile::create(*path, files::OutputFile::Access::sequential);
    if (!file) return base::failure(file.error());
    files_.push_back(std::make_unique<files::OutputFile>(std::move(*file)));
    return write([sink = files_.back()->sink()](std::string_view bytes) -> base::Result<void> {
      if (files::interrupted()) return base::failure(files::interruption());
      return sink(bytes);
    });
  }

  base::Result<void> publish() {
    for (const auto& file : files_) {
      if (auto closed = file->close(); !closed) return closed;
    }
    for (const auto& file : files_) {
      if (auto published = file->publish(); !published) return published;
    }
    return {};
  }

  std::vector<std::unique_ptr<files::OutputFile>> files_;
};

std::string text_of(const PulseArguments& arguments, const AllPulses& pulses, const Style& style) {
  std::string text = pulse_summary(arguments.curve, pulses, style);
  const bool is_short = pulses.size() == 1 && pulses.front().figures.clocks <= most_clocks_shown;
  if (!arguments.table && !is_short) return text;
  for (const waves::MeasuredPulses& each : pulses) text += "\n" + pulse_table(arguments.curve, each, style);
  return text;
}

base::Result<AllPulses> made(const PulseArguments& arguments) {
  auto pulses = measured(arguments);
  if (!pulses) return pulses;
  if (auto sound = check_length(arguments, *pulses); !sound) return base::failure(sound.error());
  if (auto written = PulseFiles().write(arguments, *pulses); !written) return base::failure(written.error());
  return pulses;
}

Status rejected(const Arguments& arguments, const DiagnosticLog& log, Console& console) {
  if (!arguments.json || log.status() == Status::usage || log.status() == Status::interrupted) return log.status();
  const std::string text = json_text(pulse_schema, {json_of_rejected_pulses(arguments.pulse.curve, log)});
  return worse(log.status(), write_output(console, text));
}

}  // namespace

Status pulse(const Arguments& arguments, Console& console) {
  const PulseArguments& asked = arguments.pulse;
  DiagnosticLog log(console);
  for (const base::Diagnostic& each : asked.overflows) log.add(each);
  if (log.errors() > 0) return rejected(arguments, log, console);
  for (const base::Diagnostic& each : nc::problems_of(asked.curve, asked.options.bits)) log.add(each);
  if (log.errors() > 0) return rejected(arguments, log, console);
  for (const nc::PulseMethod method : asked.methods) {
    if (const auto problem = nc::capacity_problem(method, asked.curve, asked.options)) log.add(*problem);
  }
  if (log.errors() > 0) return rejected(arguments, log, console);
  const auto pulses = made(asked);
  if (!pulses) {
    log.add(pulses.error());
    return rejected(arguments, log, console);
  }
  if (arguments.json)
    return write_output(console, json_text(pulse_schema, {json_of_pulses(asked.curve, *pulses, asked.path)}));
  if (arguments.quiet && !asked.table) return Status::done;
  return write_output(console, text_of(asked, *pulses, console.output_style()));
}

}  // namespace leadscrew::cli
