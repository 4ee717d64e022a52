#include <array>
#include <cmath>
#include <leadscrew/design/dda_design.hpp>
#include <leadscrew/study/studies.hpp>

// "Interpolators linear", lecture 12: its three worked problems.

namespace leadscrew::study {

namespace {

constexpr Scale whole = {"", 0};

/// N20 X20 Y40 F100, N30 X50 Y80; encoder of 200 holes on a screw of 4 mm.
Rows encoder_rows() {
  constexpr double pitch = 4, holes = 200, feed = 100, delta_x = 50 - 20, delta_y = 80 - 40;
  const double blu = pitch / holes, length = std::hypot(delta_x, delta_y), feed_x = feed * delta_x / length,
               feed_y = feed * delta_y / length;
  return under(
      "problem 1: a pulse-driven axis",
      {exact_row("basic length unit", {"mm", 2}, 0.02, blu), exact_row("feed of X", {"mm/min", 0}, 60, feed_x),
       because(exact_row("pulse rate of X", {"ppm", 0}, 3000, feed_x / blu),
               "at steady state the encoder gives as many as the interpolator"),
       exact_row("pulses of X", whole, 1500, delta_x / blu), exact_row("feed of Y", {"mm/min", 0}, 80, feed_y),
       exact_row("pulse rate of Y", {"ppm", 0}, 4000, feed_y / blu),
       exact_row("pulses of Y", whole, 2000, delta_y / blu), exact_row("time", {"s", 0}, 30, length / feed * 60)});
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
  Rows rows = {
      exact_row("bits of the axis DDAs", whole, 16, design.axis_bits),
      because(exact_row("2ⁿ − 1", whole, 65536, std::ldexp(1.0, design.axis_bits) - 1), "a misprint: 2¹⁶ itself"),
      exact_row("bits of the feed DDA", whole, 12, design.feed_bits),
      exact_row("greatest feed word", whole, 2400, static_cast<double>(design.feed_word_max)),
      because(exact_row("clock", {"pps", 0}, 447392, std::floor(design.clock_pps)), "2²⁸/600, rounded down"),
      because(reproduced_row("out of the feed DDA", {"pps", 2}, 29309.43, rounded_feed_pps(design), 0.03),
              "of the clock and of a length of 11180 BLU, both rounded; no rounding gives the last digits"),
      measured_row("out of the feed DDA, nothing rounded", {"pps", 2}, ideal.feed_pps),
      exact_row("steps of X", {"pps", 0}, 4472, ideal.axis_pps[0]),
      exact_row("steps of Y", {"pps", 0}, 2236, ideal.axis_pps[1]),
      because(exact_row("feed of X", {"mm/min", 0}, 2683, ideal.axis_pps[0] * to_mm_min), "not rounded: 2683.28"),
      because(exact_row("feed of Y, not rounded", {"mm/min", 1}, 1341.5, ideal.axis_pps[1] * to_mm_min),
              "published from 2236 pps, rounded: 1341.64 it is"),
      exact_row("feed along the line", {"m/min", 3}, 3, ideal.feed_mm_min / 1000),
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

/// A clock of 1024 pulses a second; first overflow after 2, 4 and 8 s.
Rows timer_rows() {
  const design::DdaTimer timer = design::design_timer(1024, {2, 4, 8});
  Rows rows = {because(exact_row("greatest number in the register", whole, 8191, std::ldexp(1.0, timer.bits) - 1),
                       "2¹³ − 1; with 12 bits 8 s are out of reach")};
  constexpr std::array<const char*, 3> delays = {"delay 1", "delay 2", "delay 3"};
  for (std::size_t k = 0; k < delays.size(); ++k) {
    rows.push_back(because(exact_row(delays[k], {"s", 0}, std::ldexp(2.0, static_cast<int>(k)), timer.seconds[k]),
                           "load " + std::to_string(timer.loads[k])));
  }
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
