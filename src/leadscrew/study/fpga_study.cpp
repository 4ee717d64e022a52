#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/circular_search.hpp>
#include <leadscrew/study/lattice_path.hpp>
#include <leadscrew/study/studies.hpp>

// "FPGA-based implementation of circular interpolation": steps and errors of its methods on one quarter circle.

namespace leadscrew::study {

namespace {

using pulse::Arc;
using pulse::CircularSearch;
using pulse::Search;

constexpr std::int64_t radius = 5;
constexpr Arc quarter{{radius, 0}, {0, radius}, pulse::Direction::counterclockwise};

template <pulse::Interpolator State>
LatticePath along(State state) {
  return follow_arc(std::move(state), quarter);
}

Rows rows_of(const std::string& method, double steps, double error, const LatticePath& path, const std::string& why,
             int elements) {
  Row error_row = exact_row("greatest error", {"BLU", 3}, error, radial_error(path, radius * radius));
  error_row.why = why;
  return under(method, {exact_row("steps", {"", 0}, steps, static_cast<double>(path.clocks)), std::move(error_row),
                        not_reproducible_row("logic elements", {"", 0}, elements, "of their device and compiler")});
}

/// What other conventions would make of the same arc.
Rows other_rows() {
  using pulse::CircularDda;
  using pulse::Order;
  using pulse::Preload;
  const auto error_of = [](const std::string& what, const LatticePath& path) {
    return measured_row(what, {"BLU", 3}, radial_error(path, radius * radius));
  };
  return under(
      "greatest error by other conventions",
      {error_of("point comparison, F = 0 inward",
                along(CircularSearch<Search::point_comparison, pulse::OnCircle::inward>(quarter))),
       error_of("DDA, both axes half full", along(CircularDda(quarter, {Order::parallel, Preload::half}))),
       error_of("DDA, both half full, x first", along(CircularDda(quarter, {Order::x_first, Preload::half})))});
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
  append(rows, other_rows());
  return rows;
}

}  // namespace leadscrew::study
