// Each face of a shape: its surface, its size, or why it cannot be had.

#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <cmath>

#include "opencascade.hpp"

namespace leadscrew::exchange {

namespace {

using surfaces::NetPoint;
using surfaces::SurfaceForm;

surfaces::Vector vector_of(const gp_Pnt& point) {
  const auto without_sign = [](double x) { return x == 0 ? 0.0 : x; };  // of zero
  return {without_sign(point.X()), without_sign(point.Y()), without_sign(point.Z())};
}

SurfaceForm form_of(const Geom_BSplineSurface& surface) {
  SurfaceForm form;
  form.degree = {surface.UDegree(), surface.VDegree()};
  form.count = {static_cast<std::size_t>(surface.NbUPoles()), static_cast<std::size_t>(surface.NbVPoles())};
  for (const double knot : surface.UKnotSequence()) form.knots[0].push_back(knot);
  for (const double knot : surface.VKnotSequence()) form.knots[1].push_back(knot);
  for (int j = 1; j <= surface.NbVPoles(); ++j) {
    for (int i = 1; i <= surface.NbUPoles(); ++i)
      form.net.push_back({vector_of(surface.Pole(i, j)), surface.Weight(i, j)});
  }
  return form;
}

SurfaceForm form_of(const Corners& corners) {
  SurfaceForm form{{1, 1}, {surfaces::uniform_knots(2, 1), surfaces::uniform_knots(2, 1)}, {2, 2}, {}};
  for (const std::size_t corner : {0, 1, 3, 2}) form.net.push_back({vector_of(corners[corner]), 1});
  return form;
}

/// With u and v exchanged, so that the normal is on the other side.
SurfaceForm exchanged(const SurfaceForm& form) {
  SurfaceForm other{
      {form.degree[1], form.degree[0]}, {form.knots[1], form.knots[0]}, {form.count[1], form.count[0]}, {}};
  for (std::size_t j = 0; j < form.count[0]; ++j) {
    for (std::size_t i = 0; i < form.count[1]; ++i) other.net.push_back(form.point(j, i));
  }
  return other;
}

void take_size(const TopoDS_Face& given, Face& face) {
  Bnd_Box box;
  BRepBndLib::Add(given, box, false);
  box.SetGap(0);
  if (box.IsVoid() || box.IsOpen()) return;
  box.Get(face.low[0], face.low[1], face.low[2], face.high[0], face.high[1], face.high[2]);
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(given, properties);
  face.area = std::abs(properties.Mass());
}

void take_form(const TopoDS_Face& given, double tolerance, Face& face) {
  const Handle(Geom_Surface) surface = untrimmed(BRep_Tool::Surface(given));
  face.type = type_of(surface);
  const Outline outline = outline_of(given, surface);
  if (const auto* corners = std::get_if<Corners>(&outline)) face.form = form_of(*corners);
  if (const auto* refusal = std::get_if<Refusal>(&outline)) face.refusal = *refusal;
  if (const auto* rectangle = std::get_if<Rectangle>(&outline)) {
    const auto result = converted(surface, *rectangle, tolerance);
    if (const auto* refusal = std::get_if<Refusal>(&result)) face.refusal = *refusal;
    if (const auto* done = std::get_if<Converted>(&result)) {
      const std::size_t points =
          static_cast<std::size_t>(done->surface->NbUPoles()) * static_cast<std::size_t>(done->surface->NbVPoles());
      face.deviation = done->deviation;
      if (points > surfaces::most_control_points) {
        face.refusal = refused("face-size",
                               "has " + std::to_string(points) + " control points, more than " +
                                   std::to_string(surfaces::most_control_points),
                               "split it");
      } else {
        face.form = form_of(*done->surface);
      }
    }
  }
  if (face.form && face.is_reversed) face.form = exchanged(*face.form);
}

Face face_of(const TopoDS_Face& given, std::size_t number, double tolerance) {
  Face face;
  face.number = number;
  face.type = "other";
  face.is_reversed = given.Orientation() == TopAbs_REVERSED;
  const auto fails = [&face](const std::string& why) {
    face.form.reset();
    face.refusal =
        refused("face-net", "cannot be converted by OpenCASCADE: " + why, "repair the face in the CAD system");
  };
  try {
    take_form(given, tolerance, face);
    take_size(given, face);
  } catch (const Standard_Failure& failure) {
    fails(failure.GetMessageString());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& failure) {
    fails(failure.what());
  }
  return face;
}

}  // namespace

void for_each_face(const TopoDS_Shape& shape, double tolerance, const std::function<void(const Face&)>& take) {
  TopTools_IndexedMapOfShape faces;
  if (!shape.IsNull()) TopExp::MapShapes(shape, TopAbs_FACE, faces);
  if (faces.IsEmpty())
    throw Unreadable("exchange-faces", "has no face", "export solids or surfaces, not curves or meshes");
  for (int i = 1; i <= faces.Extent(); ++i)
    take(face_of(TopoDS::Face(faces(i)), static_cast<std::size_t>(i), tolerance));
}

}  // namespace leadscrew::exchange
