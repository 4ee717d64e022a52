// G17.1, G18.1 and G19.1: planes of U, V and W, across which canned cycles go.

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_secondary_planes {

/// The ends of all moves, along three axes.
std::string ends(const std::string& program, const std::string& letters) {
  const Reading reading = read(program + "M2\n");
  std::string told;
  for (const Move& line : reading.lines()) {
    for (const char letter : letters) {
      for (const base::Axis axis : base::all_axes) {
        if (base::letter(axis) == letter) told += text(line.end[base::index(axis)]) + " ";
      }
    }
    told += line.feed.mode == Feed::Mode::rapid ? "rapid; " : "feed; ";
  }
  return told + reading.problems();
}

std::string replaced(std::string program, const std::string& from, const std::string& by) {
  for (char& c : program) {
    const std::size_t at = from.find(c);
    if (at != std::string::npos) c = by[at];
  }
  return program;
}

/// The same holes as in X, Y and Z, letter by letter.
TEST(SecondaryPlanes, TakeTheCyclesOfTheirNeighbours) {
  const std::string cycles[] = {"G81 X10 Y4 Z-5 R1\nX20\n",
                                "G82 X10 Z-5 R1 P0.1\n",
                                "G83 X1 Y4 Z-5 R1 Q2\n",
                                "G99 G73 X10 Z-5 R1 Q2\nG98 Y9\n",
                                "G85 X10 Z-5 R1\nG91 X2 Z-3 R0 L3\n",
                                "S100 M3\nG86 X10 Z-5 R1 P0\n",
                                "G89 X10 Z-5 R1 P0.1\n",
                                "S100 M3\nG87 X10 Z-5 R-4 I1 J0 K-2\n"};
  for (const std::string& cycle : cycles) {
    const std::string primary = "G21 F200\nG0 X1 Y2 Z8\n" + cycle;
    // R, K and their like stay; G17 becomes G17.1.
    const std::string secondary = "G17.1 " + replaced(primary, "XYZ", "UVW");
    EXPECT_EQ(ends(secondary, "UVW"), ends(primary, "XYZ")) << cycle;
    EXPECT_EQ(read(secondary + "M2\n").problems(), "") << cycle;
    EXPECT_EQ(ends(secondary, "XYZ").find_first_of("123456789"), std::string::npos) << cycle;
  }
  const std::string hole = "G81 U10 V4 W-5 R1\n";
  EXPECT_EQ(ends("F200 G18.1\nG0 V8\n" + replaced(hole, "UVW", "WUV"), "WUV"),
            ends("F200 G17.1\nG0 W8\n" + hole, "UVW"));
  EXPECT_EQ(ends("F200 G19.1\nG0 U8\n" + replaced(hole, "UVW", "VWU"), "VWU"),
            ends("F200 G17.1\nG0 W8\n" + hole, "UVW"));
}

TEST(SecondaryPlanes, HaveNoArcsAndNoCompensation) {
  const auto problems = [](const std::string& program) { return read(program + "M2\n").problems(); };
  EXPECT_EQ(problems("F200 G17.1\nG2 U10 I5\n"), "2:1 bad-plane; ");
  EXPECT_EQ(problems("F200 G18.1\nG3 X10 I5\n"), "2:1 bad-plane; ");
  EXPECT_EQ(problems("F200 G19.1\nG41.1 D2\nG1 V10\n"), "2:1 cutter-compensation; ");
  EXPECT_EQ(problems("F200 G17.1\nG81 X10 Y3 Z-5 R1\n"), "2:1 missing-word; ");
  EXPECT_EQ(problems("F200 G17.1\nG81 X10 U3 W-5 R1\n"), "2:5 unused-word; ");
  EXPECT_EQ(problems("F200\nG81 U10 V3 Z-5 R1\n"), "2:5 unused-word; ");
  EXPECT_EQ(problems("F200 G17.1\nG1 X3 U4\nG17 G2 X13 I5\n"), "");
  EXPECT_EQ(problems("F200 G17.1\nG5.1 X3 Y4 I1 J1\n"), "2:1 bad-plane; ");
}

TEST(SecondaryPlanes, AreToldToTheProgram) {
  Conditions conditions;
  std::string told;
  conditions.options.remarks = [&](const Remark& remark) { told += remark.text + ";"; };
  read(
      "G17.1\n(PRINT,%d#<_plane>)\nG18.1\n(PRINT,%d#<_plane>)\nG19.1\n(PRINT,%d#<_plane>)\nG18\n(PRINT,%d#<_plane>)"
      "\nM2\n",
      conditions);
  EXPECT_EQ(told, "171;181;191;180;");
}

}  // namespace test_secondary_planes
}  // namespace leadscrew::gcode
