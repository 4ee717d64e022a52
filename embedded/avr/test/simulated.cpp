// The firmware in simavr beside pulse/ with 64 bits: the same pulses at the same clocks, and how many cycles a step takes.
//
//   simulated FIRMWARE.elf METHOD BITS EVERY RARE…
//
// sends every EVERYth of all arcs between lattice points of circles with R² ≤ 900, both ways, and of all lines to
// |a|, |b| ≤ 30; a circle and a line of 1000 BLU, and what must be refused. RARE: addresses of functions that are told
// apart (Chip). Prints one line, and returns 1 where a pulse differs:
//   METHOD BITS arcs N clocks N mean C worst C border C lines N clocks N mean C worst C pulse C set-up C hold C

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <lattice_arcs.hpp>

#include "../../methods.hpp"
#include "chip.hpp"

namespace leadscrew::embedded {
namespace {

using pulse::Arc;
using pulse::Direction;
using pulse::Point;

/// Of interrupts.
struct Count {
  std::uint64_t moves = 0, clocks = 0, steps_cycles = 0;
  Cycles worst = 0;         ///< of a step inside a quadrant
  Cycles worst_border = 0;  ///< of one over a border of quadrants, or the end
  double mean() const { return static_cast<double>(steps_cycles) / static_cast<double>(clocks); }
};

class Session {
 public:
  Session(Chip& chip, int bits)
      : chip_(chip), bytes_(bits / 8), period_(bits == 16 ? least_period<std::int16_t> : least_period<std::int32_t>) {
    if (chip_.run([](const Interrupt&) {}) != '.') throw std::runtime_error("the firmware does not begin with '.'");
  }

  /// A move; `state` makes its pulses. Throws where one differs.
  template <typename State>
  void move(char kind, Point start, Point end, State state, Count& count) {
    ++count.moves;
    bool is_first = true;
    const char answer = send(kind, start, end, period_, [&](const Interrupt& found) {
      // The first interrupt shows nothing yet; the last finds that there is no more.
      const pulse::Pulse<2> expected = is_first || state.done() ? pulse::Pulse<2>{} : state.step();
      if (found.pulse != expected) throw std::runtime_error("another pulse: " + text(kind, start, end));
      is_first = false;
      ++count.clocks;
      count.steps_cycles += found.cycles;
      Cycles& worst = found.is_rare ? count.worst_border : count.worst;
      worst = std::max(worst, found.cycles);
    });
    if (answer != '.') throw std::runtime_error("refused: " + text(kind, start, end));
    if (!state.done()) throw std::runtime_error("too few pulses: " + text(kind, start, end));
  }

  int period() const { return period_; }

  void expect_refused(char kind, Point start, Point end, int period) {
    const char answer = send(kind, start, end, period, [](const Interrupt&) {});
    if (answer != '!') throw std::runtime_error("not refused: " + text(kind, start, end));
  }

 private:
  template <typename Take>
  char send(char kind, Point start, Point end, int period, const Take& take) {
    chip_.send(static_cast<std::uint8_t>(kind));
    for (const std::int64_t number : {start.x, start.y, end.x, end.y}) send_number(number, bytes_);
    send_number(period, 2);
    return chip_.run(take);
  }
  void send_number(std::int64_t number, int bytes) {
    for (int i = 0; i < bytes; ++i) chip_.send(static_cast<std::uint8_t>(number >> (8 * i)));
  }
  static std::string text(char kind, Point start, Point end) {
    return std::string{kind} + ' ' + std::to_string(start.x) + ',' + std::to_string(start.y) + " to " +
           std::to_string(end.x) + ',' + std::to_string(end.y);
  }

  Chip& chip_;
  int bytes_, period_;
};

std::vector<Point> all_lines() {
  std::vector<Point> lines;
  for (std::int64_t a = -30; a <= 30; ++a) {
    for (std::int64_t b = -30; b <= 30; ++b) lines.push_back({a, b});
  }
  return lines;
}

template <template <typename> typename Of>
struct Checked {
  using Method = Of<std::int64_t>;

