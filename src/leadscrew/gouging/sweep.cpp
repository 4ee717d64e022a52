#include <algorithm>
#include <cmath>
#include <leadscrew/gouging/sweep.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::gouging {

namespace {

using numeric::difference;
using numeric::dot;

/// A way is this much longer than its chord at most, as Way::most_step has it.
constexpr double chord_margin = 1.05;
constexpr int most_step_trials = 40;
constexpr double same_place = 1e-6;  // mm, and of a unit vector

/// How far a part may move while it touches, mm; axial: the share of the motion that is along the axis.
double touching_step(const Part& part, double tolerance, double axial) {
  const double by_corner = std::sqrt(part.corner * tolerance);
  const double by_side = std::sqrt(part.radius * tolerance);
  return std::max(by_corner, std::min(by_side, axial > 0 ? tolerance / axial : by_side));
}

struct Displacement {
  double all = 0;    ///< mm, of no place of the part more
  double axial = 0;  ///< share of the tip's that is along the axis
};

Displacement displacement_of(const Part& part, const Pose& from, const Pose& to, double reach) {
  const Vector tip = difference(to.tip, from.tip);
  const double length = numeric::norm(tip), turn = numeric::distance(from.axis, to.axis);
  const double axial = length > 0 ? std::abs(dot(tip, from.axis)) / length : 0;
  return {chord_margin * (length + std::min(part.top, reach) * turn), turn > 0 ? 1 : std::min(axial, 1.0)};
}

}  // namespace

void Sweep::hold(const Tool& tool) {
  parts_.clear();
  for (const Part& part : tool) parts_.push_back({part});
  pose_.reset();
}

void Sweep::look(PartState& state, const Pose& pose, double t) {
  const Hit hit = workpiece_.nearest(state.part, pose, std::numeric_limits<double>::infinity(), state.near);
  ++looks_;
  state.near = hit.cell;
  state.distance = hit.distance;
  state.moved = state.used = 0;
  if (!deepest_ || hit.distance < deepest_->hit.distance) deepest_ = Deepest{hit, state.part, pose, t};
}

double Sweep::distance_at_end() const {
  double least = std::numeric_limits<double>::infinity();
  for (const PartState& state : parts_) {
    if (pose_) least = std::min(least, state.distance - state.moved);
  }
  return least;
}

/// Of the way that the part may go between two looks, at `to`.
double Sweep::share_after(const PartState& state, const Pose& from, const Pose& to) const {
  const Displacement by = displacement_of(state.part, from, to, workpiece_.reach_from(from.tip));
  const double moved =
      state.clearance() > 0 ? (state.moved + by.all) / state.clearance() : std::numeric_limits<double>::infinity();
  return std::min(moved, state.used + by.all / touching_step(state.part, tolerance_, by.axial));
}

void Sweep::advance(const Pose& to) {
  const double reach = workpiece_.reach_from(pose_->tip);
  for (PartState& state : parts_) {
    const Displacement by = displacement_of(state.part, *pose_, to, reach);
    state.moved += by.all;
    state.used += by.all / touching_step(state.part, tolerance_, by.axial);
  }
  pose_ = to;
}

/// As far as all parts may go, or nearly. `share`: of the one that has gone farthest.
double Sweep::step_to(const Way& way, double t, double step, double& share) const {
  for (int trial = 0;; ++trial) {
    const Pose to = way.at(t + step);
    share = 0;
    for (const PartState& state : parts_) share = std::max(share, share_after(state, *pose_, to));
    if (share <= 1 || trial >= most_step_trials || step <= 1.0 / most_looks) return step;
    step = std::max(step * std::max(0.8 / share, 0.1), 1.0 / most_looks);
  }
}

std::optional<Deepest> Sweep::follow(const Way& way) {
  deepest_.reset();
  const Pose begin = way.at(0);
  const bool goes_on = pose_ && numeric::distance(pose_->tip, begin.tip) < same_place &&
                       numeric::distance(pose_->axis, begin.axis) < same_place;
  if (goes_on) {
    advance(begin);
  } else {
    pose_ = begin;
    for (PartState& state : parts_) look(state, begin, 0);
  }
  double step = way.most_step;
  for (double t = 0; t < 1;) {
    double share = 0;
    step = step_to(way, t, std::min({step, way.most_step, 1 - t}), share);
    t = t + step >= 1 - 1e-12 ? 1 : t + step;
    advance(way.at(t));
    for (PartState& state : parts_) {
      const bool touches = state.moved >= state.clearance();
      const bool is_spent = std::min(state.used, state.clearance() > 0 ? state.moved / state.clearance() : 2) >= 0.5;
      if (is_spent || (t == 1 && touches)) look(state, *pose_, t);
    }
    step *= std::clamp(share > 0 ? 0.95 / share : 4.0, 0.25, 4.0);
  }
  return deepest_;
}

}  // namespace leadscrew::gouging
