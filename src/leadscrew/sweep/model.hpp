#pragma once
// How long a sweep takes on so many processors: a simulation by discrete events of what ranks do, with times that tasks were
// measured to take.
//
//     rank    claim ─▶ [counter] ─▶ task ─▶ [file system, of the first result] ─▶ claim ─▶ …
//
// The counter and the file system serve one rank after the other. Ranks that share processors share them equally: each goes on
// at min(1, processors/ranks at work) of its speed: tasks are then given by their processor time. Where they are given by the time
// of the clock, which has the waiting for a processor in it, each rank has a processor of its own.

#include <cstdint>
#include <vector>

namespace leadscrew::sweep {

struct ModelSetup {
  int ranks = 1;
  int processors = 1;              ///< that they share
  double counter_service = 2e-6;   ///< s that the counter takes for a claim, during which no other is served
  double counter_latency = 10e-6;  ///< s more until the rank knows it
  double shard_service = 1e-3;     ///< s that the file system takes to make a shard
};

struct ModelResult {
  double makespan = 0;      ///< s, from the first claim to the last result
  double work = 0;          ///< s, sum of the tasks
  double counter_busy = 0;  ///< share of the time in which the counter serves
  double longest_wait = 0;  ///< s of a rank for the counter
  double shard_wait = 0;    ///< s until the last rank has its shard
  double straggling = 0;    ///< s from when the first rank finds no task to the end

  /// work / (makespan · processors in use)
  double efficiency = 0;
};

/// `tasks`: s, of a processor or of the clock as said above, in the order in which they are claimed; 0 and above.
ModelResult simulate(const ModelSetup& setup, const std::vector<double>& tasks);

}  // namespace leadscrew::sweep
