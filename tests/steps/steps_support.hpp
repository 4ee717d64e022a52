#pragma once
// Words for tests of steps, and steps found by brute force: the cubic between words in long double, looked at in many
// places and bisected between them. Shares nothing with the room but its definitions.

#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/steps/step_generator.hpp>
#include <vector>

namespace leadscrew::steps::testing {

inline machine::Machine mill_with(double velocity, double blu, base::Period period = {}) {
  machine::Machine machine = machine::mill3();
  machine.period = period;
  for (auto& axis : machine.axes) {
    if (!axis) continue;
    axis->velocity = velocity;
    axis->blu = blu;
  }
  return machine;
}

/// Words of X alone, positions in BLU.
inline std::vector<base::Word> words_along_x(const std::vector<double>& positions, double blu) {
  std::vector<base::Word> words(positions.size());
  for (std::size_t k = 0; k < positions.size(); ++k) {
    words[k].tick = base::Tick{static_cast<std::int64_t>(k)};
    words[k].position[0] = positions[k] * blu;
  }
  return words;
}

struct Made {
  std::vector<StepEvent> events;
  StepReport report;
};

inline Made steps_of(const std::vector<base::Word>& words, const machine::Machine& machine, std::int64_t clock_hz) {
  auto generator = StepGenerator::create(machine, clock_hz).value();
  Made made;
  const auto sink = [&](std::span<const StepEvent> events) {
    made.events.insert(made.events.end(), events.begin(), events.end());
  };
  for (const base::Word& word : words) generator.follow(word, sink);
  generator.finish(sink);
  made.report = generator.report();
  return made;
}

struct Crossing {
  long double tick;  ///< not rounded
  int direction;
};

class BruteForce {
 public:
  /// `sharpest` as in reference.hpp.
  BruteForce(const std::vector<base::Word>& words, const machine::AxisLimits& limits, base::Period period,
             std::int64_t clock_hz)
      : ticks_(static_cast<long double>(period.nanoseconds) * static_cast<long double>(clock_hz) / 1e9L) {
    for (const base::Word& word : words) q_.push_back(word.position[0] / limits.blu);
    sharpest_ = 2 * limits.acceleration * period.seconds() * period.seconds() / limits.blu;
  }

  std::vector<Crossing> crossings(int looks) const {
    std::vector<Crossing> found;
    long double count = std::round(q_[0]);
    int direction = q_[0] < count ? 1 : -1;
    for (std::size_t n = 0; n + 1 < q_.size(); ++n) {
      const auto at = [&](long double x) { return cubic(n, x); };
      for (int k = 0; k < looks; ++k) {
        long double from = static_cast<long double>(k) / looks, to = static_cast<long double>(k + 1) / looks;
        while (true) {
          const long double up = count + 0.5L + (direction < 0 ? hysteresis : 0);
          const long double down = count - 0.5L - (direction > 0 ? hysteresis : 0);
          const long double there = k + 1 == looks ? q_[n + 1] : at(to);
          if (there < up && there > down) break;
          const int step = there >= up ? 1 : -1;
          const long double wanted = step > 0 ? up : down;
          long double low = from, high = to;
          for (int halving = 0; halving < 70; ++halving) {
            const long double middle = (low + high) / 2;
            (step * (at(middle) - wanted) < 0 ? low : high) = middle;
          }
          found.push_back({(static_cast<long double>(n) + high) * ticks_, step});
          count += step;
          direction = step;
          from = high;
        }
      }
    }
    return found;
  }

 private:
  static constexpr long double hysteresis = 1.0L / (1 << 20);

  long double speed(std::size_t n) const {
    const long double before = n == 0 ? 0 : q_[n] - q_[n - 1];
    const long double after = n + 1 == q_.size() ? 0 : q_[n + 1] - q_[n];
    const long double mean = (before + after) / 2, least = std::min(std::abs(before), std::abs(after));
    if (least == 0) return 0;
    if ((before > 0) == (after > 0)) return mean > 0 ? std::min(mean, 3 * least) : std::max(mean, -3 * least);
    return std::abs(after - before) <= sharpest_ ? mean : 0;
  }
  /// Hermite's four polynomials.
  long double cubic(std::size_t n, long double x) const {
    const long double y = 1 - x;
    return q_[n] * y * y * (1 + 2 * x) + q_[n + 1] * x * x * (1 + 2 * y) + speed(n) * x * y * y -
           speed(n + 1) * x * x * y;
  }

  std::vector<long double> q_;
  long double ticks_;  ///< in a period
  long double sharpest_ = 0;
};

}  // namespace leadscrew::steps::testing
