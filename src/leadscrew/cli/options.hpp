#pragma once
// What the sources here say of options and of the console, by its name alone.

#include <leadscrew/console/diagnostic_log.hpp>
#include <leadscrew/options/options.hpp>
#include <leadscrew/options/quantity.hpp>
#include <leadscrew/options/status.hpp>

namespace leadscrew::cli {

using console::ColorChoice;
using console::Console;
using console::DiagnosticLog;
using console::Progress;
using console::Style;
using console::Tone;
using console::write_output;
using options::Answer;
using options::AxisValue;
using options::Command;
using options::file;
using options::parse_axis_values;
using options::parse_frequency;
using options::parse_number;
using options::parse_numbers;
using options::parse_period;
using options::parse_step_time;
using options::parse_tolerance;
using options::Parsed;
using options::Status;
using options::status_of;
using options::Values;
using options::worse;
using options::wrong;

}  // namespace leadscrew::cli
