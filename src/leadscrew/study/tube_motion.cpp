#include <algorithm>
#include <leadscrew/study/tube_motion.hpp>

namespace leadscrew::study {

namespace {

/// The least interval that keeps the limits.
double least_interval(const Tube& tube, const std::vector<PlaneVector>& c) {
  const auto largest = [](PlaneVector a) { return std::max(std::abs(a.x), std::abs(a.y)); };
  double interval = 0;
  for (std::size_t k = 0; k + 1 < c.size(); ++k) {
    interval = std::max(interval, norm(c[k + 1] - c[k]) / tube.feed);
    if (k + 2 == c.size()) break;
    const PlaneVector second = c[k + 2] - 2.0 * c[k + 1] + c[k];
    interval = std::max(interval, std::sqrt(largest(second) / tube.acceleration));
    if (k + 3 == c.size()) continue;
    const PlaneVector third = c[k + 3] - 3.0 * c[k + 2] + 3.0 * c[k + 1] - c[k];
    interval = std::max(interval, std::cbrt(largest(third) / tube.jerk));
  }
  return interval;
}

}  // namespace

SplineWeights position_weights(double time, std::size_t intervals) {
  const double last = static_cast<double>(intervals) - 1;
  const double begin = std::clamp(std::floor(time), 0.0, last);
  const double u = time - begin, v = 1 - u;
  return {static_cast<std::size_t>(begin),
          {v * v * v / 6, ((3 * u - 6) * u * u + 4) / 6, (((3 - 3 * u) * u + 3) * u + 1) / 6, u * u * u / 6}};
}

PlaneVector TubeMotion::at(double time) const {
  const SplineWeights at = position_weights(time, intervals());
  PlaneVector sum;
  for (std::size_t i = 0; i < 4; ++i) sum = sum + at.weights[i] * points[at.first + i];
  return sum;
}

PlaneVector TubeMotion::velocity(double time) const {
  const std::size_t k = position_weights(time, intervals()).first;
  const double u = time - static_cast<double>(k), v = 1 - u;
  return v * v / 2 * (points[k + 1] - points[k]) + (0.5 + u * v) * (points[k + 2] - points[k + 1]) +
         u * u / 2 * (points[k + 3] - points[k + 2]);
}

std::vector<PlaneVector> TubeMotion::words(double period) const {
  // At knots where as many make a word, since only there the tube holds exactly.
  const auto knots = static_cast<std::size_t>(std::floor(period / interval * (1 + 1e-12)));
  const bool divides = knots > 0 && intervals() % knots == 0;
  const auto count =
      divides ? intervals() / knots : static_cast<std::size_t>(std::ceil(seconds() / period * (1 - 1e-12)));
  std::vector<PlaneVector> words;
  for (std::size_t k = 0; k < count; ++k)
    words.push_back(at(static_cast<double>(k * intervals()) / static_cast<double>(count)));
  words.push_back(points.back());
  return words;
}

TubeMotion stopping_motion(const Tube& tube, std::size_t intervals, const std::vector<double>& shares) {
  TubeMotion motion;
  const auto n = static_cast<double>(intervals);
  double sum = 0, passed = 0;
  for (const double share : shares) sum += share;
  for (std::size_t i = 0; i + 1 < shares.size(); ++i) motion.passes.push_back(n * (passed += shares[i]) / sum);
  for (std::size_t k = 0; k < intervals + 3; ++k) {
    // The first three points and the last three at rest; s = 10 u³ − 15 u⁴ + 6 u⁵ along the leg.
    const double time = std::clamp((static_cast<double>(k) - 3) * n / (n - 4), 0.0, n);
    const auto leg = static_cast<std::size_t>(std::lower_bound(motion.passes.begin(), motion.passes.end(), time) -
                                              motion.passes.begin());
    const double begin = leg > 0 ? motion.passes[leg - 1] : 0;
    const double end = leg < motion.passes.size() ? motion.passes[leg] : n;
    const double u = std::clamp((time - begin) / (end - begin), 0.0, 1.0);
    motion.points.push_back(tube.legs[leg].at(((6 * u - 15) * u + 10) * u * u * u));
  }
  for (std::size_t k = intervals; k < intervals + 3; ++k) motion.points[k] = tube.legs.back().to;
  motion.interval = least_interval(tube, motion.points);
  return motion;
}

}  // namespace leadscrew::study
