#pragma once
// Canned cycles: what is said in the first block of a series holds for those that follow.

#include <leadscrew/gcode/drill_cycle.hpp>
#include <leadscrew/gcode/motion.hpp>
#include <leadscrew/gcode/spindle_pace.hpp>

namespace leadscrew::gcode {

class CannedCycles : Part {
 public:
  CannedCycles(const Context& context, Motion& motion, Travel& travel, Outbox& outbox)
      : Part(context), motion_(motion), travel_(travel), outbox_(outbox), pace_(context) {}

  /// Any of the cycles.
  void drill(const Block& block);
  /// G70, G71 and G72 of Haas: the cycle in force at holes on a circle, an arc or a line.
  void drill_pattern(const Block& block);
  /// Another motion, or none, has come into force.
  void end_series() { series_.reset(); }
  /// The next move of the cycle in execution; false where there is none, or no more.
  bool next(Move& move) { return cycle_.active() && next_of_cycle(move); }
  /// The cycle in execution is not followed: the program stands where it would have ended.
  void abandon();

 private:
  bool next_of_cycle(Move& move);
  bool can_drill(const Block& block);
  bool can_turn(const Block& block);
  bool can_reach(const Block& block);
  bool stands_at(const base::AxisVector& target) const;
  base::AxisVector seen(const base::AxisVector& place) const;
  base::AxisVector placed(const base::AxisVector& target) const;
  void plan_repeats(const Block& block, DrillCycle::Plan& plan);
  void plan_dwell(const Block& block, DrillCycle::Plan& plan);
  void plan_pecks(const Block& block, DrillCycle::Plan& plan);
  void plan_aside(const Block& block, DrillCycle::Plan& plan);
  void plan_tap(const Block& block, DrillCycle::Plan& plan);
  void plan_way_out(const Block& block, DrillCycle::Plan& plan);
  bool plan_levels(const Block& block, DrillCycle::Plan& plan);
  void plan_pattern(const Block& block, DrillCycle::Plan& plan);
  void plan_series(const Block& block, DrillCycle::Plan& plan);
  void set_cycle_feed(const Block& block);
  void begin(const Block& block, const DrillCycle::Plan& plan);
  void come_back(const DrillCycle::Plan& plan);
  void warn_of_wall(const Block& block);
  bool prepare_event(Move& move, DrillCycle::Step::Kind kind) const;
  bool prepare_step_event(Move& move, bool in_step) const;
  std::optional<double> tap_lead() const;
  bool can_tap(const Block& block, const DrillCycle::Plan& plan);
  base::Event::Kind spindle_event(DrillCycle::Step::Kind kind) const;
  double spindle_speed(DrillCycle::Step::Kind kind) const;
  static constexpr double most_steps = 100'000;  // holes of one block, and pecks of one hole

  // What holds for the canned cycles since the last other motion: numbers as they were written, which are read in the
  // units of the block that uses them; the dwell in seconds.
  struct Series {
    Code code = Code::none;
    double initial_level = 0;  // mm, machine coordinates
    std::optional<double> r, bottom, dwell, peck, first_peck, peck_step, least_peck, aside_first, aside_second, level,
        way_out;  // J of a tap
    bool told_of_wall = false;
  };

  Motion& motion_;
  Travel& travel_;
  Outbox& outbox_;
  SpindlePace pace_;
  std::optional<Series> series_;
  DrillCycle cycle_;
  // In a tilted plane the cycle is told in the program's coordinates, else in the machine's.
  bool is_tilted_ = false;
  base::AxisVector at_{};  // where it stands
  Feed cycle_feed_;
};

}  // namespace leadscrew::gcode
