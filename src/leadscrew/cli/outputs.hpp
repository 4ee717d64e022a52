#pragma once
// The files of one run: a trace, steps, events, a report, a picture. They appear together when all is done, or not at all.

#include <array>
#include <leadscrew/base/word.hpp>
#include <leadscrew/cli/job.hpp>
#include <leadscrew/cli/step_output.hpp>
#include <leadscrew/console/diagnostic_log.hpp>
#include <leadscrew/files/event_file.hpp>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/files/word_file.hpp>
#include <leadscrew/kinematics/word_poses.hpp>
#include <leadscrew/pipeline/lost_time.hpp>
#include <leadscrew/results/block_writer.hpp>
#include <leadscrew/results/report_output.hpp>
#include <leadscrew/servo/servo.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::cli {

/// Which files a run was asked to write.
struct OutputPaths {
  std::optional<std::string> trace, report, picture, charts, pulses, events, blocks, waves;
  std::string program = {};  ///< its name, as results have it

  std::array<std::optional<std::string>, 9> all() const {
    return {trace, files::side_of(trace), report, picture, charts, pulses, events, blocks, waves};
  }
};

/// --trace, --pulses, --report and --picture, or DIR/NAME.csv, .html and .svg where --out stands for them, and
/// NAME.steps.vcd or .csv where --pulses names a format. `program`: path, "-" is standard input, or a curve.
OutputPaths output_paths(const Arguments& arguments, const std::string& program);

/// What is wrong with files that are to be written, before anything is done: one is read by the command too, or two are
/// the same.
base::Result<void> check_written(const std::vector<std::string>& paths, const files::InputFile& program,
                                 const Arguments& arguments);
/// The same of these paths.
base::Result<void> check_paths(const OutputPaths& paths, const files::InputFile& program, const Arguments& arguments);

/// Whether a path is that of a file which the command reads or writes, so that nothing else may replace it.
bool is_in_use(const std::string& path, const std::string& program, const OutputPaths& paths,
               const Arguments& arguments);

class Outputs {
 public:
  /// Opens what was asked for, in folders that are made where they are missing. The job must outlive the outputs.
  static base::Result<Outputs> open(const OutputPaths& paths, const Job& job);

  base::Result<void> write(const base::Word& word, const trace::BesideWord& beside = {});
  /// What slides made of it, with the feed that was measured, mm/s.
  base::Result<void> write(const servo::Followed& followed, double measured_feed);

  /// Of words from the next on: the offset of their tool, mm, where no events tell it.
  void hold(const std::array<double, 3>& tool) { poses_.hold(tool); }
  /// Of the word that is written next. Errors are told by publish().
  void write(const base::PassedEvent& event);

  /// Makes the file of --blocks, with the texts of this program, where it was asked for; before the first word.
  base::Result<void> open_blocks(const files::InputFile& program);
  /// Writes a row of it, and tells the recording; empty where neither was asked for. Of these outputs, where they are.
  pipeline::LostTime::Sink blocks();

  /// The report, the picture and the charts, whichever were asked for.
  results::ReportOutput& shown() { return shown_; }
  /// Writes the steps that are left.
  base::Result<void> finish_steps(const files::InputFile& program) {
    return steps_ ? steps_->finish(program) : base::Result<void>();
  }
  /// What steps were written, if they were asked for.
  std::optional<results::StepFigures> step_figures() const;
  /// When all words are made: writes the pages that tell the figures, and puts the names of all files into these.
  template <class Figures>
  base::Result<void> conclude(const files::InputFile& program, const DiagnosticLog& log, Figures& figures) {
    if (auto same = program.unchanged(); !same) return same;
    if (shown_.recording() != nullptr) {
      if (auto written = shown_.write(report_parts(program, log), figures); !written) return written;
    }
    if (files::interrupted()) return base::failure(files::interruption());
    auto files = publish();
    if (!files) return base::failure(files.error());
    figures.files = std::move(*files);
    return {};
  }

 private:
  results::ReportParts report_parts(const files::InputFile& program, const DiagnosticLog& log) const;
  /// Ends the trace and gives all files their names; returns these.
  base::Result<std::vector<std::string>> publish();

  Outputs(const OutputPaths& paths, const Job& job, results::ReportOutput shown)
      : job_(&job), poses_(job.machine), shown_(std::move(shown)), blocks_path_(paths.blocks) {}

  const Job* job_;
  kinematics::WordPoses poses_;
  files::WordFile trace_;
  files::EventFile events_;
  results::ReportOutput shown_;
  std::optional<std::string> blocks_path_;
  std::unique_ptr<files::OutputFile> blocks_file_;
  std::unique_ptr<results::BlockWriter> blocks_;
  std::unique_ptr<StepOutput> steps_;
};

}  // namespace leadscrew::cli
