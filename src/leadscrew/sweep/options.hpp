#pragma once
// The options of `leadscrew sweep`.

#include <leadscrew/console/console.hpp>
#include <leadscrew/machine/dialect.hpp>
#include <leadscrew/options/options.hpp>
#include <leadscrew/sweep/model.hpp>
#include <leadscrew/sweep/parameters.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::sweep {

struct Options {
  std::vector<std::string> programs;  ///< files and folders
  std::vector<std::string> machines;  ///< files, or mill3; none: that
  std::optional<std::string> tools;   ///< file
  std::vector<std::string> subprograms;
  std::optional<machine::Dialect> dialect;
  Grid grid;
  std::int64_t random = 0;         ///< cases of a campaign, 0: none
  std::int64_t first = 0;          ///< number of the first of them
  std::uint64_t seed = 1;          ///< of the campaign
  std::optional<std::string> out;  ///< folder
  bool optimises = false;          ///< each limit, less and more
  std::vector<ModelSetup> model;   ///< simulated in place of a start; empty: none
  std::int64_t model_tasks = 0;    ///< that are simulated, repeated in turn; 0: those that were done
  bool merges = false;             ///< only what is there
  std::optional<int> processes;    ///< of this computer, ≥ 1; none: one a processor
};

/// What is printed at the end.
struct Output {
  bool json = false;   ///< one object; else a summary
  bool quiet = false;  ///< no summary
};

/// The command's own options; those that every command has are the caller's.
void describe(options::Command& command, Options& options);

/// `leadscrew sweep`.
options::Status sweep(const Options& options, const Output& output, console::Console& console);

}  // namespace leadscrew::sweep
