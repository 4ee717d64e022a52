#include <algorithm>
#include <cmath>
#include <leadscrew/servo/contour.hpp>
#include <leadscrew/servo/pulse_loop.hpp>
#include <leadscrew/servo/pulse_servo.hpp>
#include <leadscrew/study/studies.hpp>
#include <numbers>
#include <string>
#include <utility>

// What closed loops make of an interpolator's output: the pulse-driven axis of "Interpolators linear", lecture 12,
// problem 13.1, as it runs; and the contours of two such axes beside their closed forms.

namespace leadscrew::study {

namespace {

constexpr double time_constant = 0.02;  // s, of motor and tachogenerator

/// What a run of pulses at a constant rate shows, the first after one interval.
struct Observed {
  double mean = 0;         ///< of the up-down counter over the time that is looked at
  double rate = 0;         ///< of the encoder in the same time, pulses/s
  std::int64_t count = 0;  ///< of the encoder, at the end
  std::int64_t lost = 0;   ///< pulses
  double settled = 0;      ///< seconds: nothing is to come, the counter is 0 and the screw slower than a pulse a second
  static constexpr double from = 5, to = 25;  ///< seconds that are looked at
};

class Observer {
 public:
  Observer(servo::PulseLoop loop, double rate) : loop_(loop), rate_(rate) {}

  Observed run(std::int64_t pulses) {
    loop_.load(pulses);
    for (std::int64_t k = 1; loop_.to_come() > 0; ++k) {
      run_until(static_cast<double>(k) / rate_);
      loop_.pulse(1);
    }
    constexpr double tick = 1e-4;
    const double latest = time_ + 60;
    const auto rests = [&] { return loop_.following_error() == 0 && std::abs(loop_.velocity()) < 1; };
    while (!rests() && time_ < latest) run_until(time_ + tick);
    seen_.settled = time_;
    seen_.count = loop_.encoder_count();
    seen_.lost = loop_.lost();
    seen_.mean /= Observed::to - Observed::from;
    seen_.rate /= Observed::to - Observed::from;
    return seen_;
  }

 private:
  void run_until(double time) {
    while (time_ < time) {
      const auto counter = static_cast<double>(loop_.following_error());
      const servo::PulseLoop::Passed passed = loop_.run(time - time_);
      const double end = passed.encoder_pulse == 0 ? time : time_ + passed.seconds;
      const double seen_from = std::max(time_, Observed::from), seen_to = std::min(end, Observed::to);
      if (seen_to > seen_from) seen_.mean += counter * (seen_to - seen_from);
      if (Observed::from <= end && end < Observed::to) seen_.rate += passed.encoder_pulse;
      time_ = end;
    }
  }

  servo::PulseLoop loop_;
  double rate_;
  double time_ = 0;
  Observed seen_;
};

/// 30 mm at 60 mm/min; a screw of 4 mm and an encoder of 200 holes: 1500 pulses of 0.02 mm, 3000 a minute.
constexpr double steady_pps = 3000.0 / 60;
constexpr std::int64_t block_pulses = 1500;
constexpr Published lecture_rate(steady_pps, {Paper::linear_interpolators, "problem 13.1, answer, by 3000 ppm"}),
    lecture_pulses(block_pulses, {Paper::linear_interpolators, "problem 13.1, answer"});

/// At rest after so many seconds, as expected.
Rows pulse_rows(double gain, Reference encoder_rate, Reference encoder_pulses, double settled) {
  servo::PulseLoopOptions options{
      .converter = 10.0 / 256, .amplifier = 4, .holes = 200, .time_constant = time_constant};
  options.motor = gain / (options.converter * options.amplifier * options.holes);
  const std::string group = "pulse-driven axis, Kv " + decimal(gain, 0) + " 1/s, 3000 pulses/min, 1500 pulses";
  const base::Result<servo::PulseLoop> loop = servo::PulseLoop::create(options);
  if (!loop) return under(group, {not_run_row("run", loop.error().message)});
  const Observed seen = Observer(*loop, steady_pps).run(block_pulses);
  return under(group,
               {because(reproduced_row("up-down counter", {"pulses", 2}, steady_pps / gain, seen.mean, 0.005),
                        "f/Kv; its mean over 20 s"),
                because(reproduced_row("rate of the encoder", {"pps", 2}, encoder_rate, seen.rate, 0.05),
                        "at steady state as many as the interpolator gives; one pulse in 20 s is 0.05"),
                exact_row("pulses of the encoder", {"", 0}, encoder_pulses, static_cast<double>(seen.count)),
                limit_row("pulses lost", {"", 0}, 0, static_cast<double>(seen.lost)),
                because(exact_row("at rest after", {"s", 2}, settled, seen.settled),
                        "N/f and some times 1/Kv: no more to come, the counter 0, slower than a pulse a second")});
}

struct SlidePosition {
  double x = 0, y = 0;
};

constexpr double speed = 20;          // mm/s
constexpr double encoder_blu = 1e-4;  // mm
constexpr double settling = 1;        // s: the start has died away to e⁻²⁰ of a following error, far below a BLU
constexpr Scale micrometres = {"µm", 2};

/// Two axes, their pulse-driven loops, and the steps that follow words.
class Table {
 public:
  static base::Result<Table> create(const servo::PositionLoop& x, const servo::PositionLoop& y) {
    machine::Machine machine = machine::mill3();
    for (const auto& [axis, loop] : {std::pair{base::Axis::X, x}, {base::Axis::Y, y}}) {
      machine.axes[base::index(axis)]->velocity = 2 * speed;
      machine.axes[base::index(axis)]->blu = encoder_blu;
      machine.drives[base::index(axis)].position_gain = loop.gain;
      machine.drives[base::index(axis)].time_constant = loop.time_constant * 1000;
    }
    auto servo = servo::PulseServo::create(machine);
    if (!servo) return base::failure(servo.error());
    return Table(std::move(*servo), machine.period.seconds());
  }

