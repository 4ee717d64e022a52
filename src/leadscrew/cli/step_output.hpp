#pragma once
// A program's steps as a file: those that follow its words, or those of a published interpolator in their place.
//
//   words ──▶ compensation of the machine's screws ──▶ steps ──▶ file

#include <cstdint>
#include <leadscrew/base/word.hpp>
#include <leadscrew/cli/job.hpp>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/files/output_file.hpp>
#include <leadscrew/nc/pulse_options.hpp>
#include <leadscrew/results/figures.hpp>
#include <leadscrew/steps/compensation.hpp>
#include <leadscrew/steps/step_generator.hpp>
#include <leadscrew/waves/step_dump.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace leadscrew::cli {

/// Of the interpolator that the command line names.
nc::PulseOptions pulse_options(const Job& job);

/// What the steps that were asked for cannot be goes to the log. Those that follow words: everything that
/// steps::validate() says. Those of an interpolator: it reads and plans the program, and says what lattice, clock or
/// machine cannot give, and `pulse-compensation` where its screws have errors: they can be made good between words and
/// steps alone, and interpolators of blocks know no words. The reader's own errors must be in the log; blocks without
/// any are planned all the same.
void check_steps(const files::InputFile& file, const Job& job, DiagnosticLog& log);

class StepOutput {
 public:
  /// .vcd or .csv; the job, which check_steps() finds sound, must outlive it. Errors: those of the file.
  static base::Result<std::unique_ptr<StepOutput>> open(const std::string& path, const Job& job);

  /// Words of successive periods, from where the program begins.
  base::Result<void> write(const base::Word& word);
  /// The words have ended: writes what is left, or all steps of the interpolator's.
  base::Result<void> finish(const files::InputFile& program);

  files::OutputFile& file() { return file_; }
  results::StepFigures figures() const;

 private:
  using Writer = std::variant<std::monostate, waves::StepCsvWriter, waves::StepVcdWriter>;

  StepOutput(files::OutputFile file, const Job& job) : file_(std::move(file)), job_(&job) {}
  void put(std::span<const steps::StepEvent> events);
  void follow(const base::Word& word);
  base::Result<void> follow_to_the_end();
  base::Result<void> write_program(const files::InputFile& program);
  template <typename Pulses>
  base::Result<void> write_steps(Pulses& pulses);

  files::OutputFile file_;
  const Job* job_;
  Writer writer_;
  // Where steps follow words:
  std::optional<steps::Compensation> compensation_;
  std::optional<steps::StepGenerator> generator_;
  std::optional<base::Word> last_word_;
  std::int64_t steps_ = 0, last_tick_ = 0;
  base::Result<void> state_;
};

}  // namespace leadscrew::cli
