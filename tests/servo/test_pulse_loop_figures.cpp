// The closed loop of the lecture's problem 13.1, as it runs; and the contours of two of them beside their closed forms.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/servo/contour.hpp>
#include <numbers>

#include "loops.hpp"

namespace leadscrew::servo::testing {
namespace test_pulse_loop_figures {

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

constexpr double speed = 20, radius = 10, blu = 1e-3;  // mm/s, mm
constexpr double settled = 1;                          // s: e⁻²⁰ of the start is left
constexpr double pi = std::numbers::pi;

struct Place {
  double x = 0, y = 0;
};

/// One axis whose pulses round a path to whole BLU, looked at every 5 µs.
class Slide {
 public:
  static constexpr double tick = 5e-6;

  explicit Slide(const PositionLoop& loop) : loop_(made(options(loop))) { loop_.load(1 << 30); }

  void follow(double due) {
    const std::int64_t count = std::llround(due / blu);
    while (loop_.commanded() != count) loop_.pulse(loop_.commanded() < count ? 1 : -1);
    loop_.run_through(tick);
  }
  double position() const { return (loop_.position() - 0.5) * blu; }

 private:
  static PulseLoopOptions options(const PositionLoop& loop) {
    PulseLoopOptions options = options_with(loop.gain, loop.time_constant);
    options.start = 0.5;
    return options;
  }

  PulseLoop loop_;
};

/// Half a BLU of the pulses, a tick that they come late, half a BLU of the encoder; as far as the loop passes it on.
double coarseness(const PositionLoop& loop) {
  return greatest_gain(loop) * (blu + speed * Slide::tick);
}

template <class Path, class Look>
void travel(Path&& place, double seconds, const PositionLoop& of_x, const PositionLoop& of_y, Look&& look) {
  Slide x(of_x), y(of_y);
  const auto ticks = static_cast<int>(seconds / Slide::tick);
  for (int k = 0; k < ticks; ++k) {
    const double time = k * Slide::tick;
    const Place due = place(time);
    x.follow(due.x);
    y.follow(due.y);
    if (time > settled) look(Place{x.position(), y.position()});
  }
}

constexpr PositionLoop slow{20, 0.02}, fast{25, 0.02}, prompt{20, 0.001};

/// At every instant, though the slide goes from count to count: (V/2) sin 2α (1/Kx − 1/Ky), 100 µm at 45°. Gains that
/// are swapped, or off by 2 %, are far beyond.
TEST(PulseLoopFigures, OfALineUnderUnequalGains) {
  for (const double angle : {pi / 6, pi / 4}) {
    const double c = std::cos(angle), s = std::sin(angle);
    const double expected = speed / 2 * std::sin(2 * angle) * (1 / slow.gain - 1 / fast.gain);
    const double accuracy = s * coarseness(slow) + c * coarseness(fast);
    double least = 1, most = -1;
    travel([&](double time) { return Place{speed * time * c, speed * time * s}; }, 1.5, slow, fast,
           [&](const Place& here) {
             least = std::min(least, c * here.y - s * here.x);
             most = std::max(most, c * here.y - s * here.x);
           });
    EXPECT_NEAR(least, expected, accuracy);
    EXPECT_NEAR(most, expected, accuracy);
    EXPECT_GT(std::fabs(most - line_contour_error(speed, angle, fast, slow)), 50 * accuracy);
    EXPECT_GT(std::fabs(most - line_contour_error(speed, angle, {20.4, 0.02}, fast)), 3 * accuracy);
  }
}

SemiAxes circle_under(const PositionLoop& x, const PositionLoop& y) {
  const double frequency = speed / radius;
  SemiAxes seen{0, 2 * radius};
  travel([&](double time) { return Place{radius * std::cos(frequency * time), radius * std::sin(frequency * time)}; },
         settled + pi / frequency, x, y,
         [&](const Place& here) {
           seen.major = std::max(seen.major, std::hypot(here.x, here.y));
           seen.minor = std::min(seen.minor, std::hypot(here.x, here.y));
         });
  return seen;
}

TEST(PulseLoopFigures, OfACircle) {
  for (const auto& [x, y] : {std::pair{slow, slow}, {prompt, prompt}, {slow, fast}, {fast, slow}}) {
    const SemiAxes seen = circle_under(x, y), expected = circle_semi_axes(radius, speed / radius, x, y);
    const double accuracy = std::hypot(coarseness(x), coarseness(y));
    EXPECT_NEAR(seen.major, expected.major, accuracy);
    EXPECT_NEAR(seen.minor, expected.minor, accuracy);
  }
}

/// R·ω²/(2Kv²) leaves out τ: of 50 µm there are 10 with Kv·τ = 0.4, and 48 with 0.02.
TEST(PulseLoopFigures, OfACircleAreTheTextbooksOnlyWhereTheTimeConstantIsSmall) {
  const double textbook = speed * speed / radius / (2 * 20 * 20);
  EXPECT_NEAR(radius - circle_under(prompt, prompt).minor, textbook, 0.04 * textbook + 2 * blu);
  EXPECT_GT(std::fabs(radius - circle_under(slow, slow).minor - textbook), 0.7 * textbook);
}

}  // namespace test_pulse_loop_figures
}  // namespace leadscrew::servo::testing
