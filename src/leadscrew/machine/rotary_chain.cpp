#include <algorithm>
#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/machine/fields.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <string>

namespace leadscrew::machine {

namespace {

using base::text;

constexpr double unit_tolerance = 1e-6;    ///< of the length of a direction
constexpr double least_angle_sine = 1e-3;  ///< between directions that are not parallel
constexpr double greatest_pole_cone = 10;  ///< degrees
constexpr double greatest_tolerance = 90;  ///< degrees

double length_of(const Vector& v) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// |a × b| of unit vectors.
double sine_between(const Vector& a, const Vector& b) {
  return length_of({a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]});
}

bool is_finite(const Vector& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

std::string text_of(const Vector& v) {
  return "[" + text(v[0]) + ", " + text(v[1]) + ", " + text(v[2]) + "]";
}

std::string of_axis(const RotaryAxis& axis, const std::string& what) {
  return std::string("axis ") + base::letter(axis.axis) + ": " + what;
}

bool has_sound_direction(const RotaryAxis& axis) {
  return is_finite(axis.direction) && std::abs(length_of(axis.direction) - 1) <= unit_tolerance;
}

bool has_sound_order(const RotaryAxis& axis) {
  return axis.order == 1 || axis.order == 2;
}

void check_rotary_axis(const RotaryAxis& axis, std::vector<base::Diagnostic>& problems) {
  const auto report = [&](std::string_view code, const std::string& what, std::string hint, std::string_view field) {
    problems.push_back(base::problem(code, of_axis(axis, what), std::move(hint), {.axis = axis.axis, .field = field}));
  };
  if (!has_sound_direction(axis)) {
    const double length = length_of(axis.direction);
    const bool has_one = length > 0 && std::isfinite(length);
    const Vector& d = axis.direction;
    report("rotary-direction", "the direction is " + text_of(d) + (has_one ? ", " + text(length) + " long" : ""),
           has_one ? "a unit vector, such as " + text_of({d[0] / length, d[1] / length, d[2] / length})
                   : "a unit vector, such as [1, 0, 0]",
           field::direction);
  }
  if (!is_finite(axis.point)) {
    report("rotary-point", "the point on it is " + text_of(axis.point), "three finite numbers, mm", field::point);
  }
  if (!has_sound_order(axis)) {
    report("rotary-order", "the order is " + std::to_string(axis.order),
           "1, nearest the bed or the ram, or 2, the one behind it", field::order);
  }
  if (axis.sign != 1 && axis.sign != -1) {
    report("rotary-sign", "the sign is " + std::to_string(axis.sign), "1 or -1", field::sign);
  }
}

void check_numbers(const RotaryChain& chain, std::vector<base::Diagnostic>& problems) {
  if (!is_finite(chain.tool_zero)) {
    problems.push_back(base::problem("tool-zero", "the tool's zero is " + text_of(chain.tool_zero),
                                     "three finite numbers, mm", {.field = field::tool_zero}));
  }
  if (!(chain.orientation_tolerance > 0 && chain.orientation_tolerance <= greatest_tolerance)) {
    problems.push_back(base::problem("orientation-tolerance",
                                     "the orientation tolerance is " + text(chain.orientation_tolerance) + " degrees",
                                     "above 0, at most 90", {.field = field::orientation_tolerance}));
  }
  if (!(chain.pole_cone >= 0 && chain.pole_cone <= greatest_pole_cone)) {
    problems.push_back(base::problem("pole-cone", "the cone about poles is " + text(chain.pole_cone) + " degrees",
                                     "between 0 and 10", {.field = field::pole_cone}));
  }
}

/// The one whose turning moves the tool's direction while the other stands at 0: from the tool's side the first.
const RotaryAxis& nearest_to_tool(const RotaryChain& chain) {
  const auto& [a, b] = chain.axes;
  if (a.carries != b.carries) return a.carries == Carries::tool ? a : b;
  const bool by_tool = a.carries == Carries::tool;  // then the one of order 2 holds the tool
  return (a.order > b.order) == by_tool ? a : b;
}

void check_angles(const RotaryChain& chain, std::vector<base::Diagnostic>& problems) {
  const auto& [a, b] = chain.axes;
  if (!has_sound_direction(a) || !has_sound_direction(b)) return;
  if (sine_between(a.direction, b.direction) < least_angle_sine) {
    problems.push_back(base::problem("rotary-parallel",
                                     of_axis(b, "its direction is that of axis ") + base::letter(a.axis),
                                     "two directions that differ", {.axis = b.axis, .field = field::direction}));
  }
  const RotaryAxis& near = nearest_to_tool(chain);
  if (sine_between(near.direction, {0, 0, 1}) < least_angle_sine) {
    problems.push_back(base::problem(
        "rotary-parallel", of_axis(near, "its direction is that of the tool, Z, and turning it does not tilt the tool"),
        "carries and order say which axis stands between the other one and the tool",
        {.axis = near.axis, .field = field::direction}));
  }
}

std::string known_kinematics() {
  std::string names(cartesian);
  for (const KinematicsPreset& preset : kinematics_presets) names += ", " + std::string(preset.name);
  return names;
}

}  // namespace

std::optional<RotaryChain> preset_chain(std::string_view name) {
  const auto found = std::ranges::find(kinematics_presets, name, &KinematicsPreset::name);
  if (found == kinematics_presets.end()) return std::nullopt;
  return RotaryChain{.axes = found->axes};
}

void check_chain(const RotaryChain& chain, std::vector<base::Diagnostic>& problems) {
  const auto& [a, b] = chain.axes;
  check_rotary_axis(a, problems);
  check_rotary_axis(b, problems);
  if (a.axis == b.axis || !base::is_rotary(a.axis) || !base::is_rotary(b.axis)) {
    problems.push_back(base::problem(
        "rotary-axis", std::string("the rotary axes are ") + base::letter(a.axis) + " and " + base::letter(b.axis),
        "two of A, B and C", {.field = field::kinematics}));
  }
  if (a.carries == b.carries && a.order == b.order) {
    problems.push_back(base::problem(
        "rotary-order",
        of_axis(b, "the order is " + std::to_string(b.order) + ", as that of axis " + base::letter(a.axis)),
        "1 for the one nearest the bed or the ram, 2 for the one behind it", {.axis = b.axis, .field = field::order}));
  } else if (has_sound_order(a) && has_sound_order(b)) {
    check_angles(chain, problems);
  }
  check_numbers(chain, problems);
}

void check_kinematics(const Machine& machine, std::vector<base::Diagnostic>& problems) {
  const auto report = [&](const std::string& message, std::string hint) {
    problems.push_back(base::problem("machine-kinematics", "kinematics \"" + machine.kinematics + "\" " + message,
                                     std::move(hint), {.field = field::kinematics}));
  };
  const auto preset = preset_chain(machine.kinematics);
  if (!preset && machine.kinematics != cartesian) return report("is not known", "known: " + known_kinematics());
  if (preset.has_value() != machine.rotary_chain.has_value()) {
    return report(preset ? "has no chain of rotary axes" : "has a chain of rotary axes",
                  preset ? "give one, such as that of preset_chain()" : "known: " + known_kinematics());
  }
  if (!preset) return;
  const auto& [a, b] = machine.rotary_chain->axes;
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z, a.axis, b.axis}) {
    if (machine.has(axis)) continue;
    report(std::string("needs an axis ") + base::letter(axis), std::string("give [axis.") + base::letter(axis) + "]");
  }
  check_chain(*machine.rotary_chain, problems);
}

}  // namespace leadscrew::machine
