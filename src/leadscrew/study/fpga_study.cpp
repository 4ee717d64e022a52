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

consteval Published tabled(double figure) {
  return {figure, {Paper::fpga_interpolation, "Table 1"}};
}

Row elements_row(const Published& elements) {
  return not_reproducible_row("logic elements", {"", 0}, elements, "of their device and compiler");
}

double error_of(const LatticePath& path) {
  return radial_error(path, radius * radius);
}

Rows search_rows(const std::string& method, const Published& steps, const Published& error, const LatticePath& path,
                 const std::string& why, const Published& elements) {
  return under(method,
               {exact_row("steps", {"", 0}, steps, static_cast<double>(path.clocks)),
                because(exact_row("greatest error", {"BLU", 3}, error, error_of(path)), why), elements_row(elements)});
}

/// By either of the two conventions of a DDA in whole numbers that give both figures.
Rows fitted_dda_rows(const LatticePath& path, const std::string& convention) {
  const std::string chosen = convention + ": chosen for this figure";
  return {
      because(fitted_row("steps", {"", 0}, tabled(8), static_cast<double>(path.clocks)), "clocks; " + chosen),
      because(exact_row("pulses", {"", 0}, tabled(8), static_cast<double>(path.pulses)),
              "one clock makes none; the column is headed \"Pulse\", the text has 8 steps; no path of 8 pulses errs by "
              "less than 0.528"),
      because(fitted_row("greatest error", {"BLU", 3}, tabled(0.385), error_of(path)), chosen)};
}

Rows dda_method_rows() {
  using pulse::CircularDda;
  Rows rows = fitted_dda_rows(along(CircularDda(quarter, {pulse::Order::parallel, pulse::Preload::half_lagging})),
                              "capacity R, only the lagging axis half full");
  rows.push_back(elements_row(tabled(724)));
  rows = under("DDA", std::move(rows));
  append(rows, under("DDA, growing axis first",
                     fitted_dda_rows(along(CircularDda(quarter, {pulse::Order::growing_first, pulse::Preload::none})),
                                     "capacity R, both axes empty, the second integrates what the first has become")));
  return rows;
}

/// What other conventions would make of the same arc.
Rows other_rows() {
  using pulse::CircularDda;
  using pulse::Order;
  using pulse::Preload;
  const auto other_row = [](const std::string& what, const LatticePath& path) {
    return measured_row(what, {"BLU", 3}, error_of(path));
  };
  return under(
      "greatest error by other conventions",
      {other_row("point comparison, F = 0 inward",
                 along(CircularSearch<Search::point_comparison, pulse::OnCircle::inward>(quarter))),
       other_row("DDA, both axes half full", along(CircularDda(quarter, {Order::parallel, Preload::half}))),
       other_row("DDA, both half full, x first", along(CircularDda(quarter, {Order::x_first, Preload::half})))});
}

}  // namespace

Rows fpga_rows(const Host&) {
  Rows rows = search_rows("point comparison", tabled(10), tabled(0.877),
                          along(CircularSearch<Search::point_comparison>(quarter)),
                          "F = 0 goes outward; inward, as the text has it, the error is 1.000", tabled(690));
  append(rows, search_rows("least error", tabled(7), tabled(0.385), along(CircularSearch<Search::least_error>(quarter)),
                           "the least of |F|, whatever wins a tie", tabled(792)));
  append(rows, search_rows("improved least error", tabled(7), tabled(0.385),
                           along(CircularSearch<Search::improved_least_error>(quarter)), "", tabled(724)));
  append(rows, dda_method_rows());
  append(rows, other_rows());
  return rows;
}

}  // namespace leadscrew::study
