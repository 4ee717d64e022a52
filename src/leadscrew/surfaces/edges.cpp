// Edges of a surface: knots at which its normal may have a step, and has one.

#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/surfaces/pass_lines.hpp>

namespace leadscrew::surfaces {

namespace {

/// Normals farther apart than this, radians, are an edge's.
constexpr double least_edge = 1e-6;

/// Is the surface no more than continuous at a knot?
bool may_be_edge(const SurfaceForm& form, std::size_t d, double knot) {
  const auto [from, to] = std::equal_range(form.knots[d].begin(), form.knots[d].end(), knot);
  return to - from >= form.degree[d];
}

void look_along(PassLog& log, Direction across, double knot, double before, double after) {
  const Machining& machining = *log.machining;
  const bool is_u = across == Direction::u;
  const Direction along = is_u ? Direction::v : Direction::u;
  const std::vector<double> places = places_along(*machining.surface, along, is_u ? machining.v : machining.u, 9);
  for (const double place : places) {
    const auto normal = [&](double neighbour) {
      const Span span = span_of(*machining.surface, line_place(along, place, 1, neighbour));
      const LinePlace at = span.inside(line_place(along, place, 1, knot));
      return frame_of(machining.surface->jet(at.u.value, at.v.value), machining.side);
    };
    const std::optional<Frame> low = normal(before), high = normal(after);
    if (!low || !high || kinematics::angle_between(low->n, high->n) > least_edge) {
      log.fail(low && high ? PassFailure::Kind::edge : PassFailure::Kind::normal, is_u ? knot : place,
               is_u ? place : knot);
      return;
    }
  }
}

}  // namespace

void look_for_edges(PassLog& log) {
  const Machining& machining = *log.machining;
  for (const Direction across : {Direction::u, Direction::v}) {
    const Range& range = across == Direction::u ? machining.u : machining.v;
    const std::vector<double>& breaks = machining.surface->breaks(across);
    for (std::size_t k = 1; k + 1 < breaks.size() && !log.failure; ++k) {
      const double knot = breaks[k];
      if (!(knot > range.from && knot < range.to)) continue;
      if (!may_be_edge(machining.surface->form(), across == Direction::u ? 0 : 1, knot)) continue;
      look_along(log, across, knot, (breaks[k - 1] + knot) / 2, (breaks[k + 1] + knot) / 2);
    }
  }
}

}  // namespace leadscrew::surfaces
