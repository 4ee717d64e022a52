#pragma once
// The servo period of a trace, from its times.

#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/result.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/files/input_file.hpp>

namespace leadscrew::results {

/// Rows must be evenly spaced, to 2 % of the first spacing, which leaves room for times of few digits; the period is
/// their mean spacing, to the nanosecond. A trace of one row has the period `otherwise`. Errors: `trace-period` with
/// the first row that is out of step, `trace-empty`, and those of trace::TraceReader.
base::Result<base::Period> trace_period(const files::InputFile& file, base::AxisSet axes, base::Period otherwise);

/// Does it begin as a trace does? No part program can.
bool is_trace(const files::InputFile& file, base::AxisSet axes);

}  // namespace leadscrew::results
