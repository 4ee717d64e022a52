#include <algorithm>
#include <charconv>
#include <cmath>
#include <leadscrew/study/curves.hpp>
#include <vector>

namespace leadscrew::study {

namespace {

/// The shortest decimal that reads back as this very number.
std::string exactly(double value) {
  char buffer[400];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed);
  return {buffer, end.ptr};
}

std::string feed_word(double feed) {
  return word('F', feed * 60);
}

geometry::Point in_plane(double x, double y) {
  geometry::Point point{};
  point[0] = x;
  point[1] = y;
  return point;
}

/// The least of `f` between a and b, where it has one minimum only (Kiefer 1953).
template <class Function>
double golden_section(Function&& f, double a, double b) {
  constexpr double golden = 0.6180339887498949;
  double left = b - golden * (b - a), right = a + golden * (b - a);
  double at_left = f(left), at_right = f(right);
  for (int i = 0; i < 60; ++i) {
    if (at_left < at_right) {
      b = right;
      right = left;
      at_right = at_left;
      at_left = f(left = b - golden * (b - a));
    } else {
      a = left;
      left = right;
      at_left = at_right;
      at_right = f(right = a + golden * (b - a));
    }
  }
  return std::min(at_left, at_right);
}

}  // namespace

std::string word(char letter, double value) {
  return std::string(1, ' ') + letter + exactly(value);
}

geometry::NurbsForm plane_cubic() {
  // In Bernstein's basis a u + b u² + c u³ has the coefficients 0, a/3, (2a + b)/3, a + b + c.
  geometry::NurbsForm form;
  form.degree = 3;
  form.knots = {0, 0, 0, 0, 1, 1, 1, 1};
  form.points = {in_plane(0, 0), in_plane(20.0 / 3, -10.0 / 3), in_plane(40.0 / 3, 20), in_plane(20, 20)};
  form.weights = {1, 1, 1, 1};
  return form;
}

PartProgram program_of(const geometry::NurbsForm& curve, double feed) {
  const auto order = static_cast<std::size_t>(curve.degree) + 1;
  std::string text = "G21 G90 G17 G94 G61.1\n";
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    if (i == 0) text += "G6.2 P" + std::to_string(order);
    text += word('K', curve.knots[i]) + word('X', curve.points[i][0]) + word('Y', curve.points[i][1]) +
            word('R', curve.weights[i]);
    if (i == 0) text += feed_word(feed);
    text += '\n';
  }
  for (std::size_t i = curve.points.size(); i < curve.knots.size(); ++i) text += word('K', curve.knots[i]) + "\n";
  return {text + "M2\n", curve.points.front()};
}

PartProgram circle_program(double radius, double feed) {
  const std::string text =
      "G21 G90 G17 G94 G61.1\nG3" + word('X', radius) + " Y0" + word('I', -radius) + " J0" + feed_word(feed) + "\nM2\n";
  return {text, in_plane(radius, 0)};
}

double curvature(const geometry::PointJet& jet) {
  // κ = |C″ − t (t·C″)|/|C′|², t = C′/|C′|: free of the cancellation that |C′|²|C″|² − (C′·C″)² suffers.
  double speed_squared = 0, along = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    speed_squared += jet[i].first * jet[i].first;
    along += jet[i].first * jet[i].second;
  }
  double across_squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double across = jet[i].second - jet[i].first * (along / speed_squared);
    across_squared += across * across;
  }
  return std::sqrt(across_squared) / speed_squared;
}

double min_radius(const geometry::Nurbs& curve) {
  // Equal steps of length, so that fast and slow parameters are seen alike. A bend can be sharper than a step is long:
  // whatever comes near the sharpest sample is refined.
  constexpr int samples = 20000;
  const double step = curve.length() / samples;
  const auto straightness = [&](double s) { return -curvature(curve.jets_at(curve.parameter(s))); };
  std::vector<double> sampled(samples + 1);
  for (std::size_t i = 0; i <= samples; ++i) sampled[i] = straightness(static_cast<double>(i) * step);
  const double near = *std::min_element(sampled.begin(), sampled.end()) / 2;
  double sharpest = 0;
  for (std::size_t i = 0; i <= samples; ++i) {
    const bool is_summit = (i == 0 || sampled[i] <= sampled[i - 1]) && (i == samples || sampled[i] <= sampled[i + 1]);
    if (!is_summit || sampled[i] > near) continue;
    const double at = static_cast<double>(i) * step;
    const double refined = golden_section(straightness, std::max(0.0, at - step), std::min(curve.length(), at + step));
    sharpest = std::min(sharpest, refined);
  }
  return -1 / sharpest;
}

}  // namespace leadscrew::study
