#pragma once
// What the verbs do that work on programs and need few words: run.hpp, simulate.hpp and drive.hpp have the others.

#include <leadscrew/cli/job.hpp>

namespace leadscrew::cli {

/// `leadscrew check`: reads programs and says what is wrong with them.
Status check(const Job& job, Console& console);

/// `leadscrew canon`: the canonical machining calls of a program.
Status canon(const Job& job, Console& console);

/// `leadscrew verify`: the referee judges a trace, ours or another controller's, against its program and machine.
Status verify(const Job& job, Console& console);

/// `leadscrew measure`: the surface that a trace's tool leaves.
Status measure(const Job& job, Console& console);

}  // namespace leadscrew::cli
