#pragma once
// The pulse methods, a row each: which interpolators it has, what it takes a command for, what its registers are
// called. A new method is a row here, an enumerator of PulseMethod and, where its steps are new, an interpolator in
// pulse/.
//
// A row says
//
//   method, name                  its enumerator; what the command line and JSON call it
//   rate                          what it takes a command for
//   Line<axes>, line()            the interpolator of lines in programs, for deltas, a capacity q and what is in the
//                                 registers at the start
//   Circle, circle()              that of arcs in programs
//   Curves, load()                the interpolators of one curve alone, and the one of a curve
//   conventions()                 what is in force for a curve (PulseConventions)
//   takes_preload, _capacity, _order, _tie   which options it has; order and tie are of arcs
//   takes_ellipse, takes_free     draws it ellipses, arcs without counters?
//   bits_hold_capacity            must the registers asked for hold the capacity of the curve?
//   candidates                    which values it compares at a clock, to be shown
//   paper_names()                 its registers' names in the paper
//   in_programs                   the conventions along whole programs, where DDAs have any, for people
//
// add_registers() says for an interpolator which registers it shows.

#include <leadscrew/nc/program_circle.hpp>
#include <leadscrew/nc/pulse_method.hpp>
#include <leadscrew/nc/registers.hpp>
#include <leadscrew/nc/type_list.hpp>
#include <leadscrew/pulse/free_circle.hpp>
#include <leadscrew/pulse/linear.hpp>

namespace leadscrew::nc {

// Registers.

template <pulse::Search search, pulse::OnCircle tie>
void add_registers(Registers& registers, const pulse::CircularSearch<search, tie>& state) {
  registers.add("F", state.deviation());
}

inline void add_registers(Registers& registers, const pulse::CircularDda& state) {
  registers.add("rx", state.x().remainder());
  registers.add("ry", state.y().remainder());
  registers.add("nx", state.left_x());
  registers.add("ny", state.left_y());
  registers.add("q", state.x().capacity());
}

inline void add_registers(Registers& registers, const pulse::EllipticDda& state) {
  registers.add("rx", state.x().integrator.remainder());
  registers.add("ry", state.y().integrator.remainder());
  registers.add("nx", state.x().left);
  registers.add("ny", state.y().left);
  registers.add("q", state.x().integrator.capacity());
}

inline void add_registers(Registers& registers, const pulse::FreeArc& state) {
  registers.add("rx", state.x().integrator.remainder());
  registers.add("ry", state.y().integrator.remainder());
  registers.add("n", state.left());
  registers.add("q", state.x().integrator.capacity());
}

inline void add_registers(Registers& registers, const pulse::LinearDda<2>& state) {
  registers.add("Jx", state.integrand(0));
  registers.add("Jy", state.integrand(1));
  registers.add("rx", state.integrator(0).remainder());
  registers.add("ry", state.integrator(1).remainder());
  registers.add("nx", state.left(0));
  registers.add("ny", state.left(1));
  registers.add("q", state.integrator(0).capacity());
}

inline void add_registers(Registers& registers, const pulse::LinearPointComparison<2>& state) {
  registers.add("F", state.deviation());
  registers.add("nx", state.left(0));
  registers.add("ny", state.left(1));
}

inline void add_registers(Registers& registers, const pulse::LinearBresenham& state) {
  registers.add("F", state.deviation());
  registers.add("n", state.left());
}

/// What a method compares to choose a step along an arc.
enum class Candidates : std::uint8_t {
  none,
  three,   ///< F after each of the steps that the quadrant allows: n1 n2 n3
  middle,  ///< and the middle of two of them against the circle: d
};

inline constexpr std::array<PaperName, 10> names_of_fpga = {{{"x", "Val_x"},
                                                             {"y", "Val_y"},
                                                             {"y", "Val_z"},
                                                             {"F", "Val_f"},
                                                             {"n1", "Val_n1"},
                                                             {"n2", "Val_n2"},
                                                             {"n3", "Val_n3"},
                                                             {"rx", "Sum_X"},
                                                             {"ry", "Sum_Y"},
                                                             {"ry", "Sum_Z"}}};
inline constexpr std::array<PaperName, 6> names_of_koren_lines = {
    {{"Jx", "y1"}, {"Jy", "y2"}, {"rx", "r1"}, {"ry", "r2"}, {"dx", "dz1"}, {"dy", "dz2"}}};
inline constexpr std::array<PaperName, 6> names_of_koren_arcs = {
    {{"x", "y1"}, {"y", "y2"}, {"ry", "r1"}, {"rx", "r2"}, {"dy", "dz1"}, {"dx", "dz2"}}};

// Rows.

/// What all rows say that do not say otherwise.
struct MethodDefaults {
  static constexpr bool takes_preload = false, takes_capacity = false, takes_order = false, takes_tie = false,
                        takes_ellipse = false, takes_free = false, bits_hold_capacity = false;
  static constexpr Candidates candidates = Candidates::none;
  static constexpr std::string_view in_programs = {};
  static std::span<const PaperName> paper_names(PulseCurve::Shape) { return names_of_fpga; }

