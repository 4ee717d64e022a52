#pragma once
// Along one section, from rest to rest, window by window: pieces go in, chunks of the optimal motion come out.
//
//        speed   ╭────────────╮
//               ╱│            │╲
//              ╱ │  committed │ ╲  tail
//             ╱  │            │  ╰──╌╌
//
// Each window is planned from where the last one's committed part ends, as far ahead as a window reaches, down to
// a creep from which the motion can stop. Only the first part is committed: what lies ahead of it by some times the
// distance to stop is no different from the optimum of the whole section. The rest, with a stop at its end, is the
// chunk's stop tail.
//
// A committed part may be handed out in slices, each with a tail that stops as early as can be. A change of speed asked
// for (feed override, feed hold) takes effect where the last slice ends: from there the window is planned anew, first
// down to the speed that is wanted as fast as the limits allow, then as fast as is allowed.

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/planner/effort.hpp>
#include <leadscrew/planner/motion.hpp>
#include <leadscrew/planner/plan_memory.hpp>
#include <leadscrew/planner/section.hpp>
#include <leadscrew/planner/window.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace leadscrew::planner {

class LookAhead {
 public:
  /// The machine must outlive this.
  explicit LookAhead(const machine::Machine& machine) : machine_(machine), constraints_(machine) {}

  /// What planning takes, and who may stop it: then no chunk comes any more.
  Effort& effort() { return effort_; }
  const Effort& effort() const { return effort_; }

  /// The section goes on with this piece.
  void append(const toolpath::Piece& piece);
  /// It has no more pieces.
  void close() { closed_ = true; }
  /// Ready for another section.
  void clear();
  /// Motion goes on at `s` of the section, at rest. Nothing has been planned from there on.
  void begin_at(double s);

  /// From now on the committed part of a chunk is no longer than this, s, or one interval between knots.
  void slice(double seconds) { slice_ = seconds; }
  /// Feed override: programmed feed is multiplied by `factor` ≥ 0 from where the last chunk's committed part ends. 0
  /// holds: the motion comes to rest and nothing more is planned until the factor is greater.
  void override_feed(double factor);
  /// The last chunk was refused: motion has come to rest where the tail of the one before it ends, and goes on there.
  void refuse();

  /// Of what is not yet travelled.
  const Section& section() const { return section_; }
  bool is_closed() const { return closed_; }
  /// Has nothing been planned yet?
  bool is_untouched() const { return untouched_; }
  /// Does motion rest where the next chunk begins?
  bool stands() const { return !window_ && !continuation_; }
  /// Has all been planned that there is and will be?
  bool is_done() const { return closed_ && begin_ >= section_.length(); }
  /// Was no motion found, not even over the shortest distance from rest to rest? No chunk comes any more.
  bool has_failed() const { return failed_; }

  /// The next chunk, once enough of the section is known; never again after the one that ends where the section ends.
  /// Velocity, acceleration and jerk of every axis stay inside their limits, looked at twelve times a segment or more on what
  /// the cycle will evaluate: what an optimum leaves above a limit between its knots is planned again with tightened
  /// rows.
  std::optional<Chunk> plan();
  /// Windows for which no motion was found: there the motion stopped once.
  std::int64_t refused() const { return refused_; }
  /// Sections, or rests of sections, that would have taken more effort than their motion allows: planned with lower
  /// limits.
  std::int64_t simplified() const { return simplified_; }
  /// Windows that had been planned before of the very same numbers.
  std::int64_t remembered() const { return remembered_; }
  /// Does a change of the feed wait for the next slice, or because no motion was found at once? It is tried again two
  /// segments later, then four, … sixteen. Shortly before motion comes to rest none can begin, and none waits.
  bool change_waits() const { return window_ && factor_ != planned_factor_ && may_change(); }

 private:
  bool knows_enough() const;
  std::size_t most_intervals() const;
  PlannedRange next_range() const;
  enum class Refinement : std::uint8_t { none, where_speed_changes };
  std::unique_ptr<Window> solve(Refinement refinement, const Window* before = nullptr);
  std::unique_ptr<Window> remembered_or_planned(const PlannedRange& range, const Window* before);
  std::unique_ptr<Window> settled(std::unique_ptr<Window> window);
  void solve_to_rest();
  void plan_from_rest();
  void plan_in_motion();
  bool is_overdrawn() const;
  bool lower_limits();
  const constraints::Constraints& limits() const { return gentle_ ? *gentle_ : constraints_; }
  bool may_change() const;
  void take_change();
  void go_on_from(Continuation continuation);
  void stand_at(double s);
  void forget();
  void split(Window& window) const;
  std::size_t split_at(Window& window, std::size_t next) const;
  Chunk hand_out();

  const machine::Machine& machine_;
  constraints::Constraints constraints_;
  /// Kept in its place, where planning took too much effort.
  std::optional<constraints::Constraints> gentle_;
  int lowerings_ = 0;         ///< how many times limits have been lowered on this section
  double least_balance_ = 0;  ///< of the effort: below it they are lowered
  Effort effort_;
  PlanMemory memory_;  ///< of windows with the limits of constraints_
  Section section_;
  bool closed_ = false;
  bool untouched_ = true;
  bool failed_ = false;
  double begin_ = 0;                          ///< where the next chunk begins
  double last_begin_ = 0;                     ///< where the window of the last chunk began
  double tail_end_ = 0, last_tail_end_ = 0;   ///< of the last chunk and of the one before
  std::unique_ptr<Window> window_;            ///< that is being handed out
  std::optional<Continuation> continuation_;  ///< without a window: in motion; from rest without
  double slice_ = std::numeric_limits<double>::infinity();
  double factor_ = 1, planned_factor_ = 1;  ///< of the feed: asked for, and planned with
  std::int64_t refused_ = 0, simplified_ = 0, remembered_ = 0;
  double reach_ = 0;                      ///< how far a window looks
  double fastest_ = 0;                    ///< greatest speed of the pieces so far
  double slowest_stop_ = 0;               ///< longest time to stop from it
  std::bitset<base::axis_count> moving_;  ///< axes that the pieces so far move
  bool is_of_least_time_ = false;         ///< is any piece so far?
};

}  // namespace leadscrew::planner
