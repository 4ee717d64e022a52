// What the edges of a face leave of its surface: a rectangle of its parameters, four straight sides of a plane, or something
// that no surface of a program can have.

#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Plane.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pnt2d.hxx>
#include <gp_Vec.hxx>
#include <leadscrew/base/number_text.hpp>
#include <vector>

#include "opencascade.hpp"

namespace leadscrew::exchange {

namespace {

constexpr double closeness = 1e-6;  // of parameters, by their range; of directions, rad
constexpr int samples = 32;         // pieces of an edge

using Side = std::vector<gp_Pnt2d>;  // an edge in parameters, in the direction of the outline

Refusal trimmed(std::string why) {
  return refused("face-trimmed", std::move(why),
                 "export its surface untrimmed, or keep to a part of it by the range of G6.5");
}

std::vector<TopoDS_Wire> wires_of(const TopoDS_Face& face) {
  std::vector<TopoDS_Wire> wires;
  for (TopExp_Explorer each(face, TopAbs_WIRE); each.More(); each.Next()) wires.push_back(TopoDS::Wire(each.Current()));
  return wires;
}

/// Empty where an edge has no curve on the surface.
std::vector<Side> sides_of(const TopoDS_Wire& wire, const TopoDS_Face& face) {
  std::vector<Side> sides;
  for (TopExp_Explorer each(wire, TopAbs_EDGE); each.More(); each.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(each.Current());
    if (edge.Orientation() != TopAbs_FORWARD && edge.Orientation() != TopAbs_REVERSED) continue;
    double from = 0, to = 0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, from, to);
    if (curve.IsNull()) return {};
    Side side;
    for (int i = 0; i <= samples; ++i) side.push_back(curve->Value(from + (to - from) * i / samples));
    if (edge.Orientation() == TopAbs_REVERSED) std::reverse(side.begin(), side.end());
    sides.push_back(std::move(side));
  }
  return sides;
}

/// Twice the area inside, in parameters, positive where they go round counterclockwise.
double doubled_area(const std::vector<Side>& sides) {
  double area = 0;
  for (const Side& side : sides) {
    for (std::size_t i = 1; i < side.size(); ++i) area += side[i - 1].X() * side[i].Y() - side[i].X() * side[i - 1].Y();
  }
  return area;
}

/// The parameters that all sides lie along, if they are the sides of a rectangle.
std::optional<Rectangle> rectangle_of(const std::vector<Side>& sides) {
  Rectangle box{sides[0][0].X(), sides[0][0].X(), sides[0][0].Y(), sides[0][0].Y()};
  for (const Side& side : sides) {
    for (const gp_Pnt2d& point : side) {
      box.u0 = std::min(box.u0, point.X());
      box.u1 = std::max(box.u1, point.X());
      box.v0 = std::min(box.v0, point.Y());
      box.v1 = std::max(box.v1, point.Y());
    }
  }
  const double width = box.u1 - box.u0, height = box.v1 - box.v0;
  const auto all_at = [&](const Side& side, double (*coordinate)(const gp_Pnt2d&), double value, double range) {
    return std::all_of(side.begin(), side.end(),
                       [&](const gp_Pnt2d& point) { return std::abs(coordinate(point) - value) <= closeness * range; });
  };
  const auto u = [](const gp_Pnt2d& point) { return point.X(); };
  const auto v = [](const gp_Pnt2d& point) { return point.Y(); };
  for (const Side& side : sides) {
    const bool is_along = all_at(side, u, box.u0, width) || all_at(side, u, box.u1, width) ||
                          all_at(side, v, box.v0, height) || all_at(side, v, box.v1, height);
    if (!is_along) return std::nullopt;
  }
  const double area = std::abs(doubled_area(sides)) / 2;
  if (!(area > 0) || std::abs(area - width * height) > 10 * closeness * width * height) return std::nullopt;
  return box;
}

/// Bounds that are the surface's own but for rounding become the surface's own.
Rectangle snapped(Rectangle box, const Handle(Geom_Surface) & surface) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  surface->Bounds(u0, u1, v0, v1);
  const double du = closeness * (box.u1 - box.u0), dv = closeness * (box.v1 - box.v0);
  if (surface->IsUPeriodic() && std::abs(box.u1 - box.u0 - surface->UPeriod()) <= du) {
    if (std::abs(box.u0 - u0) > du) u0 = box.u0, u1 = box.u0 + surface->UPeriod();
  }
  if (surface->IsVPeriodic() && std::abs(box.v1 - box.v0 - surface->VPeriod()) <= dv) {
    if (std::abs(box.v0 - v0) > dv) v0 = box.v0, v1 = box.v0 + surface->VPeriod();
  }
  int own = 0;
  const auto snap = [&own](double& value, double bound, double tolerance) {
    if (std::abs(value - bound) > tolerance) return;
    value = bound;
    ++own;
  };
  snap(box.u0, u0, du);
  snap(box.u1, u1, du);
  snap(box.v0, v0, dv);
  snap(box.v1, v1, dv);
  double first_u = 0, first_v = 0, last = 0;
  surface->Bounds(first_u, last, first_v, last);
  box.is_whole = own == 4 && u0 == first_u && v0 == first_v;
  return box;
}