  static int run(Chip& chip, std::string_view name, int bits, std::size_t every) {
    Session session(chip, bits);
    Count arcs, lines;
    const auto send_arc = [&](const Arc& arc) {
      const char kind = arc.is_counterclockwise() ? '+' : '-';
      session.move(kind, arc.start, arc.end, Method::circle(arc), arcs);
    };
    const auto send_line = [&](Point delta) { session.move('l', {}, delta, Method::line(delta), lines); };
    std::size_t arc_at = every / 2;
    testing_support::each_lattice_arc(30, [&](const Arc& arc) {
      if (++arc_at % every == 0) send_arc(arc);
    });
    send_arc({{0, 1000}, {0, 1000}, Direction::clockwise});
    send_arc({{-600, 800}, {600, 800}, Direction::counterclockwise});
    const std::vector<Point> deltas = all_lines();
    const std::size_t every_line = (every + 9) / 10;
    for (std::size_t i = 0; i < deltas.size(); i += every_line) send_line(deltas[i]);
    send_line({-1000, 617});
    send_line({3, -1000});
    refuse(session, bits);
    if (static_cast<int>(std::max(arcs.worst_border, lines.worst_border)) >= session.period())
      throw std::runtime_error("a step over a border takes longer than the least period");
    report(chip, name, bits, arcs, lines);
    return 0;
  }

  static void refuse(Session& session, int bits) {
    const std::int64_t above = (std::int64_t{1} << (bits - 4)) + 1;
    session.expect_refused('l', {}, {above, 0}, session.period());
    session.expect_refused('+', {0, 5}, {0, -above}, session.period());
    session.expect_refused('-', {0, 0}, {5, 0}, session.period());
    session.expect_refused('+', {5, 0}, {0, 0}, session.period());
    session.expect_refused('l', {}, {5, 0}, session.period() - 1);
    session.expect_refused('?', {5, 0}, {5, 0}, session.period());
  }

  static void report(const Chip& chip, std::string_view name, int bits, const Count& arcs, const Count& lines) {
    std::printf("%s %d arcs %llu clocks %llu mean %.1f worst %llu border %llu ", std::string(name).c_str(), bits,
                as_printed(arcs.moves), as_printed(arcs.clocks), arcs.mean(), as_printed(arcs.worst),
                as_printed(arcs.worst_border));
    std::printf("lines %llu clocks %llu mean %.1f worst %llu pulse %llu set-up %llu hold %llu\n",
                as_printed(lines.moves), as_printed(lines.clocks), lines.mean(), as_printed(lines.worst),
                as_printed(chip.shortest_pulse()), as_printed(chip.least_set_up()), as_printed(chip.least_hold()));
  }
  static unsigned long long as_printed(std::uint64_t number) { return number; }
};

int run(int count, char** arguments) {
  if (count < 5) throw std::runtime_error("simulated FIRMWARE.elf METHOD BITS EVERY RARE...");
  const std::string_view name = arguments[2];
  const int bits = std::atoi(arguments[3]);
  const auto every = static_cast<std::size_t>(std::max(1, std::atoi(arguments[4])));
  std::vector<std::uint32_t> rare;
  for (int i = 5; i < count; ++i) rare.push_back(static_cast<std::uint32_t>(std::strtoul(arguments[i], nullptr, 16)));
  Chip chip(arguments[1], rare);
  if (name == "koren") return Checked<koren>::run(chip, name, bits, every);
  if (name == "point_comparison") return Checked<point_comparison>::run(chip, name, bits, every);
  if (name == "least_error") return Checked<least_error>::run(chip, name, bits, every);
  if (name == "improved") return Checked<improved>::run(chip, name, bits, every);
  throw std::runtime_error("no method " + std::string(name));
}

}  // namespace
}  // namespace leadscrew::embedded

int main(int count, char** arguments) {
  try {
    return leadscrew::embedded::run(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
