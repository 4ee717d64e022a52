#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/tool_clearance.hpp>
#include <limits>

namespace leadscrew::surfaces {

using numeric::difference;
using numeric::dot;
using numeric::sum;

double distance_from_tool(const Cutter& cutter, const ToolPose& pose, const Vector& point) {
  const Vector d = difference(point, pose.tip);
  const double height = dot(d, pose.axis), from_axis = std::sqrt(std::max(0.0, dot(d, d) - height * height));
  const double aside = from_axis - (cutter.radius - cutter.corner_radius), below = cutter.corner_radius - height;
  const double out = std::max(aside, 0.0), down = std::max(below, 0.0);
  return std::sqrt(out * out + down * down) + std::min(std::max(aside, below), 0.0) - cutter.corner_radius;
}

namespace {

constexpr std::size_t fewest_places = 16, most_places = 256;  // in one direction
constexpr std::size_t block_side = 8, group_side = 4 * block_side;
constexpr int most_rounds = 16;

/// Evenly spaced over the whole range, about an eighth of the radius apart on the surface.
std::vector<double> places_of(const Surface& surface, Direction direction, double radius) {
  const Range range = surface.range(direction),
              other = surface.range(direction == Direction::u ? Direction::v : Direction::u);
  double longest = 0;
  for (const double share : {0.0, 0.5, 1.0}) {
    const double fixed = other.from + share * (other.to - other.from);
    double length = 0;
    Vector last{};
    for (std::size_t k = 0; k <= fewest_places; ++k) {
      const double run = range.from + (range.to - range.from) * static_cast<double>(k) / fewest_places;
      const Vector next = direction == Direction::u ? surface.at(run, fixed) : surface.at(fixed, run);
      if (k > 0) length += numeric::distance(last, next);
      last = next;
    }
    longest = std::max(longest, length);
  }
  const double wanted = std::clamp(8 * longest / radius, double{fewest_places}, double{most_places});
  const auto count = static_cast<std::size_t>(wanted);
  std::vector<double> places;
  for (std::size_t k = 0; k <= count; ++k) {
    places.push_back(range.from + (range.to - range.from) * static_cast<double>(k) / static_cast<double>(count));
  }
  return places;
}

/// The distance's gradient and second derivatives about a point: the gradient g, and curvatures of the surface on which the distance is
/// the same, along the meridian m and around the axis c.
struct Slope {
  Vector gradient{}, meridian{}, around{};
  double by_meridian = 0, by_around = 0;
};
Slope slope_at(const Cutter& cutter, const ToolPose& pose, const Vector& point) {
  const Vector d = difference(point, pose.tip);
  const double height = dot(d, pose.axis);
  Vector radial = sum(d, -height, pose.axis);
  const double from_axis = numeric::norm(radial);
  const double aside = from_axis - (cutter.radius - cutter.corner_radius), below = cutter.corner_radius - height;
  Slope slope;
  if (!(from_axis > 1e-12 * cutter.radius)) {
    slope.gradient = sum(Vector{}, -1, pose.axis);
    return slope;
  }
  for (double& x : radial) x /= from_axis;
  const bool is_corner = aside > 0 && below > 0;
  const double size = numeric::hypot(aside, below);
  const double out = is_corner ? aside / size : aside > below ? 1 : 0, down = is_corner ? below / size : 1 - out;
  slope.gradient = sum(sum(Vector{}, out, radial), -down, pose.axis);
  slope.meridian = sum(sum(Vector{}, down, radial), out, pose.axis);
  slope.around = {pose.axis[1] * radial[2] - pose.axis[2] * radial[1],
                  pose.axis[2] * radial[0] - pose.axis[0] * radial[2],
                  pose.axis[0] * radial[1] - pose.axis[1] * radial[0]};
  slope.by_meridian = is_corner ? 1 / size : 0;
  slope.by_around = out / from_axis;
  return slope;
}

}  // namespace

ToolClearance::ToolClearance(const Surface& surface, const Cutter& cutter) : surface_(surface), cutter_(cutter) {
  const std::array<std::vector<double>, 2> places = {places_of(surface, Direction::u, cutter.radius),
                                                     places_of(surface, Direction::v, cutter.radius)};
  for (std::size_t j = 0; j < places[1].size(); j += group_side) {
    for (std::size_t i = 0; i < places[0].size(); i += group_side) add_group(places, i, j);
  }
}

/// Of the points from the first on, to the last and without it.
ToolClearance::Block ToolClearance::around(std::size_t first, std::size_t last) const {
  Block block{{}, 0, first, last};
  const double share = 1 / static_cast<double>(last - first);
  for (std::size_t k = first; k < last; ++k) block.centre = sum(block.centre, share, points_[k].position);
  for (std::size_t k = first; k < last; ++k)
    block.radius = std::max(block.radius, numeric::distance(block.centre, points_[k].position));
  return block;
}

/// Of the places from u number i and v number j on.
void ToolClearance::add_group(const std::array<std::vector<double>, 2>& places, std::size_t i, std::size_t j) {
  const std::size_t last_u = std::min(i + group_side, places[0].size()),
                    last_v = std::min(j + group_side, places[1].size());
  const std::size_t first_point = points_.size(), first_block = blocks_.size();
  for (std::size_t v = j; v < last_v; v += block_side) {
    for (std::size_t u = i; u < last_u; u += block_side) {
      const std::size_t first = points_.size();
      for (std::size_t l = v; l < std::min(v + block_side, last_v); ++l) {
        for (std::size_t k = u; k < std::min(u + block_side, last_u); ++k) {
          points_.push_back({surface_.at(places[0][k], places[1][l]), places[0][k], places[1][l]});
        }
      }
      blocks_.push_back(around(first, points_.size()));
    }
  }
  groups_.push_back(around(first_point, points_.size()));
  groups_.back().first = first_block;
  groups_.back().last = blocks_.size();
}

/// Newton's method, or down the gradient where the distance is not convex; halved where it does not get less.
ToolClearance::Place ToolClearance::refined(const ToolPose& pose, Place place) const {
  const Range u = surface_.range(Direction::u), v = surface_.range(Direction::v);
  place.distance = distance_from_tool(cutter_, pose, surface_.at(place.u, place.v));
  for (int round = 0; round < most_rounds; ++round) {
    const SurfaceJet jet = surface_.jet_of_second_order(place.u, place.v);
    const Slope slope = slope_at(cutter_, pose, jet.s);
    const Vector& g = slope.gradient;
    const auto second = [&](const Vector& a, const Vector& b, const Vector& ab) {
      return slope.by_meridian * dot(slope.meridian, a) * dot(slope.meridian, b) +
             slope.by_around * dot(slope.around, a) * dot(slope.around, b) + dot(g, ab);
    };
    double by_u = dot(g, jet.u), by_v = dot(g, jet.v);
    double uu = second(jet.u, jet.u, jet.uu), uv = second(jet.u, jet.v, jet.uv), vv = second(jet.v, jet.v, jet.vv);
    const double E = dot(jet.u, jet.u), G = dot(jet.v, jet.v), least = 1e-3 / cutter_.radius;
    // What would leave the range stays at its border.
    const bool u_stays = (place.u <= u.from && by_u > 0) || (place.u >= u.to && by_u < 0);
    const bool v_stays = (place.v <= v.from && by_v > 0) || (place.v >= v.to && by_v < 0);
    if (u_stays) by_u = uv = 0;
    if (v_stays) by_v = uv = 0;
    const bool is_convex = uu > least * E && vv > least * G && uu * vv - uv * uv > 1e-3 * uu * vv;
    if (!is_convex) uu = E / cutter_.radius, vv = G / cutter_.radius, uv = 0;
    const double determinant = uu * vv - uv * uv;
    const double du = -(vv * by_u - uv * by_v) / determinant, dv = -(uu * by_v - uv * by_u) / determinant;
    bool got_less = false;
    for (double share = 1; share > 1e-3 && !got_less; share /= 3) {
      const double next_u = std::clamp(place.u + share * du, u.from, u.to),
                   next_v = std::clamp(place.v + share * dv, v.from, v.to);
      const double distance = distance_from_tool(cutter_, pose, surface_.at(next_u, next_v));
      if (!(distance < place.distance - 1e-10)) continue;
      got_less = true;
      place = {distance, next_u, next_v};
    }
    if (!got_less) break;
  }
  return place;
}

ToolClearance::Place ToolClearance::least(const ToolPose& pose, const Place& near, double enough) const {
  Place coarse{std::numeric_limits<double>::infinity(), near.u, near.v};
  double limit = std::numeric_limits<double>::infinity(), finest = 0;
  std::vector<std::pair<double, std::size_t>> order;
  for (const Block& group : groups_) {
    if (!(distance_from_tool(cutter_, pose, group.centre) - group.radius < enough)) continue;
    for (std::size_t b = group.first; b < group.last; ++b) {
      const double at_least = distance_from_tool(cutter_, pose, blocks_[b].centre) - blocks_[b].radius;
      if (at_least < enough) order.emplace_back(at_least, b);
    }
  }
  std::sort(order.begin(), order.end());
  for (const auto& [at_least, b] : order) {
    if (at_least > limit) break;
    for (std::size_t k = blocks_[b].first; k < blocks_[b].last; ++k) {
      const double distance = distance_from_tool(cutter_, pose, points_[k].position);
      if (distance < coarse.distance) {
        coarse = {distance, points_[k].u, points_[k].v};
        finest = blocks_[b].radius / 4;
      }
    }
    limit = std::min(limit, coarse.distance);
  }
  // Points are no farther apart than the sphere's radius over a few: what is far from all of them needs no refinement.
  if (coarse.distance > enough + finest) return coarse;
  const Place best = refined(pose, near), fine = refined(pose, coarse);
  return fine.distance < best.distance ? fine : best;
}

}  // namespace leadscrew::surfaces
