#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/study/curves.hpp>
#include <leadscrew/study/marching.hpp>

namespace leadscrew::study {

namespace {

constexpr std::int64_t most_steps = 10'000'000;

using Place = std::array<double, 3>;

Place place(const geometry::PointJet& jet) {
  return {jet[0].value, jet[1].value, jet[2].value};
}

/// What one step is: the length of its chord and of the curve above it, mm.
struct Step {
  double chord = 0, arc = 0;
};

constexpr std::size_t samples = 16;  // of the curve along one step, even
using Places = std::array<Place, samples + 1>;

/// Length of the polygon through every `stride`-th place. Its error falls with the square of the stride.
double polygon(const Places& places, std::size_t stride) {
  double sum = 0;
  for (std::size_t i = stride; i < places.size(); i += stride) sum += numeric::distance(places[i], places[i - stride]);
  return sum;
}

/// How far the curve leaves the chord: the greatest distance at the samples, raised to the vertex of the parabola
/// through it and its neighbours.
double chord_error(const Places& places) {
  std::array<double, samples + 1> distances{};
  for (std::size_t i = 1; i < samples; ++i)
    distances[i] = numeric::distance_to_segment(places[i], places[0], places[samples]);
  const auto greatest = std::max_element(distances.begin() + 1, distances.end() - 1);
  const double before = greatest[-1], at = greatest[0], after = greatest[1];
  const double bend = 2 * at - before - after, slope = after - before;
  return bend > 0 ? at + slope * slope / (8 * bend) : at;
}

/// Follows the curve along one step and raises the chord errors of the march.
Step observe(const geometry::Nurbs& curve, double u_begin, double u_end, double step_length, March& march) {
  Places places;
  for (std::size_t i = 0; i <= samples; ++i) {
    const double part = static_cast<double>(i) / samples;
    const geometry::PointJet jet = curve.jets_at(i == samples ? u_end : u_begin + (u_end - u_begin) * part);
    places[i] = place(jet);
    march.chord_error_rule = std::max(march.chord_error_rule, step_length * step_length * curvature(jet) / 8);
  }
  march.chord_error = std::max(march.chord_error, chord_error(places));
  const double fine = polygon(places, 1), coarse = polygon(places, 2);
  return {numeric::distance(places[samples], places[0]), fine + (fine - coarse) / 3};  // Richardson's extrapolation
}

}  // namespace

March march(const geometry::Nurbs& curve, interpolator::StepRule rule, double speed, double period) {
  March result;
  const double step_length = speed * period;
  double u = curve.first_parameter();
  while (result.steps < most_steps) {
    const double s = static_cast<double>(result.steps) * step_length;
    const double next = interpolator::next_parameter(curve, rule, u, s, step_length);
    if (!(next < curve.last_parameter())) break;
    const Step step = observe(curve, u, next, step_length, result);
    const double error = step.chord / step_length - 1;
    result.arc_error = std::max(result.arc_error, std::abs(step.arc / step_length - 1));
    const bool is_first = result.steps == 0;
    result.feed_error_max = is_first ? error : std::max(result.feed_error_max, error);
    result.feed_error_min = is_first ? error : std::min(result.feed_error_min, error);
    u = next;
    ++result.steps;
  }
  return result;
}

}  // namespace leadscrew::study
