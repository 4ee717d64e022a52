#include <leadscrew/study/bounds.hpp>
#include <leadscrew/study/circular_methods.hpp>

namespace leadscrew::study {

namespace {

using pulse::Arc;
using pulse::Direction;

double half_digit(int decimals) {
  return 0.5 * std::pow(10, -decimals);
}

struct Circle {
  double error = 0;
  std::int64_t clocks = 0, pulses = 0;
  bool ends = false;
};
using Circles = std::vector<Circle>;  // R = 1, 2, …

double worst_to(const Circles& circles, std::int64_t radius) {
  double worst = 0;
  for (std::int64_t r = 1; r <= radius; ++r) worst = std::max(worst, circles[static_cast<std::size_t>(r - 1)].error);
  return worst;
}

std::string error_to(std::int64_t radius) {
  return "greatest error to R = " + std::to_string(radius);
}

Rows rows_of(const CircularMethod& method, const Circles& circles) {
  const auto greatest = static_cast<std::int64_t>(circles.size());
  double farthest = 0, not_ended = 0;
  for (std::int64_t r = 1; r <= greatest; ++r) {
    const Circle& circle = circles[static_cast<std::size_t>(r - 1)];
    const double expected = method.clocks_by_radius * static_cast<double>(r);
    farthest = std::max(farthest, std::abs(static_cast<double>(circle.clocks) - expected));
    not_ended += !circle.ends;
  }
  Rows rows;
  std::int64_t told = 0;
  for (const CircleBound& bound : method.circles) {
    if (told == greatest) break;
    told = std::min(bound.radius, greatest);
    rows.push_back(limit_row(error_to(told), {"BLU", bound.decimals}, bound.error, worst_to(circles, told),
                             half_digit(bound.decimals)));
    if (told < bound.radius) rows.back().why = "the bound is that of R = " + std::to_string(bound.radius);
  }
  if (told < greatest) {
    rows.push_back(measured_row(error_to(greatest), {"BLU", 5}, worst_to(circles, greatest)));
    rows.back().why = told == 0 ? untold_bound : "the bound goes to R = " + std::to_string(told);
  }
  const auto by_radius = [&](std::int64_t count) { return static_cast<double>(count) / static_cast<double>(greatest); };
  // Two clocks a quadrant, for what the remainders hold at its end.
  rows.push_back(reproduced_row("clocks by R, at R = " + std::to_string(greatest), {"", 4}, method.clocks_by_radius,
                                by_radius(circles.back().clocks), 8.0 / static_cast<double>(greatest)));
  rows.push_back(measured_row("clocks, farthest from that times R", {"", 2}, farthest));
  rows.push_back(measured_row("clocks with a pulse, by R", {"", 4}, by_radius(circles.back().pulses)));
  rows.push_back(limit_row("circles that do not end where they began", {"", 0}, 0, not_ended));
  return under("circles, " + method.name, std::move(rows));
}

}  // namespace

Rows circle_bounds(const Host& host, std::int64_t radius) {
  const auto each = static_cast<std::size_t>(radius);
  std::vector<Circles> found(circular_methods().size(), Circles(each));
  share_out(host, found.size() * each, [&](std::size_t i) {
    const auto r = static_cast<std::int64_t>(i % each + 1);
    const Arc circle{{r, 0}, {r, 0}, Direction::counterclockwise};
    const LatticePath path = circular_methods()[i / each].follow(circle).path;
    found[i / each][i % each] = {radial_error(path, r * r), path.clocks, path.pulses, path.ends};
  });
  Rows rows;
  for (std::size_t m = 0; m < found.size(); ++m) append(rows, rows_of(circular_methods()[m], found[m]));
  return rows;
}

}  // namespace leadscrew::study
