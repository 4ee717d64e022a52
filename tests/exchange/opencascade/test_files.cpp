// Files that OpenCASCADE writes, read back by the reading program: the same surfaces, the right side outside, reasons.

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <leadscrew/exchange/faces.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/frame.hpp>
#include <numbers>

#include "../../surfaces/patches.hpp"
#include "command.hpp"

namespace leadscrew::exchange {
namespace test_files {

using cli::testing::Folder;
using surfaces::Surface;
using surfaces::SurfaceForm;
using surfaces::Vector;

constexpr double pi = std::numbers::pi;

Handle(Geom_BSplineSurface) spline_of(const SurfaceForm& form) {
  const auto count = [&](std::size_t d) { return static_cast<int>(form.count[d]); };
  TColgp_Array2OfPnt poles(1, count(0), 1, count(1));
  TColStd_Array2OfReal weights(1, count(0), 1, count(1));
  for (int j = 0; j < count(1); ++j) {
    for (int i = 0; i < count(0); ++i) {
      const auto& point = form.point(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
      poles(i + 1, j + 1) = gp_Pnt(point.position[0], point.position[1], point.position[2]);
      weights(i + 1, j + 1) = point.weight;
    }
  }
  std::array<std::vector<double>, 2> values;
  std::array<std::vector<int>, 2> times;
  for (std::size_t d = 0; d < 2; ++d) {
    for (const double knot : form.knots[d]) {
      if (values[d].empty() || values[d].back() != knot) values[d].push_back(knot), times[d].push_back(0);
      ++times[d].back();
    }
  }
  const auto reals = [](std::vector<double>& v) { return TColStd_Array1OfReal(v[0], 1, static_cast<int>(v.size())); };
  const auto integers = [](std::vector<int>& v) {
    return TColStd_Array1OfInteger(v[0], 1, static_cast<int>(v.size()));
  };
  return new Geom_BSplineSurface(poles, weights, reals(values[0]), reals(values[1]), integers(times[0]),
                                 integers(times[1]), form.degree[0], form.degree[1]);
}

TopoDS_Face face_of(const Handle(Geom_Surface) & surface) {
  return BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
}

TopoDS_Face reversed(TopoDS_Face face) {
  face.Reverse();
  return face;
}

/// Written in this unit.
std::string write_step(const Folder& folder, const TopoDS_Shape& shape, const char* unit = "MM") {
  STEPControl_Controller::Init();
  Message::DefaultMessenger()->ChangePrinters().Clear();
  Interface_Static::SetCVal("write.step.unit", unit);
  STEPControl_Writer writer;
  EXPECT_EQ(writer.Transfer(shape, STEPControl_AsIs), IFSelect_RetDone);
  const std::string file = folder.path() / "part.step";
  EXPECT_EQ(writer.Write(file.c_str()), IFSelect_RetDone);
  return file;
}

std::string write_iges(const Folder& folder, const TopoDS_Shape& shape, const char* unit = "MM") {
  IGESControl_Controller::Init();
  Message::DefaultMessenger()->ChangePrinters().Clear();
  IGESControl_Writer writer(unit, 0);
  EXPECT_TRUE(writer.AddShape(shape));
  writer.ComputeModel();
  const std::string file = folder.path() / "part.iges";
  EXPECT_TRUE(writer.Write(file.c_str()));
  return file;
}

std::vector<Face> faces_in(const std::string& file, std::optional<double> tolerance = {}) {
  const auto faces = read_faces(LEADSCREW_EXCHANGE_PROGRAM, file, tolerance);
  EXPECT_TRUE(faces) << faces.error().message;
  return faces ? faces->faces : std::vector<Face>();
}

void expect_near(const SurfaceForm& found, const SurfaceForm& expected, double tolerance) {
  EXPECT_EQ(found.degree, expected.degree);
  EXPECT_EQ(found.count, expected.count);
  ASSERT_EQ(found.net.size(), expected.net.size());
  for (std::size_t d = 0; d < 2; ++d) {
    ASSERT_EQ(found.knots[d].size(), expected.knots[d].size());
    for (std::size_t k = 0; k < found.knots[d].size(); ++k)
      EXPECT_NEAR(found.knots[d][k], expected.knots[d][k], tolerance);
  }
  for (std::size_t i = 0; i < found.net.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(found.net[i].position[k], expected.net[i].position[k], tolerance) << "point " << i;
    EXPECT_NEAR(found.net[i].weight, expected.net[i].weight, tolerance) << "point " << i;
  }
}

/// With knots and a weight of its own.
SurfaceForm uneven() {
  SurfaceForm form{
      {3, 2}, {std::vector<double>{0, 0, 0, 0, 0.25, 1, 1, 1, 1}, {-1, -1, -1, 2, 2, 5, 5, 5}}, {5, 5}, {}};
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i < 5; ++i) form.net.push_back({{10.0 * i, 7.0 * j, std::sin(i + 2.0 * j)}, 1 + 0.1 * (i * j % 3)});
  }
  return form;
}

TEST(StepFile, GivesPatchABack) {
  const Folder folder;
  for (const SurfaceForm& form : {surfaces::test::patch_a(), uneven()}) {
    const auto faces = faces_in(write_step(folder, face_of(spline_of(form))));
    ASSERT_EQ(faces.size(), 1u);
    ASSERT_TRUE(faces[0].form) << faces[0].refusal->why;
    EXPECT_FALSE(faces[0].refusal);
    EXPECT_FALSE(faces[0].is_reversed);
    expect_near(*faces[0].form, form, 1e-12);
  }
  EXPECT_NEAR(*faces_in(write_step(folder, face_of(spline_of(surfaces::test::patch_a()))))[0].area, 3673.206807, 1e-3);
}

TEST(IgesFile, GivesPatchABack) {
  const Folder folder;
  for (const SurfaceForm& form : {surfaces::test::patch_a(), uneven()}) {
    const auto faces = faces_in(write_iges(folder, face_of(spline_of(form))));
    ASSERT_EQ(faces.size(), 1u);
    ASSERT_TRUE(faces[0].form) << faces[0].refusal->why;
    const bool has_short_numbers = form == surfaces::test::patch_a();
    expect_near(*faces[0].form, form, has_short_numbers ? 1e-12 : 1e-8);  // it writes nine digits
  }
}

TEST(StepFile, IsInMillimetresWhateverItsUnit) {
  const Folder folder;
  for (const auto& [unit, name] : {std::pair("INCH", "inch"), {"M", "m"}, {"CM", "cm"}, {"MM", "mm"}}) {
    const std::string file = write_step(folder, face_of(spline_of(surfaces::test::patch_a())), unit);
    const auto faces = read_faces(LEADSCREW_EXCHANGE_PROGRAM, file, {});
    ASSERT_TRUE(faces);
    EXPECT_EQ(faces->length_unit, name);
    ASSERT_TRUE(faces->faces.at(0).form);
    expect_near(*faces->faces[0].form, surfaces::test::patch_a(), 1e-10);  // numbers of a file have 14 digits
  }
  const auto faces = read_faces(LEADSCREW_EXCHANGE_PROGRAM, write_iges(folder, face_of(spline_of(uneven())), "IN"), {});
  ASSERT_TRUE(faces);
  EXPECT_EQ(faces->length_unit, "inch");
  expect_near(*faces->faces.at(0).form, uneven(), 1e-7);
}

TEST(StepFile, OfAReversedFaceHasUAndVExchanged) {
  const Folder folder;
  const auto faces = faces_in(write_step(folder, reversed(face_of(spline_of(uneven())))));
  ASSERT_EQ(faces.size(), 1u);
  ASSERT_TRUE(faces[0].form);
  EXPECT_TRUE(faces[0].is_reversed);
  const Surface surface(*faces[0].form), before(uneven());
  for (const double u : {0.1, 0.6}) {
    const auto jet = surface.jet(3 * u, u), other = before.jet(u, 3 * u);
    const auto n = surfaces::frame_of(jet, 1)->n, m = surfaces::frame_of(other, 1)->n;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(jet.s[k], other.s[k], 1e-11);
      EXPECT_NEAR(n[k], -m[k], 1e-11);
    }
  }
}

