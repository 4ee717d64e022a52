#pragma once
// A program made into words, and judged by the referee: what a task of a sweep is.

#include <functional>
#include <leadscrew/campaign/cases.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <leadscrew/pipeline/lost_time.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>
#include <optional>

namespace leadscrew::sweep {

/// How a program is run.
struct RunSetup {
  const machine::Machine& machine;
  const machine::ToolTable& tools;
  gcode::ReaderOptions options{};
  std::function<gcode::ByteSource()> source;           ///< opens the text anew, from its beginning
  double override_factor = 1;                          ///< of the programmed feed, 0.01 … 2
  std::vector<campaign::FeedChange> changes = {};      ///< of it, while motion goes on; the last above 0
  std::function<base::Result<void>()> unchanged = {};  ///< is it still the program that was read?
  std::function<bool()> is_cancelled = {};
};

struct JudgedRun {
  pipeline::Summary summary;
  referee::Verdict verdict;
  pipeline::LostByCause lost;
  std::uint64_t words_hash = 0;  ///< of the positions of all words, bit by bit

  /// The greatest ratio of velocity, acceleration and jerk among the axes, by the referee.
  std::array<double, 3> worst_ratios() const;
  /// Were limits and tolerances kept, by plan and by referee, and the program's end reached within 1 nm?
  bool kept() const;
};

/// A program that has been read whole without error. Errors: what ended its motion before its end, `interrupted` too.
base::Result<JudgedRun> run_judged(const RunSetup& setup);

}  // namespace leadscrew::sweep
