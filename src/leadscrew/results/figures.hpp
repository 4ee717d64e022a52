#pragma once
// What one program's run, check or verification found: what the summary and JSON show.

#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/gcode/remark.hpp>
#include <leadscrew/gouging/program_check.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/pipeline/lost_time.hpp>
#include <leadscrew/pipeline/path_survey.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/realtime/histogram.hpp>
#include <leadscrew/referee/referee.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::results {

using Diagnostics = std::vector<base::Diagnostic>;

/// How many of them are as severe as this.
std::int64_t count(const Diagnostics& diagnostics, base::Severity severity);

/// Where the time of the computer went.
struct ComputingTime {
  double read = 0;             ///< s of the processor: the program, whole, for its diagnostics
  double plan = 0;             ///< s of the processor: all calls that plan
  double words = 0;            ///< s: all calls that make words, from those that were timed
  realtime::Histogram cycles;  ///< of the calls that were timed, one of 61
};

/// How far the steps of an axis were led from its words, so that its screw would be where they are.
struct Correction {
  base::Axis axis = base::Axis::X;
  double greatest = 0;  ///< mm or degrees
};

/// What was written.
struct StepFigures {
  std::string method;       ///< "words", or the interpolator's name
  std::string conventions;  ///< of interpolators by DDAs, for people
  std::int64_t clock_hz = 0;
  std::int64_t steps = 0;
  double time_s = 0;                    ///< of the last step
  std::optional<double> error_blu;      ///< greatest distance from the words, compensated; none of other methods
  bool accelerates = false;             ///< a method of its own, kept to the axes' acceleration
  std::vector<Correction> corrections;  ///< of axes whose screws have errors
};

/// What an axis reaches.
struct Extent {
  base::Axis axis{};
  double least = 0, greatest = 0;  ///< mm or degrees, machine coordinates
};

/// Of the axes of the machine, from these coordinates to those.
std::vector<Extent> extents_of(const machine::Machine& machine, const base::AxisVector& least,
                               const base::AxisVector& greatest);

/// Of a program that was only read.
struct CheckFigures {
  std::int64_t blocks = 0;
  std::int64_t moves = 0;  ///< lines and arcs
  /// Of a program without errors.
  std::vector<Extent> extents{};
  std::optional<double> bound_s{};                 ///< as pipeline::Summary has it
  std::optional<gouging::GougeVerdict> gouging{};  ///< where it was asked for
  // What the program says.
  std::vector<gcode::Remark> messages{};  ///< the first of them
  std::int64_t message_count = 0;         ///< of all
};

/// "line 12", "line 12 of subprogram file 1, visit 3": the place of a block, for people.
std::string line_text(base::Line line);

struct RunFigures {
  pipeline::Summary summary;
  referee::Verdict verdict;
  ComputingTime effort;
  pipeline::LostByCause lost{};  ///< where time is lost against feed words
  std::vector<Extent> extents{};
  std::vector<std::string> files{};                ///< written
  std::optional<StepFigures> steps{};              ///< where they were asked for
  std::optional<gouging::GougeVerdict> gouging{};  ///< for the report of a program that may gouge

  /// Did the motion keep what it must, by plan and by referee?
  bool kept() const;
};

struct VerifyFigures {
  std::string trace;
  base::Period period;
  referee::Verdict verdict;
  double length_mm = 0;              ///< from word to word, as feed is counted
  std::vector<std::string> files{};  ///< written
};

}  // namespace leadscrew::results
