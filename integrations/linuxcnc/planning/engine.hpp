#pragma once
// Motion from one place where it was set down: path, planner and the controller that the servo thread asks.
//
// Moves may be slow to come: motion begins once moves are there that take 2 s at their speeds, or none came for a while, and
// comes to rest where they end only when less than 30 ms of motion are left (realtime::Feeder). Until it begins nothing is
// planned, so that no more is settled ahead than while it lasts.

#include <cstdint>
#include <functional>
#include <leadscrew/controller.hpp>
#include <leadscrew/diagnostic.hpp>
#include <leadscrew/machine.hpp>
#include <leadscrew/motion.hpp>
#include <leadscrew/motion_source.hpp>
#include <leadscrew/realtime.hpp>
#include <string>

#include "kinematics.hpp"
#include "link.hpp"
#include "speeds_ahead.hpp"

namespace leadscrew::linuxcnc {

/// "arc-radius: arc radius is 0; both ends lie on one circle around the centre".
std::string told(const base::Diagnostic& diagnostic);
/// The machine that these limits describe, or that of the kinematics, with no more jerk than these allow; without ends of travel,
/// for these are LinuxCNC's. Codes: those of machine::validate().
base::Result<machine::Machine> machine_of(const leadscrew_tp_limits& limits, const leadscrew_tp_options& options,
                                          std::int64_t period_ns, const Kinematics& kinematics);
/// The move behind a start, mm or degrees, on the machine; with rotary axes that make its kinematics, of the tip of a tool so long,
/// mm. Codes: those of host::put_behind().
base::Result<gcode::Move> move_of(const leadscrew_tp_move& asked, const Position& start,
                                  const machine::Machine& machine, double tool);

/// What is asked of motion now.
struct Wanted {
  double factor = 1;            ///< of the feed, 0 … 2
  double top_speed = 0;         ///< leadscrew_tp_wishes::top_speed
  std::uint32_t in_motion = 0;  ///< number of the move that motion has come to
};

/// The thread of planning's, but for controller().next(). The machine is sound (machine::validate).
class Engine {
 public:
  /// From this pose, with a tool so long, mm. Planning is broken off once `ends` says so, which is asked every few milliseconds.
  Engine(machine::Machine machine, const Kinematics& kinematics, const Position& pose, double tool,
         const leadscrew_tp_options& options, std::function<bool()> ends);
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// The next move. Codes: those of move_of(); nothing is changed then.
  base::Result<void> push(const leadscrew_tp_move& asked);
  /// Motion is to rest where the moves so far end.
  void end_for_now();
  /// Plans, or hands motion over. False where there is nothing to do but wait.
  bool step(const Wanted& wanted, bool abort);

  /// Is there a move behind the last place of rest that was asked for?
  bool is_open() const { return is_open_; }
  /// Does motion rest where all moves end?
  bool is_settled() const;
  /// Why motion ends before its moves do; empty where it does not.
  std::string failure() const;
  /// Chunks that came too late.
  std::int64_t late_chunks() const { return feeder_.late_chunks(); }
  /// What the servo thread asks for words.
  interpolator::Controller& controller() { return controller_; }
  /// The same.
  const interpolator::Controller& controller() const { return controller_; }
  /// Of all words.
  const machine::Machine& machine() const { return machine_; }

 private:
  realtime::Planning planning();
  pipeline::Supply give(gcode::Move& move);
  double quiet() const;

  const machine::Machine machine_;
  const double tool_;
  const leadscrew_tp_options options_;
  host::MoveQueue moves_;
  pipeline::MotionSource source_;
  interpolator::Controller controller_;
  const realtime::Planning planning_;
  realtime::Feeder feeder_;
  SpeedsAhead speeds_;
  double factor_ = 1;  ///< of the feed, in force
  bool is_open_ = false;
  bool has_begun_ = false;      ///< to plan what is open
  double waiting_ = 0;          ///< s that the moves take at their speeds which are open and were not begun
  std::int64_t last_came_ = 0;  ///< ns
  double took_ = 0;             ///< s, to plan the last chunk
};

}  // namespace leadscrew::linuxcnc
