#include <algorithm>
#include <cmath>
#include <leadscrew/servo/axis_loop.hpp>
#include <leadscrew/servo/contour.hpp>
#include <leadscrew/servo/pulse_loop.hpp>
#include <leadscrew/study/studies.hpp>
#include <numbers>
#include <string>

// What closed loops make of an interpolator's output: the pulse-driven axis of "Interpolators linear", lecture 12,
// problem 13.1, as it runs; and the contours of two position loops beside their closed forms.

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
Rows pulse_rows(double gain, double settled) {
  constexpr double rate = 3000.0 / 60;
  constexpr std::int64_t pulses = 1500;
  servo::PulseLoopOptions options{
      .converter = 10.0 / 256, .amplifier = 4, .holes = 200, .time_constant = time_constant};
  options.motor = gain / (options.converter * options.amplifier * options.holes);
  const std::string group = "pulse-driven axis, Kv " + decimal(gain, 0) + " 1/s, 3000 pulses/min, 1500 pulses";
  const base::Result<servo::PulseLoop> loop = servo::PulseLoop::create(options);
  if (!loop) return under(group, {not_run_row("run", loop.error().message)});
  const Observed seen = Observer(*loop, rate).run(pulses);
  return under(group,
               {because(reproduced_row("up-down counter", {"pulses", 2}, rate / gain, seen.mean, 0.005),
                        "f/Kv; its mean over 20 s"),
                because(reproduced_row("rate of the encoder", {"pps", 2}, rate, seen.rate, 0.05),
                        "at steady state as many as the interpolator gives; one pulse in 20 s is 0.05"),
                exact_row("pulses of the encoder", {"", 0}, pulses, static_cast<double>(seen.count)),
                limit_row("pulses lost", {"", 0}, 0, static_cast<double>(seen.lost)),
                because(exact_row("at rest after", {"s", 2}, settled, seen.settled),
                        "N/f and some times 1/Kv: no more to come, the counter 0, slower than a pulse a second")});
}

struct Place {
  double x = 0, y = 0;
};

/// Two axes under proportional loops, read every 0.1 ms.
class Table {
 public:
  static constexpr double period = 1e-4;

  static base::Result<Table> create(double gain_x, double gain_y) {
    const auto x = loop_of(gain_x), y = loop_of(gain_y);
    if (!x) return base::failure(x.error());
    if (!y) return base::failure(y.error());
    return Table(*x, *y);
  }
  /// Where it is when this place is due.
  Place follow(const Place& due) {
    const Place here{x_.axis().slide(), y_.axis().slide()};
    x_.follow({due.x});
    y_.follow({due.y});
    return here;
  }

 private:
  Table(servo::AxisLoop x, servo::AxisLoop y) : x_(std::move(x)), y_(std::move(y)) {}

  static base::Result<servo::AxisLoop> loop_of(double gain) {
    auto axis = servo::Axis::create({.drive = servo::velocity_drive(1, time_constant)});
    if (!axis) return base::failure(axis.error());
    auto pid = servo::Pid::create({.gains = {.proportional = gain}}, period);
    if (!pid) return base::failure(pid.error());
    return servo::AxisLoop(std::move(*axis), std::move(*pid), period);
  }

  servo::AxisLoop x_, y_;
};

constexpr double speed = 20;      // mm/s
constexpr int settling = 40'000;  // periods, 4 s: many times 1/Kv

constexpr Scale micrometres = {"µm", 2};

Row line_row(double degrees, double gain_x, double gain_y) {
  const std::string what = "line at " + decimal(degrees, 0) + "°, Kv " + decimal(gain_x, 0) + " and " +
                           decimal(gain_y, 0) + " 1/s: distance from it";
  auto table = Table::create(gain_x, gain_y);
  if (!table) return not_run_row(what, table.error().message);
  const double angle = degrees * std::numbers::pi / 180, along_x = std::cos(angle), along_y = std::sin(angle);
  Place here;
  for (int k = 0; k <= settling; ++k) {
    const double way = speed * Table::period * k;
    here = table->follow({way * along_x, way * along_y});
  }
  const double off = along_x * here.y - along_y * here.x;
  const double expected = servo::line_contour_error(speed, angle, {gain_x, time_constant}, {gain_y, time_constant});
  return because(reproduced_row(what, micrometres, expected * 1000, off * 1000, 0.01), "(V/2) sin 2α (1/Kx − 1/Ky)");
}

Rows circle_rows(double radius, double gain_x, double gain_y) {
  const std::string circle =
      "circle of " + decimal(radius, 0) + " mm, Kv " + decimal(gain_x, 0) + " and " + decimal(gain_y, 0) + " 1/s: ";
  auto table = Table::create(gain_x, gain_y);
  if (!table) return {not_run_row(circle + "semi-axes", table.error().message)};
  const double frequency = speed / radius;
  const int turn = static_cast<int>(std::ceil(2 * std::numbers::pi / frequency / Table::period));
  double nearest = radius * 10, farthest = 0;
  for (int k = 0; k <= settling + turn; ++k) {
    const double angle = frequency * Table::period * k;
    const Place here = table->follow({radius * (std::cos(angle) - 1), radius * std::sin(angle)});
    if (k < settling) continue;
    const double distance = std::hypot(here.x + radius, here.y);
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  const servo::SemiAxes expected =
      servo::circle_semi_axes(radius, frequency, {gain_x, time_constant}, {gain_y, time_constant});
  const auto row = [&](const char* what, double axis, double ours) {
    return because(reproduced_row(circle + what, micrometres, (axis - radius) * 1000, (ours - radius) * 1000, 0.2),
                   "less the radius; the closed form knows no periods, of which there is one each 0.1 ms");
  };
  return {row("greater semi-axis", expected.major, farthest), row("lesser semi-axis", expected.minor, nearest)};
}

}  // namespace

Rows closed_loop_rows(const Host&) {
  Rows rows = pulse_rows(20, 30.13);
  append(rows, pulse_rows(5, 30.56));
  Rows contours = {line_row(30, 20, 25), line_row(45, 20, 25), line_row(45, 20, 20)};
  append(contours, circle_rows(10, 20, 20));
  append(contours, circle_rows(10, 20, 25));
  append(rows, under("contours of two loops, 20 mm/s, τ 20 ms, beside their closed forms", std::move(contours)));
  return rows;
}

}  // namespace leadscrew::study
