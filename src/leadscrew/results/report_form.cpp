#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/geometry/curve.hpp>
#include <leadscrew/kinematics/word_poses.hpp>
#include <leadscrew/results/gouging.hpp>
#include <leadscrew/results/report_form.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <set>

namespace leadscrew::results {

namespace {

constexpr std::size_t longest_line = 200;

std::set<base::Line> lines_named(const report::Recording& recording, const report::Report& report) {
  std::set<base::Line> lines;
  const auto insert = [&lines](base::Line line) { lines.insert(base::place_of(line)); };
  for (const report::LostBlock& block : recording.dearest_blocks()) insert(block.line);
  for (const report::Violation& violation : report.violations) insert(violation.line);
  if (report.gouging) {
    for (std::size_t k = 0; k < std::min(report.gouging->blocks.size(), report::most_gouges); ++k)
      insert(report.gouging->blocks[k].line);
  }
  for (const report::BlockFigures& block : recording.slowest_blocks()) insert(block.line);
  for (const report::BlockFigures& block : recording.nearest_to_limit()) insert(block.line);
  return lines;
}

using SourceLines = std::vector<std::pair<base::Line, std::string>>;

/// Gathers the beginnings of wanted lines of a text, all of which are its own, while it comes in pieces.
class LineGatherer {
 public:
  LineGatherer(const std::set<base::Line>& wanted, int file) : wanted_(wanted), line_(base::line_at(1, file)) {
    begin_line();
  }

