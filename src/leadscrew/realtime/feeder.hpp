#pragma once
// The planner's side of the hand-over: takes chunks from where motion comes from and offers them to the cycle, as far
// ahead of it as it is told to be.
//
// A planner that is slow must not make itself slower. A chunk that comes too late is lost with the window that it is
// part of: motion has stopped, and is planned anew from rest, which takes longest. Were the first slice from rest
// handed over at once, the second would soon be late again. So after a late chunk motion waits at rest until more is
// planned, twice as much each time, and all that is handed over at once:
//
//   late            late                          handed over together
//    │▁▁▁▁▁┌─┐▁▁▁▁▁▁│▁▁▁▁▁▁▁▁▁▁▁▁▁▁┌──────┐▁ ···   ┌─┬─┬─┬─┬─┬─┐
//    planning 0.3 s  planning 0.6 s of motion      held: never late, for it begins at rest
//
// Nor must it be so far ahead that nobody can intervene: where it is in time, it plans less far (look_ahead.hpp), in
// shorter slices.
//
// Where moves come from somebody who may be slow, motion must neither be cut up for want of the next move, nor wait for
// ever for one that does not come. It begins once 2 s of motion are planned, or nothing came for 0.1 s (Planning::enough_to_begin,
// quiet_to_begin). On the way it waits for the next move as long as it can: only when less than 30 ms of motion are left is
// the end of the last move made a place of rest.

#include <cstdint>
#include <functional>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/interpolator/controller.hpp>
#include <leadscrew/planner/motion.hpp>
#include <leadscrew/realtime/look_ahead_time.hpp>
#include <optional>
#include <vector>

namespace leadscrew::realtime {

/// There is no chunk as it is not known yet what follows.
struct Drought {
  bool is_open = false;  ///< are there moves behind the last place of rest that was asked for?
  double quiet = 0;      ///< s since the last move came
};

/// Where motion comes from; called by the planner's thread alone.
struct Planning {
  std::function<std::optional<planner::Chunk>()> next;  ///< none: the motion is held, or it has ended
  std::function<void()> refuse;                         ///< the last chunk came too late
  std::function<void(double)> override_feed;            ///< 0 … 2
  /// So fast the spindle turns that the cycle follows, revolutions per minute, either way. Absent: it follows none.
  std::function<void(double)> spindle_turns = {};
  /// May motion go on with this chunk, which begins at rest? While not, it waits there. Absent: always.
  std::function<bool(const planner::Chunk&)> lets = {};
  /// From now on chunks are to be about so long, s. Absent: they are as they come.
  std::function<void(double)> slice = {};
  /// Of moves that somebody gives: was there no chunk for want of them? Absent, or none: motion is held, or has ended.
  std::function<std::optional<Drought>()> drought = {};
  /// Motion is to rest where the moves end that are known by now. Goes with `drought`.
  std::function<void()> end_for_now = {};
  /// Motion is to come to rest and end, whatever the program says of overrides (planner::Planner::come_to_rest).
  /// Absent: override_feed(0) does it.
  std::function<void()> come_to_rest = {};
  /// Is motion held? A program may not let override_feed(0) hold it (M53), or come to where it does. Absent: it is by
  /// override_feed(0).
  std::function<bool()> is_held = {};
  /// s ≥ 0 that the last next() has taken, by a clock: what is planned before motion begins then tells how far ahead is enough.
  /// Absent: it begins as far as it may be.
  std::function<double()> took = {};
  /// s ≥ 0 for which no move has come, at rest, until motion begins along those there are. Goes with `drought`.
  double quiet_to_begin = 0.1;
  /// s ≥ 0 of motion that are planned before any of it begins, and handed over together, unless it is quiet before. Goes with
  /// `drought`.
  double enough_to_begin = 2;
};

/// Keeps the cycle supplied: plans as far ahead of it as look_ahead_time.hpp says, and hands chunks over.
class Feeder {
 public:
  /// So far it looks ahead after chunks that were late, s.
  static constexpr double farthest = 4;

  /// look_ahead: s of motion that the cycle has not begun; where the planner is in time as little as
  /// `least_look_ahead`. Both must outlive it; one thread calls everything.
  Feeder(const Planning& planning, interpolator::Controller& controller, double look_ahead, double least_look_ahead)
      : planning_(planning),
        controller_(controller),
        farthest_look_ahead_(look_ahead),
        look_ahead_(least_look_ahead, look_ahead) {}
  /// The same, as far at all times.
  Feeder(const Planning& planning, interpolator::Controller& controller, double look_ahead)
      : Feeder(planning, controller, look_ahead, look_ahead) {}

  /// What is asked for from now on: the feed's factor, 0 … 2, or to come to rest and end.
  void request(double factor, bool stop);
  /// By so many seconds the cycle woke up late, at most.
  void cycle_was_late(double by) { look_ahead_.cycle_was_late(by); }
  /// Takes a chunk or hands some over. False where nothing can be done but wait.
  bool step();

  /// Has it taken chunks that the cycle has not been given?
  bool holds_chunks() const { return !held_.empty() || after_; }
  /// Number of the last chunk, once it is known.
  std::optional<std::int64_t> last_chunk() const { return last_; }
  /// Why motion ends although more would come: `travel-unchecked`, of a chunk that the controller refused.
  const std::optional<base::Diagnostic>& failure() const { return failure_; }
  /// Chunks that came after the motion they continue had been stopped.
  std::int64_t late_chunks() const { return late_chunks_; }
  /// s of motion that is to be planned and not begun.
  double look_ahead() const { return look_ahead_.seconds(); }

 private:
  bool wants_more() const;
  bool is_held() const;
  void set_slice();
  bool is_held_back() const { return held_back() > 0 && !in_motion_; }
  double held_back() const;
  bool wait_for_moves(const Drought& drought);
  bool take_next();
  bool hand_over();
  void settle_patience();

  const Planning& planning_;
  interpolator::Controller& controller_;
  const double farthest_look_ahead_;
  LookAheadTime look_ahead_;
  std::optional<double> ahead_before_;  ///< s planned and not begun, when the next chunk was asked for
  double slice_ = 0;                    ///< s, asked for
  std::vector<planner::Chunk> held_;    ///< taken, not yet accepted: one, or from rest on what is handed over together
  double held_seconds_ = 0;
  std::optional<planner::Chunk> after_;  ///< begins at rest behind those
  double patience_ = 0;                  ///< s of motion that are held back at rest
  double since_late_ = 0;                ///< s of motion accepted
  double factor_ = 1;
  bool stopping_ = false;
  bool in_motion_ = false;  ///< does the last accepted chunk end in motion?
  bool has_ended_ = false;  ///< does nothing follow those held?
  std::int64_t accepted_ = 0, late_chunks_ = 0;
  std::optional<std::int64_t> last_;
  std::optional<base::Diagnostic> failure_;
};

}  // namespace leadscrew::realtime
