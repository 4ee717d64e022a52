#include <array>
#include <leadscrew/cli/report_form.hpp>
#include <leadscrew/geometry/curve.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <set>

namespace leadscrew::cli {

namespace {

constexpr std::size_t longest_line = 200;

std::set<base::Line> lines_named(const report::Recording& recording) {
  std::set<base::Line> lines;
  for (const report::BlockFigures& block : recording.slowest_blocks()) lines.insert(block.line);
  for (const report::BlockFigures& block : recording.nearest_to_limit()) lines.insert(block.line);
  return lines;
}

using SourceLines = std::vector<std::pair<base::Line, std::string>>;

/// Gathers the beginnings of wanted lines from a text that comes in pieces.
class LineGatherer {
 public:
  explicit LineGatherer(const std::set<base::Line>& wanted) : wanted_(wanted) { begin_line(); }

  void take(char c) {
    if (c == '\n') {
      line_ = base::Line{base::number(line_) + 1};
      begin_line();
    } else if (is_wanted_ && c != '\r' && lines_.back().second.size() < longest_line) {
      lines_.back().second += c;
    }
  }

  bool has_all() const { return wanted_.empty() || line_ > *wanted_.rbegin(); }
  SourceLines lines() && { return std::move(lines_); }

 private:
  void begin_line() {
    is_wanted_ = wanted_.contains(line_);
    if (is_wanted_) lines_.emplace_back(line_, std::string());
  }

  const std::set<base::Line>& wanted_;
  SourceLines lines_;
  base::Line line_{1};
  bool is_wanted_ = false;
};

base::Result<SourceLines> source_lines(const files::InputFile& file, const std::set<base::Line>& wanted) {
  LineGatherer gatherer(wanted);
  auto source = file.source();
  std::array<char, 1 << 16> buffer;
  while (!gatherer.has_all()) {
    const auto got = source(buffer);
    if (!got) return base::failure(got.error());
    if (*got == 0) break;
    for (std::size_t i = 0; i < *got; ++i) gatherer.take(buffer[i]);
  }
  return std::move(gatherer).lines();
}

std::vector<report::AxisRatios> limits_of(const results::RunFigures& figures) {
  std::vector<report::AxisRatios> list;
  for (const referee::AxisVerdict& axis : figures.verdict.axes) {
    const machine::Derivatives plan = figures.summary.plan.of_axis(axis.axis);
    list.push_back({.axis = axis.axis,
                    .velocity = axis.velocity_ratio,
                    .acceleration = axis.acceleration_ratio,
                    .jerk = axis.jerk_ratio,
                    .planned_velocity = plan.velocity,
                    .planned_acceleration = plan.acceleration,
                    .planned_jerk = plan.jerk});
  }
  return list;
}

}  // namespace

base::Result<report::Report> report_of(const files::InputFile& file, const Job& job, const results::RunFigures& figures,
                                       const DiagnosticLog& log, const report::Recording& recording) {
  const pipeline::Summary& summary = figures.summary;
  auto source = source_lines(file, lines_named(recording));
  if (!source) return base::failure(source.error());
  report::Report report;
  report.title = file.name();
  report.version = LEADSCREW_VERSION;
  report.command = job.arguments.command_line;
  report.time_s = summary.time_s;
  report.dwell_s = summary.dwell_s;
  report.bound_s = summary.bound_s;
  report.length_mm = summary.length_mm;
  report.blocks = summary.blocks;
  report.moves = summary.moves;
  report.words = summary.words;
  report.deviation_mm = figures.verdict.deviation_mm;
  report.tolerance_mm = summary.tolerance_mm;
  report.feed_programmed_max = summary.feed_programmed_max;
  report.feed_max_ratio = figures.verdict.feed_max_ratio;
  report.limits = limits_of(figures);
  report.diagnostics = log.all();
  report.source = std::move(*source);
  return report;
}

base::Result<report::Report> report_of(const files::InputFile& file, const Job& job,
                                       const results::SimulateFigures& figures, const DiagnosticLog& log,
                                       const report::Recording& recording) {
  results::RunFigures of_words{figures.summary, figures.verdict, {}};
  of_words.verdict.axes.clear();
  for (const auto& [axis, tracking] : figures.axes) {
    const machine::Derivatives plan = figures.summary.plan.of_axis(axis);
    of_words.verdict.axes.push_back({axis, plan.velocity, plan.acceleration, plan.jerk});
  }
  of_words.verdict.feed_max_ratio = 0;  // an override may double it
  auto report = report_of(file, job, of_words, log, recording);
  if (report) report->tolerance_mm = figures.tolerance;
  return report;
}

void observe_ideal_path(const files::InputFile& file, const Job& job, report::FollowedRecording& followed) {
  constexpr int parts = 64;
  gcode::Reader reader = silent_reader(file, job);
  gcode::Move move;
  followed.observe_ideal(job.start);
  while (reader.next(move)) {
    for (const toolpath::Piece& piece : toolpath::pieces_of(move)) {
      const int count = move.kind == gcode::Move::Kind::line ? 1 : parts;
      for (int i = 1; i <= count; ++i) {
        const double s = piece.axes().length() * i / count;
        followed.observe_ideal(piece.axes().position(numeric::DoubleDouble(s)));
      }
    }
  }
}

}  // namespace leadscrew::cli
