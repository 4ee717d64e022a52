#pragma once
// The report's contents, from what was found and the text of the blocks that its tables name.

#include <leadscrew/files/input_file.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/interpolator/parameter_steps.hpp>
#include <leadscrew/report/recording.hpp>
#include <leadscrew/report/report.hpp>
#include <leadscrew/results/figures.hpp>
#include <leadscrew/results/simulate_figures.hpp>
#include <leadscrew/servo/servo.hpp>

namespace leadscrew::results {

/// What was asked for in place of what program and machine file say.
struct MotionAsked {
  base::AxisVector start{};                       ///< where the program begins, mm or degrees
  std::optional<gcode::PathMode> mode{};          ///< exact_stop or blend, in place of G61, G61.1 and G64
  std::optional<double> tolerance{};              ///< mm, in place of P of G64
  std::optional<machine::Smoothing> smoothing{};  ///< in place of the machine's
  interpolator::StepRule steps = interpolator::StepRule::arc_length;  ///< by which words step along curves
};

/// What a report needs beside figures: the program, for its text, the command line that makes the report again, what was
/// said of the program, and the recording.
struct ReportParts {
  const files::InputFile& program;
  const std::string& command_line;
  const Diagnostics& diagnostics;
  const report::Recording& recording;
  std::string machine_file = {}, tools = {};  ///< their texts; empty: the built-in mill, no table
  MotionAsked asked = {};
};

/// Errors: those of reading the program once more.
base::Result<report::Report> report_of(const ReportParts& parts, const RunFigures& figures);
/// Of slides: deviation and tolerance are theirs, limits those of the plan.
base::Result<report::Report> report_of(const ReportParts& parts, const SimulateFigures& figures);
/// Of a trace, whoever made it.
base::Result<report::Report> report_of(const ReportParts& parts, const VerifyFigures& figures);

std::array<report::FollowedAxis, base::axis_count> followed_axes(const servo::Followed& followed);

/// As the table of blocks that lose time shows it.
report::LostBlock lost_block(const pipeline::BlockTime& block);

/// The programmed geometry from `start`, move by move, curves in 64 parts.
void observe_ideal_path(gcode::Reader reader, const machine::Machine& machine, const base::AxisVector& start,
                        report::FollowedRecording& followed);

}  // namespace leadscrew::results
