#include <algorithm>
#include <cmath>
#include <leadscrew/measuring/word_path.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::measuring {

namespace {

constexpr double exact_enough = 1e-6;  // mm
constexpr double most_parts = 16;

double bend(const ToolPose& a, const ToolPose& b, const ToolPose& c) {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double second = a.tip[k] - 2 * b.tip[k] + c.tip[k];
    square += second * second;
  }
  return std::sqrt(square);
}

/// From b to c.
Vector cubic(const Vector& a, const Vector& b, const Vector& c, const Vector& d, double x) {
  Vector at;
  for (std::size_t k = 0; k < 3; ++k) {
    const double slope = (c[k] - a[k]) / 2, slope_after = (d[k] - b[k]) / 2, rise = c[k] - b[k];
    at[k] = b[k] + x * (slope + x * (3 * rise - 2 * slope - slope_after + x * (slope + slope_after - 2 * rise)));
  }
  return at;
}

ToolPose between(const std::array<ToolPose, 4>& p, double x) {
  ToolPose pose{cubic(p[0].tip, p[1].tip, p[2].tip, p[3].tip, x), cubic(p[0].axis, p[1].axis, p[2].axis, p[3].axis, x)};
  const double length = numeric::norm(pose.axis);
  for (double& coordinate : pose.axis) coordinate /= length;
  return pose;
}

}  // namespace

/// The way from poses_[from] to the one behind it.
void WordPath::tell(std::size_t from, const Sink& sink) {
  const bool has_before = from > 0, has_behind = from + 2 < count_;
  const std::array<ToolPose, 4> p = {poses_[has_before ? from - 1 : from], poses_[from], poses_[from + 1],
                                     poses_[has_behind ? from + 2 : from + 1]};
  const double length = numeric::distance(p[1].tip, p[2].tip);
  if (length == 0 && p[1].axis == p[2].axis) return;
  double most = 0;
  if (has_before) most = bend(p[0], p[1], p[2]);
  if (has_behind) most = std::max(most, bend(p[1], p[2], p[3]));
  const double chord = most / 8;
  // A corner that is as sharp as that is no motion of a machine: nothing is known of what lies between.
  const bool is_smooth = has_before && has_behind && most < length / 2;
  const double parts = is_smooth ? std::clamp(std::ceil(std::sqrt(chord / exact_enough)), 1.0, most_parts) : 1;
  ToolPose begin = p[1];
  for (double k = 1; k <= parts; ++k) {
    const ToolPose end = k == parts ? p[2] : between(p, k / parts);
    sink({SweptTool(body_, begin, end), places_[from], chord / (parts * parts)});
    begin = end;
  }
}

void WordPath::add(const ToolPose& pose, const ToolBody& body, const WordPlace& word, bool joined, const Sink& sink) {
  // What turns by more than 60° between two words has not gone the shortest way.
  const bool leaps = count_ > 0 && numeric::dot(pose.axis, poses_[count_ - 1].axis) < 0.5;
  if (!joined || leaps) end(sink);
  body_ = body;
  if (count_ == poses_.size()) {
    std::move(poses_.begin() + 1, poses_.end(), poses_.begin());
    std::move(places_.begin() + 1, places_.end(), places_.begin());
    --count_;
  }
  places_[count_] = word;
  poses_[count_++] = pose;
  if (count_ == 1) return sink({SweptTool(body, pose, pose), word, 0});
  if (count_ >= 3) tell(count_ - 3, sink);
}

void WordPath::end(const Sink& sink) {
  if (count_ >= 2) tell(count_ - 2, sink);
  count_ = 0;
}

}  // namespace leadscrew::measuring
