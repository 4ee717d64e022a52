#pragma once
// A part program in motion, measured in two ways: planned once, room by room, with a clock around each call; and run
// through the pipeline at a servo period, with the referee at its side.

#include <leadscrew/base/result.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>
#include <leadscrew/study/curves.hpp>
#include <leadscrew/study/host.hpp>
#include <vector>

namespace leadscrew::study {

/// The same for X, Y and Z.
struct LimitSet {
  double velocity = 200;    ///< mm/s
  double acceleration = 0;  ///< mm/s²
  double jerk = 0;          ///< mm/s³
};

/// The built-in mill with these limits.
machine::Machine machine_with(const LimitSet& limits, base::Period period);

/// Processor time, seconds; all 0 where the host has no clock.
struct PlanningTime {
  double path = 0;          ///< moves to path
  double plan = 0;          ///< path to motion
  double longest_plan = 0;  ///< longest single call of the planner
};

/// Of the calls that make a word, nanoseconds of the steady clock, its two looks included; all 0 without a clock.
struct CycleTime {
  double p50 = 0, p999 = 0, max = 0;
};

struct Planned {
  double seconds = 0;  ///< the motion takes, exactly
  PlanningTime cpu;
  CycleTime cycle;  ///< at the machine's period
};

/// Reads, plans and interpolates. Errors: the first problem of the program.
base::Result<Planned> plan(const PartProgram& program, const machine::Machine& machine, const Host& host);

struct Judged {
  pipeline::Summary summary;
  referee::Verdict verdict;
};

/// Through pipeline::Program at the machine's period, judged by the referee. Errors: the first problem of the program.
base::Result<Judged> judge(const PartProgram& program, const machine::Machine& machine);

/// The largest ratio of all axes.
machine::Derivatives largest(const constraints::LimitRatios& ratios);
machine::Derivatives largest(const std::vector<referee::AxisVerdict>& axes);

}  // namespace leadscrew::study
