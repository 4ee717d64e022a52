#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/kinematics/solutions.hpp>
#include <leadscrew/numeric/jet.hpp>
#include <leadscrew/study/surface_pass.hpp>

namespace leadscrew::study {

namespace {

using numeric::Jet;
using JetDirection = kinematics::Vector3<Jet<>>;

constexpr double side = 60, pass_v = 0.75;  // mm
/// Heights of control points, mm: along u, then along v.
constexpr std::array<std::array<double, 4>, 4> heights = {{{0, 6, 6, 0}, {6, 14, 2, -4}, {6, 2, 14, 6}, {0, -4, 6, 8}}};
constexpr std::array<double, 3> tilt_point = {-4, 5, 6}, turn_point = {1, 2, 3};
constexpr std::size_t A = base::index(base::Axis::A), C = base::index(base::Axis::C);

using Cubic = std::array<double, 4>;  // control points of a polynomial of third degree

/// Its polar form: symmetric, affine in each, and p(u) = f(u, u, u).
template <typename T>
T blossom(const Cubic& control, const T& a, const T& b, const T& c) {
  std::array<T, 4> level = {control[0], control[1], control[2], control[3]};
  const std::array<T, 3> arguments = {a, b, c};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i + k < 3; ++i) level[i] = level[i] + arguments[k] * (level[i + 1] - level[i]);
  }
  return level[0];
}
template <typename T>
T value_of_cubic(const Cubic& control, const T& u) {
  return blossom(control, u, u, u);
}

/// Of z along the pass, and of ∂z/∂y.
Cubic heights_of_pass() {
  Cubic control;
  for (std::size_t i = 0; i < 4; ++i) control[i] = value_of_cubic(heights[i], pass_v);
  return control;
}
Cubic slopes_across_pass() {
  Cubic control;
  for (std::size_t i = 0; i < 4; ++i) control[i] = value_of_cubic(heights[i], Jet<>::parameter(pass_v)).first / side;
  return control;
}

Jet<> height(double u) {
  return value_of_cubic(heights_of_pass(), Jet<>::parameter(u));
}

/// (−∂z/∂x, −∂z/∂y, 1), with derivatives by u.
JetDirection upright_normal(double u) {
  // One order more than a jet of three has: ∂z/∂x of a cubic in u has no third derivative.
  const Jet<> z = height(u);
  return {Jet<>{-z.first / side, -z.second / side, -z.third / side, 0},
          -value_of_cubic(slopes_across_pass(), Jet<>::parameter(u)), Jet<>(1.0)};
}

/// A and C, in this order, of the two solutions that with A ≥ 0; for the pass is nowhere upright.
template <typename T>
std::array<T, 2> tilt_and_turn(const kinematics::Chain& chain, const kinematics::Vector3<T>& direction) {
  const std::size_t a = chain.turns()[0].axis == base::Axis::A ? 0 : 1;
  const auto both = kinematics::solutions<T>(chain, direction).angles;
  const auto& angles = both[both[0][a] < T(0.0) ? 1 : 0];
  return {angles[a], angles[1 - a]};
}

double in_turns_nearest(double angle, double last) {
  return angle + 360 * std::round((last - angle) / 360);
}

std::string pose_words(const TipAndRotary& pose) {
  return word('X', pose[0]) + word('Y', pose[1]) + word('Z', pose[2]) + word('A', pose[A]) + word('C', pose[C]);
}

double distance(const TipAndRotary& a, const TipAndRotary& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

machine::Machine trunnion() {
  machine::Machine machine = machine::mill3();
  machine.kinematics = "table-table-ac";
  machine.rotary_chain = machine::preset_chain(machine.kinematics);
  machine.rotary_chain->axes[0].point = tilt_point;
  machine.rotary_chain->axes[1].point = turn_point;
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z})
    machine.axes[base::index(axis)] = machine::AxisLimits{-500, 500, 400, 3000, 60000, 0.001};
  machine.axes[A] = machine::AxisLimits{-120, 120, 180, 1500, 30000, 0.001};
  machine.axes[C] = machine::AxisLimits{-36000, 36000, 360, 3000, 60000, 0.001};
  machine.period = {1'000'000};
  return machine;
}

Vector SurfacePass::point(double u) const {
  return {side * u, side * pass_v, height(u).value};
}

Vector SurfacePass::normal(double u) const {
  const JetDirection n = upright_normal(u);
  const double length = std::hypot(n[0].value, n[1].value, 1.0);
  return {n[0].value / length, n[1].value / length, 1 / length};
}

double SurfacePass::speed(double u) const {
  return std::hypot(side, height(u).first);
}

double SurfacePass::curvature(double u) const {
  return side * std::abs(height(u).second) / std::pow(speed(u), 3);
}

double SurfacePass::nearest(const Vector& point) const {
  double u = std::clamp(point[0] / side, 0.0, 1.0);
  // Newton's method for (S − point)·S′ = 0: the patch is all but flat beside its distance from points near it.
  for (int k = 0; k < 8; ++k) {
    const Jet<> z = height(u);
    const double x = side * u - point[0], up = z.value - point[2];
    const double slope = side * side + z.first * z.first + up * z.second;
    u = std::clamp(u - (x * side + up * z.first) / slope, 0.0, 1.0);
  }
  return u;
}

