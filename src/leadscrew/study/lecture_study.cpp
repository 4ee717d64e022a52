#include <array>
#include <cmath>
#include <leadscrew/design/dda_design.hpp>
#include <leadscrew/pulse/integrator.hpp>
#include <leadscrew/study/studies.hpp>

// "Interpolators linear", lecture 12: its three worked problems.

namespace leadscrew::study {

namespace {

constexpr Scale whole = {"", 0};

consteval Published lectured(double figure, std::string_view where) {
  return {figure, {Paper::linear_interpolators, where}};
}

/// N20 X20 Y40 F100, N30 X50 Y80; encoder of 200 holes on a screw of 4 mm.
Rows encoder_rows() {
  constexpr double pitch = 4, holes = 200, feed = 100, delta_x = 50 - 20, delta_y = 80 - 40;
  const double blu = pitch / holes, length = std::hypot(delta_x, delta_y), feed_x = feed * delta_x / length,
               feed_y = feed * delta_y / length;
  constexpr std::string_view answer = "problem 13.1, answer", of_y = "problem 13.1, by Vx/Vy = 3/4 and the BLU";
  return under("problem 1: a pulse-driven axis",
               {exact_row("basic length unit", {"mm", 2}, lectured(0.02, answer), blu),
                exact_row("feed of X", {"mm/min", 0}, lectured(60, answer), feed_x),
                because(exact_row("pulse rate of X", {"ppm", 0}, lectured(3000, answer), feed_x / blu),
                        "at steady state the encoder gives as many as the interpolator"),
                exact_row("pulses of X", whole, lectured(1500, answer), delta_x / blu),
                exact_row("feed of Y", {"mm/min", 0}, lectured(80, of_y), feed_y),
                exact_row("pulse rate of Y", {"ppm", 0}, lectured(4000, of_y), feed_y / blu),
                exact_row("pulses of Y", whole, lectured(2000, "problem 13.1, by 40 mm and the BLU"), delta_y / blu),
                exact_row("time", {"s", 0}, lectured(30, "problem 13.1, by 30 mm at 60 mm/min"), length / feed * 60)});
}

/// As the lecture calculates it: f S/2ᵐ with S = 10 V/L, V 300 000 BLU/min and L = √(10000² + 5000²), rounded.
double rounded_feed_pps(const design::DdaDesign& design) {
  const double clock = std::floor(design.clock_pps), length = std::round(std::hypot(10000, 5000));
  return clock * (10 * 300000 / length) / std::ldexp(1.0, design.feed_bits);
}

/// 600 × 600 mm, 12 m/min along 50 mm or more, steps of 10 µm; (20, 10) to (120, 60) at 3 m/min.
Rows dda_rows() {
  constexpr design::DdaRange table{600, 0.01, 12000, 50};
  const design::DdaDesign design = design::design_dda(table);
  const design::DdaLine ideal = design::along_line(design, table, {100, 50}, 3000, false);
  const design::DdaLine real = design::along_line(design, table, {100, 50}, 3000, true);
  const double to_mm_min = table.blu_mm * 60;
  constexpr std::string_view sizes = "DDA interpolator, bit sizes", line = "DDA interpolator, the particular case";
  Rows rows = {
      exact_row("bits of the axis DDAs", whole, lectured(16, sizes), design.axis_bits),
      because(expecting(exact_row("2ⁿ − 1", whole, lectured(65536, "DDA interpolator, bit sizes, as spoken"),
                                  std::ldexp(1.0, design.axis_bits) - 1),
                        65535),
              "a misprint: 2¹⁶ itself"),
      exact_row("bits of the feed DDA", whole, lectured(12, sizes), design.feed_bits),
      exact_row("greatest feed word", whole, lectured(2400, sizes), static_cast<double>(design.feed_word_max)),
      because(exact_row("clock", {"pps", 0}, lectured(447392, sizes), std::floor(design.clock_pps)),
              "2²⁸/600, rounded down"),
      because(
          reproduced_row("out of the feed DDA", {"pps", 2}, lectured(29309.43, line), rounded_feed_pps(design), 0.03),
          "of the clock and of a length of 11180 BLU, both rounded; no rounding gives the last digits"),
      measured_row("out of the feed DDA, nothing rounded", {"pps", 2}, ideal.feed_pps),
      exact_row("steps of X", {"pps", 0}, lectured(4472, line), ideal.axis_pps[0]),
      exact_row("steps of Y", {"pps", 0}, lectured(2236, line), ideal.axis_pps[1]),
      because(exact_row("feed of X", {"mm/min", 0}, lectured(2683, line), ideal.axis_pps[0] * to_mm_min),
              "not rounded: 2683.28"),
      because(expecting(exact_row("feed of Y, not rounded", {"mm/min", 1}, lectured(1341.5, line),
                                  ideal.axis_pps[1] * to_mm_min),
                        1341.6),
              "a misprint of 1341.6, 2236 pps · 0.6; not rounded before, 1341.64"),
      exact_row("feed along the line", {"m/min", 3}, lectured(3, line), ideal.feed_mm_min / 1000),
  };
  Rows in_register = {
      measured_row("feed word", whole, real.feed_word),
      measured_row("steps of X", {"pps", 2}, real.axis_pps[0]),
      measured_row("steps of Y", {"pps", 2}, real.axis_pps[1]),
      measured_row("feed along the line", {"mm/min", 2}, real.feed_mm_min),
      measured_row("time of the line", {"s", 4}, real.seconds),
  };
  rows = under("problem 2: a linear interpolator of DDAs", std::move(rows));
  append(rows, under("problem 2, the feed word as a register holds it", std::move(in_register)));
  return rows;
}

/// From cleared registers to the first overflow, s.
double first_overflow(int bits, double clock_pps, std::int64_t load) {
  pulse::Integrator timer(std::int64_t{1} << bits, 0);
  std::int64_t clocks = 1;
  while (!timer.add(load)) ++clocks;
  return static_cast<double>(clocks) / clock_pps;
}

/// A clock of 1024 pulses a second; first overflow after 2, 4 and 8 s.
Rows timer_rows() {
  constexpr double clock = 1024;
  const design::DdaTimer timer = design::design_timer(clock, {2, 4, 8});
  Rows rows = {because(exact_row("greatest number in the register", whole, lectured(8191, "MCQ, answer b"),
                                 std::ldexp(1.0, timer.bits) - 1),
                       "2¹³ − 1; with 12 bits 8 s are out of reach")};
  constexpr std::array published = {lectured(2, "MCQ, delays"), lectured(4, "MCQ, delays"), lectured(8, "MCQ, delays")};
  constexpr std::array<const char*, 3> delays = {"delay 1", "delay 2", "delay 3"};
  for (std::size_t k = 0; k < delays.size(); ++k) {
    rows.push_back(because(exact_row(delays[k], {"s", 0}, published[k], timer.seconds[k]),
                           "load " + std::to_string(timer.loads[k])));
  }
  rows.push_back(because(expecting(exact_row("load of the shortest delay", whole, lectured(3, "MCQ, its last sentence"),
                                             static_cast<double>(timer.loads[0])),
                                   4),
                         "4 is meant: 2 s"));
  rows.push_back(exact_row("first overflow of load 3", {"s", 3}, std::ldexp(1.0, timer.bits) / (3 * clock),
                           first_overflow(timer.bits, clock, 3)));
  return under("problem 3: the DDA as a timer", std::move(rows));
}

}  // namespace

Rows lecture_rows(const Host&) {
  Rows rows = encoder_rows();
  append(rows, dda_rows());
  append(rows, timer_rows());
  return rows;
}

}  // namespace leadscrew::study
