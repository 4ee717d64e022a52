#include <leadscrew/cli/outputs.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/cli/pulse.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/files/output_file.hpp>
#include <leadscrew/results/pulses.hpp>
#include <memory>

namespace leadscrew::cli {

namespace {

constexpr std::int64_t clocks_between_checks = 1 << 16;

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

base::Result<results::AllPulses> made(const PulseArguments& arguments) {
  auto pulses = measured(arguments);
  if (!pulses) return pulses;
  if (arguments.path || arguments.table) {
    if (auto sound = results::check_clocks(*pulses, arguments.path ? "--path" : "--table"); !sound)
      return base::failure(sound.error());
  }
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
    const auto problem = nc::capacity_problem(method, asked.curve, asked.options);
    if (!problem) continue;
    log.add(*problem);
    return rejected(arguments, log, console);
  }
  const auto pulses = made(asked);
  if (!pulses) {
    log.add(pulses.error());
    return rejected(arguments, log, console);
  }
  if (arguments.json)
    return write_output(console, results::json_text(results::pulse_schema,
                                                    {results::json_of_pulses(asked.curve, *pulses, asked.path)}));
  if (arguments.quiet && !asked.table) return Status::done;
  return write_output(console, results::pulse_text(asked.curve, *pulses, console.output_style(), asked.table));
}

}  // namespace leadscrew::cli
