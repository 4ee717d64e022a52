#pragma once
// What comes after a chunk, decided by two threads without a lock. The planner says "followed", the cycle "closed"; the
// compare-and-swap that succeeds first decides, and the other side sees it fail:
//
//             planner: follow()            cycle: claim()
//   followed ◀───────────────── open ─────────────────▶ closed
//       ▲                                                 │
//       └──────── planner: follow_at_rest() ──────────────┘
//
// What has been closed has come to rest: only what begins at rest may follow it.

#include <atomic>
#include <cstdint>

namespace leadscrew::interpolator {

/// Atomic: std::atomic, or what a test of every interleaving puts in its place.
template <template <class> class Atomic = std::atomic>
class Succession {
 public:
  enum class State : std::uint8_t { open, followed, closed };

  // The planner's.

  /// Of a chunk that the cycle does not see yet.
  void reset(bool is_followed) { state_.store(is_followed ? State::followed : State::open, std::memory_order_relaxed); }
  /// Has the cycle found no successor? Not false again before reset() or follow_at_rest().
  bool is_closed() const { return state_.load(std::memory_order_relaxed) == State::closed; }
  /// A successor that goes on with the motion is released to the cycle. False if motion has come to an end.
  bool follow() {
    State expected = State::open;
    return state_.compare_exchange_strong(expected, State::followed, std::memory_order_release,
                                          std::memory_order_relaxed);
  }
  /// A successor that begins at rest is released, whether the cycle has closed this or not: it looks again for as long
  /// as it stands.
  void follow_at_rest() { state_.store(State::followed, std::memory_order_release); }

  // The cycle's.

  /// The chunk has ended: is there a successor? If not, none that goes on with its motion can come any more.
  bool claim() noexcept {
    State state = State::open;
    const bool nothing_follows = state_.compare_exchange_strong(state, State::closed, std::memory_order_acquire);
    return !nothing_follows && state == State::followed;
  }

 private:
  Atomic<State> state_{State::open};
};

static_assert(std::atomic<Succession<>::State>::is_always_lock_free);

}  // namespace leadscrew::interpolator