  /// Follows place(t) for so many seconds, and shows where the slides are once they have settled.
  template <class Path, class Look>
  void follow(Path&& place, double seconds, Look&& look) {
    for (std::int64_t k = 0; static_cast<double>(k) * period_ <= seconds; ++k) {
      const SlidePosition due = place(static_cast<double>(k) * period_);
      base::Word word;
      word.tick = base::Tick{k};
      word.position = {due.x, due.y};
      const auto followed = servo_.follow(word);
      const bool has_settled = static_cast<double>(k - 1) * period_ >= settling;
      if (followed && has_settled) look(SlidePosition{followed->position[0], followed->position[1]});
    }
  }

 private:
  Table(servo::PulseServo servo, double period) : servo_(std::move(servo)), period_(period) {}

  servo::PulseServo servo_;
  double period_;
};

/// How far an axis may ever be from where its loop without counts would be, mm. Steps are within half a BLU of the path
/// and come with the next tick of their clock; encoder counts are within half a BLU of the slide. The loop passes that
/// on like any input: times ∫|h| dt of its impulse response h at most.
double coarseness(const servo::PositionLoop& loop) {
  constexpr double tick = 1 / static_cast<double>(servo::PulseServo::step_clock);
  return servo::greatest_gain(loop) * (encoder_blu / 2 + speed * tick + encoder_blu / 2);
}

std::string gains_text(const servo::PositionLoop& x, const servo::PositionLoop& y) {
  return "Kv " + decimal(x.gain, 0) + " and " + decimal(y.gain, 0) + " 1/s, τ " + decimal(x.time_constant * 1000, 0) +
         " ms: ";
}

std::string counts_text(double accuracy) {
  return decimal(accuracy * 1000, 2) + " µm by the counts of both axes";
}

Row line_row(double degrees, const servo::PositionLoop& x, const servo::PositionLoop& y) {
  const std::string what = "line at " + decimal(degrees, 0) + "°, " + gains_text(x, y) + "distance from it";
  auto table = Table::create(x, y);
  if (!table) return not_run_row(what, table.error().message);
  const double angle = degrees * std::numbers::pi / 180, along_x = std::cos(angle), along_y = std::sin(angle);
  double sum = 0;
  int count = 0;
  table->follow([&](double time) { return SlidePosition{speed * time * along_x, speed * time * along_y}; },
                2 * settling,
                [&](const SlidePosition& here) {
                  sum += along_x * here.y - along_y * here.x;
                  ++count;
                });
  const double expected = servo::line_contour_error(speed, angle, x, y);
  const double accuracy = along_y * coarseness(x) + along_x * coarseness(y);
  return because(reproduced_row(what, micrometres, expected * 1000, sum / count * 1000, accuracy * 1000),
                 "(V/2) sin 2α (1/Kx − 1/Ky), ± " + counts_text(accuracy) + "; the mean of a second");
}

/// Distances from the centre.
struct Ring {
  double nearest = 0, farthest = 0;
};

base::Result<Ring> ring_of(double radius, const servo::PositionLoop& x, const servo::PositionLoop& y) {
  auto table = Table::create(x, y);
  if (!table) return base::failure(table.error());
  const double frequency = speed / radius;
  const double half_turn = std::numbers::pi / frequency;  // has each semi-axis once
  Ring ring{2 * radius, 0};
  table->follow(
      [&](double time) {
        return SlidePosition{radius * (std::cos(frequency * time) - 1), radius * std::sin(frequency * time)};
      },
      settling + half_turn,
      [&](const SlidePosition& here) {
        const double distance = std::hypot(here.x + radius, here.y);
        ring.nearest = std::min(ring.nearest, distance);
        ring.farthest = std::max(ring.farthest, distance);
      });
  return ring;
}

/// What a circle of equal loops loses, beside R·ω²/(2Kv²). That leaves τ out, and ω/Kv but for its square: to the next
/// order, with ε = (ω/Kv)²,
///
///   (R − R|H|)/(R·ε/2) = 1 − 2Kv·τ + (τω)² − 3/4·ε·(1 − 2Kv·τ + (τω)²)² + …
Row textbook_row(const std::string& circle, double radius, const servo::PositionLoop& loop, double found,
                 double accuracy) {
  const double frequency = speed / radius, ratio = frequency / loop.gain;
  const double textbook = radius * ratio * ratio / 2, lag = loop.time_constant * frequency;
  return because(
      reproduced_row(circle + "share of the textbook's R·ω²/(2Kv²)", {"", 3}, 1 - 2 * loop.gain * loop.time_constant,
                     (radius - found) / textbook, accuracy / textbook + lag * lag + ratio * ratio),
      decimal(textbook * 1000, 2) + " µm, which leaves out τ: 1 − 2Kv·τ of it is left, ± (τω)² + (ω/Kv)²");
}

/// What unequal gains make of it, by the line's formula at 45°. Exactly, with one τ,
///
///   (major − minor)/2 = R·|Hx − Hy|/2 = (V/2)·|1/Kx − 1/Ky|·|Hx|·|Hy|·√(1 + (τω)²),
///
/// and 1 − (ω/Kv)²/2 ≤ |H| ≤ 1 while Kv·τ ≤ 1/2.
Row ellipse_row(const std::string& circle, double radius, const servo::PositionLoop& x, const servo::PositionLoop& y,
                const Ring& ring, double accuracy) {
  const double frequency = speed / radius, lag = x.time_constant * frequency;
  const double of_x = frequency / x.gain, of_y = frequency / y.gain;
  const double expected = std::abs(servo::line_contour_error(speed, std::numbers::pi / 4, x, y));
  const double left_out = expected * (lag * lag + of_x * of_x + of_y * of_y) / 2;
  return because(reproduced_row(circle + "half the difference of its semi-axes", micrometres, expected * 1000,
                                (ring.farthest - ring.nearest) / 2 * 1000, (accuracy + left_out) * 1000),
                 "(V/2)(1/Kx − 1/Ky), which leaves out half of (τω)² + (ω/Kx)² + (ω/Ky)² of it: ± " +
                     decimal((accuracy + left_out) * 1000, 2) + " µm with the counts");
}

Rows circle_rows(double radius, const servo::PositionLoop& x, const servo::PositionLoop& y) {
  const std::string circle = "circle of " + decimal(radius, 0) + " mm, " + gains_text(x, y);
  const base::Result<Ring> ring = ring_of(radius, x, y);
  if (!ring) return {not_run_row(circle + "semi-axes", ring.error().message)};
  const servo::SemiAxes expected = servo::circle_semi_axes(radius, speed / radius, x, y);
  const double accuracy = std::hypot(coarseness(x), coarseness(y));
  const auto row = [&](const char* what, double axis, double ours) {
    return because(
        reproduced_row(circle + what, micrometres, (axis - radius) * 1000, (ours - radius) * 1000, accuracy * 1000),
        "less the radius, by Kv/(τs² + s + Kv) at s = jω, ± " + counts_text(accuracy));
  };
  Rows rows = {row("greater semi-axis", expected.major, ring->farthest),
               row("lesser semi-axis", expected.minor, ring->nearest)};
  rows.push_back(x == y ? textbook_row(circle, radius, x, (ring->nearest + ring->farthest) / 2, accuracy)
                        : ellipse_row(circle, radius, x, y, *ring, accuracy));
  return rows;
}

Rows contour_rows() {
  constexpr servo::PositionLoop slow{20, time_constant}, fast{25, time_constant}, prompt{20, time_constant / 20};
  Rows rows = {line_row(30, slow, fast), line_row(45, slow, fast), line_row(30, slow, slow)};
  append(rows, circle_rows(10, slow, slow));
  append(rows, circle_rows(10, prompt, prompt));
  append(rows, circle_rows(10, slow, fast));
  return under("contours of two pulse-driven axes, 20 mm/s, BLU 0.1 µm, beside their closed forms", std::move(rows));
}

}  // namespace

Rows closed_loop_rows(const Host&) {
  // The lecture tells no gain: figures of a second one are expected to be the same.
  Rows rows = pulse_rows(20, lecture_rate, lecture_pulses, 30.13);
  append(rows, pulse_rows(5, steady_pps, block_pulses, 30.56));
  append(rows, contour_rows());
  return rows;
}

}  // namespace leadscrew::study