/// The corners of a plane's outline: where straight edges meet that are not in line. Empty where an edge is bent.
std::vector<gp_Pnt> corners_of(const TopoDS_Wire& wire, const TopoDS_Face& face) {
  std::vector<gp_Pnt> points, corners;
  for (BRepTools_WireExplorer each(wire, face); each.More(); each.Next()) {
    double from = 0, to = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(each.Current(), from, to);
    if (curve.IsNull()) return {};
    const gp_Pnt a = curve->Value(from), b = curve->Value(to);
    for (int i = 1; i < samples; ++i) {
      const gp_Vec along(a, b), there(a, curve->Value(from + (to - from) * i / samples));
      if (along.Crossed(there).Magnitude() > closeness * along.SquareMagnitude()) return {};
    }
    points.push_back(BRep_Tool::Pnt(each.CurrentVertex()));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const gp_Vec before(points[(i + points.size() - 1) % points.size()], points[i]),
        behind(points[i], points[(i + 1) % points.size()]);
    const double turn = before.Crossed(behind).Magnitude();
    if (turn > closeness * before.Magnitude() * behind.Magnitude()) corners.push_back(points[i]);
  }
  return corners;
}

Outline plane_outline(const TopoDS_Wire& wire, const TopoDS_Face& face, const Handle(Geom_Plane) & plane) {
  std::vector<gp_Pnt> corners = corners_of(wire, face);
  if (corners.empty()) return trimmed("is trimmed: a plane face needs straight edges");
  if (corners.size() != 4) return trimmed("is trimmed: its outline has " + std::to_string(corners.size()) + " corners");
  const gp_Vec normal(plane->Position().XDirection().Crossed(plane->Position().YDirection()));
  std::array<double, 4> turns{};
  for (std::size_t i = 0; i < 4; ++i) {
    turns[i] = gp_Vec(corners[i], corners[(i + 1) % 4])
                   .Crossed(gp_Vec(corners[(i + 1) % 4], corners[(i + 2) % 4]))
                   .Dot(normal);
  }
  const bool is_left = std::all_of(turns.begin(), turns.end(), [](double turn) { return turn > 0; });
  const bool is_right = std::all_of(turns.begin(), turns.end(), [](double turn) { return turn < 0; });
  if (!is_left && !is_right) return trimmed("is trimmed: its outline has a reentrant corner");
  if (is_right) std::reverse(corners.begin() + 1, corners.end());
  return Corners{corners[0], corners[1], corners[2], corners[3]};
}

}  // namespace

Outline outline_of(const TopoDS_Face& given, const Handle(Geom_Surface) & surface) {
  const TopoDS_Face face = TopoDS::Face(given.Oriented(TopAbs_FORWARD));
  const std::vector<TopoDS_Wire> wires = wires_of(face);
  if (wires.empty()) {
    Rectangle box;
    surface->Bounds(box.u0, box.u1, box.v0, box.v1);
    for (const double bound : {box.u0, box.u1, box.v0, box.v1}) {
      if (Precision::IsInfinite(bound)) return trimmed("has no outline, and its surface no end");
    }
    box.is_whole = true;
    return box;
  }
  if (wires.size() > 1) {
    return trimmed("is trimmed: it has " + std::to_string(wires.size()) +
                   " outlines, where one that follows its parameters is needed");
  }
  const auto plane = Handle(Geom_Plane)::DownCast(surface);
  if (!plane.IsNull()) return plane_outline(wires[0], face, plane);
  const std::vector<Side> sides = sides_of(wires[0], face);
  if (sides.empty()) return trimmed("has an edge without a curve in its parameters");
  const auto rectangle = rectangle_of(sides);
  if (!rectangle) return trimmed("is trimmed: its outline does not follow the lines of its parameters");
  return snapped(*rectangle, surface);
}

}  // namespace leadscrew::exchange
