#include <algorithm>
#include <bit>
#include <cmath>
#include <leadscrew/nc/lattice_arc.hpp>
#include <leadscrew/nc/method_traits.hpp>

namespace leadscrew::nc {

using pulse::OnCircle;
using pulse::Order;
using pulse::Preload;

namespace {

std::int64_t longer_of(pulse::Point delta) {
  return std::max(pulse::absolute(delta.x), pulse::absolute(delta.y));
}

/// The fewest bits that hold the longer component of a line.
int bits_for(pulse::Point delta) {
  return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(longer_of(delta))));
}

/// The least capacity of an arc: its radius, rounded, or the longer semi-axis.
std::int64_t radius_of(const PulseCurve& curve, int places = 0) {
  if (curve.is_ellipse()) return curve.semi_axes->longer();
  return std::max<std::int64_t>(1, pulse::root(curve.arc().squared_radius(), places));
}

/// What of an arc or a line decides on the capacity.
std::string_view longest_of(const PulseCurve& curve, std::string_view of_a_line) {
  if (!curve.is_arc()) return of_a_line;
  return curve.is_ellipse() ? "the longer semi-axis" : "the radius, rounded,";
}

PulseConventions of_options(const MethodOptions& options) {
  return {.bits = options.bits, .capacity = {}, .preload = {}, .order = {}, .tie = {}, .end = {}};
}

PulseConventions by_integrators(const PulseCurve& curve, const MethodOptions& options) {
  PulseConventions in_force = of_options(options);
  in_force.end = curve.is_arc() ? "counters-by-quadrant-drained" : "counters";
  if (curve.is_ellipse()) {
    in_force.scale = curve.semi_axes->scale();
  } else if (curve.is_arc() && options.free) {
    in_force.end = "clocks-of-the-angle";
    in_force.accumulation = options.accumulation.value_or(pulse::Accumulation::sign_magnitude);
  } else if (curve.is_arc() && options.places) {
    in_force.places = options.places;
    in_force.capacity = radius_of(curve, *options.places);
    return in_force;
  }
  in_force.capacity = options.capacity;
  return in_force;
}

/// An integrator that adds more than its capacity at a clock would have to overflow twice.
std::optional<base::Diagnostic> capacity_below_integrands(const PulseCurve& curve, std::int64_t capacity) {
  const std::int64_t greatest = curve.is_arc() ? radius_of(curve) : longer_of(curve.delta());
  if (greatest <= capacity) return std::nullopt;
  const std::string_view what = longest_of(curve, "the longer distance along an axis");
  return base::problem("register-overflow",
                       std::string(what) + " is " + std::to_string(greatest) + ": integrators of capacity " +
                           std::to_string(capacity) + " take no more than that",
                       "a capacity of " + std::to_string(greatest) + " would do", {.field = "capacity"});
}

/// Integrands of an ellipse and their capacity are taken so many times that they are whole.
std::optional<base::Diagnostic> scaled_capacity_problem(const PulseCurve& curve, std::int64_t capacity) {
  const std::int64_t scale = curve.semi_axes->scale();
  if (scale <= pulse::greatest_scaled_capacity / capacity) return std::nullopt;
  return base::problem("register-overflow",
                       "the capacity " + std::to_string(capacity) + ", taken " + std::to_string(scale) +
                           " times so that integrands are whole, is more than registers hold, 2^61",
                       "semi-axes in the ratio of small whole numbers, or shorter ones", {.field = "semi_axes"});
}

}  // namespace

PulseConventions by_search(const PulseCurve& curve, const MethodOptions& options, std::string_view tie) {
  PulseConventions in_force = of_options(options);
  in_force.tie = tie;
  in_force.end = curve.is_arc() ? "faster-axis-in-last-quadrant" : "counters";
  return in_force;
}

