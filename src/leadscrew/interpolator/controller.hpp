#pragma once
// The cycle beside a planner in a thread of its own: chunks are handed over without a lock, and no word waits for them.
//
//                     ring of links, in the order of motion
//   planner            +--------+   +--------+   +--------+            cycle
//   offer() ─────────▶ | chunk  |◀──| chunk  |◀──| chunk  | ◀───────── next(), once a servo period
//   frees what the     | follow |   | follow |   | follow |            moves its position on
//   cycle has left     +--------+   +--------+   +--------+
//
// Each link says of its chunk what comes after it: `open` (nobody knows yet), `followed` (the next link of the ring) or
// `closed` (the cycle found nothing and brought the machine to rest). When a committed part ends, the cycle claims the
// link with one compare-and-swap, open → closed: if that fails there is a successor, and the motion goes on; if it
// succeeds the stop tail runs. The planner appends with open → followed: if that fails, the motion that the new chunk
// was to continue is over, and the chunk is late. The one that succeeds first decides; the other side sees it fail
// (succession.hpp). A chunk that begins at rest is never late: it follows whenever the machine stands.
//
// Memory orders. A link is written by the planner and then released by the store or compare-and-swap to `followed` in
// the link before it; the cycle's compare-and-swap acquires it. The cycle's last look at a link is before its release
// store of how many it has left, which the planner acquires before it writes the link again: one whose events belong to
// the last word is left with the next. Nothing else is shared but figures
// for the planner to look at.
//
// Memory is taken by the constructor and by the planner; what chunks hold is freed by the planner's thread when a link
// is used again, or by the destructor.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <leadscrew/interpolator/interpolator.hpp>
#include <leadscrew/interpolator/succession.hpp>
#include <memory>
#include <span>

namespace leadscrew::interpolator {

/// One thread, the cycle's, calls next(); one other, the planner's, calls everything else. Both have ended when it is
/// destroyed.
class Controller {  // NOLINT(clang-analyzer-optin.performance.Padding): kept apart by lines of the cache
 public:
  /// Stands at `position`, behind so much of the path and in this line of the program. capacity: chunks held at a time,
  /// the one in motion included, ≥ 2.
  Controller(base::Period period, const base::AxisVector& position, std::size_t capacity = 8, double path_length = 0,
             base::Line line = {});
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  /// The cycle: the word of this tick. It neither allocates nor frees, locks, throws nor reads a clock, and goes
  /// through capacity − 1 new chunks at most. Motion from rest begins with the word after the one that stood.
  base::Word next() noexcept;
  /// The cycle: the next event of the period that ends with the last word, in order: what motion has passed since the
  /// word before, once each, never early. None where there is no more. Good until the next call of next(), which passes
  /// over those that were not taken.
  const planner::PlacedEvent* next_event() noexcept;

  /// The cycle's: a copy of itself that goes on as this would if no chunk followed the one in motion. Good until the
  /// next call of next().
  Interpolator onward() const noexcept {
    Interpolator copy = interpolator_;
    copy.leave_step();
    return copy;
  }
  /// The cycle's: motion in step with the spindle, if there is any now, comes to rest as soon as the limits allow, and
  /// ends; chunks behind it are not begun.
  void leave_step() noexcept { interpolator_.leave_step(); }
  /// The cycle's: does it rest there?
  bool has_left_step() const noexcept { return interpolator_.has_left_step(); }
  /// Before the first word: threads follow this spindle.
  void follow(const machine::Spindle& spindle) { interpolator_.follow(spindle); }
  /// Is motion on a line in step with the spindle?
  bool is_in_step() const { return in_step_.load(std::memory_order_relaxed); }
  /// So fast the spindle turned behind the last word, revolutions per minute, either way; 0 where none is followed.
  double spindle_speed() const { return spindle_speed_.load(std::memory_order_relaxed); }
  /// Of the lines in step so far; while there are words, each figure for itself.
  ThreadFigures threads() const;

  /// What became of a chunk.
  enum class Offer : std::uint8_t {
    accepted,
    full,       ///< all links are in use: offer it again when the cycle has moved on
    unchecked,  ///< a piece of it has not been found inside travel (toolpath::check_travel): never offer it again
    late,       ///< the motion it continues has been stopped: plan anew from the last accepted chunk's `rest`, at rest
  };
  /// Hands over the chunk that comes after the last accepted one; moved from only if accepted. One that begins at rest
  /// follows when the one before has come to rest, by its tail if it has one. One that begins in motion after a chunk
  /// that ends at rest is late.
  Offer offer(planner::Chunk& chunk) { return offer(std::span(&chunk, 1)); }
  /// Hands over several at once: the cycle sees all of them or none. Each but the first goes on with the motion of the
  /// one before. At least one.
  Offer offer(std::span<planner::Chunk> chunks);

  /// Chunks that it holds at most.
  std::size_t capacity() const { return capacity_; }

  /// Committed motion, dwells included, that was accepted and that the cycle has not begun, seconds; nothing of the
  /// chunk in motion. Of lines in step with the spindle the time that they would take at the speed of S.
  double seconds_ahead() const;
  /// Has a word at rest been given after the end of everything accepted?
  bool idle() const;
  /// Did the last word stand at rest because all motion had ended? Not in a dwell.
  bool stands() const { return stands_.load(std::memory_order_relaxed); }
  /// How many accepted chunks the cycle has begun.
  std::int64_t begun() const { return position_.load(std::memory_order_acquire); }
  /// How many times a stop tail was entered because nothing followed.
  std::int64_t starvations() const { return starvations_.load(std::memory_order_relaxed); }

 private:
  // What two threads write to lies apart by a line of the cache, or each write would take it from the other.
  static constexpr std::size_t cache_line = 64;

  struct alignas(cache_line) Link {
    planner::Chunk chunk;
    double committed_seconds = 0;  ///< of this chunk and all before it; the planner's
    Succession<> succession;
    std::size_t events_passed = 0;  ///< of the chunk, when the cycle has left it; the cycle's
  };
  static_assert(std::atomic<std::int64_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

  Link& link(std::int64_t number) const { return links_[static_cast<std::size_t>(number) % capacity_]; }
  bool go_on() noexcept;
  void tell_threads() noexcept;
  std::size_t events_passed(std::int64_t number) const noexcept;
  bool append(Link& last, bool begins_at_rest);

  const std::size_t capacity_;
  const std::unique_ptr<Link[]> links_;  ///< chunk n in link n % capacity; n = 0 is standing at the start

  // The planner's.
  std::int64_t accepted_ = 0;  ///< number of the last accepted chunk

  // The cycle's.
  alignas(cache_line) Interpolator interpolator_;
  std::int64_t current_ = 0;     ///< number of the chunk in motion
  std::int64_t event_link_ = 0;  ///< number of the chunk that holds the next event
  std::size_t event_ = 0;        ///< index of that there

  // Told by the cycle to the planner.
  alignas(cache_line) std::atomic<std::int64_t> position_{0};  ///< current_, when the call has ended
  std::atomic<std::int64_t> left_{0};                          ///< event_link_, then: chunks before it are done with
  std::atomic<std::int64_t> starvations_{0};
  std::atomic<bool> stands_{true}, in_step_{false};
  std::atomic<std::int64_t> thread_lines_{0}, out_of_step_{0};
  std::atomic<double> run_in_{0}, spindle_speed_{0};
  std::atomic<base::Line> run_in_line_{base::Line{}}, out_of_step_line_{base::Line{}};
  static_assert(std::atomic<double>::is_always_lock_free && std::atomic<base::Line>::is_always_lock_free);
};

}  // namespace leadscrew::interpolator