  // In programs. With the longest component as its capacity a DDA is Bresenham's line (block_interpolator.cpp).
  template <std::size_t axes>
  using Line = pulse::LinearDda<axes>;
  template <std::size_t axes>
  static Line<axes> line(const std::array<std::int64_t, axes>& delta, std::int64_t capacity, std::int64_t preload) {
    return {delta, capacity, preload};
  }
};

/// Arcs by search, lines by Bresenham's, which decides between the same points.
template <pulse::Search search>
struct BySearch : MethodDefaults {
  static constexpr CommandRate rate = CommandRate::longest_axis;
  using Circle = pulse::CircularSearch<search>;
  static Circle circle(const pulse::Arc& arc, const InterpolationOptions&) { return Circle(arc); }
  using Curves = TypeList<Circle, pulse::LinearBresenham>;
  template <typename State>
  static State load(const PulseCurve& curve, const PulseConventions&, const MethodOptions&) {
    if (curve.is_arc()) return Circle(curve.arc());
    return pulse::LinearBresenham(curve.delta());
  }

 protected:
  static PulseConventions with_ties(const PulseCurve& curve, const MethodOptions& options, std::string_view of_arcs) {
    return by_search(curve, options, curve.is_arc() ? of_arcs : "longer-axis");
  }
};

/// Arcs and lines by integrators.
struct ByIntegrators : MethodDefaults {
  static constexpr CommandRate rate = CommandRate::path_length;
  static constexpr bool takes_preload = true, takes_capacity = true, takes_order = true, takes_ellipse = true,
                        takes_free = true;
  using Circle = ProgramCircle;
  using Curves = TypeList<pulse::CircularDda, pulse::EllipticDda, pulse::FreeArc, pulse::LinearDda<2>>;
  template <typename State>
  static State load(const PulseCurve& curve, const PulseConventions& in_force, const MethodOptions& asked) {
    const pulse::Preload preload = in_force.preload.value_or(pulse::Preload::none);
    const pulse::CircularDdaOptions options{
        .order = in_force.order.value_or(pulse::Order::parallel),
        .preload = preload,
        .places = in_force.places.value_or(0),
        .capacity = in_force.places.value_or(0) > 0 ? 0 : static_cast<std::int32_t>(*in_force.capacity)};
    if (curve.is_ellipse()) return pulse::EllipticDda(curve.arc(), *curve.semi_axes, options);
    if (curve.is_arc() && asked.free)
      return pulse::FreeArc(curve.arc(), free_clocks(curve, *in_force.capacity), options,
                            in_force.accumulation.value_or(pulse::Accumulation::sign_magnitude));
    if (curve.is_arc()) return pulse::CircularDda(curve.arc(), options);
    const pulse::Point delta = curve.delta();
    return pulse::LinearDda<2>({delta.x, delta.y}, *in_force.capacity, preload);
  }
};

struct PointComparison : MethodDefaults {
  static constexpr PulseMethod method = PulseMethod::point_comparison;
  static constexpr std::string_view name = "point-comparison";
  static constexpr CommandRate rate = CommandRate::every_step;
  static constexpr bool takes_tie = true;
  template <std::size_t axes>
  using Line = pulse::LinearPointComparison<axes>;
  template <std::size_t axes>
  static Line<axes> line(const std::array<std::int64_t, axes>& delta, std::int64_t, std::int64_t) {
    return Line<axes>(delta);
  }
  using Circle = pulse::CircularSearch<pulse::Search::point_comparison>;
  static Circle circle(const pulse::Arc& arc, const InterpolationOptions&) { return Circle(arc); }

