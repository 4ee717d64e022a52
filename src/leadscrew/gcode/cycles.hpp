#pragma once
// Canned cycles: what is said in the first block of a series holds for those that follow.

#include <leadscrew/gcode/drill_cycle.hpp>
#include <leadscrew/gcode/motion.hpp>

namespace leadscrew::gcode {

class CannedCycles : Part {
 public:
  CannedCycles(const Context& context, Motion& motion, Travel& travel, Outbox& outbox)
      : Part(context), motion_(motion), travel_(travel), outbox_(outbox) {}

  /// Any of the cycles.
  void drill(const Block& block);
  /// Another motion, or none, has come into force.
  void end_series() { series_.reset(); }
  /// The next move of the cycle in execution; false where there is none, or no more.
  bool next(Move& move);
  /// The cycle in execution is not followed: the program stands where it would have ended.
  void abandon();

 private:
  bool can_drill(const Block& block);
  void plan_repeats(const Block& block, DrillCycle::Plan& plan);
  void plan_dwell(const Block& block, DrillCycle::Plan& plan);
  void plan_pecks(const Block& block, DrillCycle::Plan& plan);
  bool plan_levels(const Block& block, DrillCycle::Plan& plan);

  // What holds for the canned cycles since the last other motion: the level at which the first of them began, mm in
  // machine coordinates; the others as they were written, dwell in seconds.
  struct Series {
    Code code = Code::none;
    double initial_level = 0;
    std::optional<double> r, bottom, dwell, peck;
  };

  Motion& motion_;
  Travel& travel_;
  Outbox& outbox_;
  std::optional<Series> series_;
  DrillCycle cycle_;
  Feed cycle_feed_;
};

}  // namespace leadscrew::gcode
