#include <algorithm>
#include <array>
#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/circular_search.hpp>
#include <leadscrew/study/fpga_cells.hpp>
#include <leadscrew/study/lattice_path.hpp>
#include <leadscrew/study/studies.hpp>
#include <span>
#include <string>
#include <utility>

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

constexpr Published tabled(double figure) {
  return {figure, {Paper::fpga_interpolation, "Table 1"}};
}

/// Theirs, and ours.
Rows element_rows(const Published& elements, const FpgaCells& cells) {
  return {not_reproducible_row("logic elements", {"", 0}, elements, "of their device and compiler"),
          because(measured_row("logic cells of our hardware", {"", 0}, cells.logic),
                  "16 bits, one quadrant, Cyclone IV by yosys before placing, beside " +
                      std::to_string(cells.flip_flops) + " flip-flops: hdl/syn/table_1.txt")};
}

/// Of a size among others: 1 for the least.
double rank_of(const FpgaCells& cells, std::span<const FpgaCells> among) {
  return 1.0 + static_cast<double>(
                   std::ranges::count_if(among, [&](const FpgaCells& other) { return other.logic < cells.logic; }));
}

/// Sizes themselves are of devices and compilers; their order is of the methods.
Rows order_rows() {
  constexpr std::array all = {point_comparison_cells, improved_least_error_cells, least_error_cells, dda_cells};
  const std::span searches = std::span(all).first(3);
  const auto of_three = [&](const std::string& what, double place, const FpgaCells& cells) {
    return exact_row(what + ", of the three searches", {"", 0}, tabled(place), rank_of(cells, searches));
  };
  return under(
      "order of sizes, the least first",
      {of_three("point comparison", 1, point_comparison_cells),
       of_three("improved least error", 2, improved_least_error_cells), of_three("least error", 3, least_error_cells),
       because(exact_row("DDA, of all four", {"", 0}, tabled(2), rank_of(dda_cells, all)),
               "theirs is as large as the improved search; ours begins on the X axis and has two adders, no squares")});
}

double error_of(const LatticePath& path) {
  return radial_error(path, radius * radius);
}

Rows search_rows(const std::string& method, const Published& steps, const Published& error, const LatticePath& path,
                 const std::string& why, const Rows& elements) {
  Rows rows = {exact_row("steps", {"", 0}, steps, static_cast<double>(path.clocks)),
               because(exact_row("greatest error", {"BLU", 3}, error, error_of(path)), why)};
  append(rows, elements);
  return under(method, std::move(rows));
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
  append(rows, element_rows(tabled(724), dda_cells));
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
                          "F = 0 goes outward; inward, as the text has it, the error is 1.000",
                          element_rows(tabled(690), point_comparison_cells));
  append(rows, search_rows("least error", tabled(7), tabled(0.385), along(CircularSearch<Search::least_error>(quarter)),
                           "the least of |F|, whatever wins a tie", element_rows(tabled(792), least_error_cells)));
  append(rows, search_rows("improved least error", tabled(7), tabled(0.385),
                           along(CircularSearch<Search::improved_least_error>(quarter)), "",
                           element_rows(tabled(724), improved_least_error_cells)));
  append(rows, dda_method_rows());
  append(rows, order_rows());
  append(rows, other_rows());
  return rows;
}

}  // namespace leadscrew::study
