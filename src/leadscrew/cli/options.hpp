#pragma once
// The options of each command, as its --help tells them. They leave what was given as text.

#include <leadscrew/cli/arguments.hpp>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace leadscrew::cli {

/// Options as text, before their values are looked at.
struct Texts {
  std::optional<std::string> period, mode, tolerance, start, color;
  std::string one_program;  ///< of verify and drive
  RunTexts run;
  PulseTexts pulse;
  DesignTexts design;
  SimulateTexts simulate;
  DriveTexts drive;
};

/// Each adds a command to the application. What needs no looking at goes to the arguments, the rest to the texts; all
/// three must outlive the application's parsing.
CLI::App* add_run(CLI::App& app, Arguments& arguments, Texts& texts);
CLI::App* add_simulate(CLI::App& app, Arguments& arguments, Texts& texts);
CLI::App* add_check(CLI::App& app, Arguments& arguments, Texts& texts);
CLI::App* add_verify(CLI::App& app, Arguments& arguments, Texts& texts);
CLI::App* add_drive(CLI::App& app, Arguments& arguments, Texts& texts);
CLI::App* add_pulse(CLI::App& app, Arguments& arguments, Texts& texts);
CLI::App* add_study(CLI::App& app, Arguments& arguments, Texts& texts);
CLI::App* add_design(CLI::App& app, Arguments& arguments, Texts& texts);

}  // namespace leadscrew::cli
