#pragma once
// What the command line asks `leadscrew simulate` for, beside what other commands are asked for too.

#include <leadscrew/cli/options.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/servo/adaptive_cut.hpp>
#include <leadscrew/servo/pid.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::cli {

/// Of --adaptive. The limit of the force is empty where it is to be what the first depth gives at the greatest feed.
struct AdaptiveArguments {
  servo::AdaptiveCutOptions cut;  ///< without limit and noise
  std::optional<double> limit;    ///< N
  double noise = 0.05;            ///< of the limit
};

struct SimulateArguments {
  std::optional<servo::PidGains> gains;  ///< of every axis, in the published form
  std::optional<bool> feed_forward;      ///< of every axis, whole or none
  std::optional<AdaptiveArguments> adaptive;
  bool pulses = false;  ///< steps that follow the words, through pulse-driven loops

  /// What the machine tells of its drives, and what was asked for in its place. Gains without a word on feed-forward
  /// have none, as published.
  void put_into(machine::Machine& machine) const;
};

struct Arguments;

/// The options of simulate, which put their values into the arguments.
void describe_simulate(Command& command, Arguments& arguments);

/// Those of --adaptive.
void add_adaptive(Command& command, Arguments& arguments);

}  // namespace leadscrew::cli
