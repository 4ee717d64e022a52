#pragma once
// The digital integrator (DDA): each addition of the integrand p to the remainder r overflows the capacity q as often
// as p/q says.

#include <leadscrew/pulse/pulse.hpp>

namespace leadscrew::pulse {

template <typename Register>
class BasicIntegrator {
 public:
  constexpr BasicIntegrator() = default;
  /// capacity: q > 0, as many as an n-bit register has values (2ⁿ) or any other. preload: 0 ≤ r < q,
  /// or −1, with which it overflows as one does that begins empty and only overflows at r > q.
  constexpr BasicIntegrator(Register capacity, Register preload) : capacity_(capacity), remainder_(preload) {}

  /// Does it overflow? 0 ≤ integrand. With an integrand above the capacity the remainder grows: at most one pulse a
  /// clock.
  constexpr bool add(Register integrand) {
    remainder_ = static_cast<Register>(remainder_ + integrand);
    const bool overflows = remainder_ >= capacity_;
    remainder_ = static_cast<Register>(remainder_ - (overflows ? capacity_ : 0));
    return overflows;
  }

  constexpr Register capacity() const { return capacity_; }
  constexpr Register remainder() const { return remainder_; }

 private:
  Register capacity_ = 1, remainder_ = 0;
};
using Integrator = BasicIntegrator<std::int64_t>;

/// What the remainders hold at first. Empty ones are what Koren's program has and what a cleared register holds; half
/// full ones halve the error of a line, for they round where empty ones cut off.
enum class Preload : std::uint8_t {
  none,          ///< 0
  half,          ///< ⌊q/2⌋
  half_lagging,  ///< ⌊q/2⌋ in the axis whose integrand is the smaller one at the start, 0 in the other
  full,          ///< q − 1
  minus_one,     ///< −1: those that begin empty and only overflow at r > q, as the papers' text has it
};

template <typename Register>
constexpr Register preloaded(Preload preload, Register capacity, bool is_lagging) {
  switch (preload) {
    case Preload::half:
      return static_cast<Register>(capacity / 2);
    case Preload::half_lagging:
      return static_cast<Register>(is_lagging ? capacity / 2 : 0);
    case Preload::full:
      return static_cast<Register>(capacity - 1);
    case Preload::minus_one:
      return static_cast<Register>(-1);
    case Preload::none:
      break;
  }
  return 0;
}

/// Feed: a clock, divided. Koren's program has q0 = 3000 and f = 100·V0 for V0 in inches a minute, so that the clock of
/// 5000 a second gives 30 in/min at one command an interrupt.
class FeedDda {
 public:
  /// 0 ≤ word ≤ capacity
  constexpr FeedDda(std::int64_t capacity, std::int64_t word) : word_(word), integrator_(capacity, 0) {}

  /// Is there a command at this clock?
  constexpr bool step() { return integrator_.add(word_); }
  /// Feed override: from now on.
  constexpr void feed(std::int64_t word) { word_ = word; }

  constexpr std::int64_t word() const { return word_; }
  constexpr std::int64_t remainder() const { return integrator_.remainder(); }

 private:
  std::int64_t word_;
  Integrator integrator_;
};

}  // namespace leadscrew::pulse