TipAndRotary SurfacePass::at(double u, double last_c) const {
  const auto angles = tilt_and_turn<double>(chain_, normal(u));
  TipAndRotary pose{};
  const Vector tip = point(u);
  for (std::size_t i = 0; i < 3; ++i) pose[i] = tip[i];
  pose[A] = angles[0];
  pose[C] = in_turns_nearest(angles[1], last_c);
  return pose;
}

std::vector<TipAndRotary> SurfacePass::along(const std::vector<double>& places) const {
  std::vector<TipAndRotary> poses;
  double c = 0;
  for (const double u : places) {
    poses.push_back(at(u, c));
    c = poses.back()[C];
  }
  return poses;
}

std::vector<double> SurfacePass::chords(double chord) const {
  std::vector<double> places = {0};
  while (places.back() < 1) {
    const double u = places.back();
    places.push_back(std::min(1.0, u + std::sqrt(8 * chord / curvature(u)) / speed(u)));
  }
  return places;
}

std::vector<TipAndRotary> SurfacePass::control_points(int spans) const {
  const std::vector<double> knots = clamped_knots(spans);
  std::vector<TipAndRotary> control;
  double last = 0;
  for (std::size_t i = 1; i + 3 < knots.size(); ++i) {
    const double a = knots[i], b = knots[i + 1], c = knots[i + 2], middle = (a + b + c) / 3;
    const double da = a - middle, db = b - middle, dc = c - middle;
    const auto angles = tilt_and_turn<Jet<>>(chain_, upright_normal(middle));
    const auto polar = [&](const Jet<>& f) {
      return f.value + f.second * (da * db + da * dc + db * dc) / 6 + f.third * da * db * dc / 6;
    };
    TipAndRotary point{};
    point[0] = side * middle;
    point[1] = side * pass_v;
    point[2] = blossom(heights_of_pass(), a, b, c);
    point[A] = polar(angles[0]);
    point[C] = last = in_turns_nearest(polar(angles[1]), last);
    control.push_back(point);
  }
  return control;
}

std::vector<double> clamped_knots(int spans) {
  std::vector<double> knots(3, 0.0);
  for (int k = 0; k <= spans; ++k) knots.push_back(static_cast<double>(k) / spans);
  knots.insert(knots.end(), 3, 1.0);
  return knots;
}

TipAndRotary spline_at(const std::vector<TipAndRotary>& control_points, double u) {
  // De Boor's algorithm.
  const int spans = static_cast<int>(control_points.size()) - 3;
  const std::vector<double> knots = clamped_knots(spans);
  const auto span = static_cast<std::size_t>(std::clamp(static_cast<int>(u * spans), 0, spans - 1)) + 3;
  std::array<TipAndRotary, 4> level;
  for (std::size_t i = 0; i < 4; ++i) level[i] = control_points[span - 3 + i];
  for (std::size_t k = 1; k <= 3; ++k) {
    for (std::size_t i = 3; i >= k; --i) {
      const double from = knots[span - 3 + i], to = knots[span + 1 + i - k], share = (u - from) / (to - from);
      for (std::size_t axis = 0; axis < level[i].size(); ++axis)
        level[i][axis] = (1 - share) * level[i - 1][axis] + share * level[i][axis];
    }
  }
  return level[3];
}

PartProgram program_of_axes(const kinematics::Chain& chain, const std::vector<TipAndRotary>& ends, double feed,
                            const std::string& path_control) {
  std::string text = "G21 G90 G17 G93 " + path_control + "\n";
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double per_minute = 60 * feed / distance(ends[i - 1], ends[i]);
    text += "G1" + pose_words(kinematics::machine_of(chain, ends[i], {})) + word('F', per_minute) + "\n";
  }
  return {text + "M2\n", kinematics::machine_of(chain, ends.front(), {})};
}

PartProgram program_of_tip(const kinematics::Chain& chain, const std::vector<TipAndRotary>& ends, double feed,
                           const std::string& path_control) {
  std::string text = "G21 G90 G17 G94 " + path_control + word('F', 60 * feed) + "\nG43.4\nG1";
  for (std::size_t i = 1; i < ends.size(); ++i) text += pose_words(ends[i]) + "\n";
  return {text + "M2\n", kinematics::machine_of(chain, ends.front(), {})};
}

PartProgram program_of_pass(const kinematics::Chain& chain, const std::vector<TipAndRotary>& control_points,
                            double feed) {
  const std::vector<double> knots = clamped_knots(static_cast<int>(control_points.size()) - 3);
  std::string text = "G21 G90 G17 G94 G61.1" + word('F', 60 * feed) + "\nG43.4\nG6.2 P4";
  for (std::size_t i = 0; i < knots.size(); ++i) {
    text += word('K', knots[i]);
    if (i < control_points.size()) text += pose_words(control_points[i]);
    text += '\n';
  }
  return {text + "M2\n", kinematics::machine_of(chain, control_points.front(), {})};
}

}  // namespace leadscrew::study
