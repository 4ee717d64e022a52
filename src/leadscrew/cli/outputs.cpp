#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <leadscrew/cli/curve_program.hpp>
#include <leadscrew/cli/outputs.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/files/same_output.hpp>

namespace leadscrew::cli {

using files::is_same_output;

namespace {

tl::unexpected<base::Diagnostic> usage_problem(std::string message, std::string hint) {
  return base::failure({base::Severity::error, "usage", std::move(message), std::move(hint), {}, {}});
}

base::Result<std::unique_ptr<files::OutputFile>> create(const std::string& path, files::OutputFile::Access access) {
  auto file = files::OutputFile::create(path, access);
  if (!file) return base::failure(file.error());
  return std::make_unique<files::OutputFile>(std::move(*file));
}

/// NAME of DIR/NAME.csv.
std::string stem_of(const std::string& program) {
  if (program == "-") return "stdin";
  return is_curve(program) ? program.substr(curve_prefix.size()) : std::filesystem::path(program).stem().string();
}

}  // namespace

OutputPaths output_paths(const Arguments& arguments, const std::string& program) {
  OutputPaths paths{arguments.run.trace,  arguments.run.report, arguments.run.picture, arguments.run.charts,
                    arguments.run.pulses, arguments.run.events, arguments.run.blocks,  arguments.run.waves};
  paths.program = shown_name(program);
  if (!arguments.run.out) return paths;
  const std::string base = (std::filesystem::path(*arguments.run.out) / stem_of(program)).string();
  if (!paths.trace) paths.trace = base + ".csv";
  if (!paths.report) paths.report = base + ".html";
  if (!paths.picture) paths.picture = base + ".svg";
  if (!paths.pulses) return paths;
  if (const auto format = step_format(*paths.pulses)) paths.pulses = base + ".steps." + *format;
  return paths;
}

base::Result<void> check_written(const std::vector<std::string>& paths, const files::InputFile& program,
                                 const Arguments& arguments) {
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const std::string& path = paths[i];
    const auto is_read = [&](std::string_view what) {
      return usage_problem(fmt::format("{} is {}", path, what), "choose another name for what is written");
    };
    if (program.is_same(path)) return is_read("the program itself");
    if (arguments.parameters && is_same_output(path, *arguments.parameters)) return is_read("the parameter file");
    if (arguments.machine && is_same_output(path, *arguments.machine)) return is_read("the machine file");
    if (arguments.tools && is_same_output(path, *arguments.tools)) return is_read("the tool table");
    const std::string& trace = arguments.judged_trace;
    if (!trace.empty() && is_same_output(path, trace)) return is_read("the trace itself");
    for (std::size_t k = 0; k < i; ++k) {
      if (!is_same_output(path, paths[k])) continue;
      return usage_problem(fmt::format("{} and {} name the same file", paths[k], path),
                           "give each output a name of its own");
    }
  }
  return {};
}

base::Result<void> check_paths(const OutputPaths& paths, const files::InputFile& program, const Arguments& arguments) {
  std::vector<std::string> written;
  for (const auto& path : paths.all()) {
    if (path) written.push_back(*path);
  }
  return check_written(written, program, arguments);
}

bool is_in_use(const std::string& path, const std::string& program, const OutputPaths& paths,
               const Arguments& arguments) {
  const drive::Options& drive = arguments.drive;
  const auto is_used = [&](const std::optional<std::string>& used) { return used && is_same_output(path, *used); };
  const auto used = {std::optional(program),
                     arguments.machine,
                     arguments.tools,
                     arguments.parameters,
                     drive.trace,
                     drive.axes,
                     drive.events,
                     drive.state,
                     drive.resume,
                     drive.sink};
  return std::ranges::any_of(used, is_used) || std::ranges::any_of(paths.all(), is_used);
}

