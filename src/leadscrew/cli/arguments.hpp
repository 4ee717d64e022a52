#pragma once
// What the command line asks for.

#include <leadscrew/base/time.hpp>
#include <leadscrew/cli/about.hpp>
#include <leadscrew/cli/design_arguments.hpp>
#include <leadscrew/cli/drive_arguments.hpp>
#include <leadscrew/cli/options.hpp>
#include <leadscrew/cli/pulse_arguments.hpp>
#include <leadscrew/cli/run_arguments.hpp>
#include <leadscrew/cli/serve.hpp>
#include <leadscrew/cli/simulate_arguments.hpp>
#include <leadscrew/cli/study_arguments.hpp>
#include <leadscrew/cli/surfaces.hpp>
#include <leadscrew/console/console.hpp>
#include <leadscrew/drive/setup.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/results/measured.hpp>
#include <leadscrew/results/sizing.hpp>
#include <leadscrew/sweep/options.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace leadscrew::cli {

struct Arguments {
  enum class Verb {
    run,
    check,
    verify,
    measure,
    canon,
    pulse,
    study,
    design,
    simulate,
    drive,
    explain,
    format,
    surfaces,
    serve,
    sweep
  };

  Verb verb = Verb::run;
  std::optional<std::string> explained;   ///< of explain: a block
  bool explain_page = false;              ///< of explain: every code
  std::vector<std::string> programs;      ///< one or more; of canon, verify and measure one
  std::string judged_trace;               ///< of verify and measure
  RunArguments run;                       ///< of run; its files of simulate too
  SimulateArguments simulate;             ///< of simulate
  results::MeasureQuestion measure;       ///< of measure
  PulseArguments pulse;                   ///< of pulse
  results::SizingQuestion design;         ///< of design
  drive::Options drive;                   ///< of drive
  AboutArguments about;                   ///< of help, completion and --version
  StudyArguments study;                   ///< of study
  SurfacesArguments surfaces;             ///< of surfaces
  sweep::Options sweep;                   ///< of sweep
  ServeArguments serve;                   ///< of serve and drive
  std::optional<std::string> machine;     ///< file, or the name of a built-in machine
  std::optional<std::string> tools;       ///< file
  std::optional<std::string> parameters;  ///< file, of run, check, verify, simulate and drive
  std::vector<AxisValue> start;           ///< machine coordinates, mm or degrees; axes not named start at zero
  std::optional<base::Period> period;
  std::optional<gcode::PathMode> mode;
  std::optional<double> tolerance;  ///< mm
  std::optional<machine::Smoothing> smoothing;
  std::optional<machine::Dialect> dialect;
  bool gouge = false;                     ///< of check
  std::optional<double> gouge_tolerance;  ///< of check, mm
  bool lint = false;                      ///< of check
  std::optional<double> stock_top;        ///< of check: Z of the program, mm
  std::vector<std::string> subprograms;   ///< folders
  bool allow_gouge = false;               ///< surfaces are machined though the tool gouges
  std::optional<std::int64_t> fuel;       ///< lines in loops and subprograms, ≥ 1
  std::optional<int> threads;             ///< that work on several programs, 1 … 1024; none: as many as processors
  bool json = false;
  bool quiet = false;
  ColorChoice color = ColorChoice::automatic;
  std::string command_line;  ///< as a shell would take it
};

/// "run", "check" and all others.
std::vector<std::string> command_names();

/// Describes every command, whose values will go to the arguments; these must outlive the program.
void describe_program(options::Program& program, Arguments& arguments);

std::variant<Arguments, Answer> parse_arguments(int count, const char* const* values);

}  // namespace leadscrew::cli
