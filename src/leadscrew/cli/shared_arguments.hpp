#pragma once
// Options that several commands have.

#include <leadscrew/cli/options.hpp>
#include <string>
#include <vector>

namespace leadscrew::cli {

struct Arguments;

/// What a part program is, for the completion of shells.
Values program_values();

/// Of traces: those of trace::endings().
std::vector<std::string> trace_endings();

/// --machine, --tools, --start.
void add_setup(Command& command, Arguments& arguments);

/// --color.
void add_color(Command& command, Arguments& arguments);

/// --json, --quiet, --color.
void add_output(Command& command, Arguments& arguments);

/// --dialect, of programs.
void add_dialect(Command& command, Arguments& arguments);

/// --subprograms and --fuel, of programs.
void add_flow(Command& command, Arguments& arguments);

/// Of commands that read programs: all of those above.
void add_common(Command& command, Arguments& arguments);

/// --period, of the machine's servo.
void add_period(Command& command, Arguments& arguments);

/// --mode, --tolerance.
void add_motion(Command& command, Arguments& arguments);

/// What is made to look at: --report, --picture, --charts.
void add_report(Command& command, Arguments& arguments);

/// Those, --events and --out; then, of the files of several programs, the check.
void add_pages(Command& command, Arguments& arguments);

/// --threads, of commands that work on several programs.
/// --parameters is for one program.
void add_one_set_of_parameters(Command& command, Arguments& arguments);
void add_threads(Command& command, Arguments& arguments);

inline constexpr const char* programs_help = "Part programs; - is standard input, curve:NAME a curve of the studies";

}  // namespace leadscrew::cli
