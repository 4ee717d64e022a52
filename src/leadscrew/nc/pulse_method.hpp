#pragma once
// The interpolators of pulse/ by name, each for lines and for arcs, and the conventions that the papers leave open.
// What each of them is made of stands in method_traits.hpp.
//
//   method              arcs                                    lines
//   point-comparison    F and the quadrant say which axis       F = |a|y − |b|x says which axis
//   dda                 hardware: capacity R, clocked together  hardware: capacity 2ⁿ of n-bit registers
//   min-error           the least |F| of three steps            as bresenham
//   improved-min-error  the middle between two steps            as bresenham
//   bresenham           as min-error                            the longer axis at each clock
//   koren               software: capacity R, x before y        software: capacity ⌈L⌉
//
// Ellipses are for dda and koren, as arcs: capacity the longer semi-axis. So is an arc of a circle that runs freely:
// the circle generator without counters, for the clocks that its angle takes.
//
// On a line the nearest of three steps is one of the two that Bresenham's middle decides between; on a circle
// Bresenham's (1977) compares the same three |F| that the method of least error does, and no two are ever equal.

#include <array>
#include <cstdint>
#include <leadscrew/nc/pulse_curve.hpp>
#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/circular_search.hpp>
#include <leadscrew/pulse/free_circle.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace leadscrew::nc {

enum class PulseMethod : std::uint8_t { point_comparison, dda, min_error, improved_min_error, bresenham, koren };

inline constexpr std::array all_pulse_methods = {PulseMethod::point_comparison, PulseMethod::dda,
                                                 PulseMethod::min_error,        PulseMethod::improved_min_error,
                                                 PulseMethod::bresenham,        PulseMethod::koren};
inline constexpr std::array all_preloads = {pulse::Preload::none, pulse::Preload::half, pulse::Preload::half_lagging,
                                            pulse::Preload::full, pulse::Preload::minus_one};
inline constexpr std::array all_ties = {pulse::OnCircle::outward, pulse::OnCircle::inward};
inline constexpr std::array all_orders = {pulse::Order::parallel, pulse::Order::x_first, pulse::Order::shrinking_first,
                                          pulse::Order::growing_first};

inline constexpr std::array all_accumulations = {pulse::Accumulation::sign_magnitude, pulse::Accumulation::floor,
                                                 pulse::Accumulation::symmetric};

/// What a method takes a command of feed for.
enum class CommandRate : std::uint8_t {
  path_length,   ///< a BLU of the path, whatever its course: integrators
  every_step,    ///< a step of one axis
  longest_axis,  ///< a step of the axis that is fastest there
};
CommandRate rate_of(PulseMethod method);

// As the command line and JSON have them.
std::string_view name(PulseMethod method);
std::string_view name(pulse::Preload preload);
std::string_view name(pulse::OnCircle tie);
std::string_view name(pulse::Order order);
std::string_view name(pulse::Accumulation accumulation);

/// Which of the options below a method has.
struct MethodUses {
  bool preload = false;
  bool capacity = false;
  bool order = false;  ///< on arcs
  bool tie = false;    ///< on arcs
  bool ellipse = false;
  bool free = false;          ///< on arcs of circles
  bool places = false;        ///< on arcs of circles that end by counters
  bool accumulation = false;  ///< on arcs of circles that run freely
};
MethodUses uses_of(PulseMethod method);

/// The conventions along whole programs, where integrators have some that differ from those of one curve; for people.
std::string_view conventions_in_programs(PulseMethod method);

/// Of integrators along whole programs.
struct InterpolationOptions {
  pulse::Preload preload = pulse::Preload::half;  ///< Koren's registers begin empty
  int places = 0;  ///< 0 … 16, of the radius in circular DDAs: more where feed on circles is to be exact
};

/// Conventions that were asked for; each method has a default of its own for what was not.
struct MethodOptions {
  std::optional<int> bits;  ///< 1 … 30: of the registers; the capacity of `dda` is 2ⁿ
  /// Of integrators, 1 … 2³⁰: that of hardware whose registers stay as they are whatever the curve. Without bits.
  std::optional<std::int64_t> capacity{};
  std::optional<pulse::Preload> preload;
  std::optional<pulse::OnCircle> tie;
  std::optional<pulse::Order> order;
  bool free =
      false;  ///< of integrators of arcs of circles: no quadrants and counters, as many clocks as the angle takes
  /// Of integrators of arcs of circles, 1 … 16: binary places of the radius in the capacity. Without bits, capacity and free.
  std::optional<int> places{};
  /// Of those that run freely: how remainders take negative integrands. Preload::minus_one is for magnitudes.
  std::optional<pulse::Accumulation> accumulation{};
};

/// The first of the options that were asked for which none of these methods has on this curve, and of what it is: "order is for
/// arcs by dda and koren". Empty where each is used.
std::string unused_option(const MethodOptions& options, std::span<const PulseMethod> methods, const PulseCurve& curve);

/// What is wrong with options that do not go together on this curve; empty where nothing is.
std::string_view conflict_of(const MethodOptions& options, const PulseCurve& curve);

inline constexpr int most_pulse_bits = 30, most_places = 16;

/// Those that are in force; empty where the method has no such choice.
struct PulseConventions {
  std::optional<int> bits;               ///< of the registers
  std::optional<std::int64_t> capacity;  ///< q
  std::optional<pulse::Preload> preload;
  std::optional<pulse::Order> order;
  std::string_view tie;  ///< what happens where two steps are as good as one another
  std::string_view end;  ///< how the end is found
  /// Of an ellipse: what its integrands and its capacity are taken times, so that they are whole.
  std::optional<std::int64_t> scale{};
  std::optional<int> places{};                        ///< of the radius in the capacity, where they were asked for
  std::optional<pulse::Accumulation> accumulation{};  ///< of remainders of an arc that runs freely
};

// Of a search, whose tie is this; of the DDA in hardware; of Koren's program.
PulseConventions by_search(const PulseCurve& curve, const MethodOptions& options, std::string_view tie);
PulseConventions of_hardware(const PulseCurve& curve, const MethodOptions& options);
PulseConventions of_software(const PulseCurve& curve, const MethodOptions& options);

PulseConventions conventions_of(PulseMethod method, const PulseCurve& curve, const MethodOptions& options);

/// Of integrators: a BLU of the path takes so many clocks, q/L along a line and q/R along a circle. None of the others,
/// whose rate depends on the course.
std::optional<double> clocks_per_blu(PulseMethod method, const PulseCurve& curve, const PulseConventions& in_force);

/// The clocks of an arc of a circle that runs freely, by integrators of this capacity: as many as they take for its angle.
std::int64_t free_clocks(const PulseCurve& curve, std::int64_t capacity);

/// Of a curve that problems_of() finds nothing wrong with: `register-overflow` where the bits asked for do not hold the
/// capacity of `koren`, which is the radius of an arc, rounded, the longer semi-axis of an ellipse, and the length of a
/// line, rounded up; where the capacity asked for is less than an integrand: than the radius, rounded, that semi-axis, or
/// the longer of a line's distances along the axes; or where registers do not hold an ellipse's capacity, scaled.
/// `no-ellipse` where the method draws none.
std::optional<base::Diagnostic> capacity_problem(PulseMethod method, const PulseCurve& curve,
                                                 const MethodOptions& options);

}  // namespace leadscrew::nc
