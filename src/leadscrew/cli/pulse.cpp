#include <leadscrew/cli/outputs.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/cli/pulse.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/files/output_file.hpp>
#include <leadscrew/results/pulses.hpp>
#include <memory>

namespace leadscrew::cli {

namespace {

constexpr std::int64_t most_clocks_shown = 64;  // unasked
constexpr std::int64_t clocks_between_checks = 1 << 16;
constexpr std::int64_t most_places = 10'000'000;  // that --path and --table give: half a gigabyte of text

base::Result<results::AllPulses> measured(const PulseArguments& arguments) {
  results::AllPulses all;
  for (const nc::PulseMethod method : arguments.methods) {
    const nc::PulseRun run(method, arguments.curve, arguments.options);
    nc::PulseMeasurement measurement(run, arguments.curve);
    while (!measurement.done()) {
      measurement.step();
      if (measurement.run().clock() % clocks_between_checks == 0 && files::interrupted())
        return base::failure(files::interruption());
    }
    all.push_back({run, measurement.figures()});
  }
  return all;
}

/// Every clock as text is for curves of some size.
base::Result<void> check_length(const PulseArguments& arguments, const results::AllPulses& pulses) {
  if (!arguments.path && !arguments.table) return {};
  std::int64_t clocks = 0;
  for (const waves::MeasuredPulses& each : pulses) clocks += each.figures.clocks;
  if (clocks <= most_places) return {};
  return base::failure(base::problem("too-many-clocks",
                                     std::to_string(clocks) + " clocks are too many for " +
                                         (arguments.path ? "--path" : "--table") + ", which gives up to " +
                                         std::to_string(most_places),
                                     "--vcd writes any number of them"));
}

/// A file that takes bytes until the user interrupts.
template <class Write>
base::Result<std::unique_ptr<files::OutputFile>> written(const std::optional<std::string>& path, const Write& write) {
  if (!path) return nullptr;
  auto created = files::OutputFile::create(*path, files::OutputFile::Access::sequential);
  if (!created) return base::failure(created.error());
  auto file = std::make_unique<files::OutputFile>(std::move(*created));
  const base::Result<void> result = write([&](std::string_view bytes) -> base::Result<void> {
    if (files::interrupted()) return base::failure(files::interruption());
    return file->write(bytes);
  });
  if (!result) return base::failure(result.error());
  return file;
}

/// The files that were asked for.
base::Result<void> write_files(const PulseArguments& arguments, const results::AllPulses& pulses) {
  if (arguments.vcd && arguments.svg && is_same_output(*arguments.vcd, *arguments.svg))
    return base::failure(base::problem("usage", *arguments.vcd + " and " + *arguments.svg + " name the same file",
                                       "give each output a name of its own"));
  const auto dump =
      written(arguments.vcd, [&](const auto& sink) { return waves::write_pulse_dump(arguments.curve, pulses, sink); });
  if (!dump) return base::failure(dump.error());
  const auto picture = written(
      arguments.svg, [&](const auto& sink) { return waves::write_pulse_picture(arguments.curve, pulses, sink); });
  if (!picture) return base::failure(picture.error());
  return files::publish_together({dump->get(), picture->get()});
}

std::string text_of(const PulseArguments& arguments, const results::AllPulses& pulses, const Style& style) {
  std::string text = results::pulse_summary(arguments.curve, pulses, style);
  const bool is_short = pulses.size() == 1 && pulses.front().figures.clocks <= most_clocks_shown;
  if (!arguments.table && !is_short) return text;
  for (const waves::MeasuredPulses& each : pulses) text += "\n" + results::pulse_table(arguments.curve, each, style);
  return text;
}

base::Result<results::AllPulses> made(const PulseArguments& arguments) {
  auto pulses = measured(arguments);
  if (!pulses) return pulses;
  if (auto sound = check_length(arguments, *pulses); !sound) return base::failure(sound.error());
  if (auto written = write_files(arguments, *pulses); !written) return base::failure(written.error());
  return pulses;
}

Status rejected(const Arguments& arguments, const DiagnosticLog& log, Console& console) {
  if (!arguments.json || log.status() == Status::usage || log.status() == Status::interrupted) return log.status();
  const std::string text =
      results::json_text(results::pulse_schema, {results::json_of_rejected_pulses(arguments.pulse.curve, log.all())});
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
    return write_output(console, results::json_text(results::pulse_schema,
                                                    {results::json_of_pulses(asked.curve, *pulses, asked.path)}));
  if (arguments.quiet && !asked.table) return Status::done;
  return write_output(console, text_of(asked, *pulses, console.output_style()));
}

}  // namespace leadscrew::cli
