#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/pose_path.hpp>
#include <leadscrew/kinematics/solutions.hpp>
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
  return std::hypot(axis[0][1], axis[1][1], axis[2][1]);
}

}  // namespace

/// The angles of a node, the shorter way round from those before.
std::optional<PoseFailure> PosePath::hold(Node& node, const Angles& before) const {
  const surfaces::PassNode& place = node.place;
  PoseFailure failure{PoseFailure::Kind::pole, place.u, place.v};
  const kinematics::Vector direction{place.axis[0][0], place.axis[1][0], place.axis[2][0]};
  const auto plain = kinematics::solutions(*chain_, direction);
  if (plain.count == 0) {
    failure.kind = PoseFailure::Kind::out_of_reach;
    failure.miss = plain.miss;
    return failure;
  }
  const double from_pole = numeric::degrees_of_radian.hi * pole_itself;
  if (kinematics::angle_from_pole(*chain_, direction) < from_pole && rate_of(place.axis) < steady) {
    node.angles = {Jet(before[0]), Jet(plain.angles[plain.count == 2 ? side_ : 0][1])};
  } else {
    const auto found = kinematics::solutions(*chain_, place.axis);
    if (found.count < 2 || !is_finite(found.angles[side_])) return failure;
    node.angles = found.angles[side_];
  }
  for (std::size_t i = 0; i < 2; ++i)
    node.angles[i][0] = before[i] + std::remainder(node.angles[i][0] - before[i], turn_of_angle);
  return std::nullopt;
}

/// Do quintics of the angles hold the tool as the path says?
bool PosePath::is_held(const Node& a, const Node& b) const {
  const double width = b.place.t - a.place.t;
  for (const double share : {0.5, 0.25, 0.75}) {
    surfaces::Vector axis;
    Angles angles;
    for (std::size_t k = 0; k < 3; ++k)
      axis[k] = surfaces::hermite_value(a.place.axis[k], b.place.axis[k], width, share);
    for (std::size_t i = 0; i < 2; ++i) angles[i] = surfaces::hermite_value(a.angles[i], b.angles[i], width, share);
    const surfaces::Vector wanted = surfaces::unit_of(axis), held = kinematics::direction_of(*chain_, angles);
    if (!(std::hypot(held[0] - wanted[0], held[1] - wanted[1], held[2] - wanted[2]) <= axis_tolerance)) return false;
  }
  return true;
}

PosePath::Node PosePath::between(const Node& a, const Node& b) {
  const surfaces::PassNode &from = a.place, &to = b.place;
  const double width = to.t - from.t;
  Node node;
  node.place.t = from.t + width / 2;
  for (std::size_t k = 0; k < 3; ++k) {
    node.place.tip[k] = surfaces::hermite_jet(from.tip[k], to.tip[k], width, 0.5);
    node.place.axis[k] = surfaces::hermite_jet(from.axis[k], to.axis[k], width, 0.5);
    node.place.contact[k] = surfaces::hermite_jet(from.contact[k], to.contact[k], width, 0.5);
  }
  node.place.axis = surfaces::unit_of(node.place.axis);
  node.place.u = (from.u + to.u) / 2;
  node.place.v = (from.v + to.v) / 2;
  return node;
}

/// Depth first, from the beginning: what waits on the stack lies behind.
std::optional<PoseFailure> PosePath::add_between(const Node& from, const Node& to) {
  std::vector<Node> ahead = {to};
  Node at = from;
  while (!ahead.empty()) {
    Node& next = ahead.back();
    const Angles before{at.angles[0][0], at.angles[1][0]};
    if (auto failure = hold(next, before)) return failure;
    if (is_held(at, next)) {
      if (nodes_.size() == most_nodes_in_all) break;
      at = next;
      nodes_.push_back(at);
      ahead.pop_back();
      if (ahead.empty()) return std::nullopt;
      continue;
    }
    if (next.place.t - at.place.t < least_part) break;
    ahead.push_back(between(at, next));
  }
  return PoseFailure{PoseFailure::Kind::pole, at.place.u, at.place.v};
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
  Node first{std::move(pass.nodes.front()), {}};
  if (auto failure = hold(first, angles_)) return failure;
  nodes_.push_back(first);
  for (std::size_t k = 1; k < pass.nodes.size(); ++k) {
    const Node from = nodes_.back();
    if (auto failure = add_between(from, {std::move(pass.nodes[k]), {}})) {
      nodes_.clear();
      return failure;
    }
  }
  angles_ = {nodes_.back().angles[0][0], nodes_.back().angles[1][0]};
  return std::nullopt;
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
