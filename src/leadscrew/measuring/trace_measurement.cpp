#include <algorithm>
#include <cmath>
#include <leadscrew/measuring/trace_measurement.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::measuring {

namespace {

constexpr std::int64_t rows_between_looks = 1024;

}  // namespace

TraceMeasurement::TraceMeasurement(ProgramTools tools, const machine::Machine& machine, const base::AxisVector& start,
                                   const MeasureOptions& options)
    : tools_(std::move(tools)), machine_(&machine), start_(start), pose_(machine) {
  const std::size_t surfaces = std::max<std::size_t>(tools_.surfaces().size(), 1);
  for (const ProgramSurface& surface : tools_.surfaces()) {
    measurements_.push_back(std::make_unique<Measurement>(
        target_of(surface, options.reach, std::max<std::size_t>(options.most_places / surfaces, 1024))));
  }
}

base::Result<void> TraceMeasurement::measure(const Opener& open, const Watcher& watch) {
  std::int64_t rows = 0;
  for (bool again = true; again;) {
    if (auto read = read_once(open, watch, rows); !read) return read;
    again = false;
    for (const auto& measurement : measurements_) again = measurement->end_reading() || again;
  }
  return {};
}

base::Result<void> TraceMeasurement::read_once(const Opener& open, const Watcher& watch, std::int64_t& rows) {
  auto reader = open();
  if (!reader) return base::failure(reader.error());
  tools_.begin_again();
  before_.reset();
  words_ = 0;
  while (true) {
    const auto row = reader->next();
    if (!row) return base::failure(row.error());
    if (!*row) break;
    if (auto taken = take(**row, reader->axes(), words_++); !taken) return taken;
    if (++rows % rows_between_looks != 0) continue;
    if (auto watched = watch(rows); !watched) return watched;
  }
  if (words_ > 0) return {};
  return base::failure(base::problem("trace-empty", "the trace has no row", "one row for each servo period"));
}

base::Result<void> TraceMeasurement::take(const trace::TraceRow& row, base::AxisSet given, std::int64_t number) {
  const BlockTool* const tool = tools_.tool_of(row.line);
  if (tool == nullptr) {
    return base::failure(
        base::problem("measure-line", "the trace has no column line, and the program more than one tool",
                      "a trace with the column line, as run --trace writes it, tells which tool cuts"));
  }
  const bool joined = before_ == *tool;
  before_ = *tool;
  if (!tool->body) return {};
  base::AxisVector axes = row.position;
  for (const base::Axis axis : base::all_axes) {
    if (!given.contains(axis)) axes[base::index(axis)] = start_[base::index(axis)];
  }
  const base::AxisVector tip = pose_.tip_of(axes, tool->offset);
  const ToolPose in_workpiece{{tip[0], tip[1], tip[2]}, pose_.direction_of(axes)};
  ToolPose by_axes;
  for (std::size_t k = 0; k < 3; ++k) by_axes.tip[k] = axes[k] - tool->offset[k];
  const WordPlace word{number, row.t, row.line.value_or(0)};
  for (std::size_t k = 0; k < measurements_.size(); ++k) {
    const bool is_of_tip = tools_.surfaces()[k].machined->is_of_tip;
    measurements_[k]->add(is_of_tip ? in_workpiece : by_axes, *tool->body, word, joined);
  }
  return {};
}

}  // namespace leadscrew::measuring
