#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/study/butterfly.hpp>
#include <leadscrew/study/optima.hpp>
#include <leadscrew/study/studies.hpp>

namespace leadscrew::study {

namespace {

/// A map from arc length to parameter by quintic Hermite pieces, as fine as a speed fluctuation asks.
struct ExpectedMap {
  double fluctuation;
  std::size_t pieces;
};
constexpr std::array<ExpectedMap, 3> expected_maps = {{{1e-4, 336}, {1e-5, 534}, {1e-6, 844}}};

double total_length(const std::vector<geometry::Nurbs>& pieces) {
  double length = 0;
  for (const geometry::Nurbs& piece : pieces) length += piece.length();
  return length;
}

/// Greatest ||dC/ds| − 1|: by how much the speed differs from what is asked for.
double speed_fluctuation(const std::vector<geometry::Nurbs>& pieces) {
  constexpr int samples = 50000;
  double most = 0;
  for (const geometry::Nurbs& piece : pieces) {
    for (int i = 0; i <= samples; ++i) {
      const geometry::PointJet jet = piece.jets(piece.length() * i / samples);
      most = std::max(most, std::abs(std::hypot(jet[0].first, jet[1].first, jet[2].first) - 1));
    }
  }
  return most;
}

std::string power_of_ten(double value) {
  return "1e" + decimal(std::log10(value), 0);
}

Rows map_rows(const ExpectedMap& expected) {
  const auto pieces = geometry::smooth_pieces(butterfly(), {expected.fluctuation, INFINITY, INFINITY});
  std::size_t count = 0;
  for (const geometry::Nurbs& piece : pieces) count += piece.map_pieces();
  const std::string asked = " for speed fluctuation below " + power_of_ten(expected.fluctuation);
  Row map =
      exact_row("pieces of the map" + asked, {"", 0}, static_cast<double>(expected.pieces), static_cast<double>(count));
  map.why = "expected: quintic Hermite pieces of a prototype; here every span is halved at least once";
  const Row measured =
      limit_row("measured" + asked, {"ppm", 3}, 1e6 * expected.fluctuation, 1e6 * speed_fluctuation(pieces));
  return {map, measured};
}

Rows curve_rows() {
  const auto pieces = geometry::smooth_pieces(butterfly());
  double radius = INFINITY;
  for (const geometry::Nurbs& piece : pieces) radius = std::min(radius, min_radius(piece));
  Rows rows = {exact_row("length", {"mm", 4}, butterfly_length, total_length(pieces)),
               exact_row("smallest radius of curvature", {"mm", 4}, butterfly_min_radius, radius)};
  for (const ExpectedMap& expected : expected_maps) append(rows, map_rows(expected));
  return rows;
}

Rows motion_rows(const Optimum& optimum) {
  const PartProgram program = butterfly_optima().program(optimum.feed);
  const machine::Machine machine = machine_with(optimum.limits, base::Period{});
  const auto planned = plan(program, machine, {});
  if (!planned) return {not_run_row("motion", planned.error().message)};
  const auto judged = judge(program, machine);
  if (!judged) return {not_run_row("words", judged.error().message)};
  return time_rows(optimum, planned->seconds, judged->summary.bound_s);
}

}  // namespace

Rows butterfly_rows(const Host&) {
  Rows rows = under("butterfly, the curve", curve_rows());
  for (const Optimum& optimum : butterfly_optima().optima)
    append(rows, under(circumstances(butterfly_optima(), optimum), motion_rows(optimum)));
  return rows;
}

}  // namespace leadscrew::study