base::Result<Outputs> Outputs::open(const OutputPaths& paths, const Job& job) {
  using Shows = results::ReportOutput::Shows;
  const bool follows = job.arguments.verb == Arguments::Verb::simulate;
  const Shows shows = follows                                      ? Shows::slides
                      : job.arguments.verb == Arguments::Verb::run ? Shows::words
                                                                   : Shows::trace;
  auto shown = results::ReportOutput::open({paths.report, paths.picture, paths.charts}, job.machine, shows);
  if (!shown) return base::failure(shown.error());
  Outputs outputs(paths, job, std::move(*shown));
  if (paths.trace) {
    const trace::MoreColumns columns{
        .actual = follows, .power = job.machine.laser.has_value(), .pose = job.machine.rotary_chain.has_value()};
    if (auto opened = outputs.trace_.open(*paths.trace, paths.program, job.machine, columns); !opened)
      return base::failure(opened.error());
  }
  if (paths.pulses) {
    auto opened = StepOutput::open(*paths.pulses, job);
    if (!opened) return base::failure(opened.error());
    outputs.steps_ = std::move(*opened);
  }
  if (paths.events) {
    if (auto opened = outputs.events_.open(*paths.events, job.machine.period); !opened)
      return base::failure(opened.error());
  }
  return outputs;
}

base::Result<void> Outputs::write(const servo::Followed& followed, double measured_feed) {
  shown_.observe(followed, measured_feed);
  return write(followed.word, {followed.position, followed.velocity, followed.control, followed.current});
}

base::Result<void> Outputs::write(const base::Word& word, const trace::BesideWord& beside) {
  const auto pose = poses_.of(word);
  shown_.observe(word, pose);
  if (steps_) {
    if (auto written = steps_->write(word); !written) return written;
  }
  trace::BesideWord all = beside;
  if (pose) all.pose = pose->numbers();
  return trace_.write(word, all);
}

void Outputs::write(const base::PassedEvent& event) {
  trace_.observe(event);
  poses_.observe(event);
  shown_.observe(event);
  static_cast<void>(events_.write(event));
}

base::Result<void> Outputs::open_blocks(const files::InputFile& program) {
  if (!blocks_path_) return {};
  auto file = create(*blocks_path_, files::OutputFile::Access::sequential);
  if (!file) return base::failure(file.error());
  blocks_file_ = std::move(*file);
  blocks_ = std::make_unique<results::BlockWriter>(blocks_file_->sink(), program, job_->machine);
  return {};
}

pipeline::LostTime::Sink Outputs::blocks() {
  if (!blocks_ && shown_.recording() == nullptr) return {};
  return [this](const pipeline::BlockTime& block) {
    if (blocks_) blocks_->write(block);
    const auto pose = poses_.of(block.middle);
    shown_.observe(block, pose ? pose->tip : block.middle);
  };
}

results::ReportParts Outputs::report_parts(const files::InputFile& program, const DiagnosticLog& log) const {
  return {program,
          job_->arguments.command_line,
          log.all(),
          *shown_.recording(),
          job_->machine_text(),
          job_->tools_text(),
          {job_->start, job_->arguments.mode, job_->arguments.tolerance, job_->arguments.smoothing,
           job_->arguments.run.interpolator}};
}

std::optional<results::StepFigures> Outputs::step_figures() const {
  if (!steps_) return std::nullopt;
  return steps_->figures();
}

base::Result<std::vector<std::string>> Outputs::publish() {
  if (auto finished = trace_.finish(); !finished) return base::failure(finished.error());
  if (auto finished = events_.finish(); !finished) return base::failure(finished.error());
  if (blocks_) {
    if (auto finished = blocks_->finish(); !finished) return base::failure(finished.error());
  }
  files::OutputFile* const steps = steps_ ? &steps_->file() : nullptr;
  const auto written = {trace_.file(),   trace_.side(), shown_.report(), shown_.picture(),
                        shown_.charts(), steps,         events_.file(),  blocks_file_.get()};
  if (auto published = files::publish_together(written); !published) return base::failure(published.error());
  std::vector<std::string> paths;
  for (const files::OutputFile* file : written) {
    if (file != nullptr) paths.push_back(file->path());
  }
  return paths;
}

}  // namespace leadscrew::cli
