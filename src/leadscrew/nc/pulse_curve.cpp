#include <algorithm>
#include <bit>
#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/nc/ellipse_distance.hpp>
#include <leadscrew/nc/pulse_curve.hpp>
#include <string>
#include <tuple>
#include <utility>

namespace leadscrew::nc {

namespace {

using pulse::absolute;
using pulse::Point;

using Problems = std::vector<base::Diagnostic>;

Point from(Point origin, Point at) {
  return {at.x - origin.x, at.y - origin.y};
}

double length_of(Point delta) {
  return std::sqrt(static_cast<double>(delta.x * delta.x + delta.y * delta.y));
}

void add(Problems& problems, std::string_view code, std::string message, std::string hint, base::Subject subject) {
  problems.push_back(base::problem(code, std::move(message), std::move(hint), subject));
}

base::Diagnostic overflow(std::string_view name, std::string_view meaning, std::string_view value,
                          std::int64_t greatest, std::string hint) {
  std::string message(meaning);
  message.append(" is ").append(value).append(": register ").append(name);
  return base::problem("register-overflow", message + " holds no more than " + std::to_string(greatest),
                       std::move(hint));
}

void check_register(Problems& problems, const RegisterContent& content, std::optional<int> bits,
                    base::Subject subject) {
  auto problem = overflow_of(content, bits);
  if (!problem) return;
  problem->subject = subject;
  problems.push_back(std::move(*problem));
}

/// Both coordinates of a point; `of` is what messages call it, and what is behind it.
void check_point(Problems& problems, std::string_view field, const std::string& of, Point at, std::optional<int> bits) {
  check_register(problems, {"x", at.x, "x of the " + of}, bits, {.axis = base::Axis::X, .field = field});
  check_register(problems, {"y", at.y, "y of the " + of}, bits, {.axis = base::Axis::Y, .field = field});
}

/// As they were given: beyond the greatest even their differences might be out of range.
void check_given(Problems& problems, const PulseCurve& curve) {
  check_point(problems, "start", "start", curve.start, std::nullopt);
  check_point(problems, "end", "end", curve.end, std::nullopt);
  if (curve.is_arc()) check_point(problems, "center", "centre", curve.center, std::nullopt);
}

void check_line(Problems& problems, const PulseCurve& curve, std::optional<int> bits) {
  const Point delta = curve.delta();
  if (delta == Point{}) {
    add(problems, "no-way", "the line ends at " + point_text(curve.end) + ", where it starts",
        "give an end away from the start; a full circle is an arc", {.field = "end"});
    return;
  }
  check_register(problems, {"Jx", delta.x, "the distance along x"}, bits, {.axis = base::Axis::X, .field = "end"});
  check_register(problems, {"Jy", delta.y, "the distance along y"}, bits, {.axis = base::Axis::Y, .field = "end"});
}

EllipseFoot foot_on(pulse::SemiAxes axes, Point at) {
  return foot_on_ellipse(static_cast<double>(axes.x), static_cast<double>(axes.y), static_cast<double>(at.x),
                         static_cast<double>(at.y));
}

/// The place of the lattice that is nearest to the ellipse, of those around a point of it: no more than half a BLU off,
/// for where the ellipse passes a line of the lattice at less than 45° one of its two neighbours on that is.
Point beside(pulse::SemiAxes axes, EllipseFoot foot) {
  const Point middle{std::llround(foot.x), std::llround(foot.y)};
  Point nearest = middle;
  const auto off = [&](Point at) { return std::abs(foot_on(axes, at).distance); };
  for (std::int64_t x = middle.x - 1; x <= middle.x + 1; ++x) {
    for (std::int64_t y = middle.y - 1; y <= middle.y + 1; ++y) {
      if (Point{x, y} != Point{} && off({x, y}) < off(nearest)) nearest = {x, y};
    }
  }
  return nearest;
}

void check_beside(Problems& problems, pulse::SemiAxes axes, std::string_view field, Point given, Point from_center) {
  const EllipseFoot foot = foot_on(axes, from_center);
  const double off = std::abs(foot.distance);
  if (off <= 0.5 && from_center != Point{}) return;
  const Point right = beside(axes, foot);
  add(problems, "off-ellipse",
      "the " + std::string(field) + " " + point_text(given) + " is " + base::fixed_text(off, 3) +
          " BLU off the ellipse with the semi-axes " + point_text({axes.x, axes.y}),
      "half a BLU at most, as " + point_text({right.x + given.x - from_center.x, right.y + given.y - from_center.y}) +
          " is",
      {.field = field});
}

void check_ellipse(Problems& problems, const PulseCurve& curve, std::optional<int> bits) {
  const pulse::SemiAxes axes = *curve.semi_axes;
  for (const auto& [name, length, axis] :
       {std::tuple("x", axes.x, base::Axis::X), std::tuple("y", axes.y, base::Axis::Y)}) {
    const base::Subject subject{.axis = axis, .field = "semi_axes"};
    const std::string meaning = std::string("the semi-axis along ") + name;
    if (length > 0) {
      check_register(problems, {name, length, meaning}, bits, subject);
    } else {
      add(problems, "zero-radius", meaning + " is " + std::to_string(length), "a semi-axis is more than 0", subject);
    }
  }
  if (!problems.empty()) return;
  check_beside(problems, axes, "start", curve.start, from(curve.center, curve.start));
  check_beside(problems, axes, "end", curve.end, from(curve.center, curve.end));
}

void check_arc(Problems& problems, const PulseCurve& curve, std::optional<int> bits) {
  const pulse::Arc arc = curve.arc();
  if (arc.start == Point{}) {
    add(problems, "zero-radius", "the radius is 0: the arc starts at its centre " + point_text(curve.center),
        "a centre away from the start", {.field = "center"});
    return;
  }
  const std::size_t before = problems.size();
  check_point(problems, "start", "start, from the centre,", arc.start, bits);
  check_point(problems, "end", "end, from the centre,", arc.end, bits);
  if (problems.size() > before) return;
  const double radius = curve.radius(), at_end = length_of(arc.end);
  if (std::abs(at_end - radius) > 0.5) {
    add(problems, "end-off-circle",
        "the end " + point_text(curve.end) + " is " + base::fixed_text(at_end, 3) + " BLU from the centre, the start " +
            base::fixed_text(radius, 3),
        "the end may be off the circle through the start by half a BLU at most", {.field = "end"});
    return;
  }
  // Where the arc passes an axis, a coordinate grows to the radius.
  if (pulse::borders(arc) == 0) return;
  const int quadrant = pulse::quadrant(arc.start, arc.direction);
  const Point border = pulse::border(quadrant, arc.direction, pulse::root(arc.squared_radius(), 0));
  check_register(problems, {"x", border.x, "x where the arc passes an axis"}, bits, {.field = "bits"});
  check_register(problems, {"y", border.y, "y where the arc passes an axis"}, bits, {.field = "bits"});
}

}  // namespace

std::string point_text(Point at) {
  return "(" + std::to_string(at.x) + ", " + std::to_string(at.y) + ")";
}

std::optional<base::Diagnostic> overflow_of(const RegisterContent& content, std::optional<int> bits) {
  const std::int64_t greatest = bits ? (std::int64_t{1} << *bits) - 1 : pulse::greatest_coordinate;
  if (content.value >= -greatest && content.value <= greatest) return std::nullopt;
  if (!bits) return overflow_beyond(content.name, content.meaning, std::to_string(content.value));
  const std::string name = content.name + (" of " + std::to_string(*bits) + (*bits == 1 ? " bit" : " bits"));
  const auto needed = std::bit_width(static_cast<std::uint64_t>(absolute(content.value)));
  return overflow(name, content.meaning, std::to_string(content.value), greatest,
                  std::to_string(needed) + " bits would hold it");
}

base::Diagnostic overflow_beyond(std::string_view name, std::string_view meaning, std::string_view value) {
  return overflow(name, meaning, value, pulse::greatest_coordinate, "make the curve smaller, or the BLU larger");
}

pulse::Arc PulseCurve::arc() const {
  return {from(center, start), from(center, end), direction};
}

Point PulseCurve::delta() const {
  return from(start, end);
}

double PulseCurve::radius() const {
  return length_of(from(center, start));
}

Problems problems_of(const PulseCurve& curve, std::optional<int> bits) {
  Problems problems;
  check_given(problems, curve);
  if (!problems.empty()) return problems;
  if (curve.is_ellipse()) {
    check_ellipse(problems, curve, bits);
  } else if (curve.is_arc()) {
    check_arc(problems, curve, bits);
  } else {
    check_line(problems, curve, bits);
  }
  return problems;
}

PulseError::PulseError(const PulseCurve& curve)
    : curve_(curve),
      delta_(curve.is_arc() ? from(curve.center, curve.start) : curve.delta()),
      square_(delta_.x * delta_.x + delta_.y * delta_.y),
      root_(std::sqrt(static_cast<double>(square_))) {}

double PulseError::operator()(Point place) const {
  const Point at = from(curve_.origin(), place);
  if (!curve_.is_arc()) return static_cast<double>(delta_.x * at.y - delta_.y * at.x) / root_;
  if (curve_.is_ellipse()) return foot_on(*curve_.semi_axes, at).distance;
  // F = ρ² − R² is exact: F/(ρ + R) has no difference of nearly equal roots.
  const std::int64_t square = at.x * at.x + at.y * at.y;
  return static_cast<double>(square - square_) / (std::sqrt(static_cast<double>(square)) + root_);
}

}  // namespace leadscrew::nc
