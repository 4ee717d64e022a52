#pragma once
// Pecking of Fanuc's lathes, G-code system A (Fanuc 0i operator's manual, "End Face Peck Drilling Cycle", "Outer
// Diameter / Internal Diameter Drilling Cycle"): G74 pecks along Z, G75 along X, at one place or at several beside each
// other. A block of R alone says how far the tool goes back between pecks, the block of the cycle the rest.
//
//     G74    A ●━━▶ ━━▶ ━━▶ ━━▶ ╮ Z      pecks of Q, back by R of the block before
//              ◀────────────────╯ R      off the wall at the bottom, back at rapid
//            P ▼
//              ●━━▶ ━━▶ ━━▶ ━━▶ ╮        the next place, until X; at last back to A
//
// P, along X, is of the radius.

#include <leadscrew/gcode/planned_cycle.hpp>

namespace leadscrew::gcode {

class PeckingCycles : Part {
 public:
  PeckingCycles(const Context& context, Motion& motion, PlannedCycle& planned)
      : Part(context), motion_(motion), planned_(planned) {}

  /// A block of G74 or G75.
  [[gnu::cold]] void peck(const Block& block);

 private:
  /// One cycle, in mm.
  struct Plan {
    std::size_t along = 0, across = 0;  ///< axes
    double depth = 0, peck = 0;         ///< the first signed
    double width = 0, step = 0;         ///< of all places beside each other, signed; between two
    double relief = 0;                  ///< at the bottom, signed
    Feed feed;
  };

  bool check(const Block& block);
  bool step_of(const Block& block, char letter, double way, double& step);
  bool plan(const Block& block, Plan& plan);
  void peck_at(double across, const Plan& plan);
  /// A line in the plane of the lathe, to mm of the program.
  void go(const Plan& plan, double along, double across, const Feed& feed);

  Motion& motion_;
  PlannedCycle& planned_;
  double retract_ = 0.5;  ///< between pecks, in the program's units
};

}  // namespace leadscrew::gcode
