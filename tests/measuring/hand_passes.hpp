#pragma once
// Passes of a tool over a surface, made by hand: words along lines of the surface, and a leap from one line to the next.

#include <algorithm>
#include <cmath>
#include <functional>
#include <leadscrew/measuring/measurement.hpp>
#include <leadscrew/surfaces/cutter.hpp>
#include <leadscrew/surfaces/step_over.hpp>
#include <leadscrew/surfaces/surface.hpp>
#include <vector>

namespace leadscrew::measuring::test {

/// The tool where it touches at a place, on the side of Su × Sv; the pass goes along u.
inline ToolPose held(const surfaces::Surface& surface, double u, double v, const surfaces::Cutter& cutter,
                     const surfaces::Orientation& orientation) {
  const surfaces::SurfaceJet jet = surface.jet(u, v);
  const surfaces::Frame frame = *surfaces::frame_of(jet, 1);
  const surfaces::TangentPair tangents = surfaces::tangents_of(jet, frame, surfaces::Direction::u);
  const Vector axis = surfaces::axis_of(orientation, frame.n, tangents.f);
  return {surfaces::tip_of(cutter, jet.s, frame.n, axis, tangents.f), axis};
}

/// Passes along u from end to end at these v, so many words each.
struct Passes {
  const surfaces::Surface* surface = nullptr;
  surfaces::Cutter cutter;
  surfaces::Orientation orientation;
  std::vector<double> v;
  int words = 600;
};

/// Measured with all readings; lifted by so many mm along the axis.
inline const Findings& measured(Measurement& measurement, const Passes& passes, double lift = 0) {
  std::vector<ToolPose> poses;
  for (const double v : passes.v) {
    for (int k = 0; k <= passes.words; ++k) {
      ToolPose pose =
          held(*passes.surface, static_cast<double>(k) / passes.words, v, passes.cutter, passes.orientation);
      for (std::size_t i = 0; i < 3; ++i) pose.tip[i] += lift * pose.axis[i];
      poses.push_back(pose);
    }
  }
  const ToolBody body{passes.cutter.radius, passes.cutter.corner_radius};
  do {
    for (std::size_t k = 0; k < poses.size(); ++k)
      measurement.add(poses[k], body, {static_cast<std::int64_t>(k)},
                      k % static_cast<std::size_t>(passes.words + 1) > 0);
  } while (measurement.end_reading());
  return measurement.findings();
}

/// count + 1 evenly spaced parameters from 0 to 1.
inline std::vector<double> even(int count) {
  std::vector<double> lines;
  for (int k = 0; k <= count; ++k) lines.push_back(static_cast<double>(k) / count);
  return lines;
}

/// v of passes along u by the greatest step that leaves no more than h, the remainder last: of a ball.
inline std::vector<double> greedy(const surfaces::Surface& surface, double radius, double height) {
  const auto step = [&](double v) {
    double least = 1;
    for (int k = 0; k <= 100; ++k) {
      const surfaces::SurfaceJet jet = surface.jet(k / 100.0, v);
      const surfaces::Frame frame = *surfaces::frame_of(jet, 1);
      const double bend =
          surfaces::curvature_of(jet, frame, surfaces::tangents_of(jet, frame, surfaces::Direction::u)).bb;
      least = std::min(least,
                       surfaces::step_over(radius, bend, height) / surfaces::width_of(frame, surfaces::Direction::u));
    }
    return least;
  };
  std::vector<double> lines = {0};
  while (lines.back() < 1) {
    const double v = lines.back(), first = step(v);
    lines.push_back(
        std::min(1.0, v + std::min({first, step(std::min(1.0, v + first / 2)), step(std::min(1.0, v + first))})));
  }
  return lines;
}

}  // namespace leadscrew::measuring::test
