#pragma once
// What one program's run, check or verification found: what the summary and JSON show.

#include <cstdint>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/cli/job.hpp>
#include <leadscrew/cli/step_output.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/realtime/histogram.hpp>
#include <leadscrew/referee/referee.hpp>
#include <string>
#include <vector>

namespace leadscrew::cli {

/// Where the time of the computer went.
struct Effort {
  double read = 0;             ///< s of the processor: the program, whole, for its diagnostics
  double plan = 0;             ///< s of the processor: all calls that plan
  double words = 0;            ///< s: all calls that make words, from those that were timed
  realtime::Histogram cycles;  ///< of the calls that were timed (stop_watch.hpp)
};

struct RunFigures {
  pipeline::Summary summary;
  referee::Verdict verdict;
  Effort effort;
  std::vector<std::string> files{};    ///< written
  std::optional<StepFigures> steps{};  ///< where they were asked for

  /// Did the motion keep what it must, by plan and by referee?
  bool kept() const;
};

struct VerifyFigures {
  std::string trace;
  base::Period period;
  referee::Verdict verdict;
};

}  // namespace leadscrew::cli
