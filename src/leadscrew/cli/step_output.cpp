#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <leadscrew/cli/step_hints.hpp>
#include <leadscrew/cli/step_output.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/hardware/model_program.hpp>
#include <leadscrew/nc/pulse_program.hpp>
#include <string_view>

namespace leadscrew::cli {

namespace {

constexpr std::size_t steps_between_checks = 4096;
constexpr std::int64_t settling_words_between_checks = 4096;

constexpr std::string_view too_many_problems = "too-many-problems";

bool is_of_pulses(const base::Diagnostic& problem) {
  return problem.subject.field == nc::pulses_field;
}

bool has_too_many(const DiagnosticLog& log) {
  return std::any_of(log.all().begin(), log.all().end(),
                     [](const base::Diagnostic& problem) { return problem.code == too_many_problems; });
}

std::vector<base::Axis> axes_with_errors(const machine::Machine& machine) {
  std::vector<base::Axis> axes;
  for (const base::Axis axis : base::all_axes) {
    if (!machine.screw(axis).none()) axes.push_back(axis);
  }
  return axes;
}

/// Interpolators of blocks make steps without words.
void check_screws(const Job& job, DiagnosticLog& log) {
  std::vector<char> letters;
  for (const base::Axis axis : axes_with_errors(job.machine)) letters.push_back(base::letter(axis));
  if (letters.empty()) return;
  log.add(
      base::problem("pulse-compensation",
                    fmt::format("--pulse-method {} cannot make good the errors of screws that machine {} gives for {}",
                                nc::name(*job.arguments.run.pulse_method), job.machine.name, fmt::join(letters, ", ")),
                    "leave --pulse-method out, for steps that follow the words; or give a machine without pitch "
                    "errors and backlash"));
}

/// As it is asked to move, so that its screws' errors are made good.
base::Result<machine::Machine> compensated_machine(const Job& job) {
  const auto compensation = steps::Compensation::create(job.machine);
  if (!compensation) return base::failure(compensation.error());
  return compensation->stretched(job.machine);
}

void check_signals(const Job& job, DiagnosticLog& log) {
  const auto machine = compensated_machine(job);
  if (!machine) return log.add(machine.error());
  for (const base::Diagnostic& problem : steps::validate(job.arguments.run.step_clock, *machine)) log.add(problem);
}

}  // namespace

nc::PulseOptions pulse_options(const Job& job) {
  const RunArguments& run = job.arguments.run;
  nc::PulseOptions options;
  if (run.pulse_method) options.method = *run.pulse_method;
  options.clock_pps = run.step_clock;
  // Of any two steps, for an axis may turn back between them.
  const steps::LongestReversal slowest = steps::longest_reversal(job.machine, run.step_clock);
  options.step_clocks = slowest.ticks;
  options.slowest_steps = slowest.axis;
  options.interpolation.places = 16;
  if (run.accelerate) options.shape = nc::Shape::accelerate;
  return options;
}

void check_steps(const files::InputFile& file, const Job& job, DiagnosticLog& log) {
  if (!job.arguments.run.pulses) return;
  if (!job.arguments.run.pulse_method) return check_signals(job, log);
  const bool in_hardware = job.arguments.run.hardware_model;
  if (const auto missing = in_hardware ? hardware::missing_model() : std::nullopt) return log.add(*missing);
  check_screws(job, log);
  if (has_too_many(log)) return;
  // What else the reader has to say has been said.
  nc::check_pulses(
      file.source(), job.machine, job.tools, job.reader_options(file), pulse_options(job),
      [&](const base::Diagnostic& problem) {
        if (is_of_pulses(problem) || problem.code == too_many_problems) log.add(in_options(problem, job));
      },
      [] { return !files::interrupted(); }, in_hardware ? hardware::model_check(job.machine) : nc::BlockCheck{});
  if (files::interrupted()) log.add(files::interruption());
}

base::Result<std::unique_ptr<StepOutput>> StepOutput::open(const std::string& path, const Job& job) {
  const std::int64_t clock_hz = job.arguments.run.step_clock;
  std::optional<steps::Compensation> compensation;
  std::optional<steps::StepGenerator> generator;
  if (!job.arguments.run.pulse_method) {
    auto compensating = steps::Compensation::create(job.machine);
    if (!compensating) return base::failure(compensating.error());
    auto generating = steps::StepGenerator::create(compensating->stretched(job.machine), clock_hz);
    if (!generating) return base::failure(generating.error());
    compensation.emplace(std::move(*compensating));
    generator.emplace(std::move(*generating));
  }
  auto file = files::OutputFile::create(path, files::OutputFile::Access::sequential);
  if (!file) return base::failure(file.error());
  std::unique_ptr<StepOutput> output(new StepOutput(std::move(*file), job));
  output->compensation_ = std::move(compensation);
  output->generator_ = std::move(generator);
  if (files::extension(path) == ".csv") {
    output->writer_.emplace<waves::StepCsvWriter>(output->file_.sink(), clock_hz);
  } else {
    output->writer_.emplace<waves::StepVcdWriter>(output->file_.sink(), job.machine, clock_hz);
  }
  return output;
}

void StepOutput::put(std::span<const steps::StepEvent> events) {
  steps_ += static_cast<std::int64_t>(events.size());
  last_tick_ = events.back().tick();
  if (!state_) return;
  if (auto* csv = std::get_if<waves::StepCsvWriter>(&writer_)) state_ = csv->write(events);
  if (auto* vcd = std::get_if<waves::StepVcdWriter>(&writer_)) state_ = vcd->write(events);
}

base::Result<void> StepOutput::write(const base::Word& word) {
  if (generator_) follow(word);
  return state_;
}

void StepOutput::follow(const base::Word& word) {
  last_word_ = word;
  generator_->follow(compensation_->apply(word), [this](auto events) { put(events); });
}

/// An axis that has turned shortly before the end still goes over to the command of its direction.
base::Result<void> StepOutput::follow_to_the_end() {
  for (std::int64_t count = 1; state_ && last_word_ && !compensation_->settled(); ++count) {
    follow(*last_word_);
    if (count % settling_words_between_checks == 0 && files::interrupted()) return base::failure(files::interruption());
  }
  generator_->finish([this](auto events) { put(events); });
  if (const auto complaint = generator_->complaint()) return base::failure(*complaint);
  return {};
}

base::Result<void> StepOutput::finish(const files::InputFile& program) {
  if (generator_) {
    if (auto followed = follow_to_the_end(); !followed) return followed;
  } else if (auto written = write_program(program); !written) {
    return written;
  }
  if (!state_) return state_;
  if (auto* csv = std::get_if<waves::StepCsvWriter>(&writer_)) return csv->finish();
  return std::get<waves::StepVcdWriter>(writer_).finish();
}

base::Result<void> StepOutput::write_program(const files::InputFile& program) {
  std::optional<base::Diagnostic> problem;
  const auto write = [&]<typename Pulses>(std::type_identity<Pulses>, const auto&... more) {
    Pulses pulses(
        program.source(), job_->machine, job_->tools, job_->reader_options(program), pulse_options(*job_),
        [&](const base::Diagnostic& found) {
          if (is_of_pulses(found) && !problem) problem = found;
        },
        more...);
    return write_steps(pulses);
  };
  const RunArguments& run = job_->arguments.run;
  auto written = run.hardware_model ? write(std::type_identity<hardware::ModelProgram>(), run.waves)
                                    : write(std::type_identity<nc::PulseProgram>());
  if (written && problem) return base::failure(*problem);
  return written;
}

template <typename Pulses>
base::Result<void> StepOutput::write_steps(Pulses& pulses) {
  std::array<steps::StepEvent, steps_between_checks> buffer;
  for (auto steps = pulses.next(buffer); state_ && !steps.empty(); steps = pulses.next(buffer)) {
    put(steps);
    if (files::interrupted()) return base::failure(files::interruption());
  }
  if (pulses.source_failure()) return base::failure(*pulses.source_failure());
  return state_;
}

results::StepFigures StepOutput::figures() const {
  const Arguments& arguments = job_->arguments;
  results::StepFigures figures;
  figures.method = arguments.run.pulse_method ? std::string(nc::name(*arguments.run.pulse_method)) : "words";
  if (arguments.run.pulse_method) figures.conventions = nc::conventions_in_programs(*arguments.run.pulse_method);
  figures.clock_hz = arguments.run.step_clock;
  figures.steps = steps_;
  figures.time_s = static_cast<double>(last_tick_) / static_cast<double>(arguments.run.step_clock);
  figures.accelerates = arguments.run.accelerate;
  if (!generator_) return figures;
  figures.error_blu = generator_->report().greatest_error;
  const base::AxisVector greatest = compensation_->greatest_corrections();
  for (const base::Axis axis : axes_with_errors(job_->machine)) {
    figures.corrections.push_back({axis, greatest[base::index(axis)]});
  }
  return figures;
}

}  // namespace leadscrew::cli