/// Every face that can be machined: `distance` is 0 on it and grows outwards.
void expect_outside(const std::vector<Face>& faces, const std::function<double(const Vector&)>& distance) {
  for (const Face& face : faces) {
    if (!face.form) continue;
    const Surface surface(*face.form);
    const auto u = surface.range(surfaces::Direction::u), v = surface.range(surfaces::Direction::v);
    for (double i = 0.05; i < 1; i += 0.1) {
      for (double j = 0.05; j < 1; j += 0.1) {
        const auto jet = surface.jet(u.from + i * (u.to - u.from), v.from + j * (v.to - v.from));
        const auto frame = surfaces::frame_of(jet, 1);
        ASSERT_TRUE(frame);
        EXPECT_NEAR(distance(jet.s), 0, 1e-10) << face.type;
        Vector out = jet.s;
        for (std::size_t k = 0; k < 3; ++k) out[k] += 1e-3 * frame->n[k];
        EXPECT_NEAR(distance(out), 1e-3, 1e-7) << face.type;
      }
    }
  }
}

std::vector<std::string> refusals(const std::vector<Face>& faces) {
  std::vector<std::string> codes;
  for (const Face& face : faces) codes.push_back(face.refusal ? face.refusal->code : "");
  return codes;
}
using Codes = std::vector<std::string>;