  void take(char c) {
    if (c == '\n') {
      line_ = base::line_at(base::number(line_) + 1, base::file(line_));
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
  base::Line line_;
  bool is_wanted_ = false;
};

base::Result<SourceLines> source_lines(const files::InputFile& text, int file, const std::set<base::Line>& wanted) {
  LineGatherer gatherer(wanted, file);
  auto source = text.source();
  std::array<char, 1 << 16> buffer;
  while (!gatherer.has_all()) {
    const auto got = source(buffer);
    if (!got) return base::failure(got.error());
    if (*got == 0) break;
    for (std::size_t i = 0; i < *got; ++i) gatherer.take(buffer[i]);
  }
  return std::move(gatherer).lines();
}

/// The program's texts, and of each of them the lines that are named.
base::Result<void> take_texts(const files::InputFile& program, const std::set<base::Line>& named,
                              report::Report& report) {
  for (int file = 0; const files::InputFile* const text = program.text_of(file); ++file) {
    report.texts.push_back(text->name());
    const std::set<base::Line> wanted(named.lower_bound(base::line_at(0, file)),
                                      named.lower_bound(base::line_at(0, file + 1)));
    if (wanted.empty()) continue;
    auto lines = source_lines(*text, file, wanted);
    if (!lines) return base::failure(lines.error());
    report.source.insert(report.source.end(), lines->begin(), lines->end());
  }
  return {};
}

/// plan: null where there is none.
std::vector<report::AxisRatios> limits_of(const referee::Verdict& verdict, const constraints::LimitRatios* plan) {
  std::vector<report::AxisRatios> list;
  for (const referee::AxisVerdict& axis : verdict.axes) {
    const machine::Derivatives planned = plan != nullptr ? plan->of_axis(axis.axis) : machine::Derivatives();
    list.push_back({.axis = axis.axis,
                    .velocity = axis.velocity_ratio,
                    .acceleration = axis.acceleration_ratio,
                    .jerk = axis.jerk_ratio,
                    .planned_velocity = planned.velocity,
                    .planned_acceleration = planned.acceleration,
                    .planned_jerk = planned.jerk});
  }
  return list;
}

/// Those of one kind in one block together, in the order of their first.
std::vector<report::Violation> by_block(const std::vector<referee::Violation>& violations) {
  std::vector<report::Violation> blocks;
  for (const referee::Violation& violation : violations) {
    auto block = std::ranges::find_if(blocks, [&](const report::Violation& other) {
      return other.line == violation.line && other.what == violation.what;
    });
    if (block == blocks.end()) {
      if (blocks.size() == report::most_violations) continue;
      block = blocks.insert(blocks.end(), {.line = violation.line, .what = violation.what, .first = violation.t});
    }
    ++block->count;
    block->last = violation.t;
    if (block->count > 1 && std::fabs(violation.value) <= std::fabs(block->value)) continue;
    block->value = violation.value;
    block->limit = violation.limit;
  }
  return blocks;
}

/// gouging: null where it was not looked for.
base::Result<report::Report> report_of(const ReportParts& parts, const referee::Verdict& verdict,
                                       const gouging::GougeVerdict* gouging = nullptr) {
  report::Report report;
  report.title = parts.program.name();
  report.version = LEADSCREW_VERSION;
  report.command = parts.command_line;
  report.time_s = verdict.time_s;
  report.deviation_mm = verdict.deviation_mm;
  report.tolerance_mm = verdict.tolerance_mm;
  if (verdict.tip_deviation_mm) {
    report.tip = report::TipDeviation{*verdict.tip_deviation_mm, *verdict.orientation_deviation_deg,
                                      verdict.orientation_tolerance_deg};
  }
  report.feed_programmed_max = verdict.feed_programmed_max;
  report.feed_max_ratio = verdict.feed_max_ratio;
  report.words = parts.recording.words();
  report.diagnostics = parts.diagnostics;
  report.violation_count = verdict.violation_count;
  report.violations = by_block(verdict.violations);
  if (gouging != nullptr) report.gouging = reported_gouging(*gouging, parts.recording.shows_tip());
  const auto taken = take_texts(parts.program, lines_named(parts.recording, report), report);
  if (!taken) return base::failure(taken.error());
  return report;
}

}  // namespace

base::Result<report::Report> report_of(const ReportParts& parts, const RunFigures& figures) {
  const pipeline::Summary& summary = figures.summary;
  auto report = report_of(parts, figures.verdict, figures.gouging ? &*figures.gouging : nullptr);
  if (!report) return report;
  report->time_s = summary.time_s;
  report->dwell_s = summary.dwell_s;
  report->length_mm = summary.length_mm;
  report->moves = summary.moves;
  report->words = summary.words;
  report->tolerance_mm = summary.tolerance_mm;
  report->feed_programmed_max = summary.feed_programmed_max;
  report->plan = report::Plan{summary.bound_s, summary.blocks};
  report->limits = limits_of(figures.verdict, &summary.plan);
  for (const auto& [cause, seconds] : pipeline::ranked(figures.lost))
    report->losses.push_back({pipeline::name(cause), seconds});
  return report;
}

base::Result<report::Report> report_of(const ReportParts& parts, const SimulateFigures& figures) {
  RunFigures of_words{figures.summary, figures.verdict, {}};
  of_words.verdict.axes.clear();
  for (const auto& [axis, tracking] : figures.axes) {
    const machine::Derivatives plan = figures.summary.plan.of_axis(axis);
    of_words.verdict.axes.push_back({axis, plan.velocity, plan.acceleration, plan.jerk});
  }
  // Words are within limits; slides are judged by their deviation alone, and an override may double the feed.
  of_words.verdict.feed_max_ratio = 0;
  of_words.verdict.violations.clear();
  of_words.verdict.violation_count = 0;
  auto report = report_of(parts, of_words);
  if (report) report->tolerance_mm = figures.tolerance;
  return report;
}

base::Result<report::Report> report_of(const ReportParts& parts, const VerifyFigures& figures) {
  auto report = report_of(parts, figures.verdict);
  if (!report) return report;
  report->title = figures.trace;
  report->program = parts.program.name();
  report->length_mm = figures.length_mm;
  report->limits = limits_of(figures.verdict, nullptr);
  return report;
}

std::array<report::FollowedAxis, base::axis_count> followed_axes(const servo::Followed& followed) {
  std::array<report::FollowedAxis, base::axis_count> axes;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    axes[k] = {followed.word.position[k] - followed.position[k], followed.velocity[k], followed.control[k],
               followed.current[k]};
  }
  return axes;
}

report::LostBlock lost_block(const pipeline::BlockTime& block) {
  return {block.line,  block.feed_asked, block.feed_reached, block.seconds, block.lost(), pipeline::name(block.cause),
          block.middle};
}

void observe_ideal_path(gcode::Reader reader, const machine::Machine& machine, const base::AxisVector& start,
                        report::FollowedRecording& followed) {
  constexpr int parts = 64;
  gcode::Move move;
  kinematics::WordPoses poses(machine);
  const auto observe = [&](const base::AxisVector& place, bool is_of_tip) {
    const auto pose = is_of_tip ? std::nullopt : poses.of(place);
    followed.observe_ideal(pose ? pose->tip : place);
  };
  observe(start, false);
  while (reader.next(move)) {
    poses.hold(move.tool);
    for (const toolpath::Piece& piece : toolpath::pieces_of(move)) {
      const bool is_straight = move.kind == gcode::Move::Kind::line && (move.is_of_tip || !machine.rotary_chain);
      const int count = is_straight ? 1 : parts;
      for (int i = 1; i <= count; ++i) {
        const double s = piece.axes().length() * i / count;
        observe(piece.axes().position(numeric::DoubleDouble(s)), move.is_of_tip);
      }
    }
  }
}

}  // namespace leadscrew::results
