#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/kinematics/pose.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/study/five_axes_motion.hpp>
#include <numbers>

namespace leadscrew::study {

namespace {

double dot_of(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double length_of(const Vector& a) {
  return std::hypot(a[0], a[1], a[2]);
}

/// Between unit vectors, degrees: 2 atan2(|a − b|, |a + b|), exact for small ones.
double angle_between(const Vector& a, const Vector& b) {
  const Vector sum = {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  return 360 / std::numbers::pi * std::atan2(length_of(difference(a, b)), length_of(sum));
}

/// A share of the way from one unit vector to another along their great circle.
Vector on_great_circle(const Vector& from, const Vector& to, double share) {
  const double angle = angle_between(from, to) * std::numbers::pi / 180;
  if (angle == 0) return from;
  Vector result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = (std::sin((1 - share) * angle) * from[i] + std::sin(share * angle) * to[i]) / std::sin(angle);
  return result;
}

double distance_from_line(const Vector& point, const Vector& from, const Vector& to) {
  const Vector along = difference(to, from);
  Vector off = difference(point, from);
  const double share = dot_of(off, along) / dot_of(along, along);
  for (std::size_t i = 0; i < 3; ++i) off[i] -= share * along[i];
  return length_of(off);
}

Vector tip_of(const TipAndRotary& pose) {
  return {pose[0], pose[1], pose[2]};
}

Vector tool_of(const kinematics::Chain& chain, const base::AxisVector& coordinates) {
  return kinematics::direction_of<double>(chain, kinematics::angles_of<double>(chain, coordinates));
}

base::AxisVector part_of_way(const base::AxisVector& from, const base::AxisVector& to, double share) {
  base::AxisVector result;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = (1 - share) * from[i] + share * to[i];
  return result;
}

PoseError error_of_line(const kinematics::Chain& chain, const TipAndRotary& from, const TipAndRotary& to,
                        Straight straight, int places) {
  const bool axes = straight == Straight::axes;
  const base::AxisVector first = axes ? kinematics::machine_of(chain, from, {}) : from;
  const base::AxisVector last = axes ? kinematics::machine_of(chain, to, {}) : to;
  const Vector begins = tool_of(chain, from), ends = tool_of(chain, to);
  PoseError most;
  for (int k = 0; k <= places; ++k) {
    const double share = static_cast<double>(k) / places;
    const base::AxisVector now = part_of_way(first, last, share);
    const Vector tip = tip_of(axes ? kinematics::pose_of(chain, now, {}) : now);
    most.tip = std::max(most.tip, distance_from_line(tip, tip_of(from), tip_of(to)));
    const Vector meant = on_great_circle(begins, ends, share);
    most.direction = std::max(most.direction, angle_between(tool_of(chain, now), meant));
  }
  return most;
}

}  // namespace

PoseError error_of_lines(const kinematics::Chain& chain, const std::vector<TipAndRotary>& ends, Straight straight,
                         int places) {
  PoseError most;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const PoseError error = error_of_line(chain, ends[i - 1], ends[i], straight, places);
    most = {std::max(most.tip, error.tip), std::max(most.direction, error.direction)};
  }
  return most;
}

PoseError error_of_spline(const kinematics::Chain& chain, const SurfacePass& pass,
                          const std::vector<TipAndRotary>& control_points, int places) {
  PoseError most;
  for (int k = 0; k <= places; ++k) {
    const TipAndRotary pose = spline_at(control_points, static_cast<double>(k) / places);
    const double u = pass.nearest(tip_of(pose));
    most.tip = std::max(most.tip, length_of(difference(tip_of(pose), pass.point(u))));
    most.direction = std::max(most.direction, angle_between(tool_of(chain, pose), pass.normal(u)));
  }
  return most;
}

std::vector<double> subdivided(const kinematics::Chain& chain, const SurfacePass& pass,
                               const std::vector<double>& places, double tolerance) {
  constexpr int most_parts = 4096, looked_at = 20;
  std::vector<double> result = {places.front()};
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double from = places[i - 1], to = places[i];
    std::vector<double> parts;
    // As few equal parts as will do.
    for (int count = 1; count <= most_parts; ++count) {
      parts = {from};
      for (int k = 1; k <= count; ++k) parts.push_back(k == count ? to : from + (to - from) * k / count);
      if (error_of_lines(chain, pass.along(parts), Straight::axes, looked_at).tip <= tolerance) break;
    }
    result.insert(result.end(), parts.begin() + 1, parts.end());
  }
  return result;
}

std::vector<PoseSample> pose_samples(const PartProgram& program, const machine::Machine& machine,
                                     const SurfacePass& pass) {
  const kinematics::Chain chain = kinematics::chain_of(machine);
  const machine::ToolTable tools;
  gcode::ReaderOptions options;
  options.start = program.start;
  pipeline::Program motion(gcode::text_source(program.text), machine, tools, options, nullptr);
  std::vector<PoseSample> samples;
  const double rate = 1 / machine.period.seconds();
  constexpr std::size_t c = base::index(base::Axis::C);
  base::AxisVector last = kinematics::pose_of(chain, program.start, {});
  while (motion.prepare()) {
    const base::AxisVector pose = kinematics::pose_of(chain, motion.cycle().position, {});
    const double u = pass.nearest(tip_of(pose));
    samples.push_back({length_of(difference(tip_of(pose), pass.point(u))),
                       angle_between(tool_of(chain, pose), pass.normal(u)),
                       rate * length_of(difference(tip_of(pose), tip_of(last))), rate * (pose[c] - last[c])});
    last = pose;
  }
  return samples;
}

}  // namespace leadscrew::study
