#pragma once
// What a run, a simulation or a judgement leaves to be looked at: the report, the picture of the path, the charts.
//
// A run's report is the workbench's page with the recording inside, where that page is at hand (page_report.hpp) and has room
// for the program and its moves; else, and of all others, it is the page that the command makes by itself (report/).

#include <leadscrew/files/output_file.hpp>
#include <leadscrew/gcode/machined_move.hpp>
#include <leadscrew/kinematics/word_poses.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/report/recording.hpp>
#include <leadscrew/report/report.hpp>
#include <leadscrew/results/page_recording.hpp>
#include <leadscrew/results/report_form.hpp>
#include <leadscrew/servo/servo.hpp>
#include <memory>
#include <optional>
#include <string>

namespace leadscrew::results {

/// Where they go; none: not asked for.
struct ReportPaths {
  std::optional<std::string> report, picture, charts;
};

class ReportOutput {
 public:
  enum class Shows { words, slides, trace };

  /// Opens what was asked for. The machine must outlive it. Errors: those of files::OutputFile::create().
  static base::Result<ReportOutput> open(const ReportPaths& paths, const machine::Machine& machine, Shows shows);

  /// What they are made of; null where none was asked for.
  const report::Recording* recording() const { return recording_ ? &*recording_ : nullptr; }
  /// What a report of slides shows beside; null where there is none.
  report::FollowedRecording* followed() { return followed_ ? &*followed_ : nullptr; }

  /// Of the word that is told next: how far it is from the program.
  void judge(const referee::MatchedBlock& matched);
  /// Word after word, with the pose of the tool where there is a chain of rotary axes.
  void observe(const base::Word& word, const std::optional<kinematics::ToolPose>& pose);
  /// Of a word that is told next.
  void observe(const base::PassedEvent& event);
  /// Of the word that is told next, with the feed that was measured, mm/s.
  void observe(const servo::Followed& followed, double measured_feed);
  /// What the next move has to do with a surface.
  void expect(const gcode::MachinedMove& machined);
  /// Of what is expected; `middle` is halfway along it, as pictures show it.
  void observe(const pipeline::BlockTime& block, const base::AxisVector& middle);

  /// Writes what was asked for. Errors: those of reading the program once more, and of writing.
  base::Result<void> write(const ReportParts& parts, const RunFigures& figures);
  base::Result<void> write(const ReportParts& parts, const SimulateFigures& figures);
  base::Result<void> write(const ReportParts& parts, const VerifyFigures& figures);

  /// Null where they were not asked for.
  files::OutputFile* report() { return report_.get(); }
  files::OutputFile* picture() { return picture_.get(); }
  files::OutputFile* charts() { return charts_.get(); }

 private:
  explicit ReportOutput(const machine::Machine& machine) : machine_(&machine) {}
  base::Result<void> write(const base::Result<report::Report>& report);
  base::Result<void> write_pictures(const std::string& title);
  /// True where the page was written.
  base::Result<bool> write_page(const ReportParts& parts, const RunFigures& figures);

  const machine::Machine* machine_;
  std::unique_ptr<files::OutputFile> report_, picture_, charts_;  ///< their sinks refer to them
  std::optional<report::Recording> recording_;
  std::optional<report::FollowedRecording> followed_;
  std::optional<std::string> page_;  ///< of the workbench
  std::optional<PageRecording> page_recording_;
};

}  // namespace leadscrew::results
