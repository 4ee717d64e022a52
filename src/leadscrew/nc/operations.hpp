#pragma once
// What a routine of the NC program has done, counted in the instructions of a computer with one accumulator: Koren's
// paper gives its program 85 of them, 2 µs each, in an interrupt that comes every 200 µs.

#include <cstdint>

namespace leadscrew::nc {

struct Operations {
  std::int64_t loads = 0;      ///< of a word into the accumulator
  std::int64_t additions = 0;  ///< or subtractions
  std::int64_t tests = 0;      ///< comparison, or test for zero or sign, with its jump
  std::int64_t stores = 0;     ///< of the accumulator, or a command to an axis

  constexpr std::int64_t total() const { return loads + additions + tests + stores; }

  constexpr Operations& operator+=(const Operations& other) {
    loads += other.loads;
    additions += other.additions;
    tests += other.tests;
    stores += other.stores;
    return *this;
  }
  friend constexpr bool operator==(const Operations&, const Operations&) = default;
};

/// Over many interrupts.
struct OperationCount {
  std::int64_t interrupts = 0;
  Operations sum;
  std::int64_t worst = 0;  ///< operations of one interrupt

  constexpr void add(const Operations& of_interrupt) {
    ++interrupts;
    sum += of_interrupt;
    if (of_interrupt.total() > worst) worst = of_interrupt.total();
  }
  constexpr double mean() const {
    return interrupts == 0 ? 0 : static_cast<double>(sum.total()) / static_cast<double>(interrupts);
  }
};

}  // namespace leadscrew::nc
