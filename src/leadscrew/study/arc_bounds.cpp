#include <leadscrew/study/bounds.hpp>
#include <leadscrew/study/circular_methods.hpp>
#include <map>

namespace leadscrew::study {

namespace {

using pulse::Arc;
using pulse::Direction;

/// All arcs between points of one circle, or of many.
struct Arcs {
  struct Kind {
    double error = 0;
    std::int64_t arcs = 0, endless = 0;  ///< endless but for the drain rule
  };
  Kind one_quadrant, more_whole, more_irrational;  ///< those of more quadrants: of whole R, and others
  double exception = 0;                            ///< error of those that were left out of the above
  std::int64_t clocks = 0, pulses = 0, not_ended = 0;
  int most_drained = 0;

  Kind& of(const Arc& arc) {
    if (pulse::borders(arc) == 0) return one_quadrant;
    const std::int64_t radius = pulse::root(arc.squared_radius(), 0);
    return radius * radius == arc.squared_radius() ? more_whole : more_irrational;
  }
};

void add(Arcs::Kind& to, const Arcs::Kind& kind) {
  to.error = std::max(to.error, kind.error);
  to.arcs += kind.arcs;
  to.endless += kind.endless;
}

void add(Arcs& to, const Arcs& arcs) {
  add(to.one_quadrant, arcs.one_quadrant);
  add(to.more_whole, arcs.more_whole);
  add(to.more_irrational, arcs.more_irrational);
  to.exception = std::max(to.exception, arcs.exception);
  to.clocks += arcs.clocks;
  to.pulses += arcs.pulses;
  to.not_ended += arcs.not_ended;
  to.most_drained = std::max(to.most_drained, arcs.most_drained);
}

void try_arc(const CircularMethod& method, const Arc& arc, Arcs& arcs) {
  const FollowedArc found = method.follow(arc);
  const double error = radial_error(found.path, arc.squared_radius());
  Arcs::Kind& kind = arcs.of(arc);
  double& worst = arc.squared_radius() == method.exception ? arcs.exception : kind.error;
  worst = std::max(worst, error);
  ++kind.arcs;
  kind.endless += found.drained > 0;
  arcs.clocks += found.path.clocks;
  arcs.pulses += found.path.pulses;
  arcs.not_ended += !found.path.ends;
  arcs.most_drained = std::max(arcs.most_drained, found.drained);
}

using LatticeCircle = std::vector<pulse::Point>;

/// Those of R² = 1 … 900 that have lattice points.
std::vector<LatticeCircle> lattice_circles() {
  constexpr std::int64_t reach = 30;
  std::map<std::int64_t, LatticeCircle> circles;
  for (std::int64_t x = -reach; x <= reach; ++x) {
    for (std::int64_t y = -reach; y <= reach; ++y) {
      const std::int64_t square = x * x + y * y;
      if (square > 0 && square <= reach * reach) circles[square].push_back({x, y});
    }
  }
  std::vector<LatticeCircle> all;
  for (auto& [square, points] : circles) all.push_back(std::move(points));
  return all;
}

Arcs try_arcs(const CircularMethod& method, const LatticeCircle& circle) {
  Arcs arcs;
  for (const pulse::Point start : circle) {
    for (const pulse::Point end : circle) {
      for (const Direction direction : {Direction::clockwise, Direction::counterclockwise})
        try_arc(method, {start, end, direction}, arcs);
    }
  }
  return arcs;
}

Row error_row(std::string what, double bound, double error) {
  if (bound != no_bound) return limit_row(std::move(what), {"BLU", 2}, bound, error);
  Row row = measured_row(std::move(what), {"BLU", 4}, error);
  row.why = untold_bound;
  return row;
}

Row endless_row(const std::string& kind, int expected, const Arcs::Kind& found) {
  const std::string what = "endless without the drain rule, " + kind;
  const auto count = static_cast<double>(found.endless);
  Row row = expected < 0 ? measured_row(what, {"arcs", 0}, count) : exact_row(what, {"arcs", 0}, expected, count);
  row.why = "of " + std::to_string(found.arcs);
  return row;
}

Rows rows_of(const CircularMethod& method, const Arcs& arcs) {
  const double more = std::max(arcs.more_whole.error, arcs.more_irrational.error);
  Rows rows = {error_row("greatest error in one quadrant", method.one_quadrant, arcs.one_quadrant.error),
               error_row("greatest error through more", method.more, more)};
  if (method.exception > 0) {
    rows.push_back(
        exact_row("greatest error where R² = " + std::to_string(method.exception), {"BLU", 3}, 0.586, arcs.exception));
    rows.back().why = "the exception: left out of the above";
  }
  rows.push_back(limit_row("arcs that do not end at their end", {"arcs", 0}, 0, static_cast<double>(arcs.not_ended)));
  rows.push_back(measured_row("clocks of all arcs", {"", 0}, static_cast<double>(arcs.clocks)));
  rows.push_back(measured_row("of them with a pulse", {"", 0}, static_cast<double>(arcs.pulses)));
  if (method.name.starts_with("DDA")) {
    const int none_or_untold = method.endless < 0 ? -1 : 0;
    rows.push_back(endless_row("one quadrant", none_or_untold, arcs.one_quadrant));
    rows.push_back(endless_row("more, whole R", none_or_untold, arcs.more_whole));
    rows.push_back(endless_row("more, other R", method.endless, arcs.more_irrational));
    rows.push_back(limit_row("pulses drained from one arc", {"", 0}, 1, arcs.most_drained));
  }
  return under("arcs of R² ≤ 900, " + method.name, std::move(rows));
}

}  // namespace

Rows arc_bounds(const Host& host) {
  const std::vector<LatticeCircle> circles = lattice_circles();
  std::vector<Arcs> found(circular_methods().size() * circles.size());
  share_out(host, found.size(), [&](std::size_t i) {
    found[i] = try_arcs(circular_methods()[i / circles.size()], circles[i % circles.size()]);
  });
  Rows rows;
  for (std::size_t m = 0; m < circular_methods().size(); ++m) {
    Arcs all;
    for (std::size_t c = 0; c < circles.size(); ++c) add(all, found[m * circles.size() + c]);
    append(rows, rows_of(circular_methods()[m], all));
  }
  return rows;
}

}  // namespace leadscrew::study
