#include <cmath>
#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/circular_search.hpp>
#include <leadscrew/study/studies.hpp>

// "Four circular interpolators in an FPGA": steps and errors of its methods on one quarter circle.

namespace leadscrew::study {

namespace {

using pulse::Arc;
using pulse::CircularSearch;
using pulse::Search;

constexpr std::int64_t radius = 5;
constexpr Arc quarter{{radius, 0}, {0, radius}, pulse::Direction::counterclockwise};

struct Found {
  double clocks = 0, worst = 0;
};

template <pulse::Interpolator State>
Found along(State state) {
  Found found;
  pulse::Point at = quarter.start;
  while (!state.done()) {
    const auto pulse = state.step();
    at.x += pulse.step[0];
    at.y += pulse.step[1];
    ++found.clocks;
    const double distance = std::hypot(static_cast<double>(at.x), static_cast<double>(at.y));
    found.worst = std::max(found.worst, std::abs(distance - static_cast<double>(radius)));
  }
  return found;
}

Rows rows_of(const std::string& method, double steps, double error, const Found& found, const std::string& why,
             int elements) {
  Row error_row = exact_row("greatest error", {"BLU", 3}, error, found.worst);
  error_row.why = why;
  return under(method, {exact_row("steps", {"", 0}, steps, found.clocks), std::move(error_row),
                        not_run_row("logic elements", "published " + std::to_string(elements) +
                                                          ": a figure of their device and compiler")});
}

}  // namespace

Rows fpga_rows(const Host&) {
  Rows rows = rows_of("point comparison", 10, 0.877, along(CircularSearch<Search::point_comparison>(quarter)),
                      "F = 0 goes outward; inward, as the text has it, the error is 1.000", 690);
  append(rows, rows_of("least error", 7, 0.385, along(CircularSearch<Search::least_error>(quarter)),
                       "the least of |F|, whatever wins a tie", 792));
  append(rows, rows_of("improved least error", 7, 0.385, along(CircularSearch<Search::improved_least_error>(quarter)),
                       "", 724));
  append(rows,
         rows_of("DDA", 8, 0.385,
                 along(pulse::CircularDda(quarter, {pulse::Order::parallel, pulse::Preload::half_lagging})),
                 "steps are clocks, one of which makes no pulse; capacity R, only the lagging axis half full", 724));
  return rows;
}

}  // namespace leadscrew::study
