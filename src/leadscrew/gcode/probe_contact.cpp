#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/patch_meeting.hpp>
#include <leadscrew/gcode/probe_contact.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <limits>

namespace leadscrew::gcode {

namespace {

using machine::ProbeBody;
using machine::Vector;
using BodyKind = ProbeBody::Kind;

constexpr double shortest_stretch = 4 * contact_rounding;  // mm of a line

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector first_three(const base::AxisVector& a) {
  return {a[0], a[1], a[2]};
}

bool is_box(BodyKind kind) {
  return kind == BodyKind::box || kind == BodyKind::pocket;
}

/// How far a point is outside the body, mm: no more than it is, below 0 inside.
double outside(const ProbeBody& body, const Vector& point) {
  const Vector from = numeric::difference(point, body.from);
  if (body.kind == BodyKind::sphere) return numeric::norm(from) - body.radius;
  if (is_box(body.kind)) {
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) most = std::max({most, body.from[i] - point[i], point[i] - body.to[i]});
    return most;
  }
  const Vector axis = numeric::difference(body.to, body.from);
  const double height = numeric::norm(axis), along = numeric::dot(from, axis) / height;
  return std::max({numeric::norm(cross(from, axis)) / height - body.radius, -along, along - height});
}

/// Of the axis that goes farthest.
double longest_way(const base::AxisVector& way) {
  double longest = 0;
  for (const double each : way) longest = std::max(longest, std::abs(each));
  return longest;
}

/// The shares t at which |m + t d| = radius, of vectors across an axis, or of any.
void cross_round(const Vector& m, const Vector& d, double radius, const auto& add) {
  const double a = numeric::dot(d, d), b = numeric::dot(m, d);
  const Vector normal = cross(d, m);
  const double square = a * radius * radius - numeric::dot(normal, normal);  // a quarter of the discriminant
  if (!(a > 0 && square > 0)) return;
  const double q = -(b + std::copysign(std::sqrt(square), b));
  const double reach = numeric::norm(m);
  add(q / a);
  add((reach - radius) * (reach + radius) / q);
}

}  // namespace

ProbeContact::Gap ProbeContact::gap(const base::AxisVector& position) const {
  double material = std::numeric_limits<double>::infinity(), cut = -material;
  for (std::size_t i = 0; i < base::axis_count; ++i) {
    if (probe_.planes[i]) material = std::min(material, position[i] - tool_[i] - *probe_.planes[i]);
  }
  base::AxisVector point = position;
  for (std::size_t i = 0; i < 3; ++i) point[i] -= tool_[i];
  for (const ProbeBody& body : probe_.bodies) {
    const double distance = outside(body, first_three(point));
    if (machine::is_hollow(body.kind)) {
      cut = std::max(cut, -distance);
    } else {
      material = std::min(material, distance);
    }
  }
  return {material, cut};
}

bool ProbeContact::touches(const base::AxisVector& position) const {
  const Gap to = gap(position);
  if (to.cut > contact_rounding) return false;
  if (to.material <= contact_rounding) return true;
  return !probe_.patches.empty() &&
         is_near_patch(probe_.patches, numeric::difference(first_three(position), first_three(tool_)),
                       contact_rounding);
}

void ProbeContact::cross_plane(const Line& line, std::size_t axis, double plane, std::vector<Crossing>& found) const {
  const double before = line.start[axis] - tool_[axis] - plane, behind = line.target[axis] - tool_[axis] - plane;
  if (before != behind) found.push_back({before / (before - behind), axis, plane});
}

void ProbeContact::cross_body(const Line& line, const ProbeBody& body, std::vector<Crossing>& found) const {
  if (is_box(body.kind)) {
    for (std::size_t i = 0; i < 3; ++i) {
      cross_plane(line, i, body.from[i], found);
      cross_plane(line, i, body.to[i], found);
    }
    return;
  }
  const auto add = [&](double share) { found.push_back({share}); };
  const Vector way = numeric::difference(first_three(line.target), first_three(line.start));
  const Vector start = numeric::difference(numeric::difference(first_three(line.start), first_three(tool_)), body.from);
  if (body.kind == BodyKind::sphere) return cross_round(start, way, body.radius, add);
  const Vector axis = numeric::difference(body.to, body.from);
  const double square = numeric::dot(axis, axis), speed = numeric::dot(way, axis), height = numeric::dot(start, axis);
  const auto across = [&](const Vector& v, double along) { return numeric::sum(v, -along / square, axis); };
  cross_round(across(start, height), across(way, speed), body.radius, add);
  // The ends: where the axis of the cylinder is one of the machine's, exactly.
  for (std::size_t i = 0; i < 3; ++i) {
    if (axis[(i + 1) % 3] != 0 || axis[(i + 2) % 3] != 0) continue;
    cross_plane(line, i, body.from[i], found);
    return cross_plane(line, i, body.to[i], found);
  }
  if (speed == 0) return;
  add(-height / speed);
  add((square - height) / speed);
}