std::vector<std::string> types(const std::vector<Face>& faces) {
  std::vector<std::string> types;
  for (const Face& face : faces) types.push_back(face.type);
  return types;
}

TEST(Solids, HaveTheirSurfacesWithTheNormalOutside) {
  const Folder folder;
  const auto box = faces_in(write_step(folder, BRepPrimAPI_MakeBox(30, 20, 10).Shape()));
  EXPECT_EQ(refusals(box), Codes(6));
  double area = 0;
  for (const Face& face : box) area += *face.area;
  EXPECT_NEAR(area, 2200, 1e-9);
  expect_outside(box, [](const Vector& p) {
    return std::max({std::abs(p[0] - 15) - 15, std::abs(p[1] - 10) - 10, std::abs(p[2] - 5) - 5});
  });

  const auto cylinder = faces_in(write_step(folder, BRepPrimAPI_MakeCylinder(12, 30).Shape()));
  ASSERT_EQ(types(cylinder), (Codes{"cylinder", "plane", "plane"}));
  EXPECT_EQ(refusals(cylinder), (Codes{"", "face-trimmed", "face-trimmed"}));
  EXPECT_NEAR(*cylinder[0].area, 2 * pi * 12 * 30, 1e-6);
  expect_outside(cylinder, [](const Vector& p) { return std::hypot(p[0], p[1]) - 12; });

  const auto cone = faces_in(write_step(folder, BRepPrimAPI_MakeCone(20, 10, 30).Shape()));
  ASSERT_EQ(types(cone), (Codes{"cone", "plane", "plane"}));
  EXPECT_EQ(refusals(cone), (Codes{"", "face-trimmed", "face-trimmed"}));
  expect_outside(cone, [](const Vector& p) { return (std::hypot(p[0], p[1]) - 20 + p[2] / 3) * 3 / std::sqrt(10.0); });

  const auto torus = faces_in(write_step(folder, BRepPrimAPI_MakeTorus(30, 8).Shape()));
  ASSERT_EQ(types(torus), Codes{"torus"});
  EXPECT_EQ(refusals(torus), Codes{""});
  EXPECT_NEAR(*torus[0].area, 4 * pi * pi * 30 * 8, 1e-3);
  expect_outside(torus, [](const Vector& p) { return std::hypot(std::hypot(p[0], p[1]) - 30, p[2]) - 8; });
}

TEST(Solids, AreOfTheSameFacesInIges) {
  const Folder folder;
  const auto cylinder = faces_in(write_iges(folder, BRepPrimAPI_MakeCylinder(12, 30).Shape()));
  ASSERT_EQ(cylinder.size(), 3u);
  EXPECT_TRUE(cylinder[0].form);
  expect_outside({cylinder[0]}, [](const Vector& p) { return std::hypot(p[0], p[1]) - 12; });
}

