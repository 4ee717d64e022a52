// G6.5: what its words say, and what they cannot.

#include <cmath>

#include "surface_programs.hpp"

namespace leadscrew::gcode {
namespace test_surface_words {

using surfaces::Orientation;
using surfaces::Pattern;

std::string problems(const std::string& block, const Conditions& conditions = with_shapes(),
                     const std::string& before = {}) {
  return read("F600\nG0 Z40\n" + before + flat_patch + block + "\nM2\n", conditions).problems();
}

Machined machined_by(const std::string& block, const Conditions& conditions = with_shapes(),
                     const std::string& before = {}) {
  const auto all = read_surfaces("F600\nG0 Z40\n" + before + flat_patch + block + "\nM2\n", conditions);
  for (const OnSurface& each : all) {
    if (each.machined.surface) return *each.machined.surface;
  }
  ADD_FAILURE() << "nothing is machined by " << block;
  return {};
}

TEST(SurfaceWords, SayHowASurfaceIsMachined) {
  const Machined machined = machined_by("G6.5 D1 T1 H0.01 L2 S1 P3 U0.25 V0.75 I0.1 J0.9 Z5 C0.000001");
  EXPECT_EQ(base::number(machined.line), 8u);
  EXPECT_EQ(machined.number, 1);
  EXPECT_FALSE(machined.is_of_tip);
  EXPECT_EQ(machined.tool.number, 1);
  const surfaces::Machining& machining = machined.machining;
  EXPECT_EQ(machining.cutter, (surfaces::Cutter{5, 5}));
  EXPECT_EQ(machining.orientation.rule, Orientation::Rule::fixed);
  EXPECT_EQ(machining.orientation.axis, (surfaces::Vector{0, 0, 1}));
  EXPECT_EQ(machining.side, 1);
  EXPECT_EQ(machining.pattern, Pattern::zig);
  EXPECT_EQ(machining.along, surfaces::Direction::v);
  EXPECT_EQ(machining.start_corner, 3);
  EXPECT_EQ(machining.u, (surfaces::Range{0.25, 0.75}));
  EXPECT_EQ(machining.v, (surfaces::Range{0.1, 0.9}));
  EXPECT_EQ(machining.scallop, 0.01);
  EXPECT_EQ(machining.step, 0);
  EXPECT_EQ(machining.tolerance, 1e-6);
}

TEST(SurfaceWords, AreZigzagAlongAllOfUWithout) {
  const surfaces::Machining machining = machined_by("G6.5 D1 T1 Q2.5").machining;
  EXPECT_EQ(machining.pattern, Pattern::zigzag);
  EXPECT_EQ(machining.along, surfaces::Direction::u);
  EXPECT_EQ(machining.start_corner, 1);
  EXPECT_EQ(machining.u, (surfaces::Range{0, 1}));
  EXPECT_EQ(machining.v, (surfaces::Range{0, 1}));
  EXPECT_EQ(machining.step, 2.5);
  EXPECT_EQ(machining.tolerance, 1e-10);
}

TEST(SurfaceWords, TakeTheToolInTheSpindle) {
  EXPECT_EQ(machined_by("G6.5 D1 Q2", with_shapes(), "T2 M6\n").machining.cutter, (surfaces::Cutter{5, 1}));
  EXPECT_EQ(problems("G6.5 D1 Q2"), "8:1 missing-word; ");
  EXPECT_EQ(problems("G6.5 D1 T1 Q2", with_shapes(), "T2 M6\n"), "9:9 surface-tool; ");
  EXPECT_EQ(problems("G6.5 D1 T4 Q2"), "8:9 surface-tool; ");
  EXPECT_EQ(problems("G6.5 D1 T9 Q2"), "8:9 unknown-tool; ");
  EXPECT_EQ(problems("G6.5 D1 T1.5 Q2"), "8:9 bad-value; ");
}

TEST(SurfaceWords, TurnNoSpindleAndSelectNoTool) {
  const Reading reading = read_well("F600\nG0 Z40\n" + flat_patch + "G6.5 D1 T1 Q5 S2\nM2\n", with_shapes());
  for (const base::Event& event : reading.events()) EXPECT_EQ(event.kind, base::Event::Kind::program_end);
}

TEST(SurfaceWords, LieWhereTheFrameSays) {
  const auto net = [](const std::string& before) {
    return machined_by("G6.5 D1 T1 Q5 Z50", with_shapes(), before).machining.surface->form().net[3].position;
  };
  EXPECT_EQ(net("G92 X0 Y0 Z30\nG0 Z60\n"), (surfaces::Vector{20, 10, 10}));
  EXPECT_EQ(net("G43 H1\nG0 Z60\n"), (surfaces::Vector{20, 10, 30}));
  EXPECT_EQ(net("G51 X0 Y0 Z0 P2\nG0 Z60\n"), (surfaces::Vector{40, 20, 0}));
  const surfaces::Vector turned = net("G68 R90\n");
  EXPECT_NEAR(turned[0], -10, 1e-12);
  EXPECT_NEAR(turned[1], 20, 1e-12);
  // Its other side is up when it is mirrored, which the tool stays on.
  EXPECT_EQ(machined_by("G6.5 D1 T1 Q5 Z50", with_shapes(), "G51.1 X0\n").machining.side, -1);
}

TEST(SurfaceWords, LeanByAAndB) {
  const Conditions table = with_shapes("table-table-ac");
  const std::string control = "G43.4 H1\nG0 Z60\n";
  const Orientation leaned = machined_by("G6.5 D1 T1 Q5 S1 A3 B-2 Z20", table, control).machining.orientation;
  EXPECT_EQ(leaned.rule, Orientation::Rule::leaned);
  const double lead = 3 * M_PI / 180, tilt = -2 * M_PI / 180;
  EXPECT_NEAR(leaned.axis[0], std::sin(lead), 1e-15);
  EXPECT_NEAR(leaned.axis[1], -std::cos(lead) * std::sin(tilt), 1e-15);
  EXPECT_NEAR(leaned.axis[2], std::cos(lead) * std::cos(tilt), 1e-15);
  EXPECT_EQ(machined_by("G6.5 D1 T1 Q5 A0 Z20", table, control).machining.orientation.rule, Orientation::Rule::normal);
  // Without them the tool keeps the direction that it has.
  const Orientation kept = machined_by("G6.5 D1 T1 Q5 Z40", table, "G0 A-30\n" + control).machining.orientation;
  EXPECT_EQ(kept.rule, Orientation::Rule::fixed);
  EXPECT_NEAR(std::abs(kept.axis[1]), 0.5, 1e-12);
  EXPECT_NEAR(kept.axis[2], std::sqrt(0.75), 1e-12);
  EXPECT_EQ(problems("G6.5 D1 T1 Q5 A3"), "8:15 surface-needs-tip-control; ");
  EXPECT_EQ(problems("G6.5 D1 T1 Q5 B0", table), "8:15 surface-needs-tip-control; ");
  EXPECT_EQ(problems("G6.5 D1 T1 Q5 A90", table, control), "10:15 bad-value; ");
}

TEST(SurfaceWords, ReportWhatTheyCannotSay) {
  const struct {
    const char* block;
    const char* problems;
  } rows[] = {
      {"G6.5 T1 Q5", "8:1 missing-word; "},
      {"G6.5 D2 T1 Q5", "8:6 surface-unknown; "},
      {"G6.5 D1.5 T1 Q5", "8:6 surface-unknown; "},
      {"G6.5 D1 T1", "8:1 missing-word; "},
      {"G6.5 D1 T1 H0.1 Q5", "8:1 ambiguous-word; "},
      {"G6.5 D1 T1 H0", "8:12 bad-value; "},
      {"G6.5 D1 T1 Q-1", "8:12 bad-value; "},
      {"G6.5 D1 T1 Q5 L3", "8:15 bad-value; "},
      {"G6.5 D1 T1 Q5 S6", "8:15 bad-value; "},
      {"G6.5 D1 T1 Q5 P0", "8:15 bad-value; "},
      {"G6.5 D1 T1 Q5 R2", "8:15 bad-value; "},
      {"G6.5 D1 T1 Q5 K3", "8:15 bad-value; "},
      {"G6.5 D1 T1 Q5 C1", "8:15 bad-value; "},
      {"G6.5 D1 T1 Q5 C0", "8:15 bad-value; "},
      {"G6.5 D1 T1 Q5 U-0.1", "8:15 surface-range; "},
      {"G6.5 D1 T1 Q5 V1.1", "8:15 surface-range; "},
      {"G6.5 D1 T1 Q5 I0.5 J0.5", "8:20 surface-range; "},
      {"G6.5 D1 T1 Q5 U0.7 V0.6", "8:20 surface-range; "},
      {"G6.5 D1 T1 Q5 Z-1", "8:15 surface-clearance; "},
      {"G6.5 D1 T1 Q5 X3", "8:15 unused-word; "},
      {"G6.5 D1 T1 Q5 E3", "8:15 unused-word; "},
      {"G1 G6.5 D1 T1 Q5", "8:1 modal-conflict; "},
      {"G93 G6.5 D1 T1 Q5 F1", "8:5 bad-feed-mode; "},
      {"G43 G6.5 D1 T1 H5", "8:16 ambiguous-word; "},
  };
  for (const auto& row : rows) EXPECT_EQ(problems(row.block), row.problems) << row.block;
  EXPECT_EQ(read(flat_patch + "G6.5 D1 T1 Q5 Z5\nM2\n", with_shapes()).problems(), "6:1 missing-feed; ");
}

}  // namespace test_surface_words
}  // namespace leadscrew::gcode
