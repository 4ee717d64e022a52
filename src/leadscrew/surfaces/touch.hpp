#pragma once
// A tool that touches a surface along a line of its parameters: contact, tip and axis with their derivatives by the line's own
// parameter. The normal has one derivative less than the surface, and the pass' direction one less than the line, so that
// three derivatives of both give two of the tip.

#include <leadscrew/numeric/jet.hpp>
#include <leadscrew/surfaces/cutter.hpp>
#include <leadscrew/surfaces/frame.hpp>
#include <leadscrew/surfaces/passes.hpp>

namespace leadscrew::surfaces {

using Jet1 = numeric::Jet<1>;
using Jet2 = numeric::Jet<2>;

/// u and v of a line, by the line's parameter.
struct LinePlace {
  numeric::Jet<3> u, v;
};

/// Any scalar: double, or jets by the line's parameter.
template <typename T>
struct Touch {
  VectorOf<T> contact, normal, forward, axis, tip;
};

template <typename T>
T dot_of(const VectorOf<T>& a, const VectorOf<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <typename T>
VectorOf<T> cross_of(const VectorOf<T>& a, const VectorOf<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <typename T>
VectorOf<T> unit_of(const VectorOf<T>& a) {
  using std::sqrt;
  const T factor = T(1.0) / sqrt(dot_of(a, a));
  return {factor * a[0], factor * a[1], factor * a[2]};
}

/// Of S along the line and its partial derivatives Su and Sv; neither Su × Sv nor `along` may vanish.
template <typename T>
Touch<T> touch_of(const Machining& machining, const VectorOf<T>& contact, const VectorOf<T>& by_u,
                  const VectorOf<T>& by_v, const VectorOf<T>& along) {
  Touch<T> touch;
  touch.contact = contact;
  touch.normal = machining.side < 0 ? unit_of(cross_of(by_v, by_u)) : unit_of(cross_of(by_u, by_v));
  touch.forward = unit_of(along);
  touch.axis = axis_of(machining.orientation, touch.normal, touch.forward);
  touch.tip = tip_of(machining.cutter, contact, touch.normal, touch.axis, touch.forward);
  return touch;
}

/// With two derivatives by the line's parameter.
Touch<Jet2> touch_along(const Machining& machining, const SurfaceJet& jet, const LinePlace& place);
/// With one, of a jet of second order.
Touch<Jet1> touch_of_first_order(const Machining& machining, const SurfaceJet& jet, const LinePlace& place);
/// The place alone.
Touch<double> touch_at(const Machining& machining, const SurfaceJet& jet, const LinePlace& place);

/// How the tool and the surface bend where they touch.
struct Bending {
  double clearance = 0;  ///< local_clearance, 1/mm
  Tensor surface;        ///< the surface's curvature by f and b
  double greatest = 0;   ///< in any direction, counted without sign, 1/mm
  Vector axis{};         ///< of the tool by f, b and n
  Vector b{};            ///< across the pass
};
Bending bending_at(const Machining& machining, const SurfaceJet& jet, const Frame& frame, const LinePlace& place);

}  // namespace leadscrew::surfaces
