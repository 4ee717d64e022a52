// Surfaces of OpenCASCADE as B-splines: planes, cylinders, cones, spheres, tori, swept and Bézier surfaces exactly; offset
// surfaces, and degrees above 5, only within a tolerance.

#include <GeomConvert.hxx>
#include <GeomConvert_ApproxSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <leadscrew/base/number_text.hpp>

#include "opencascade.hpp"

namespace leadscrew::exchange {

namespace {

constexpr int most_segments = 256;

template <class Type>
bool is(const Handle(Standard_Transient) & value) {
  return value->IsKind(STANDARD_TYPE(Type));
}

bool is_exact(Handle(Geom_Curve) curve) {
  while (is<Geom_TrimmedCurve>(curve)) curve = Handle(Geom_TrimmedCurve)::DownCast(curve)->BasisCurve();
  return !is<Geom_OffsetCurve>(curve);
}

/// Does OpenCASCADE convert it without an approximation of its own?
bool is_exact(const Handle(Geom_Surface) & surface) {
  if (is<Geom_SweptSurface>(surface)) return is_exact(Handle(Geom_SweptSurface)::DownCast(surface)->BasisCurve());
  return is<Geom_BoundedSurface>(surface) || is<Geom_ElementarySurface>(surface);
}

const char* const how_to_approximate = "--approximate 0.001 takes a surface within that many mm of it";

std::variant<Refusal, Converted> approximated(const Handle(Geom_Surface) & part, double tolerance) {
  GeomConvert_ApproxSurface approximation(part, tolerance, GeomAbs_C2, GeomAbs_C2, surfaces::highest_degree,
                                          surfaces::highest_degree, most_segments, 1);
  if (!approximation.HasResult() || !(approximation.MaxError() <= tolerance)) {
    const std::string best = approximation.HasResult()
                                 ? ": " + base::rounded_text(approximation.MaxError()) + " mm are left"
                                 : std::string();
    return refused("face-inexact", "cannot be approximated within " + base::text(tolerance) + " mm" + best,
                   "a greater tolerance");
  }
  return Converted{approximation.Surface(), approximation.MaxError()};
}

bool is_clamped(const TColStd_Array1OfReal& knots, int degree) {
  return knots.First() == knots.Value(knots.Lower() + degree) && knots.Last() == knots.Value(knots.Upper() - degree);
}

/// Knots that begin and end before and behind all parameters are made those of the part between.
void clamp(Geom_BSplineSurface& surface) {
  if (is_clamped(surface.UKnotSequence(), surface.UDegree()) && is_clamped(surface.VKnotSequence(), surface.VDegree()))
    return;
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface.Bounds(u0, u1, v0, v1);
  surface.Segment(u0, u1, v0, v1);
}

}  // namespace

Handle(Geom_Surface) untrimmed(Handle(Geom_Surface) surface) {
  while (is<Geom_RectangularTrimmedSurface>(surface))
    surface = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface)->BasisSurface();
  return surface;
}

std::string type_of(const Handle(Geom_Surface) & surface) {
  if (is<Geom_Plane>(surface)) return "plane";
  if (is<Geom_CylindricalSurface>(surface)) return "cylinder";
  if (is<Geom_ConicalSurface>(surface)) return "cone";
  if (is<Geom_SphericalSurface>(surface)) return "sphere";
  if (is<Geom_ToroidalSurface>(surface)) return "torus";
  if (is<Geom_BSplineSurface>(surface)) return "B-spline";
  if (is<Geom_BezierSurface>(surface)) return "Bezier";
  if (is<Geom_SurfaceOfLinearExtrusion>(surface)) return "extrusion";
  if (is<Geom_SurfaceOfRevolution>(surface)) return "revolution";
  if (is<Geom_OffsetSurface>(surface)) return "offset";
  return "other";
}

std::variant<Refusal, Converted> converted(const Handle(Geom_Surface) & surface, const Rectangle& part,
                                           double tolerance) {
  Handle(Geom_Surface) kept = surface;
  if (!part.is_whole || !is<Geom_BoundedSurface>(surface))
    kept = new Geom_RectangularTrimmedSurface(surface, part.u0, part.u1, part.v0, part.v1);
  if (!is_exact(surface)) {
    if (tolerance > 0) return approximated(kept, tolerance);
    return refused("face-inexact",
                   "is the " + type_of(surface) + " surface of a curve or surface, which is no B-spline",
                   how_to_approximate);
  }
  Handle(Geom_BSplineSurface) result = GeomConvert::SurfaceToBSplineSurface(kept);
  if (result == surface) result = Handle(Geom_BSplineSurface)::DownCast(result->Copy());
  if (result->IsUPeriodic()) result->SetUNotPeriodic();
  if (result->IsVPeriodic()) result->SetVNotPeriodic();
  clamp(*result);
  const int degree = std::max(result->UDegree(), result->VDegree());
  if (degree <= surfaces::highest_degree) return Converted{result, std::nullopt};
  if (tolerance > 0) return approximated(result, tolerance);
  return refused("face-degree",
                 "has degree " + std::to_string(degree) + ", above " + std::to_string(surfaces::highest_degree),
                 how_to_approximate);
}

}  // namespace leadscrew::exchange
