#pragma once
// The words of a motion inside a tube, judged as any other controller's.

#include <leadscrew/referee/referee.hpp>
#include <leadscrew/study/tube.hpp>
#include <string>
#include <vector>

namespace leadscrew::study {

/// By the referee, against the program, which must be sound; words in X and Y at the machine's period.
referee::Verdict judge(const PartProgram& program, const machine::Machine& machine,
                       const std::vector<PlaneVector>& words);

/// As a trace in CSV, columns t X Y Z, whose numbers read back bit for bit.
std::string trace_of(const std::vector<PlaneVector>& words, base::Period period);

}  // namespace leadscrew::study
