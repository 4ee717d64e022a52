#pragma once
// G12 and G13: circular pockets about the place where the tool stands (Haas mill operator's manual), and Mach3's circles
// of the same numbers.
//
//          . - ~ ~ - .
//       .'    _ _     ' .     Down at feed; then arcs alone: half a circle out to radius I, once round, half a circle
//      /    /  ○  \──▶   \    out to I + Q, round, …, to K, and half a circle back to the middle. Each leads into the
//      \    \ _ _ /      /    next along its tangent. The tool keeps its radius inside of these.
//       ' .           . '
//          ' - ~ ~ - '

#include <leadscrew/gcode/cutter_radius.hpp>
#include <leadscrew/gcode/planned_cycle.hpp>

namespace leadscrew::gcode {

class CircularPockets : Part {
 public:
  CircularPockets(const Context& context, Motion& motion, CutterRadius& cutter, PlannedCycle& cycle)
      : Part(context), motion_(motion), cutter_(cutter), cycle_(cycle) {}

  [[gnu::cold]] void mill(const Block& block);

 private:
  /// Of the path of the tool's middle, mm.
  struct Radii {
    double first = 0;  ///< > 0
    double last = 0;   ///< ≥ first
    double step = 0;   ///< > 0 where last is not first
  };

  bool can_mill(const Block& block);
  bool plan(const Block& block, Radii& radii);
  void mill_circle(const Block& block, int turn, const Feed& feed);
  void mill_level(const Radii& radii, PlanePoint middle, int turn, const Feed& feed);

  Motion& motion_;
  CutterRadius& cutter_;
  PlannedCycle& cycle_;
};

}  // namespace leadscrew::gcode
