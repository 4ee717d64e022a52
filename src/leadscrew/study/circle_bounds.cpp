#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/circular_search.hpp>
#include <leadscrew/study/bounds.hpp>
#include <leadscrew/study/lattice_path.hpp>
#include <map>
#include <numbers>

namespace leadscrew::study {

namespace {

using pulse::Arc;
using pulse::CircularDda;
using pulse::CircularSearch;
using pulse::Direction;
using pulse::OnCircle;
using pulse::Order;
using pulse::Preload;
using pulse::Search;

struct Followed {
  LatticePath path;
  int drained = 0;  ///< pulses that came of an axis left over with an integrand of 0
};

template <Search method, OnCircle on_circle = OnCircle::outward>
Followed search(const Arc& arc) {
  return {follow_arc(CircularSearch<method, on_circle>(arc), arc)};
}

template <Order order, Preload preload, int places = 0>
Followed dda(const Arc& arc) {
  Followed followed;
  followed.path = follow_arc(CircularDda(arc, {order, preload, places}), arc, [&](const CircularDda& dda) {
    followed.drained += (dda.left_x() == 0 && dda.at().x == 0) || (dda.left_y() == 0 && dda.at().y == 0);
  });
  return followed;
}

/// A bound that was found by trying all circles up to this radius.
struct Bound {
  double error = 0;  ///< BLU
  int decimals = 0;
  std::int64_t radius = 0;
};

constexpr double none = 0;  // no bound was told

struct Method {
  std::string name;
  Followed (*follow)(const Arc&);
  double clocks_by_radius;  ///< on a full circle
  std::vector<Bound> circles;
  double one_quadrant = none, more = none;  ///< bounds of arcs, BLU
  std::int64_t exception = 0;               ///< R² of arcs that keep another bound
  int endless = -1;                         ///< arcs that would not end without the drain rule, all of irrational R
};

const std::vector<Method>& methods() {
  constexpr double eighths = 8, diagonal = 4 * std::numbers::sqrt2, turn = 2 * std::numbers::pi;
  static const std::vector<Method> all = {
      {"point comparison", search<Search::point_comparison>, eighths, {{0.9990, 4, 500}}},
      {"point comparison, inward on the circle",
       search<Search::point_comparison, OnCircle::inward>,
       eighths,
       {{1, 4, 500}}},
      {"least error", search<Search::least_error>, diagonal, {{0.4992, 4, 500}, {0.49987, 5, 3000}}, 0.5, 0.5},
      {"improved least error",
       search<Search::improved_least_error>,
       diagonal,
       {{0.4992, 4, 500}, {0.49987, 5, 3000}},
       0.5,
       0.5,
       2},
      {"DDA, parallel, empty", dda<Order::parallel, Preload::none>, turn, {{1.8025, 4, 4096}}, none, none, 0, 960},
      {"DDA, parallel, half", dda<Order::parallel, Preload::half>, turn, {{1.29, 2, 2000}}, none, none, 0, 0},
      {"DDA, parallel, half in the lagging axis", dda<Order::parallel, Preload::half_lagging>, turn, {{1.31, 2, 500}}},
      {"DDA, parallel, full", dda<Order::parallel, Preload::full>, turn, {{0.9995, 4, 4096}}},
      {"DDA, x first, empty", dda<Order::x_first, Preload::none>, turn, {{1.4675, 4, 4096}}, 1.45, 1.92, 0, 4624},
      {"DDA, x first, half", dda<Order::x_first, Preload::half>, turn, {{0.9655, 4, 4096}}, 0.94, 1.43, 0, 4032},
      {"DDA, x first, full", dda<Order::x_first, Preload::full>, turn, {}},
      {"DDA, shrinking axis first, empty", dda<Order::shrinking_first, Preload::none>, turn, {}},
      {"DDA, shrinking axis first, half",
       dda<Order::shrinking_first, Preload::half>,
       turn,
       {{0.950, 3, 2000}},
       0.94,
       1.43,
       0,
       8064},
      {"DDA, growing axis first, empty",
       dda<Order::growing_first, Preload::none>,
       turn,
       {{1.022, 3, 2000}},
       none,
       none,
       0,
       1024},
      {"DDA, growing axis first, half",
       dda<Order::growing_first, Preload::half>,
       turn,
       {{0.9655, 4, 4096}},
       0.94,
       1.43,
       0,
       0},
      {"DDA, x first, half, R to 8 binary places", dda<Order::x_first, Preload::half, 8>, turn, {}, 0.94, 1.43},
      {"DDA, growing axis first, half, R to 8 binary places",
       dda<Order::growing_first, Preload::half, 8>,
       turn,
       {},
       0.94,
       1.43},
  };
  return all;
}

constexpr const char* no_bound = "the table of bounds has none";

double half_digit(int decimals) {
  return 0.5 * std::pow(10, -decimals);
}

// ---------------------------------------------------------------------------------------------------------------------

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

Rows rows_of(const Method& method, const Circles& circles) {
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
  for (const Bound& bound : method.circles) {
    if (told == greatest) break;
    told = std::min(bound.radius, greatest);
    rows.push_back(limit_row(error_to(told), {"BLU", bound.decimals}, bound.error, worst_to(circles, told),
                             half_digit(bound.decimals)));
    if (told < bound.radius) rows.back().why = "the bound is that of R = " + std::to_string(bound.radius);
  }
  if (told < greatest) {
    rows.push_back(measured_row(error_to(greatest), {"BLU", 5}, worst_to(circles, greatest)));
    rows.back().why = told == 0 ? no_bound : "the bound goes to R = " + std::to_string(told);
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

// ---------------------------------------------------------------------------------------------------------------------

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

void try_arc(const Method& method, const Arc& arc, Arcs& arcs) {
  const Followed found = method.follow(arc);
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

Arcs try_arcs(const Method& method, const LatticeCircle& circle) {
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
  if (bound != none) return limit_row(std::move(what), {"BLU", 2}, bound, error);
  Row row = measured_row(std::move(what), {"BLU", 4}, error);
  row.why = no_bound;
  return row;
}

Row endless_row(const std::string& kind, int published, const Arcs::Kind& found) {
  const std::string what = "endless without the drain rule, " + kind;
  const auto count = static_cast<double>(found.endless);
  Row row = published < 0 ? measured_row(what, {"arcs", 0}, count) : exact_row(what, {"arcs", 0}, published, count);
  row.why = "of " + std::to_string(found.arcs);
  return row;
}

Rows rows_of(const Method& method, const Arcs& arcs) {
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

Rows circle_bounds(const Host& host, std::int64_t radius) {
  const auto each = static_cast<std::size_t>(radius);
  std::vector<Circles> found(methods().size(), Circles(each));
  share_out(host, found.size() * each, [&](std::size_t i) {
    const auto r = static_cast<std::int64_t>(i % each + 1);
    const Arc circle{{r, 0}, {r, 0}, Direction::counterclockwise};
    const LatticePath path = methods()[i / each].follow(circle).path;
    found[i / each][i % each] = {radial_error(path, r * r), path.clocks, path.pulses, path.ends};
  });
  Rows rows;
  for (std::size_t m = 0; m < found.size(); ++m) append(rows, rows_of(methods()[m], found[m]));
  return rows;
}

Rows arc_bounds(const Host& host) {
  const std::vector<LatticeCircle> circles = lattice_circles();
  std::vector<Arcs> found(methods().size() * circles.size());
  share_out(host, found.size(),
            [&](std::size_t i) { found[i] = try_arcs(methods()[i / circles.size()], circles[i % circles.size()]); });
  Rows rows;
  for (std::size_t m = 0; m < methods().size(); ++m) {
    Arcs all;
    for (std::size_t c = 0; c < circles.size(); ++c) add(all, found[m * circles.size() + c]);
    append(rows, rows_of(methods()[m], all));
  }
  return rows;
}

}  // namespace leadscrew::study
