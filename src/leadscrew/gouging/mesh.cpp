#include <algorithm>
#include <cmath>
#include <leadscrew/gouging/mesh.hpp>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::gouging {

namespace {

using numeric::difference;
using numeric::dot;
using surfaces::Direction;
using surfaces::Range;
using surfaces::Surface;

/// Bends are seen at five places of a cell; between them they may be a little greater.
constexpr double bend_margin = 1.25;
/// So many times is each span halved before it is looked at, and at most.
constexpr int least_halvings = 1, most_halvings = 24;

struct Rectangle {
  Range u, v;
  int halvings_u = 0, halvings_v = 0;
};

double middle(const Range& range) {
  return (range.from + range.to) / 2;
}

/// How much a cell's triangles may leave the surface, mm: by what bends along u, along v, and by both.
struct Bend {
  double u = 0, twist = 0, v = 0;
  double length_u = 0, length_v = 0;

  double all() const { return u + twist + v; }
};

Bend bend_of(const Surface& surface, const Rectangle& cell) {
  const double h = cell.u.to - cell.u.from, k = cell.v.to - cell.v.from;
  const std::array<std::array<double, 2>, 5> places = {{{cell.u.from, cell.v.from},
                                                        {cell.u.to, cell.v.from},
                                                        {cell.u.to, cell.v.to},
                                                        {cell.u.from, cell.v.to},
                                                        {middle(cell.u), middle(cell.v)}}};
  Bend bend;
  for (const auto& [u, v] : places) {
    // The surface of the cell's own span, also where a corner is where the next begins
    const double inside = 1e-9;
    const double at_u = u + inside * (middle(cell.u) - u), at_v = v + inside * (middle(cell.v) - v);
    const surfaces::SurfaceJet jet = surface.jet(at_u, at_v);
    const Vector normal = kinematics::cross_product(jet.u, jet.v);
    const double length = numeric::norm(normal);
    const auto along_normal = [&](const Vector& second) {
      return length > 0 ? std::abs(dot(second, normal)) / length : numeric::norm(second);
    };
    bend.u = std::max(bend.u, h * h * along_normal(jet.uu) / 8 * bend_margin);
    bend.twist = std::max(bend.twist, h * k * along_normal(jet.uv) / 4 * bend_margin);
    bend.v = std::max(bend.v, k * k * along_normal(jet.vv) / 8 * bend_margin);
    bend.length_u = std::max(bend.length_u, h * numeric::norm(jet.u));
    bend.length_v = std::max(bend.length_v, k * numeric::norm(jet.v));
  }
  return bend;
}

bool is_split_along_u(const Rectangle& cell, const Bend& bend) {
  if (cell.halvings_u < least_halvings || cell.halvings_v >= most_halvings) return true;
  if (cell.halvings_v < least_halvings || cell.halvings_u >= most_halvings) return false;
  if (bend.twist > bend.u + bend.v) return bend.length_u >= bend.length_v;
  return bend.u >= bend.v;
}

bool is_fine(const Rectangle& cell, const Bend& bend, double sag) {
  if (cell.halvings_u < least_halvings || cell.halvings_v < least_halvings) return false;
  return bend.all() <= sag || (cell.halvings_u >= most_halvings && cell.halvings_v >= most_halvings);
}

Cell cell_of(const Surface& surface, std::uint32_t number, const Rectangle& at) {
  return {{surface.at(at.u.from, at.v.from), surface.at(at.u.to, at.v.from), surface.at(at.u.to, at.v.to),
           surface.at(at.u.from, at.v.to)},
          at.u,
          at.v,
          number};
}

/// The share of the span that has been done.
double tessellate_span(const Surface& surface, std::uint32_t number, const Rectangle& span, double sag,
                       std::size_t most, std::vector<Cell>& cells) {
  std::vector<Rectangle> open = {span};  // no more than one for each halving
  double share = 0;
  while (!open.empty()) {
    Rectangle cell = open.back();
    open.pop_back();
    const Bend bend = bend_of(surface, cell);
    if (is_fine(cell, bend, sag)) {
      if (cells.size() >= most) return share;
      cells.push_back(cell_of(surface, number, cell));
      share += std::ldexp(1.0, -cell.halvings_u - cell.halvings_v);
      continue;
    }
    Rectangle other = cell;
    if (is_split_along_u(cell, bend)) {
      cell.u.to = other.u.from = middle(cell.u);
      ++cell.halvings_u, ++other.halvings_u;
    } else {
      cell.v.to = other.v.from = middle(cell.v);
      ++cell.halvings_v, ++other.halvings_v;
    }
    open.push_back(other);
    open.push_back(cell);
  }
  return 1;
}

}  // namespace

double tessellate(const Surface& surface, std::uint32_t number, double sag, std::size_t most,
                  std::vector<Cell>& cells) {
  const std::vector<double>& us = surface.breaks(Direction::u);
  const std::vector<double>& vs = surface.breaks(Direction::v);
  const double spans = static_cast<double>((us.size() - 1) * (vs.size() - 1));
  double done = 0;
  for (std::size_t j = 0; j + 1 < vs.size(); ++j) {
    for (std::size_t i = 0; i + 1 < us.size(); ++i) {
      const Rectangle span{{us[i], us[i + 1]}, {vs[j], vs[j + 1]}};
      const double share = tessellate_span(surface, number, span, sag, most, cells);
      if (share < 1) return (done + share) / spans;
      done += 1;
    }
  }
  return 1;
}

std::size_t least_cells(const Surface& surface) {
  const std::size_t spans = (surface.breaks(Direction::u).size() - 1) * (surface.breaks(Direction::v).size() - 1);
  return spans << (2 * least_halvings);
}

/// Of the two triangles, the one that the place is less far outside of, by its barycentric coordinates.
std::array<double, 2> parameters_in(const Cell& cell, const Vector& place) {
  std::array<double, 2> best = {middle(cell.u), middle(cell.v)};
  double least_outside = std::numeric_limits<double>::infinity();
  for (std::size_t triangle = 0; triangle < 2; ++triangle) {
    const Vector &o = cell.corners[0], &a = cell.corners[triangle + 1], &b = cell.corners[triangle + 2];
    const Vector p = difference(a, o), q = difference(b, o), r = difference(place, o);
    const double pp = dot(p, p), pq = dot(p, q), qq = dot(q, q), pr = dot(p, r), qr = dot(q, r);
    const double determinant = pp * qq - pq * pq;
    if (!(determinant > 0)) continue;
    const double s = (qq * pr - pq * qr) / determinant, t = (pp * qr - pq * pr) / determinant;
    const double outside = std::max({-s, -t, s + t - 1});
    if (outside >= least_outside) continue;
    least_outside = outside;
    // Shares of the cell's sides: the corners are at (0, 0), (1, 0), (1, 1), (0, 1)
    const double x = triangle == 0 ? s + t : s, y = triangle == 0 ? t : s + t;
    best = {cell.u.from + std::clamp(x, 0.0, 1.0) * (cell.u.to - cell.u.from),
            cell.v.from + std::clamp(y, 0.0, 1.0) * (cell.v.to - cell.v.from)};
  }
  return best;
}

}  // namespace leadscrew::gouging
