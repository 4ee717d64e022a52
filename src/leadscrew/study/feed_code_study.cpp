#include <leadscrew/design/inverse_time.hpp>
#include <leadscrew/nc/nc_program.hpp>
#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/linear.hpp>
#include <leadscrew/study/studies.hpp>
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
  append(rows, direct_rows());
  append(rows, efficiency_rows());
  append(rows, load_rows());
  return rows;
}

}  // namespace leadscrew::study