TEST(Spheres, AreMachinedBetweenTheirPoles) {
  const Folder folder;
  const auto whole = faces_in(write_step(folder, BRepPrimAPI_MakeSphere(15).Shape()));
  EXPECT_EQ(refusals(whole), Codes{"face-normal"});
  EXPECT_NE(whole.at(0).refusal->why.find("no normal"), std::string::npos);
  const auto zone = faces_in(write_step(folder, BRepPrimAPI_MakeSphere(15, -pi / 4, pi / 3, pi).Shape()));
  ASSERT_FALSE(zone.empty());
  EXPECT_EQ(zone[0].type, "sphere");
  EXPECT_EQ(refusals(zone)[0], "");
  expect_outside({zone[0]}, [](const Vector& p) { return numeric::norm(p) - 15; });
}

TopoDS_Face polygon(const std::vector<std::pair<double, double>>& corners) {
  BRepBuilderAPI_MakePolygon outline;
  for (const auto& [x, y] : corners) outline.Add(gp_Pnt(x, y, 3));
  outline.Close();
  return BRepBuilderAPI_MakeFace(outline.Wire(), true).Face();
}

TEST(Planes, AreTakenWithFourCornersInAnyPosition) {
  const Folder folder;
  const auto skewed = faces_in(write_step(folder, polygon({{0, 0}, {20, 5}, {18, 25}, {-3, 12}})));
  ASSERT_EQ(refusals(skewed), Codes{""});
  const Surface surface(*skewed[0].form);
  EXPECT_EQ(skewed[0].form->degree, (std::array<int, 2>{1, 1}));
  expect_outside(skewed, [](const Vector& p) { return p[2] - 3; });
  const auto frame = *surfaces::frame_of(surface.jet(0.5, 0.5), 1);  // the area of a bilinear patch, exactly
  EXPECT_NEAR(std::sqrt(frame.E * frame.G - frame.F * frame.F), *skewed[0].area, 1e-9);
  const auto split = faces_in(write_step(folder, polygon({{0, 0}, {7, 0}, {20, 0}, {20, 10}, {0, 10}})));
  EXPECT_EQ(refusals(split), Codes{""});
  EXPECT_EQ(refusals(faces_in(write_step(folder, polygon({{0, 0}, {20, 0}, {5, 10}})))), Codes{"face-trimmed"});
  EXPECT_EQ(refusals(faces_in(write_step(folder, polygon({{0, 0}, {20, 0}, {5, 5}, {0, 20}})))), Codes{"face-trimmed"});
  const auto clockwise = faces_in(write_step(folder, reversed(polygon({{0, 0}, {20, 0}, {20, 10}, {0, 10}}))));
  expect_outside(clockwise, [](const Vector& p) { return 3 - p[2]; });
}

TEST(TrimmedFaces, AreRefusedButAlongTheirParameters) {
  const Folder folder;
  const auto spline = spline_of(uneven());
  const auto part = faces_in(write_step(folder, BRepBuilderAPI_MakeFace(spline, 0.1, 0.7, 0, 3, 1e-7).Face()));
  ASSERT_EQ(refusals(part), Codes{""});
  const Surface whole(uneven()), kept(*part[0].form);
  EXPECT_NEAR(kept.range(surfaces::Direction::u).from, 0.1, 1e-12);
  EXPECT_NEAR(kept.range(surfaces::Direction::u).to, 0.7, 1e-12);
  for (const double u : {0.1, 0.25, 0.4, 0.7}) {
    const Vector a = whole.at(u, 4 * u), b = kept.at(u, 4 * u);
    EXPECT_LT(numeric::distance(a, b), 1e-10);
  }
  const gp_Circ hole(gp_Ax2(gp_Pnt(10, 5, 3), gp::DZ()), 2);
  BRepBuilderAPI_MakeFace holed(polygon({{0, 0}, {20, 0}, {20, 10}, {0, 10}}));
  TopoDS_Wire round = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(hole).Edge()).Wire();
  round.Reverse();
  holed.Add(round);
  const auto faces = faces_in(write_step(folder, holed.Face()));
  ASSERT_EQ(refusals(faces), Codes{"face-trimmed"});
  EXPECT_NE(faces[0].refusal->why.find("2 outlines"), std::string::npos);
  EXPECT_FALSE(faces[0].form);
}

