#pragma once
// A trace against the surfaces that its program machines: rows become poses of tools, by the referee's own kinematics, and go to
// each surface's measurement.

#include <functional>
#include <leadscrew/base/result.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/measuring/measurement.hpp>
#include <leadscrew/measuring/program_tools.hpp>
#include <leadscrew/referee/pose.hpp>
#include <leadscrew/trace/trace_reader.hpp>
#include <memory>
#include <optional>
#include <vector>

namespace leadscrew::measuring {

/// How a trace is measured.
struct MeasureOptions {
  std::optional<double> reach;        ///< mm: what is left above that has not been reached; > 0
  std::size_t most_places = 1 << 20;  ///< of the grids of all surfaces together
};

class TraceMeasurement {
 public:
  /// Of a program that has been seen whole. The machine must outlive it. start: of axes without a column, mm or degrees.
  TraceMeasurement(ProgramTools tools, const machine::Machine& machine, const base::AxisVector& start,
                   const MeasureOptions& options);

  using Opener = std::function<base::Result<trace::TraceReader>()>;
  /// Called often with the number of rows read so far, of all readings; what it returns ends the work.
  using Watcher = std::function<base::Result<void>(std::int64_t rows)>;
  /// Reads the trace from its beginning as often as need be. Errors: those of the trace, `trace-empty`, `measure-line` where it
  /// does not tell lines and the program has several tools, and what the watcher returns.
  base::Result<void> measure(const Opener& open, const Watcher& watch);

  const ProgramTools& tools() const { return tools_; }
  /// In the order of tools().surfaces().
  const std::vector<std::unique_ptr<Measurement>>& measurements() const { return measurements_; }
  std::int64_t words() const { return words_; }
  /// Of the machine.
  base::AxisSet axes() const { return machine_->axis_set(); }

 private:
  base::Result<void> read_once(const Opener& open, const Watcher& watch, std::int64_t& rows);
  base::Result<void> take(const trace::TraceRow& row, base::AxisSet given, std::int64_t number);

  ProgramTools tools_;
  const machine::Machine* machine_;
  base::AxisVector start_;
  referee::Pose pose_;
  std::vector<std::unique_ptr<Measurement>> measurements_;
  std::optional<BlockTool> before_;  // of the row before
  std::int64_t words_ = 0;
};

}  // namespace leadscrew::measuring
