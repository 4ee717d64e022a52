// G6.4: surfaces as programs define them, and what is wrong with some.

#include <leadscrew/surfaces/surface_text.hpp>
#include <random>

#include "surface_programs.hpp"

namespace leadscrew::gcode {
namespace test_surface_blocks {

using surfaces::SurfaceForm;

/// Of the only surface that is machined.
SurfaceForm form_of(const std::string& definition) {
  const auto all = read_surfaces(definition + "G0 Z40\nG6.5 D1 T1 Q5 Z30 F600\nM2\n");
  for (const OnSurface& each : all) {
    if (each.machined.surface) return each.machined.surface->machining.surface->form();
  }
  ADD_FAILURE() << "nothing is machined";
  return {};
}

std::string problems(const std::string& text) {
  return read(text + "M2\n", with_shapes()).problems();
}

TEST(SurfaceBlocks, AreANetWithUniformKnots) {
  const SurfaceForm form = form_of(patch_a());
  EXPECT_EQ(form.degree, (std::array<int, 2>{3, 3}));
  EXPECT_EQ(form.count, (std::array<std::size_t, 2>{4, 4}));
  EXPECT_EQ(form.knots[0], (std::vector<double>{0, 0, 0, 0, 1, 1, 1, 1}));
  ASSERT_EQ(form.net.size(), 16u);
  EXPECT_EQ(form.point(1, 0), (surfaces::NetPoint{{20, 0, 6}, 1}));
  EXPECT_EQ(form.point(3, 2), (surfaces::NetPoint{{60, 40, 6}, 1}));
}

TEST(SurfaceBlocks, TakeWeightsKnotsAndRemarks) {
  const SurfaceForm form = form_of(
      "#1=20\nG6.4 D1 P2 Q3 I3 J3\nX0 Y0 Z0 K0 L0\n(a remark)\nX10 K0 L0\nX#1 R2.5 K5 L0\n\n#1=7\n"
      "X0 Y10 K10 L1\nN7 X10 K10 L1\nX20 L1\nX0 Y20\nX10\nX20\n");
  EXPECT_EQ(form.knots[0], (std::vector<double>{0, 0, 5, 10, 10}));
  EXPECT_EQ(form.knots[1], (std::vector<double>{0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(form.point(2, 0), (surfaces::NetPoint{{20, 0, 0}, 2.5}));
  EXPECT_EQ(form.point(1, 1), (surfaces::NetPoint{{10, 10, 0}, 1}));
}

/// Whatever surfaces::definition_text() writes is read back to the last bit.
TEST(SurfaceBlocks, AreReadAsTheyAreWritten) {
  std::mt19937 random(24);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 40; ++round) {
    SurfaceForm form{{1 + round % 5, 1 + round / 5 % 5}, {}, {}, {}};
    for (std::size_t d = 0; d < 2; ++d) {
      form.count[d] = static_cast<std::size_t>(form.degree[d]) + 1 + static_cast<std::size_t>(round % 3);
      form.knots[d] = surfaces::uniform_knots(form.count[d], form.degree[d]);
      if (round % 2 == 0) continue;  // even ones are not written
      for (double& knot : form.knots[d]) knot = (knot - 0.1) * (1 + knot / 3) * 1e-3;
    }
    for (std::size_t i = 0; i < form.count[0] * form.count[1]; ++i) {
      const auto u = static_cast<double>(i % form.count[0]), v = static_cast<double>(i / form.count[0]);
      form.net.push_back({{10 * u + unit(random), 10 * v + unit(random), 1e-9 * unit(random)}, 0.5 + unit(random)});
    }
    ASSERT_FALSE(surfaces::fault_of(form));
    EXPECT_EQ(form_of(surfaces::definition_text(form, 1)), form) << surfaces::definition_text(form, 1);
  }
}

TEST(SurfaceBlocks, AreCoordinatesUnderG91Too) {
  EXPECT_EQ(form_of("G0 X3 Y4\nG91\n" + flat_patch + "G90\n").net[3].position, (surfaces::Vector{20, 10, 0}));
}

TEST(SurfaceBlocks, AreInInchesUnderG20) {
  EXPECT_EQ(form_of("G20\nG6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0\nX2\nX0 Y1\nX2\nG21\n").net[3].position,
            (surfaces::Vector{50.8, 25.4, 0}));
}

TEST(SurfaceBlocks, DefineANumberAgain) {
  EXPECT_EQ(form_of(patch_a() + flat_patch).net.size(), 4u);
}

TEST(SurfaceBlocks, AreOfLeadscrewAlone) {
  for (const Dialect dialect : {Dialect::linuxcnc, Dialect::fanuc, Dialect::haas, Dialect::mach3}) {
    for (const char* const code : {"G6.4 D1 P2 Q2 I2 J2\n", "G6.5 D1 H1\n", "G6.6 P1\n"}) {
      const Reading reading = read(std::string(code) + "M2\n", in_dialect(dialect));
      ASSERT_GE(reading.diagnostics.size(), 1u);
      EXPECT_EQ(reading.diagnostics[0].code, "unknown-code");
      EXPECT_NE(reading.diagnostics[0].hint.find("leadscrew"), std::string::npos) << reading.diagnostics[0].hint;
    }
  }
}

TEST(SurfaceBlocks, ReportWhatIsNoSurface) {
  const struct {
    const char* text;
    const char* problems;
  } rows[] = {
      {"G6.4 D0 P2 Q2 I2 J2\nX0 Y0 Z0\n", "1:6 surface-counts; "},
      {"G6.4 D1 P1 Q2 I2 J2\nX0 Y0 Z0\n", "1:9 surface-counts; "},
      {"G6.4 D1 P2 Q7 I2 J2\nX0 Y0 Z0\n", "1:12 surface-counts; "},
      {"G6.4 D1 P4 Q2 I3 J2\nX0 Y0 Z0\n", "1:15 surface-counts; "},
      {"G6.4 D1 P2 Q2 I2 J2.5\n", "1:18 surface-counts; "},
      {"G6.4 D1 P2 Q2 I300 J300\n", "1:15 surface-counts; "},
      {"G6.4 D1 P2 Q2 I2\n", "1:1 missing-word; "},
      {"G6.4 D1 P2 Q2 I2 J2 X0\n", "1:21 unused-word; "},
      {"G6.4 D1 P2 Q2 I2 J2 K0\n", "1:21 unused-word; "},
      {"G1 G6.4 D1 P2 Q2 I2 J2\n", "1:1 modal-conflict; "},
      {"G6.4 D1 P2 Q2 I2 J2\nX0 Z0\nX20\nX0 Y10\nX20\n", "2:1 missing-word; "},
      {"G6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0\nX20 R0\nX0 Y10\nX20\n", "3:5 surface-weight; "},
      {"G6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0\nX20 R-1\nX0 Y10\nX20\n", "3:5 surface-weight; "},
      // Knots: out of order, not clamped, too often, too few, too many, none between.
      {"G6.4 D1 P2 Q2 I3 J2\nX0 Y0 Z0 K0\nX10 K0\nX20 K-1\nX0 Y10 K1\nX10 K1\nX20\n", "4:5 surface-knots; "},
      {"G6.4 D1 P2 Q2 I3 J2\nX0 Y0 Z0 K0\nX10 K0.5\nX20 K1\nX0 Y10 K1\nX10 K1\nX20\n", "3:5 surface-knots; "},
      {"G6.4 D1 P2 Q2 I3 J2\nX0 Y0 Z0 K0\nX10 K0\nX20 K0\nX0 Y10 K1\nX10 K1\nX20\n", "4:5 surface-knots; "},
      {"G6.4 D1 P2 Q2 I3 J2\nX0 Y0 Z0 K0\nX10 K0\nX20 K1\nX0 Y10 K1\nX10 K1\nX20\n", "5:8 surface-knots; "},
      {"G6.4 D1 P2 Q2 I3 J2\nX0 Y0 Z0 K0\nX10 K0\nX20 K1\nX0 Y10 K2\nX10 K3\nX20\n", "6:5 surface-knots; "},
      {"G6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0 K1\nX20 K1\nX0 Y10 K1\nX20 K1\n", "4:8 surface-knots; "},
      {"G6.4 D1 P2 Q2 I3 J2\nX0 Y0 Z0 K0\nX10 K0\nX20 K1\nX0 Y10\nX10 K1\nX20\n", "5:1 surface-knots; "},
      {"G6.4 D1 P2 Q2 I3 J2\nX0 Y0 Z0\nX10 L0\nX20\nX0 Y10\nX10\nX20\n", "3:5 surface-knots; "},
      {"G6.4 D1 P2 Q2 I3 J2\nX0 Y0 Z0 L0\nX10 L0\nX20 L1\nX0 Y10 L1\nX10 L1\nX20\n", "6:5 surface-knots; "},
      // Rows that coincide, of points along u and along v; a corner that is a point.
      {"G6.4 D1 P2 Q2 I2 J3\nX0 Y0 Z0\nX20\nX0 Y10\nX20\nX0\nX20\n", "6:1 surface-rows; "},
      {"G6.4 D1 P2 Q2 I3 J2\nX0 Y0 Z0\nX10\nX10\nX0 Y10\nX10\nX10\n", "4:1 surface-rows; "},
      {"G6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0\nX20\nX0\nX20 Y10\n", "1:1 surface-normal; "},
  };
  for (const auto& row : rows) EXPECT_EQ(problems(row.text), row.problems) << row.text;
}

TEST(SurfaceBlocks, HoldNothingButPoints) {
  const std::string begin = "G6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0\n";
  EXPECT_EQ(problems(begin), "3:1 unfinished-surface; ");
  for (const char* const other : {"G1 X5 F600\n", "X5 F600\n", "M8\n", "X5 A3\n", "S100\n", "G6.4 D2 P2 Q2 I2 J2\n"})
    EXPECT_EQ(read(begin + other, with_shapes()).problems().substr(0, 24), "3:1 unfinished-surface; ") << other;
  const Reading reading = read(begin, with_shapes());
  EXPECT_EQ(reading.problems().substr(0, 24), "1:1 unfinished-surface; ");
}

TEST(SurfaceBlocks, ThatAreSpoiledAreToldOnce) {
  EXPECT_EQ(problems("G6.4 D1 P2 Q2 I2 J2\nX0 Z0\nX20 R-1 K4\nX0 Y10\nX20\nG6.5 D1 T1 Q5 F600\n"),
            "2:1 missing-word; ");
  EXPECT_EQ(problems("G6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0\nX[\nX0 Y10\nX20\nG6.5 D1 T1 Q5 F600\n").substr(0, 4), "3:3 ");
}

/// Neither memory nor time grows beyond what a million points take.
TEST(SurfaceBlocks, AreBoundedAllTogether) {
  std::string text =
      "#1=1\nO100 while [#1 LT 20]\nG6.4 D#1 P2 Q2 I2 J32768\n#2=0\nO101 while [#2 LT 32768]\n"
      "X0 Y#2 Z0\nX20\n#2=[#2+1]\nO101 endwhile\n#1=[#1+1]\nO100 endwhile\n";
  EXPECT_EQ(problems(text).substr(0, 20), "7:1 surface-counts; ");
}

}  // namespace test_surface_blocks
}  // namespace leadscrew::gcode
