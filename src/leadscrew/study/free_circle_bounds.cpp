#include <leadscrew/pulse/free_circle.hpp>
#include <leadscrew/study/bounds.hpp>
#include <leadscrew/study/lattice_path.hpp>
#include <numbers>

namespace leadscrew::study {

namespace {

using pulse::Accumulation;
using pulse::Order;

constexpr std::int64_t greatest = 2000;  // R, BLU

struct Turn {
  double error = 0;  ///< greatest of the turn, BLU
  double drift = 0;  ///< of the radius, from begin to end of the turn, BLU
};
using Turns = std::vector<Turn>;  // R = 1, 2, …

/// ⌊2πR⌋ commands, with remainders half full.
Turn turn(std::int64_t radius, Order order, Accumulation accumulation) {
  const auto commands = static_cast<std::int64_t>(2 * std::numbers::pi * static_cast<double>(radius));
  pulse::FreeCircle circle({radius, 0}, radius, radius / 2, order, accumulation);
  LatticePath path;
  std::int64_t square = path.least = path.greatest = radius * radius;
  for (std::int64_t k = 0; k < commands; ++k) {
    circle.step();
    square = circle.at().x * circle.at().x + circle.at().y * circle.at().y;
    path.least = std::min(path.least, square);
    path.greatest = std::max(path.greatest, square);
  }
  return {radial_error(path, radius * radius), std::sqrt(static_cast<double>(square)) - static_cast<double>(radius)};
}

Turns turns(const Host& host, Order order, Accumulation accumulation) {
  Turns all(greatest);
  share_out(host, all.size(),
            [&](std::size_t i) { all[i] = turn(static_cast<std::int64_t>(i) + 1, order, accumulation); });
  return all;
}

double worst_from(const Turns& turns, std::size_t radius) {
  double worst = 0;
  for (std::size_t r = radius; r <= turns.size(); ++r) worst = std::max(worst, turns[r - 1].error);
  return worst;
}

double mean_drift(const Turns& turns) {
  double sum = 0;
  for (const Turn& each : turns) sum += each.drift;
  return sum / static_cast<double>(turns.size());
}

// ---------------------------------------------------------------------------------------------------------------------

/// Full circles, both ways, that one counter an axis does not stop where they began.
struct Missed {
  std::int64_t elsewhere = 0, endless = 0;
};

Missed missed_by(std::int64_t radius, Order order, pulse::Preload preload) {
  Missed missed;
  for (const pulse::Direction direction : {pulse::Direction::clockwise, pulse::Direction::counterclockwise}) {
    const pulse::Arc circle{{radius, 0}, {radius, 0}, direction};
    pulse::FreeCircle state(circle, preload, order, Accumulation::sign_magnitude);
    std::int64_t clocks = 40 * radius + 100;
    for (; !state.done() && clocks > 0; --clocks) state.step();
    missed.endless += !state.done();
    missed.elsewhere += state.done() && state.at() != circle.end;
  }
  return missed;
}

Row missed_row(const Host& host, const std::string& what, Order order, pulse::Preload preload,
               std::optional<double> expected) {
  std::vector<Missed> each(greatest);
  share_out(host, each.size(),
            [&](std::size_t i) { each[i] = missed_by(static_cast<std::int64_t>(i) + 1, order, preload); });
  Missed all;
  for (const Missed& missed : each) {
    all.elsewhere += missed.elsewhere;
    all.endless += missed.endless;
  }
  const auto count = static_cast<double>(all.elsewhere + all.endless);
  Row row = expected ? exact_row(what, {"circles", 0}, *expected, count) : measured_row(what, {"circles", 0}, count);
  return because(std::move(row), std::to_string(all.endless) + " of them endless, of 4000: R = 1 … 2000, both ways");
}

Rows counted_rows(const Host& host) {
  using pulse::Preload;
  return under("free circles that one counter an axis does not end where they began",
               {missed_row(host, "eq. 27, half", Order::x_first, Preload::half, 0),
                missed_row(host, "as in hardware, empty", Order::parallel, Preload::none, 4000),
                missed_row(host, "as in hardware, half", Order::parallel, Preload::half, 4000),
                missed_row(host, "as in hardware, full", Order::parallel, Preload::full, std::nullopt)});
}

/// Arcs, and full circles, of R² = 1 … 2500.
constexpr std::size_t greatest_square = 2500;

struct Ended {
  Missed missed;
  std::int64_t tried = 0;

