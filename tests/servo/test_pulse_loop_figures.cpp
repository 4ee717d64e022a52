// The closed loop of the lecture's problem 13.1, as it runs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loops.hpp"

namespace leadscrew::servo::testing {
namespace {

/// What a run of N pulses at a constant rate shows, the first after one interval.
struct Observed {
  double mean = 0;         ///< of UDC over time, second 5 … 25
  double rate = 0;         ///< of the encoder in the same time, pulses/s
  std::int64_t least = 0;  ///< of UDC in the same time
  std::int64_t most = 0;
  double settled = 0;  ///< seconds: PDC and UDC are 0 and the screw is slower than a pulse a second
};

class Observer {
 public:
  Observer(PulseLoop& loop, int rate) : loop_(loop), rate_(rate) { seen_.least = 1 << 30; }

  Observed run() {
    for (int k = 1; loop_.to_come() > 0; ++k) {
      run_until(static_cast<double>(k) / rate_);
      loop_.pulse(1);
    }
    while (!(loop_.following_error() == 0 && std::fabs(loop_.velocity()) < 1)) run_until(time_ + 1e-4);
    seen_.settled = time_;
    seen_.mean /= 20;
    seen_.rate /= 20;
    return seen_;
  }

 private:
  void run_until(double time) {
    while (time_ < time) {
      const auto udc = loop_.following_error();
      const auto passed = loop_.run(time - time_);
      look(static_cast<double>(udc), passed);
      time_ = passed.encoder_pulse == 0 ? time : time_ + passed.seconds;
    }
  }

  void look(double udc, const PulseLoop::Passed& passed) {
    const double from = std::max(time_, 5.0), to = std::min(time_ + passed.seconds, 25.0);
    if (to < from) return;
    seen_.mean += udc * (to - from);
    seen_.rate += passed.encoder_pulse;
    if (to == from) return;
    seen_.least = std::min(seen_.least, static_cast<std::int64_t>(udc));
    seen_.most = std::max(seen_.most, static_cast<std::int64_t>(udc));
  }

  PulseLoop& loop_;
  int rate_;
  double time_ = 0;
  Observed seen_;
};

/// 30 mm at 60 mm/min with a pitch of 4 mm and 200 holes: 1500 pulses of 0.02 mm at 50 a second. UDC = f/Kv.
TEST(PulseLoopFigures, OfTheLectureAtAGainOf20) {
  PulseLoop loop = made(options_with(20, 0.02));
  loop.load(1500);
  const Observed seen = Observer(loop, 50).run();
  EXPECT_NEAR(seen.mean, 2.5, 0.005);
  EXPECT_NEAR(seen.rate, 50, 0.05 + 1e-9);
  EXPECT_EQ(seen.least, 2);
  EXPECT_EQ(seen.most, 3);
  EXPECT_NEAR(seen.settled, 30.13, 0.005);
  EXPECT_EQ(loop.commanded(), 1500);
  EXPECT_EQ(loop.encoder_count(), 1500);
  EXPECT_EQ(loop.overflows(), 0);
}

TEST(PulseLoopFigures, OfTheLectureAtAGainOf5) {
  PulseLoop loop = made(options_with(5, 0.02));
  loop.load(1500);
  const Observed seen = Observer(loop, 50).run();
  EXPECT_NEAR(seen.mean, 10, 0.005);
  EXPECT_NEAR(seen.rate, 50, 0.05 + 1e-9);
  EXPECT_NEAR(static_cast<double>(seen.most), 10, 1);
  EXPECT_NEAR(seen.settled, 30.56, 0.005);
  EXPECT_EQ(loop.encoder_count(), 1500);
}

}  // namespace
}  // namespace leadscrew::servo::testing