/// "FPGA-based implementation of circular interpolation" has 8 clocks and .385 BLU of a capacity R, old coordinates and
/// half a load in the lagging axis; the lecture and the teaching interpolator draw lines with 2ⁿ and cleared registers.
PulseConventions of_hardware(const PulseCurve& curve, const MethodOptions& options) {
  PulseConventions in_force = by_integrators(curve, options);
  if (curve.is_arc()) {
    if (!in_force.capacity) in_force.capacity = options.bits ? std::int64_t{1} << *options.bits : radius_of(curve);
    in_force.preload = options.preload.value_or(options.free ? Preload::none : Preload::half_lagging);
    in_force.order = options.order.value_or(Order::parallel);
    return in_force;
  }
  in_force.preload = options.preload.value_or(Preload::none);
  if (in_force.capacity) return in_force;
  in_force.bits = options.bits.value_or(bits_for(curve.delta()));
  in_force.capacity = std::int64_t{1} << *in_force.bits;
  return in_force;
}

/// Koren's program: capacity R or L, so that the feed is the clock's; y by the new x (eq. 27). It starts with empty
/// remainders, which give his 10 001 BLU of a circle that runs freely; counters end each quadrant here, and half full
/// remainders bring the error of circles from 1.47 to .97 BLU and that of lines from 1 to .71.
PulseConventions of_software(const PulseCurve& curve, const MethodOptions& options) {
  PulseConventions in_force = by_integrators(curve, options);
  in_force.preload = options.preload.value_or(options.free ? Preload::none : Preload::half);
  if (curve.is_arc()) {
    if (!in_force.capacity) in_force.capacity = radius_of(curve);
    in_force.order = options.order.value_or(Order::x_first);
    return in_force;
  }
  const pulse::Point delta = curve.delta();
  if (!in_force.capacity) in_force.capacity = pulse::capacity_for(delta.x * delta.x + delta.y * delta.y);
  return in_force;
}

std::optional<double> clocks_per_blu(PulseMethod method, const PulseCurve& curve, const PulseConventions& in_force) {
  if (rate_of(method) != CommandRate::path_length || !in_force.capacity || curve.is_ellipse()) return std::nullopt;
  const pulse::Point delta = curve.delta();
  const double length = std::sqrt(static_cast<double>(delta.x * delta.x + delta.y * delta.y));
  const auto unit = static_cast<double>(std::int64_t{1} << in_force.places.value_or(0));
  return static_cast<double>(*in_force.capacity) / ((curve.is_arc() ? curve.radius() : length) * unit);
}

std::string_view name(PulseMethod method) {
  return with_row(method, [](auto row) { return row.name; });
}

CommandRate rate_of(PulseMethod method) {
  return with_row(method, [](auto row) { return row.rate; });
}

MethodUses uses_of(PulseMethod method) {
  return with_row(method, [](auto row) {
    return MethodUses{row.takes_preload, row.takes_capacity, row.takes_order, row.takes_tie,
                      row.takes_ellipse, row.takes_free,     row.takes_free,  row.takes_free};
  });
}

std::string_view conventions_in_programs(PulseMethod method) {
  return with_row(method, [](auto row) { return row.in_programs; });
}

std::string_view name(Preload preload) {
  constexpr std::array<std::string_view, 5> names = {"zero", "half", "half-lagging", "full", "minus-one"};
  return names[static_cast<std::size_t>(preload)];
}

std::string_view name(OnCircle tie) {
  return tie == OnCircle::outward ? "outward" : "inward";
}

std::string_view name(Order order) {
  constexpr std::array<std::string_view, 4> names = {"parallel", "x-first", "shrinking-first", "growing-first"};
  return names[static_cast<std::size_t>(order)];
}

std::string_view name(pulse::Accumulation accumulation) {
  constexpr std::array<std::string_view, 3> names = {"sign-magnitude", "floor", "symmetric"};
  return names[static_cast<std::size_t>(accumulation)];
}

namespace {

/// "dda and koren": the methods that have something.
std::string names_of_those_with(bool MethodUses::* use) {
  std::vector<std::string_view> names;
  for (const PulseMethod method : all_pulse_methods) {
    if (uses_of(method).*use) names.push_back(name(method));
  }
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text.append(i == 0 ? "" : i + 1 < names.size() ? ", " : " and ").append(names[i]);
  return text;
}

}  // namespace

