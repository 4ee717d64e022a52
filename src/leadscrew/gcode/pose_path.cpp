#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/pose_path.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/surfaces/hermite.hpp>
#include <leadscrew/surfaces/quintic_spline.hpp>
#include <leadscrew/surfaces/touch.hpp>
#include <utility>

namespace leadscrew::gcode {

namespace {

constexpr double turn_of_angle = 360;
/// So near to a pole, radians, and so steady, 1/mm, a direction is the pole itself: on a plane, say.
constexpr double pole_itself = 1e-9, steady = 1e-9;
constexpr std::size_t most_nodes_of_curve = most_control_points / 3;
constexpr double inside_margin = 1e-3;  // mm

bool is_finite(const kinematics::Angles<numeric::Jet<2>>& angles) {
  bool all = true;
  for (const auto& angle : angles) {
    for (std::size_t k = 0; k <= 2; ++k) all = all && std::isfinite(angle[k]);
  }
  return all;
}

double rate_of(const surfaces::VectorOf<numeric::Jet<2>>& axis) {
  return numeric::hypot(axis[0][1], axis[1][1], axis[2][1]);
}

surfaces::PassNode between(const surfaces::PassNode& from, const surfaces::PassNode& to, double share) {
  const double width = to.t - from.t;
  surfaces::PassNode node;
  node.t = from.t + share * width;
  for (std::size_t k = 0; k < 3; ++k) {
    node.tip[k] = surfaces::hermite_jet(from.tip[k], to.tip[k], width, share);
    node.axis[k] = surfaces::hermite_jet(from.axis[k], to.axis[k], width, share);
    node.contact[k] = surfaces::hermite_jet(from.contact[k], to.contact[k], width, share);
  }
  node.axis = surfaces::unit_of(node.axis);
  node.u = from.u + share * (to.u - from.u);
  node.v = from.v + share * (to.v - from.v);
  return node;
}

}  // namespace

/// At a pole, and not to stay there.
bool PosePath::is_in_pole(const surfaces::PassNode& place) const {
  const kinematics::Vector direction{place.axis[0][0], place.axis[1][0], place.axis[2][0]};
  return rate_of(place.axis) >= steady &&
         kinematics::angle_from_pole(*chain_, direction) < numeric::degrees_of_radian.hi * pole_itself;
}

/// The angles of a node by one of both solutions, the shorter way round from those before.
std::optional<PoseFailure> PosePath::hold(Node& node, std::size_t side, const Angles& before, Known& solutions) const {
  const surfaces::PassNode& place = node.place;
  if (!solutions) {
    const kinematics::Vector direction{place.axis[0][0], place.axis[1][0], place.axis[2][0]};
    const auto plain = kinematics::solutions(*chain_, direction);
    if (plain.count == 0) return PoseFailure{PoseFailure::Kind::out_of_reach, place.u, place.v, plain.miss};
    const bool is_pole = kinematics::angle_from_pole(*chain_, direction) < numeric::degrees_of_radian.hi * pole_itself;
    if (is_pole && rate_of(place.axis) < steady) {
      node.angles = {Jet(before[0]), Jet(plain.angles[plain.count == 2 ? side : 0][1])};
      go_on_from(before, node);
      return std::nullopt;
    }
    solutions = kinematics::solutions(*chain_, place.axis);
  }
  if (solutions->count < 2 || !is_finite(solutions->angles[side]))
    return PoseFailure{PoseFailure::Kind::pole, place.u, place.v};
  node.angles = solutions->angles[side];
  go_on_from(before, node);
  return std::nullopt;
}

/// The shorter way round.
void PosePath::go_on_from(const Angles& before, Node& node) {
  for (std::size_t i = 0; i < 2; ++i)
    node.angles[i][0] = before[i] + std::remainder(node.angles[i][0] - before[i], turn_of_angle);
}

/// The angles of a node at a pole, from places before and behind it, either of which may lack. `angles`: those before.
std::optional<PoseFailure> PosePath::hold_through_pole(Node& node, const surfaces::PassNode* before,
                                                       const surfaces::PassNode* behind, const Angles& angles) const {
  constexpr double near = 1.0 / 64;
  constexpr double greatest_swing = 30;  // degrees
  const double t = node.place.t;
  const PoseFailure failure{PoseFailure::Kind::pole, node.place.u, node.place.v};
  node.is_given = true;
  std::optional<Node> a, b;
  if (before) a = Node{between(*before, node.place, 1 - near), {}};
  if (behind) b = Node{between(node.place, *behind, near), {}};
  Known of_a, of_b;
  if (a && hold(*a, side_, angles, of_a)) return failure;
  if (b) {
    const Angles from = a ? angles_of(*a) : angles;
    Node other = *b;
    if (hold(*b, side_, from, of_b) || hold(other, 1 - side_, from, of_b)) return failure;
    if (a && std::abs(other.angles[0][0] - from[0]) < std::abs(b->angles[0][0] - from[0])) b = other;
    if (a && std::abs(b->angles[0][0] - from[0]) > greatest_swing) return failure;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    if (a && b) {
      const double width = b->place.t - a->place.t;
      node.angles[i] = surfaces::hermite_jet(a->angles[i], b->angles[i], width, (t - a->place.t) / width);
      continue;
    }
    const Node& one = a ? *a : *b;
    const double d = t - one.place.t;
    const Jet& f = one.angles[i];
    node.angles[i].derivative = {f[0] + d * (f[1] + d * f[2] / 2), f[1] + d * f[2], f[2]};
  }
  return std::nullopt;
}

/// Do quintics of the angles hold the tool as the path says?
bool PosePath::is_held(const Node& a, const Node& b) const {
  const double width = b.place.t - a.place.t, tolerance = is_link_ ? link_tolerance : axis_tolerance;
  for (const double share : {0.5, 0.25, 0.75}) {
    surfaces::Vector axis;
    Angles angles;
    for (std::size_t k = 0; k < 3; ++k)
      axis[k] = surfaces::hermite_value(a.place.axis[k], b.place.axis[k], width, share);
    for (std::size_t i = 0; i < 2; ++i) angles[i] = surfaces::hermite_value(a.angles[i], b.angles[i], width, share);
    const surfaces::Vector wanted = surfaces::unit_of(axis), held = kinematics::direction_of(*chain_, angles);
    if (!(numeric::hypot(held[0] - wanted[0], held[1] - wanted[1], held[2] - wanted[2]) <= tolerance)) return false;
  }
  return true;
}

/// On the side so far, or else on the other, where the path goes straight through a pole.
bool PosePath::is_reached(const Node& at, Waiting& waiting, std::optional<PoseFailure>& failure) {
  Node& next = waiting.node;
  for (const std::size_t side : {side_, 1 - side_}) {
    if (!next.is_given) {
      failure = hold(next, side, angles_of(at), waiting.solutions);
      if (failure) return false;
    }
    if (!is_held(at, next)) continue;
    side_ = side;
    return true;
  }
  return false;
}

/// Depth first, from the beginning: what waits on the stack lies behind.
std::optional<PoseFailure> PosePath::add_between(const Node& from, const Node& to) {
  constexpr double beside_middle = 7.0 / 16;
  std::vector<Waiting> ahead = {{to}};
  Node at = from;
  std::optional<PoseFailure> failure;
  while (!ahead.empty()) {
    if (is_reached(at, ahead.back(), failure)) {
      if (nodes_.size() == most_nodes_in_all) break;
      at = ahead.back().node;
      nodes_.push_back(at);
      ahead.pop_back();
      continue;
    }
    if (failure) return failure;
    const surfaces::PassNode& place = ahead.back().node.place;
    if (place.t - at.place.t < (is_link_ ? least_part_of_link : least_part)) break;
    Node middle{between(at.place, place, 0.5), {}};
    if (is_in_pole(middle.place)) middle.place = between(at.place, place, beside_middle);
    ahead.push_back({std::move(middle)});
  }
  if (ahead.empty()) return std::nullopt;
  return PoseFailure{PoseFailure::Kind::pole, at.place.u, at.place.v};
}

/// Does the tool go on as it has come?
bool PosePath::joins(const Node& first) const {
  return end_ && end_->place.axis == first.place.axis && end_->place.tip == first.place.tip;
}

std::optional<PoseFailure> PosePath::add_first(surfaces::PassNode place, const surfaces::PassNode& behind) {
  Node first{std::move(place), {}};
  const Angles before = end_ ? angles_of(*end_) : angles_;
  if (joins(first)) {
    first.angles = end_->angles;
  } else if (is_in_pole(first.place)) {
    if (auto failure = hold_through_pole(first, nullptr, &behind, before)) return failure;
  } else if (Known solutions; auto failure = hold(first, side_, before, solutions)) {
    return failure;
  }
  nodes_.push_back(std::move(first));
  return std::nullopt;
}

std::optional<PoseFailure> PosePath::load(surfaces::Pass pass) {
  nodes_.clear();
  next_ = taken_from_ = 0;
  is_link_ = pass.is_link;
  number_ = pass.number;
  if (!chain_) {
    for (surfaces::PassNode& place : pass.nodes) nodes_.push_back({std::move(place), {}});
    return std::nullopt;
  }
  std::optional<PoseFailure> failure = add_first(pass.nodes[0], pass.nodes[1]);
  for (std::size_t k = 1; k < pass.nodes.size() && !failure; ++k) {
    const Node from = nodes_.back();
    Node to{pass.nodes[k], {}};
    const surfaces::PassNode* const behind = k + 1 < pass.nodes.size() ? &pass.nodes[k + 1] : nullptr;
    if (is_in_pole(to.place)) failure = hold_through_pole(to, &pass.nodes[k - 1], behind, angles_of(from));
    if (!failure) failure = add_between(from, to);
  }
  if (failure) {
    nodes_.clear();
  } else {
    end_ = nodes_.back();
  }
  return failure;
}

void PosePath::set_angles(base::AxisVector& place) const {
  for (std::size_t i = 0; chain_ && i < 2; ++i)
    place[base::index(chain_->turns()[i].axis)] = nodes_[next_].angles[i][0];
}

void PosePath::take(NurbsCurve& curve, const base::AxisVector& from, bool with_contact) {
  constexpr std::size_t coordinates = 8;  // of the tip, of rotary axes, of the contact
  const std::size_t count = std::min(nodes_.size() - next_, most_nodes_of_curve);
  std::vector<double> parameters;
  std::vector<std::array<Jet, coordinates>> jets;
  for (std::size_t k = next_; k < next_ + count; ++k) {
    const Node& node = nodes_[k];
    const surfaces::VectorOf<Jet>&tip = node.place.tip, &contact = node.place.contact;
    parameters.push_back(node.place.t);
    jets.push_back({tip[0], tip[1], tip[2], node.angles[0], node.angles[1], contact[0], contact[1], contact[2]});
  }
  auto spline = surfaces::quintic_spline<coordinates>(parameters, jets);
  curve.clear();
  curve.degree = 5;
  curve.knots = std::move(spline.knots);
  for (const auto& each : spline.points) {
    ControlPoint& point = curve.points.emplace_back();
    point.position = from;
    for (std::size_t k = 0; k < 3; ++k) point.position[k] = each[k];
    for (std::size_t i = 0; chain_ && i < 2; ++i) point.position[base::index(chain_->turns()[i].axis)] = each[3 + i];
    if (with_contact && !is_link_) curve.contact.push_back({each[5], each[6], each[7]});
  }
  // Where it goes on from, to the last bit.
  curve.points.front().position = from;
  taken_from_ = next_;
  next_ += count - 1;
  others_ = from;
}

/// Between two places h apart no axis is beyond both by more than |q″| h²/8. What is near to a limit is not sure.
bool PosePath::is_inside(const kinematics::Transformation& transformation, const base::AxisVector& low,
                         const base::AxisVector& high) const {
  for (std::size_t k = taken_from_; k <= next_; ++k) {
    const Node& node = nodes_[k];
    kinematics::Coordinates<Jet> tip;
    for (std::size_t i = 0; i < tip.size(); ++i) tip[i] = others_[i];
    for (std::size_t i = 0; i < 3; ++i) tip[i] = node.place.tip[i];
    for (std::size_t i = 0; chain_ && i < 2; ++i) tip[base::index(chain_->turns()[i].axis)] = node.angles[i];
    const auto axes = transformation.axes_of(tip);
    const double before = k > taken_from_ ? node.place.t - nodes_[k - 1].place.t : 0,
                 behind = k < next_ ? nodes_[k + 1].place.t - node.place.t : 0, width = std::max(before, behind);
    for (std::size_t i = 0; i < 3; ++i) {
      const double sag = inside_margin + std::abs(axes[i][2]) * width * width;
      if (!(low[i] + sag <= axes[i][0] && axes[i][0] + sag <= high[i])) return false;
    }
  }
  return true;
}

}  // namespace leadscrew::gcode
