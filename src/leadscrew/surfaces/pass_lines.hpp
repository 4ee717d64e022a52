#pragma once
// Which lines of the surface passes follow, one after another: each is found from the one before and the height that the
// ridge between them may have.

#include <leadscrew/surfaces/pass_nodes.hpp>
#include <memory>

namespace leadscrew::surfaces {

/// The lines of a pattern, in order.
class PassLines {
 public:
  virtual ~PassLines() = default;
  /// Those of the next pass, in the order in which they are gone: more than one where the pass is cut by the range's border. None at
  /// the end, or where the log has a failure. They stay as they are until it is asked for the pass after.
  virtual std::vector<Line> next(PassLog& log) = 0;
};

/// Of the machining's pattern.
std::unique_ptr<PassLines> lines_of(PassLog& log);

/// mm on the surface across a pass, for the ridge that may be left; no_step where the log fails.
double step_at(PassLog& log, const Bending& bending, double u, double v);

}  // namespace leadscrew::surfaces
