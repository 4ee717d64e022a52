#pragma once
// What is told of every motion: how near it comes to the limits, and what it cost.

#include <leadscrew/machine/derivatives.hpp>
#include <leadscrew/study/motion.hpp>
#include <leadscrew/study/row.hpp>
#include <string>

namespace leadscrew::study {

/// Velocity, acceleration and jerk over their limits, which may be passed by as much as the referee allows.
Rows ratio_rows(const std::string& who, const machine::Derivatives& most);

/// Processor time of planning; not run where the host has no clock.
Rows planning_rows(const Planned& planned, const Host& host);

/// Time of the calls that make a word; not run where the host has no clock.
Rows cycle_rows(const Planned& planned, const Host& host);

}  // namespace leadscrew::study
