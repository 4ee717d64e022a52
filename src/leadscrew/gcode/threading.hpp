#pragma once
// Motion in step with the spindle: G33, G33.1 and LinuxCNC's G76 (LinuxCNC manual, G Codes).
//
// There is no encoder here: the spindle is taken to turn at the speed that S says. A thread begins at rest, with an event
// for which the machine waits for the spindle's index (base::Event::Kind::spindle_in_step), goes at lead × S, and ends at
// rest. So passes at one S line up; within the distance in which motion reaches its speed the lead is short. Where the
// machine simulates its spindle, the cycle follows that (interpolator/in_step.cpp); lead × S is what it is about.

#include <leadscrew/gcode/motion.hpp>
#include <leadscrew/gcode/spindle_pace.hpp>
#include <leadscrew/gcode/thread_cycle.hpp>

namespace leadscrew::gcode {

class Threading : Part {
 public:
  Threading(const Context& context, Motion& motion, Travel& travel, Outbox& outbox)
      : Part(context), motion_(motion), travel_(travel), outbox_(outbox), pace_(context) {}

  [[gnu::cold]] void thread(const Block& block);  ///< G33
  [[gnu::cold]] void tap(const Block& block);     ///< G33.1
  [[gnu::cold]] void cycle(const Block& block);   ///< G76
  /// G76 of Fanuc's lathes (threading_of_two_blocks.cpp).
  [[gnu::cold]] void cycle_of_two_blocks(const Block& block);
  /// One cut from where the tool stands to a place, in the lead of the block.
  [[gnu::cold]] void cut_to(const Block& block, const base::AxisVector& target);

  /// The next move of the cycle in execution; false where there is none, or no more.
  bool next(Move& move) { return in_cycle_ && next_of_cycle(move); }
  /// The cycle in execution is not followed: the program stands where it would have ended.
  void abandon();

 private:
  /// What the first block of Fanuc's G76 says, lengths in the program's units.
  struct Finish {
    int passes = 1;        ///< m, at full depth
    double chamfer = 0;    ///< r, how much of the lead the tool leaves the thread by
    double angle = 60;     ///< a, of the tool's tip, degrees
    double least_cut = 0;  ///< Q
    double allowance = 0;  ///< R, what is left for the passes at full depth
  };
  /// What the second says, X a radius.
  struct Thread {
    double start_x = 0, start_z = 0, end_x = 0, end_z = 0;
    double taper = 0;        ///< R: by how much the thread begins at another X than it ends at
    double height = 0;       ///< P > 0
    double first_depth = 0;  ///< Q > 0
    double lead = 0;         ///< F > 0
    double side = 1;         ///< 1 outside, −1 inside
  };

  bool can_turn(const Block& block);
  double along_path(double lead, const base::AxisVector& target) const;
  void keep_finish(const Block& block);
  bool plan_thread(const Block& block, Thread& thread);
  bool plan_steps(const Block& block, const Thread& thread);
  void add_pass(const Thread& thread, double depth);
  bool check_steps(const Block& block);
  bool moves_linear_axes_only(const Block& block);
  std::optional<double> lead_of(const Block& block);
  double feed_at(double lead, double factor = 1) const;
  void go(const base::AxisVector& target, double feed);
  std::optional<int> count(const Block& block, char letter, int most);
  bool plan_depths(const Block& block, ThreadCycle::Plan& plan);
  bool plan_tapers(const Block& block, ThreadCycle::Plan& plan);
  bool plan_cycle(const Block& block, ThreadCycle::Plan& plan);
  bool check_passes(const Block& block, const ThreadCycle::Plan& plan);
  base::AxisVector place(const ThreadCycle::Step& step) const;
  bool next_event(Move& move, double lead);
  base::AxisVector target_of(const ThreadCycle::Step& step) const;
  [[gnu::cold]] bool next_of_cycle(Move& move);
  ThreadCycle::Step next_step();

  Motion& motion_;
  Travel& travel_;
  Outbox& outbox_;
  SpindlePace pace_;
  ThreadCycle cycle_;
  Finish finish_;
  std::vector<ThreadCycle::Step> steps_;  // of a cycle of two blocks
  std::size_t step_ = 0;                  // the next of them
  base::AxisVector start_{};              // of the cycle; machine coordinates
  base::AxisVector end_{};
  double lead_ = 0;                           // in force in the cycle; mm
  std::optional<ThreadCycle::Step> waiting_;  // for the event before it
  bool is_behind_line_ = false;               // of a thread, with no event between
  bool in_cycle_ = false;
};

}  // namespace leadscrew::gcode