std::string unused_option(const MethodOptions& options, std::span<const PulseMethod> methods, const PulseCurve& curve) {
  struct Asked {
    std::string_view name;
    bool is_given;
    bool MethodUses::* use;
  };
  const std::array<Asked, 7> all = {{{"preload", options.preload.has_value(), &MethodUses::preload},
                                     {"capacity", options.capacity.has_value(), &MethodUses::capacity},
                                     {"order", options.order.has_value(), &MethodUses::order},
                                     {"free", options.free, &MethodUses::free},
                                     {"places", options.places.has_value(), &MethodUses::places},
                                     {"accumulation", options.accumulation.has_value(), &MethodUses::accumulation},
                                     {"tie", options.tie.has_value(), &MethodUses::tie}}};
  const bool is_ellipse = curve.is_ellipse();
  for (const auto& [option, is_given, use] : all) {
    const bool is_of_circles = use != &MethodUses::preload && use != &MethodUses::capacity && use != &MethodUses::order;
    const bool is_of_arcs = is_of_circles || use == &MethodUses::order;
    const bool is_had = std::ranges::any_of(methods, [=](PulseMethod method) { return uses_of(method).*use; });
    if (!is_given || (is_had && (curve.is_arc() || !is_of_arcs) && !(is_ellipse && is_of_circles))) continue;
    const std::string_view of = is_ellipse ? "arcs of circles by " : is_of_arcs ? "arcs by " : "";
    return std::string(option).append(" is for ").append(of) + names_of_those_with(use);
  }
  return {};
}

std::string_view conflict_of(const MethodOptions& options, const PulseCurve& curve) {
  const bool is_circle = curve.is_arc() && !curve.is_ellipse();
  if (options.places && (!is_circle || options.free))
    return "places of the radius are for arcs of circles that end by counters";
  if (options.places && (options.bits || options.capacity))
    return "places of the radius make the capacity: give no bits and no capacity beside";
  if (options.accumulation && !(is_circle && options.free))
    return "an accumulation is for arcs of circles that run freely";
  if (options.accumulation.value_or(pulse::Accumulation::sign_magnitude) != pulse::Accumulation::sign_magnitude &&
      options.preload == Preload::minus_one)
    return "remainders that begin at -1 are for magnitudes: the accumulation sign-magnitude";
  return {};
}

PulseConventions conventions_of(PulseMethod method, const PulseCurve& curve, const MethodOptions& options) {
  return with_row(method, [&](auto row) { return row.conventions(curve, options); });
}

std::int64_t free_clocks(const PulseCurve& curve, std::int64_t capacity) {
  return static_cast<std::int64_t>(sweep(curve.arc()) * static_cast<double>(capacity));
}

std::optional<base::Diagnostic> capacity_problem(PulseMethod method, const PulseCurve& curve,
                                                 const MethodOptions& options) {
  if (curve.is_ellipse()) {
    if (!uses_of(method).ellipse)
      return base::problem("no-ellipse", std::string(name(method)) + " draws lines and arcs of circles",
                           "ellipses are for dda and koren", {.field = "method"});
    const auto problem = scaled_capacity_problem(curve, *conventions_of(method, curve, options).capacity);
    if (problem) return problem;
  }
  if (options.capacity && uses_of(method).capacity) return capacity_below_integrands(curve, *options.capacity);
  const bool bits_hold_capacity = with_row(method, [](auto row) { return row.bits_hold_capacity; });
  if (!bits_hold_capacity || !options.bits) return std::nullopt;
  const std::int64_t capacity = *conventions_of(method, curve, options).capacity;
  auto problem = overflow_of({"q", capacity, std::string(longest_of(curve, "the length, rounded up,"))}, options.bits);
  if (problem) problem->subject.field = "bits";
  return problem;
}

}  // namespace leadscrew::nc