  using InwardCircle = pulse::CircularSearch<pulse::Search::point_comparison, pulse::OnCircle::inward>;
  using Curves = TypeList<Circle, InwardCircle, Line<2>>;
  template <typename State>
  static State load(const PulseCurve& curve, const PulseConventions&, const MethodOptions& options) {
    const pulse::Point delta = curve.delta();
    if (!curve.is_arc()) return Line<2>({delta.x, delta.y});
    if (options.tie == pulse::OnCircle::inward) return InwardCircle(curve.arc());
    return Circle(curve.arc());
  }
  /// Outward from the circle by default: the paper's text says inward, its .877 BLU come of outward.
  static PulseConventions conventions(const PulseCurve& curve, const MethodOptions& options) {
    return by_search(curve, options, curve.is_arc() ? nc::name(options.tie.value_or(pulse::OnCircle::outward)) : "x");
  }
};

struct Dda : ByIntegrators {
  static constexpr PulseMethod method = PulseMethod::dda;
  static constexpr std::string_view name = "dda";
  static constexpr std::string_view in_programs = "capacity R or L, registers clocked together, half full";
  static Circle circle(const pulse::Arc& arc, const InterpolationOptions& options) {
    return Circle(arc, {pulse::Order::parallel, options.preload, options.places});
  }
  static PulseConventions conventions(const PulseCurve& curve, const MethodOptions& options) {
    return of_hardware(curve, options);
  }
};

struct MinError : BySearch<pulse::Search::least_error> {
  static constexpr PulseMethod method = PulseMethod::min_error;
  static constexpr std::string_view name = "min-error";
  static constexpr Candidates candidates = Candidates::three;
  static PulseConventions conventions(const PulseCurve& curve, const MethodOptions& options) {
    return with_ties(curve, options, "none");
  }
};

struct ImprovedMinError : BySearch<pulse::Search::improved_least_error> {
  static constexpr PulseMethod method = PulseMethod::improved_min_error;
  static constexpr std::string_view name = "improved-min-error";
  static constexpr Candidates candidates = Candidates::middle;
  static PulseConventions conventions(const PulseCurve& curve, const MethodOptions& options) {
    return with_ties(curve, options, "growing-axis");
  }
};

/// On a circle the method of least error.
struct Bresenham : MinError {
  static constexpr PulseMethod method = PulseMethod::bresenham;
  static constexpr std::string_view name = "bresenham";
};

struct Koren : ByIntegrators {
  static constexpr PulseMethod method = PulseMethod::koren;
  static constexpr std::string_view name = "koren";
  static constexpr std::string_view in_programs = "capacity R or L, x before y, half full";
  static constexpr bool bits_hold_capacity = true;
  static std::span<const PaperName> paper_names(PulseCurve::Shape shape) {
    if (shape == PulseCurve::Shape::arc) return names_of_koren_arcs;
    return names_of_koren_lines;
  }
  static Circle circle(const pulse::Arc& arc, const InterpolationOptions& options) {
    return Circle(arc, {pulse::Order::x_first, options.preload, options.places});
  }
  static PulseConventions conventions(const PulseCurve& curve, const MethodOptions& options) {
    return of_software(curve, options);
  }
};

/// In the order of PulseMethod.
using MethodRows = TypeList<PointComparison, Dda, MinError, ImprovedMinError, Bresenham, Koren>;

template <class... Rows>
constexpr bool are_all_methods(TypeList<Rows...>) {
  return std::array{Rows::method...} == all_pulse_methods;
}
static_assert(are_all_methods(MethodRows{}));

template <class Row, class... Rows, typename Visitor>
constexpr decltype(auto) with_row_of(TypeList<Row, Rows...>, PulseMethod method, const Visitor& visitor) {
  if constexpr (sizeof...(Rows) > 0) {
    if (method != Row::method) return with_row_of(TypeList<Rows...>{}, method, visitor);
  }
  return visitor(Row{});
}

/// What the visitor says of the method's row.
template <typename Visitor>
constexpr decltype(auto) with_row(PulseMethod method, const Visitor& visitor) {
  return with_row_of(MethodRows{}, method, visitor);
}

}  // namespace leadscrew::nc
