#pragma once
// A trace and its program, read for what the tool leaves of surfaces.

#include <functional>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/results/measured.hpp>
#include <optional>
#include <string>

namespace leadscrew::results {

/// The surfaces of a program, read whole, and its tools. Errors: `measure-nothing` where there are none; interruption.
base::Result<measuring::ProgramTools> surfaces_of(gcode::Reader reader, const machine::ToolTable& tools,
                                                  const std::string& program);
/// `measure-surfaces`: some are left out.
std::optional<base::Diagnostic> warning_of(const measuring::ProgramTools& tools, const std::string& program);

measuring::MeasureOptions options_of(const MeasureQuestion& question);

/// Told now and then, of all readings together and of the one under way.
using MeasureProgress = std::function<void(std::int64_t rows, std::int64_t bytes)>;
/// All readings of the trace. Errors: those of the trace and of TraceMeasurement::measure(), its changes, interruption.
base::Result<void> read_trace(const files::InputFile& trace, measuring::TraceMeasurement& measured,
                              const MeasureProgress& progress);

}  // namespace leadscrew::results
