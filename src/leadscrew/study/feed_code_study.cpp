#include <algorithm>
#include <cmath>
#include <leadscrew/design/inverse_time.hpp>
#include <leadscrew/nc/nc_program.hpp>
#include <leadscrew/pulse/free_circle.hpp>
#include <leadscrew/pulse/linear.hpp>
#include <leadscrew/study/studies.hpp>
#include <numbers>
#include <optional>
#include <utility>

// Koren, "Interpolator for a computer numerical control system": feed words and clocks, by formula and by registers.

namespace leadscrew::study {

namespace {

constexpr double blu_inch = 0.0001;
/// Lines of up to 12 in by four-digit words; up to 30 in/min, told to 0.01 in/min.
constexpr design::InverseTimeRange range{12, blu_inch, 30, 0.01, 4};
constexpr Scale pps = {"pps", 0};
constexpr Scale unscaled = {"", 0};

/// Koren's.
consteval Published programmed(double figure, std::string_view where) {
  return {figure, {Paper::software_interpolator, where}};
}

/// Clocks until an interpolator that is stepped by the commands of a feed DDA has ended.
template <pulse::Interpolator State>
double clocks_to_end(pulse::FeedDda feed, State state) {
  std::int64_t clocks = 0;
  for (; !state.done(); ++clocks) {
    if (feed.step()) state.step();
  }
  return static_cast<double>(clocks);
}

/// 2 in at 10 in/min.
Rows inverse_time_rows() {
  constexpr double feed_in_min = 10, distance_in = 2;
  const design::InverseTimeDesign design = design::design_inverse_time(range);
  const double feed_pps = feed_in_min / 60 / blu_inch, distance_blu = distance_in / blu_inch;
  const double by_inches = design::inverse_time_word(range, distance_in, feed_in_min, false).word;
  const double by_pulses = 600 * feed_pps / distance_blu;
  const auto steps = static_cast<std::int64_t>(distance_blu);
  const pulse::FeedDda feed(design.feed_capacity, std::llround(by_pulses));
  const pulse::LinearDda<2> line({steps, 0}, design.capacity, pulse::Preload::none);
  return under(
      "inverse-time code, eqs. 14 to 18",
      {because(exact_row("q", {"BLU", 0}, programmed(120000, "feed-rate instruction, by 12 in and the BLU"),
                         static_cast<double>(design.capacity)),
               "12 in in steps of 0.0001 in"),
       because(exact_row("clock, eq. 18", pps, programmed(2e6, "feed-rate instruction, eq. 18"), design.clock_pps),
               "q q0/600, q0 = 10 000 words of feed"),
       because(exact_row("reciprocal of the time of 2 in at 10 in/min", {"1/min", 0}, 5, by_inches / 10),
               "f counts tenths of it"),
       because(exact_row("f by pulses, eqs. 16 and 17", unscaled, by_inches, by_pulses),
               "beside f by inches, eqs. 14 and 15, where a radius stands for the length of a line"),
       because(exact_row("time of that line, by its registers", {"s", 3}, 60 / (by_inches / 10),
                         clocks_to_end(feed, line) / design.clock_pps),
               "feed DDA and axis DDA clocked at 2 MHz")});
}

/// What the registers of the hardware make of a circle from (R, 0), counterclockwise and without an end: two integrators
/// and the feed DDA before them, clocked until the tool is back at Y = 0.
struct HardwareTurn {
  std::int64_t clocks = 0, commands = 0;
  std::int64_t quarter_clocks = 0, quarter_commands = 0;  ///< until X = 0
  double apart = 0;          ///< within that quarter: steps of an axis beside Σ of the other coordinate over q, BLU
  double path = 0;           ///< ∫ρ dθ, BLU
  double quarter_angle = 0;  ///< rad
};

HardwareTurn hardware_turn(std::int64_t radius, std::int64_t capacity, pulse::FeedDda feed) {
  constexpr std::int64_t empty_and_strict = -1;  // overflow where r > q
  pulse::FreeCircle circle({radius, 0}, capacity, empty_and_strict, pulse::Order::parallel,
                           pulse::Accumulation::sign_magnitude);
  HardwareTurn turn;
  pulse::Point sum;  // of both coordinates over the commands of the quarter
  while (true) {
    ++turn.clocks;
    if (!feed.step()) continue;
    ++turn.commands;
    const pulse::Point before = circle.at();
    circle.step();
    const pulse::Point at = circle.at();
    const auto x = static_cast<double>(before.x), y = static_cast<double>(before.y);
    const auto dx = static_cast<double>(at.x - before.x), dy = static_cast<double>(at.y - before.y);
    turn.path += (x * dy - y * dx) / std::hypot(x, y);
    if (turn.quarter_clocks == 0) {
      sum = {sum.x + before.x, sum.y + before.y};
      const auto shares = [&](std::int64_t of) { return static_cast<double>(of) / static_cast<double>(capacity); };
      turn.apart = std::max({turn.apart, std::abs(static_cast<double>(radius - at.x) - shares(sum.y)),
                             std::abs(static_cast<double>(at.y) - shares(sum.x))});
      if (at.x == 0) {
        turn.quarter_clocks = turn.clocks;
        turn.quarter_commands = turn.commands;
        turn.quarter_angle = std::atan2(static_cast<double>(at.y), static_cast<double>(at.x));
      }
    }
    if (before.y < 0 && at.y >= 0) return turn;
  }
}

/// Around 1 in at 10 in/min, in registers for 12 in.
Rows circle_rows() {
  constexpr double feed_in_min = 10, radius_in = 1;
  const design::InverseTimeDesign design = design::design_inverse_time(range);
  const double feed_pps = feed_in_min / 60 / blu_inch, radius_blu = radius_in / blu_inch;
  const double by_pulses = 600 * feed_pps / radius_blu;
  const std::int64_t word = std::llround(by_pulses);
  const HardwareTurn turn =
      hardware_turn(std::llround(radius_blu), design.capacity, pulse::FeedDda(design.feed_capacity, word));
  const double seconds = static_cast<double>(turn.clocks) / design.clock_pps;
  const double quarter_seconds = static_cast<double>(turn.quarter_clocks) / design.clock_pps;
  const double omega = static_cast<double>(word) * design.clock_pps /
                       (static_cast<double>(design.capacity) * static_cast<double>(design.feed_capacity));
  return under(
      "a circle of 1 in at 10 in/min by the registers of the hardware, eqs. 12, 13, 15 and 17",
      {because(exact_row("f by pulses, eq. 17", unscaled,
                         design::inverse_time_word(range, radius_in, feed_in_min, false).word, by_pulses),
               "beside f by inches, eq. 15"),
       because(exact_row("commands, eq. 6", pps, omega * static_cast<double>(design.capacity),
                         static_cast<double>(turn.commands) / seconds),
               "f w0/q0; those of the feed DDA over a turn"),
       because(limit_row("an axis beside the other's coordinate summed over q, eq. 12", {"BLU", 3}, 1, turn.apart),
               "the greatest difference within the first quarter, both axes, at every command"),
       because(exact_row("commands of the quarter", unscaled,
                         std::ceil(std::numbers::pi / 2 * static_cast<double>(design.capacity)),
                         static_cast<double>(turn.quarter_commands)),
               "π q/2, rounded up; overflow where r > q, both integrators on one clock"),
       because(exact_row("angular velocity, eq. 13", {"rad/s", 5}, omega, turn.quarter_angle / quarter_seconds),
               "f w0/(q q0), a sixth; over the quarter"),
       because(exact_row("time of a turn", {"s", 3}, 2 * std::numbers::pi / omega, seconds),
               "2π/ω; until the tool is back at Y = 0"),
       because(reproduced_row("feed along the path", {"pps", 2}, feed_pps, turn.path / seconds, omega),
               "V = ω R; within what a BLU of the radius makes: Euler's method and whole steps go outward")});
}

std::int64_t commands(std::int64_t word, std::int64_t clocks) {
  pulse::FeedDda feed(3000, word);
  std::int64_t count = 0;
  for (std::int64_t clock = 0; clock < clocks; ++clock) count += feed.step();
  return count;
}

Rows direct_rows() {
  const design::InverseTimeDesign design = design::design_inverse_time(range);
  const double clock = design.software_clock_pps, capacity = static_cast<double>(design.software_feed_capacity);
  constexpr std::int64_t second = 5000, minute = 60 * second;
  constexpr std::string_view interpolator = "software interpolator, below eq. 20";
  const auto a_second = static_cast<double>(commands(1234, minute)) / 60;
  return under(
      "q = L, eqs. 19 to 21",
      {exact_row("clock", pps, programmed(5000, interpolator), clock),
       exact_row("from interrupt to interrupt", {"µs", 0}, programmed(200, interpolator), 1e6 / clock),
       exact_row("q0", unscaled, programmed(3000, "software interpolator, eq. 21"), capacity),
       because(exact_row("f of 30 in/min, eq. 21", unscaled, programmed(3000, "eq. 21, by 30 in/min"),
                         design::software_word(range, 30, true).word),
               "100 V0"),
       because(exact_row("commands an interrupt at f = 3000", unscaled, programmed(1, "introduction, the feed routine"),
                         static_cast<double>(commands(3000, second)) / second),
               "clocked for a second"),
       because(exact_row("commands at f = 1234", {"pps", 2}, 2056.67, a_second), "clocked for a minute"),
       because(exact_row("their feed, eq. 20", {"in/min", 2}, 12.34, a_second * blu_inch * 60), "V = w0 f/q0")});
}

/// Around a circle of 1 in at 30 in/min: a command, and the interpolator with it, at every interrupt.
nc::NcProgram travelled_circle() {
  constexpr std::int64_t radius = 10'000;
  nc::Block circle;
  circle.kind = nc::Block::Kind::arc;
  circle.arc = {{radius, 0}, {radius, 0}, pulse::Direction::counterclockwise};
  circle.feed_word = circle.greatest_word = nc::NcProgram::feed_word(30);
  nc::ArcTape tape;
  nc::count_commands(circle, nc::PulseMethod::koren, {}, tape);
  nc::NcProgram program({}, [circle, is_given = false]() mutable {
    return std::exchange(is_given, true) ? std::nullopt : std::optional(circle);
  });
  while (!program.done()) program.interrupt();
  return program;
}

/// 170 µs of 200, at 2 µs an instruction: 85 of them, beside the operations that the NC program counts.
Rows load_rows() {
  constexpr double interrupt = 200, instruction = 2;  // µs
  constexpr Published longest = programmed(170, "software interpolator, below eq. 20"),
                      instructions =
                          programmed(85, "software interpolator, below eq. 20, by 170 µs and 2 µs an instruction");
  const nc::NcProgram program = travelled_circle();
  const auto operations = static_cast<double>(program.operations().worst);
  const auto initiator = static_cast<double>(program.initiations().worst);
  return under(
      "the NC program's share of the computer",
      {because(at_most_row("instructions of the longest interrupt", unscaled, instructions, operations),
               "loads, additions, tests and stores of one accumulator, counted around a circle, without the initiator"),
       because(at_most_row("time of the longest interrupt", {"µs", 0}, longest, operations * instruction),
               "those operations at 2 µs"),
       because(at_most_row("load", {"%", 0}, programmed(85, "software interpolator, below eq. 20, by 170 µs of 200 µs"),
                           100 * operations * instruction / interrupt),
               "of 200 µs; what is left is for adaptive control"),
       because(measured_row("instructions of the mean interrupt", {"", 1}, program.operations().mean()),
               "around that circle"),
       because(measured_row("instructions with the initiator's", unscaled, operations + initiator),
               "more than the 85 published; of an interrupt that ends a block and begins another; " +
                   decimal(initiator, 0) +
                   " are the initiator's, 62 of them for the 31 digits of the root that is q; it is not told how "
                   "theirs had it, nor whether the 170 µs hold it"),
       not_reproducible_row("time measured on their computer", {"µs", 0}, longest,
                            "the computer and its program are not here")});
}

/// Pulses of a DDA that overflows where r > q, from the remainder r, beside those of one that does where r ≥ q.
bool is_same_as_lower_by_one(std::int64_t capacity, std::int64_t integrand, std::int64_t remainder) {
  pulse::Integrator integrator(capacity, remainder - 1);
  for (std::int64_t clock = 0; clock < 2 * capacity; ++clock) {
    remainder += integrand;
    const bool overflows = remainder > capacity;
    remainder -= overflows ? capacity : 0;
    if (integrator.add(integrand) != overflows) return false;
  }
  return true;
}

Rows integrator_rows() {
  constexpr std::int64_t greatest = 32;
  std::int64_t tried = 0, others = 0;
  for (std::int64_t capacity = 1; capacity <= greatest; ++capacity) {
    for (std::int64_t integrand = 0; integrand <= capacity; ++integrand) {
      for (std::int64_t remainder = 0; remainder <= capacity; ++remainder) {
        ++tried;
        others += !is_same_as_lower_by_one(capacity, integrand, remainder);
      }
    }
  }
  return under(
      "the DDA integrator, eqs. 1 to 5",
      {because(exact_row("registers that differ, r > q beside r − 1 ≥ q", unscaled, 0, static_cast<double>(others)),
               "of " + std::to_string(tried) + ": every capacity to 32, integrand and remainder")});
}

/// What a line goes by each command: its length over the commands that it takes, BLU.
double distance_a_command(const design::InverseTimeDesign& design, std::int64_t steps, std::int64_t capacity) {
  const pulse::FeedDda every_clock(design.feed_capacity, design.feed_capacity);
  const pulse::LinearDda<2> line({steps, 0}, capacity, pulse::Preload::none);
  return static_cast<double>(steps) / clocks_to_end(every_clock, line);
}

/// Of 2 in, by a command at every clock.
Rows efficiency_rows() {
  constexpr std::int64_t length = 20'000;  // BLU
  const design::InverseTimeDesign design = design::design_inverse_time(range);
  return under("efficiency L/q of a line of 2 in",
               {because(exact_row("q of the register, 12 in", {"", 4}, 1.0 / 6,
                                  distance_a_command(design, length, design.capacity)),
                        "2 in of 12 in; pulses a command, counted"),
                because(exact_row("q = L", {"", 4}, programmed(1, "software interpolator, below eq. 19"),
                                  distance_a_command(design, length, length)),
                        "pulses a command, counted")});
}

}  // namespace

Rows feed_code_rows(const Host&) {
  Rows rows = integrator_rows();
  append(rows, inverse_time_rows());
  append(rows, circle_rows());
  append(rows, direct_rows());
  append(rows, efficiency_rows());
  append(rows, load_rows());
  return rows;
}

}  // namespace leadscrew::study