  void run(const pulse::Arc& arc, Order order, Accumulation accumulation) {
    pulse::FreeCircle state(arc, pulse::Preload::half, order, accumulation);
    for (int clocks = 4000; !state.done() && clocks > 0; --clocks) state.step();
    ++tried;
    missed.endless += !state.done();
    missed.elsewhere += state.done() && state.at() != arc.end;
  }
};

std::vector<pulse::Point> lattice_points(std::int64_t square) {
  std::vector<pulse::Point> points;
  for (std::int64_t x = -50; x <= 50; ++x) {
    for (std::int64_t y = -50; y <= 50; ++y) {
      if (x * x + y * y == square) points.push_back({x, y});
    }
  }
  return points;
}

Ended all_arcs(const Host& host, Order order, Accumulation accumulation) {
  std::vector<Ended> each(greatest_square);
  share_out(host, each.size(), [&](std::size_t i) {
    const std::vector<pulse::Point> points = lattice_points(static_cast<std::int64_t>(i) + 1);
    for (const pulse::Point start : points) {
      for (const pulse::Point end : points) {
        for (const pulse::Direction direction : {pulse::Direction::clockwise, pulse::Direction::counterclockwise})
          each[i].run({start, end, direction}, order, accumulation);
      }
    }
  });
  Ended all;
  for (const Ended& ended : each) {
    all.missed.elsewhere += ended.missed.elsewhere;
    all.missed.endless += ended.missed.endless;
    all.tried += ended.tried;
  }
  return all;
}

Rows counted_arc_rows(const Host& host) {
  constexpr Scale arcs = {"arcs", 0};
  const auto count = [](const Missed& missed) { return static_cast<double>(missed.elsewhere + missed.endless); };
  const Ended magnitudes = all_arcs(host, Order::x_first, Accumulation::sign_magnitude);
  const Ended floors = all_arcs(host, Order::x_first, Accumulation::floor);
  const Ended hardware = all_arcs(host, Order::parallel, Accumulation::floor);
  const auto share = [&](std::string what, double expected, const Ended& ended) {
    return because(
        exact_row(std::move(what), {"%", 0}, expected, 100 * count(ended.missed) / static_cast<double>(ended.tried)),
        "expected of other arcs: which, is not told");
  };
  const std::string of = "of " + std::to_string(magnitudes.tried) + ": R² ≤ 2500, both ways, full circles too";
  return under(
      "arcs that one counter an axis does not end where they are to",
      {because(exact_row("eq. 27, half", arcs, 35624, count(magnitudes.missed)), of),
       because(exact_row("eq. 27, half: endless", arcs, 120, static_cast<double>(magnitudes.missed.endless)), of),
       because(measured_row("eq. 27, two's complement, half", arcs, count(floors.missed)), of),
       because(measured_row("as in hardware, two's complement, half", arcs, count(hardware.missed)), of),
       share("eq. 27, half: share", 11, magnitudes), share("eq. 27, two's complement, half: share", 11, floors),
       share("as in hardware, two's complement, half: share", 72, hardware),
       not_reproducible_row("arcs tried", arcs, 328352,
                            "of which arcs is not told; as many are missed of those of R² ≤ 2500")});
}

}  // namespace

Rows free_circle_bounds(const Host& host) {
  const Turns magnitudes = turns(host, Order::x_first, Accumulation::sign_magnitude);
  const Turns floors = turns(host, Order::x_first, Accumulation::floor);
  const Turns hardware = turns(host, Order::parallel, Accumulation::floor);
  Rows rows = {limit_row("magnitudes, greatest error to R = 2000", {"BLU", 3}, 1.026, worst_from(magnitudes, 1), 5e-4),
               limit_row("two's complement, greatest error of R = 20 … 2000", {"BLU", 2}, 1.2, worst_from(floors, 20)),
               measured_row("two's complement, drift of a turn, mean", {"BLU", 3}, mean_drift(floors))};
  rows = under("free circles by eq. 27, half", std::move(rows));
  Row drift = reproduced_row("two's complement, drift of a turn, mean to R = 2000", {"BLU", 3}, std::numbers::pi,
                             mean_drift(hardware), 0.1);
  drift.why = "Euler's method grows by e^2πT a turn: π BLU with T = 1/R, whatever the radius";
  append(rows, under("free circles as in hardware, half", {std::move(drift)}));
  append(rows, counted_rows(host));
  append(rows, counted_arc_rows(host));
  return rows;
}

}  // namespace leadscrew::study
