#include <leadscrew/results/gouging.hpp>
#include <leadscrew/results/page_report.hpp>
#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/report_output.hpp>
#include <utility>

namespace leadscrew::results {

namespace {

/// The program's own text; none where it is more than the page has room for.
base::Result<std::optional<std::string>> text_of(const files::InputFile& program) {
  if (program.size() > most_page_text) return std::nullopt;
  auto text = files::all_of(program.source(), program.size(), program.name());
  if (!text) return base::failure(text.error());
  return std::optional(std::move(*text));
}

}  // namespace

base::Result<ReportOutput> ReportOutput::open(const ReportPaths& paths, const machine::Machine& machine, Shows shows) {
  ReportOutput output(machine);
  for (const auto& [path, file] : {std::pair(&paths.report, &output.report_),
                                   {&paths.picture, &output.picture_},
                                   {&paths.charts, &output.charts_}}) {
    if (!*path) continue;
    auto created = files::OutputFile::create(**path, files::OutputFile::Access::sequential);
    if (!created) return base::failure(created.error());
    *file = std::make_unique<files::OutputFile>(std::move(*created));
    if (!output.recording_) output.recording_.emplace(machine, machine.period);
  }
  if (!output.report_) return output;
  if (shows == Shows::slides) output.followed_.emplace(machine.axis_set());
  if (shows == Shows::words) output.page_ = workbench_page();
  if (output.page_) output.page_recording_.emplace(machine);
  return output;
}

void ReportOutput::observe(const base::Word& word, const std::optional<kinematics::ToolPose>& pose) {
  if (recording_) recording_->observe(word, pose ? &pose->tip : nullptr);
  if (page_recording_) page_recording_->observe(word, pose);
}

void ReportOutput::judge(const referee::MatchedBlock& matched) {
  if (page_recording_) page_recording_->judge(matched);
}

void ReportOutput::observe(const base::PassedEvent& event) {
  if (recording_) recording_->observe(event);
  if (page_recording_) page_recording_->observe(event);
}

void ReportOutput::observe(const servo::Followed& followed, double measured_feed) {
  if (followed_) followed_->observe(followed_axes(followed), measured_feed);
}

void ReportOutput::expect(const gcode::MachinedMove& machined) {
  if (page_recording_) page_recording_->expect(machined);
}

void ReportOutput::observe(const pipeline::BlockTime& block, const base::AxisVector& middle) {
  if (!recording_) return;
  report::LostBlock lost = lost_block(block);
  lost.middle = middle;
  recording_->observe(lost);
  if (page_recording_) page_recording_->observe(block);
}

base::Result<void> ReportOutput::write(const ReportParts& parts, const RunFigures& figures) {
  if (!recording_) return {};
  const auto has_page = write_page(parts, figures);
  if (!has_page) return base::failure(has_page.error());
  return *has_page ? write_pictures(parts.program.name()) : write(report_of(parts, figures));
}

base::Result<void> ReportOutput::write(const ReportParts& parts, const SimulateFigures& figures) {
  return recording_ ? write(report_of(parts, figures)) : base::Result<void>();
}

base::Result<void> ReportOutput::write(const ReportParts& parts, const VerifyFigures& figures) {
  return recording_ ? write(report_of(parts, figures)) : base::Result<void>();
}

base::Result<void> ReportOutput::write(const base::Result<report::Report>& report) {
  if (!report) return base::failure(report.error());
  if (report_) {
    auto written = report::write_report(*report, *recording_, *machine_, machine_->period, report_->sink(), followed());
    if (!written) return written;
  }
  return write_pictures(report->title);
}

base::Result<void> ReportOutput::write_pictures(const std::string& title) {
  if (picture_) {
    if (auto written = report::write_path_svg(title, *recording_, picture_->sink()); !written) return written;
  }
  return charts_ ? report::write_motion_charts(title, *recording_, *machine_, charts_->sink()) : base::Result<void>();
}

base::Result<bool> ReportOutput::write_page(const ReportParts& parts, const RunFigures& figures) {
  const auto is_small = [](const std::string& text) { return std::ssize(text) <= most_page_text; };
  if (!page_recording_ || !page_recording_->is_whole() || !is_small(parts.machine_file) || !is_small(parts.tools))
    return false;
  const auto text = text_of(parts.program);
  if (!text) return base::failure(text.error());
  if (!*text) return false;
  PageParts page{.program = parts.program.name(),
                 .text = **text,
                 .machine = parts.machine_file,
                 .tools = parts.tools,
                 .asked = parts.asked,
                 .command = parts.command_line,
                 .events = json_of_events(recording_->events(), machine_->period),
                 .event_count = recording_->event_count(),
                 .result = json_of_run(parts.program.name(), *machine_, figures, parts.diagnostics)};
  if (figures.gouging) page.gouging = json_of_gouging(*figures.gouging);
  const auto filled = with_recording(std::move(*page_), json_of_recording(page, *page_recording_));
  if (!filled) return false;
  if (auto written = report_->write(*filled); !written) return base::failure(written.error());
  return true;
}

}  // namespace leadscrew::results