// Within the line, in order, from its start.
std::vector<ProbeContact::Crossing> ProbeContact::crossings(const Line& line) const {
  std::vector<Crossing> found;
  for (std::size_t i = 0; i < base::axis_count; ++i) {
    if (probe_.planes[i]) cross_plane(line, i, *probe_.planes[i], found);
  }
  for (const ProbeBody& body : probe_.bodies) cross_body(line, body, found);
  std::erase_if(found, [](const Crossing& crossing) { return !(crossing.share > 0 && crossing.share < 1); });
  std::ranges::stable_sort(found, {}, &Crossing::share);
  found.insert(found.begin(), Crossing{0});
  return found;
}

base::AxisVector ProbeContact::at(const Line& line, double share) const {
  return numeric::sum(line.start, share, numeric::difference(line.target, line.start));
}

// The share of the line; where nothing else begins or ends between.
std::optional<double> ProbeContact::patch_between(const Line& line, double begin, double end) const {
  if (probe_.patches.empty() || gap(at(line, (begin + end) / 2)).cut > contact_rounding) return std::nullopt;
  const base::AxisVector from = at(line, begin), to = at(line, end);
  const Vector tool = first_three(tool_);
  const auto share = first_meeting(probe_.patches, numeric::difference(first_three(from), tool),
                                   numeric::difference(first_three(to), tool));
  return share ? std::optional(begin + *share * (end - begin)) : std::nullopt;
}

// Looked for on the line beside, which is the line but for rounding; told on the line.
std::optional<base::AxisVector> ProbeContact::change(const Line& line, const Line& beside, bool to_contact) const {
  const double longest = longest_way(numeric::difference(line.target, line.start));
  const double aside = longest_way(numeric::difference(beside.start, line.start));
  const auto place_at = [&](double share) { return share * longest <= 2 * aside ? line.start : at(line, share); };
  const std::vector<Crossing> found = crossings(beside);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const double begin = found[k].share, end = k + 1 < found.size() ? found[k + 1].share : 1;
    if ((end - begin) * longest < shortest_stretch) continue;
    // Of two places: a line that passes a sphere within rounding may touch it at one.
    const bool is_inside =
        touches(at(beside, begin + 0.25 * (end - begin))) && touches(at(beside, begin + 0.75 * (end - begin)));
    if (to_contact && !is_inside) {
      if (const auto share = patch_between(beside, begin, end)) return place_at(*share);
    }
    if (is_inside != to_contact) continue;
    base::AxisVector place = place_at(begin);
    const std::size_t axis = found[k].axis;
    if (axis < base::axis_count) place[axis] = found[k].coordinate + tool_[axis];
    return place;
  }
  return std::nullopt;
}

std::optional<base::AxisVector> ProbeContact::contact(const base::AxisVector& start, const base::AxisVector& target,
                                                      const base::AxisVector& left) const {
  const double way = longest_way(left), aside = way > 0 ? 2 * shortest_stretch / way : 0;
  const Line line{start, target}, beside{numeric::sum(start, aside, left), numeric::sum(target, aside, left)};
  if (const auto place = change(line, beside, true)) return place;
  // Not where the line goes along what was left.
  const bool goes_along = way > 0 && touches(at(line, 0.5));
  return touches(target) && target != start && !goes_along ? std::optional(target) : std::nullopt;
}

std::optional<base::AxisVector> ProbeContact::loss(const base::AxisVector& start,
                                                   const base::AxisVector& target) const {
  return change({start, target}, {start, target}, false);
}

}  // namespace leadscrew::gcode