Handle(Geom_BezierSurface) of_degree_seven() {
  TColgp_Array2OfPnt poles(1, 8, 1, 3);
  for (int i = 1; i <= 8; ++i) {
    for (int j = 1; j <= 3; ++j) poles(i, j) = gp_Pnt(10.0 * i, 10.0 * j, std::sin(0.9 * i) + j);
  }
  return new Geom_BezierSurface(poles);
}

TEST(HighDegrees, AreApproximatedWhereThatIsAskedFor) {
  const Folder folder;
  const auto bezier = of_degree_seven();
  const std::string file = write_step(folder, face_of(bezier));
  ASSERT_EQ(refusals(faces_in(file)), Codes{"face-degree"});
  const auto taken = faces_in(file, 1e-4);
  ASSERT_EQ(refusals(taken), Codes{""});
  ASSERT_TRUE(taken[0].deviation);
  EXPECT_LE(*taken[0].deviation, 1e-4);
  const Surface surface(*taken[0].form);
  for (double u = 0; u <= 1; u += 0.05) {
    const gp_Pnt p = bezier->Value(u, 1 - u);
    EXPECT_LT(numeric::distance(surface.at(u, 1 - u), Vector{p.X(), p.Y(), p.Z()}), 2e-4);
  }
}

TEST(OffsetSurfaces, AreApproximatedWhereThatIsAskedFor) {
  const Folder folder;
  const Handle(Geom_Surface) offset = new Geom_OffsetSurface(spline_of(surfaces::test::patch_a()), 2);
  const std::string file = write_step(folder, face_of(offset));
  ASSERT_EQ(refusals(faces_in(file)), Codes{"face-inexact"});
  const auto taken = faces_in(file, 1e-3);
  ASSERT_EQ(refusals(taken), Codes{""});
  const Surface surface(*taken[0].form), below(surfaces::test::patch_a());
  for (double u = 0; u <= 1; u += 0.05) {
    const auto jet = below.jet(u, 1 - u);
    Vector p = jet.s;
    for (std::size_t k = 0; k < 3; ++k) p[k] += 2 * surfaces::frame_of(jet, 1)->n[k];
    EXPECT_LT(numeric::distance(surface.at(u, 1 - u), p), 2e-3);
  }
  EXPECT_EQ(refusals(faces_in(file, 1e-6 / 1e6)), Codes{"face-inexact"});
}

TEST(LargeNets, AreRefused) {
  const Folder folder;
  const std::size_t side = 257;
  SurfaceForm form{{1, 1}, {surfaces::uniform_knots(side, 1), surfaces::uniform_knots(side, 1)}, {side, side}, {}};
  for (std::size_t k = 0; k < side * side; ++k) {
    const auto x = static_cast<double>(k % side), y = static_cast<double>(k / side);
    form.net.push_back({{x, y, std::sin(x + y)}, 1});
  }
  const auto faces = faces_in(write_step(folder, face_of(spline_of(form))));
  EXPECT_EQ(refusals(faces), Codes{"face-size"});
}

TEST(BrokenFiles, AreRefusedWithoutHarm) {
  const Folder folder;
  const std::string file = write_step(folder, BRepPrimAPI_MakeCylinder(12, 30).Shape());
  const std::string text = folder.read("part.step");
  int read = 0;
  for (std::size_t part = 1; part < 20; ++part) {
    folder.write("part.step", text.substr(0, text.size() * part / 20));
    const auto faces = read_faces(LEADSCREW_EXCHANGE_PROGRAM, file, {});
    read += faces ? 1 : 0;
    const auto code = faces ? "" : faces.error().code;
    EXPECT_TRUE(code.empty() || code == "exchange-read" || code == "exchange-faces") << part << ": " << code;
  }
  EXPECT_LT(read, 19);
  folder.write("part.step", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n");
  const auto none = read_faces(LEADSCREW_EXCHANGE_PROGRAM, file, {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, "exchange-read");
}

TEST(Edges, AreNoFaces) {
  const Folder folder;
  const auto none =
      read_faces(LEADSCREW_EXCHANGE_PROGRAM,
                 write_step(folder, BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 2, 3)).Edge()), {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, "exchange-faces");
}

}  // namespace test_files
}  // namespace leadscrew::exchange
