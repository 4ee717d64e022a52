#pragma once
// What the sources of the reading program share. Exceptions of OpenCASCADE end in main.cpp at the latest.

#include <Geom_BSplineSurface.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <functional>
#include <gp_Pnt.hxx>
#include <leadscrew/exchange/faces.hpp>
#include <stdexcept>
#include <string>
#include <variant>

namespace leadscrew::exchange {

inline Refusal refused(const char* code, std::string why, std::string hint) {
  return {code, std::move(why), std::move(hint)};
}

/// A file that cannot be read as a whole.
struct Unreadable : std::runtime_error {
  Unreadable(std::string problem_code, const std::string& message, std::string what_helps)
      : std::runtime_error(message), code(std::move(problem_code)), hint(std::move(what_helps)) {}
  std::string code, hint;
};

struct Part {
  TopoDS_Shape shape;  ///< mm
  std::string unit;    ///< of the file
};
/// format: "STEP" or "IGES". Throws Unreadable.
Part part_of(const std::string& format, const std::string& file);

/// A rectangle of the parameters of a surface.
struct Rectangle {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  bool is_whole = false;  ///< all parameters that the surface has
};
/// Corners of a plane face with four straight sides, in the order (0, 0), (1, 0), (1, 1), (0, 1) for which Su × Sv is along
/// the plane's normal.
using Corners = std::array<gp_Pnt, 4>;
using Outline = std::variant<Refusal, Rectangle, Corners>;
/// What the edges of a face leave of its surface.
Outline outline_of(const TopoDS_Face& face, const Handle(Geom_Surface) & surface);

/// The part of a surface as a B-spline surface of degrees up to 5; clamped, not periodic.
struct Converted {
  Handle(Geom_BSplineSurface) surface;
  std::optional<double> deviation;  ///< mm; empty: exact
};
/// tolerance: mm; 0: nothing is approximated.
std::variant<Refusal, Converted> converted(const Handle(Geom_Surface) & surface, const Rectangle& part,
                                           double tolerance);

/// "plane", "B-spline", …
std::string type_of(const Handle(Geom_Surface) & surface);
/// Without the limits of parameters that lie around it.
Handle(Geom_Surface) untrimmed(Handle(Geom_Surface) surface);

/// Calls with each face of the shape in turn.
void for_each_face(const TopoDS_Shape& shape, double tolerance, const std::function<void(const Face&)>& take);

}  // namespace leadscrew::exchange
