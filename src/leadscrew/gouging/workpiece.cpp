#include <algorithm>
#include <cmath>
#include <leadscrew/gouging/distance.hpp>
#include <leadscrew/gouging/refine.hpp>
#include <leadscrew/gouging/workpiece.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <utility>

namespace leadscrew::gouging {

namespace {

using numeric::difference;
using numeric::dot;

constexpr std::uint32_t cells_of_leaf = 4;

/// Both triangles of a cell.
void test_cell(const Part& part, const ToolFrame& frame, const Cell& cell, std::uint32_t number, Hit& best) {
  std::array<Vector, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) corners[k] = frame.to_tool(cell.corners[k]);
  for (std::size_t k = 0; k < 2; ++k) {
    const Nearest nearest = nearest_of_triangle(part, {corners[0], corners[k + 1], corners[k + 2]}, best.distance);
    if (nearest.distance < best.distance) best = {nearest.distance, number, nearest.place};
  }
}

struct Bounds {
  Vector low{}, high{};
};

Bounds bounds_of(const std::vector<Cell>& cells, std::uint32_t first, std::uint32_t count) {
  Bounds bounds{cells[first].corners[0], cells[first].corners[0]};
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (const Vector& corner : cells[i].corners) {
      for (std::size_t k = 0; k < 3; ++k) {
        bounds.low[k] = std::min(bounds.low[k], corner[k]);
        bounds.high[k] = std::max(bounds.high[k], corner[k]);
      }
    }
  }
  return bounds;
}

}  // namespace

Workpiece::Workpiece(std::vector<std::shared_ptr<const surfaces::Surface>> surfaces, double sag, std::size_t most)
    : surfaces_(std::move(surfaces)), sag_(sag) {
  std::size_t least = 0;
  for (const auto& surface : surfaces_) least += least_cells(*surface);
  fits_ = least <= most / 2;
  if (!fits_) return;
  while (!tessellate_all(most / 2)) {
  }
  build();
}

/// False, with another sag, where there would be too many: their number is inversely proportional to it.
bool Workpiece::tessellate_all(std::size_t most) {
  cells_.clear();
  double done = 0;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const double share = tessellate(*surfaces_[i], static_cast<std::uint32_t>(i), sag_, most, cells_);
    done += share;
    if (share < 1) {
      sag_ *= std::clamp(1.2 * static_cast<double>(surfaces_.size()) / std::max(done, 1e-3), 1.5, 1e3);
      return false;
    }
  }
  return true;
}

/// Halved at the median along the longest side of the box, so that the tree is as deep as it must be.
void Workpiece::build() {
  if (cells_.empty()) return;
  struct Open {
    std::uint32_t node, first, count;
  };
  nodes_.reserve(cells_.size());
  nodes_.emplace_back();
  std::vector<Open> open = {{0, 0, static_cast<std::uint32_t>(cells_.size())}};
  while (!open.empty()) {
    const Open of = open.back();
    open.pop_back();
    const Bounds bounds = bounds_of(cells_, of.first, of.count);
    std::size_t longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      nodes_[of.node].center[k] = (bounds.low[k] + bounds.high[k]) / 2;
      nodes_[of.node].half[k] = (bounds.high[k] - bounds.low[k]) / 2;
      if (nodes_[of.node].half[k] > nodes_[of.node].half[longest]) longest = k;
    }
    nodes_[of.node].first = of.first;
    nodes_[of.node].count = of.count;
    if (of.count <= cells_of_leaf) continue;
    const std::uint32_t low = of.count / 2;
    const auto begin = cells_.begin() + of.first;
    std::nth_element(begin, begin + low, begin + of.count, [&](const Cell& a, const Cell& b) {
      return a.corners[0][longest] + a.corners[2][longest] < b.corners[0][longest] + b.corners[2][longest];
    });
    const auto child = static_cast<std::uint32_t>(nodes_.size());
    nodes_[of.node].first = child;
    nodes_[of.node].count = 0;
    nodes_.resize(nodes_.size() + 2);
    open.push_back({child + 1, of.first + low, of.count - low});
    open.push_back({child, of.first, low});
  }
}

/// The distance is convex, so that its tangent plane at the box's middle bounds it from below; and what lies above the part's
/// top is as far as that.
double Workpiece::bound_of(const Part& part, const Pose& pose, const Node& node) const {
  const Vector from_tip = difference(node.center, pose.tip);
  const double z = dot(from_tip, pose.axis);
  Vector across = numeric::sum(from_tip, -z, pose.axis);
  const double rho = numeric::norm(across);
  const SignedDistance at = signed_distance(part, rho, z);
  const double of_across = rho > 0 ? at.by_rho / rho : 0;
  double reach = 0, height = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    reach += std::abs(of_across * across[k] + at.by_z * pose.axis[k]) * node.half[k];
    height += std::abs(pose.axis[k]) * node.half[k];
  }
  const double least = at.value - reach, above = z - height - part.top;
  return above > 0 ? std::max(least, above) : least;
}

double Workpiece::reach_from(const Vector& place) const {
  if (nodes_.empty()) return 0;
  return numeric::distance(place, nodes_[0].center) + numeric::norm(nodes_[0].half);
}

Hit Workpiece::nearest(const Part& part, const Pose& pose, double bound, std::uint32_t near) const {
  Hit best{bound};
  if (nodes_.empty()) return best;
  const ToolFrame frame(pose);
  if (near < cells_.size()) test_cell(part, frame, cells_[near], near, best);
  struct Open {
    std::uint32_t node;
    double bound;
  };
  std::array<Open, 64> open;  // one for each level of a tree that is halved
  std::size_t count = 0;
  open[count++] = {0, bound_of(part, pose, nodes_[0])};
  while (count > 0) {
    const Open next = open[--count];
    if (next.bound >= best.distance) continue;
    const Node& node = nodes_[next.node];
    if (node.count > 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        if (i != near) test_cell(part, frame, cells_[i], i, best);
      }
      continue;
    }
    Open nearer = {node.first, bound_of(part, pose, nodes_[node.first])};
    Open farther = {node.first + 1, bound_of(part, pose, nodes_[node.first + 1])};
    if (farther.bound < nearer.bound) std::swap(nearer, farther);
    if (farther.bound < best.distance) open[count++] = farther;
    if (nearer.bound < best.distance) open[count++] = nearer;
  }
  if (best.cell != Hit::no_cell) best.place = frame.from_tool(best.place);
  return best;
}

SurfacePlace Workpiece::refined(const Part& part, const Pose& pose, const Hit& hit) const {
  const Cell& cell = cells_[hit.cell];
  const auto [u, v] = parameters_in(cell, hit.place);
  const RefinedPlace place =
      nearest_on(*surfaces_[cell.surface], part, pose, u, v, {cell.u.to - cell.u.from, cell.v.to - cell.v.from});
  return {place.distance, cell.surface, place.u, place.v, place.place};
}

}  // namespace leadscrew::gouging
