#include <algorithm>
#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/study/lattice_path.hpp>
#include <leadscrew/study/studies.hpp>
#include <map>
#include <vector>

// "Design and implementation of digital integral interpolator based on LabVIEW": lines and arcs in n-bit registers.

namespace leadscrew::study {

namespace {

using pulse::Arc;
using pulse::Direction;
using pulse::Integrator;
using pulse::Order;
using pulse::Point;
using pulse::Preload;

constexpr Scale plain = {"", 0};

struct Count {
  std::int64_t tried = 0, failed = 0;
};

/// Coordinates below 2ⁿ, n = 1 … 8, that m = 2ⁿ additions do not give as many pulses, or with the remainder changed:
/// without a counter that would stop them. Axes know nothing of one another.
Count ends_missed(Preload preload) {
  Count count;
  for (int bits = 1; bits <= 8; ++bits) {
    const std::int64_t capacity = std::int64_t{1} << bits, first = preloaded(preload, capacity, true);
    for (std::int64_t end = 0; end < capacity; ++end) {
      Integrator axis(capacity, first);
      std::int64_t pulses = 0;
      for (std::int64_t m = 0; m < capacity; ++m) pulses += axis.add(end);
      ++count.tried;
      count.failed += pulses != end || axis.remainder() != first;
    }
  }
  return count;
}

/// Of all coordinates of 8 bits, from an empty register: additions until the last pulse.
std::int64_t most_cycles_to_end() {
  constexpr std::int64_t capacity = 256;
  std::int64_t most = 0;
  for (std::int64_t end = 1; end < capacity; ++end) {
    Integrator axis(capacity, 0);
    std::int64_t cycles = 0;
    for (std::int64_t pulses = 0; pulses < end; ++cycles) pulses += axis.add(end);
    most = std::max(most, cycles);
  }
  return most;
}

Rows line_rows() {
  Rows rows;
  for (const auto& [what, preload] : {std::pair{"ends missed after 2ⁿ cycles, registers empty", Preload::none},
                                      std::pair{"ends missed after 2ⁿ cycles, half full", Preload::half}}) {
    const Count missed = ends_missed(preload);
    rows.push_back(because(exact_row(what, plain, 0, static_cast<double>(missed.failed)),
                           "of " + std::to_string(missed.tried) + ": every coordinate, n = 1 … 8, k = 1/2ⁿ"));
  }
  rows.push_back(because(exact_row("cycles to the end, n = 8, register empty", plain,
                                   Published(256, {Paper::digital_integrals, "linear interpolation, m = 2ⁿ"}),
                                   static_cast<double>(most_cycles_to_end())),
                         "the most of any coordinate, 1 … 255"));
  return under("lines", std::move(rows));
}

/// Pulses of an axis by commands where the tool is at (3, 4) on the circle of 5.
double share_of_overflows(std::int64_t integrand) {
  constexpr std::int64_t capacity = 5, cycles = 1000 * capacity;
  Integrator axis(capacity, 0);
  std::int64_t pulses = 0;
  for (std::int64_t m = 0; m < cycles; ++m) pulses += axis.add(integrand);
  return static_cast<double>(pulses) / static_cast<double>(cycles);
}

Rows speed_rows() {
  constexpr std::int64_t x = 3, y = 4;
  constexpr Source said = {Paper::digital_integrals, "circular interpolation, v/R = vx/x = vy/y"};
  constexpr const char* misprint = "a misprint: v/R = vx/y = vy/x, as its next line has it";
  return under(
      "speeds on a circle, at (3, 4)",
      {because(expecting(exact_row("vx/v", {"", 1}, Published(0.6, said), share_of_overflows(y)), 0.8), misprint),
       because(expecting(exact_row("vy/v", {"", 1}, Published(0.8, said), share_of_overflows(x)), 0.6), misprint)});
}

/// Arcs inside a quadrant, in registers of n bits, that the counters |x0 − xe| and |ye − y0| do not stop at their end.
Count endless_arcs(int bits, Preload preload) {
  const std::int64_t reach = (std::int64_t{1} << bits) - 1;
  std::map<std::int64_t, std::vector<Point>> circles;
  for (std::int64_t x = -reach; x <= reach; ++x) {
    for (std::int64_t y = -reach; y <= reach; ++y) circles[x * x + y * y].push_back({x, y});
  }
  circles.erase(0);
  Count count;
  const auto try_arc = [&](const Arc& arc) {
    if (pulse::borders(arc) > 0) return;
    const std::int64_t most_clocks = 16 << bits;
    const auto anything = [](Point) { return std::int64_t{0}; };
    const pulse::CircularDda dda(arc, {.order = Order::parallel, .preload = preload, .capacity = 1 << bits});
    ++count.tried;
    count.failed += !follow(dda, arc.start, arc.end, most_clocks, anything, [](const auto&) {}).ends;
  };
  for (const auto& [square, points] : circles) {
    for (const Point start : points) {
      for (const Point end : points) {
        for (const Direction direction : {Direction::clockwise, Direction::counterclockwise})
          try_arc({start, end, direction});
      }
    }
  }
  return count;
}

Rows arc_rows() {
  Rows rows;
  for (const auto& [what, preload] : {std::pair{"arcs in a quadrant that do not end, registers empty", Preload::none},
                                      std::pair{"arcs in a quadrant that do not end, half full", Preload::half}}) {
    Count all;
    for (int bits = 1; bits <= 5; ++bits) {
      const Count count = endless_arcs(bits, preload);
      all.tried += count.tried;
      all.failed += count.failed;
    }
    rows.push_back(because(exact_row(what, plain, 0, static_cast<double>(all.failed)),
                           "of " + std::to_string(all.tried) + ": all with coordinates below 2ⁿ, n = 1 … 5"));
  }
  rows.push_back(not_reproducible_row("arcs in a quadrant tried", plain, 7680,
                                      "by another computation; of which arcs is not told"));
  return under("arcs", std::move(rows));
}

}  // namespace

Rows digital_integrals_rows(const Host&) {
  Rows rows = line_rows();
  append(rows, speed_rows());
  append(rows, arc_rows());
  return rows;
}

}  // namespace leadscrew::study
