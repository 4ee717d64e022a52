// Tools' offsets that programs of Fanuc's dialects set by G10: geometry and wear, of lathes and of mills.

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_lathe_offsets {

// Offset 4 is of X-10, a radius, Z-30, and a nose of radius 0.4 that is programmed by its middle.
Conditions lathe() {
  Conditions conditions = in_dialect(Dialect::fanuc_lathe);
  machine::Tool tool{.number = 4, .diameter = 0.8};
  tool.offset[base::index(base::Axis::X)] = -10;
  tool.offset[base::index(base::Axis::Z)] = -30;
  conditions.tools = machine::ToolTable({tool});
  return conditions;
}

// Where X50 Z5 is behind the blocks.
Point place_behind(const std::string& blocks) {
  return xyz(read_well(blocks + "\nT0404\nG0 X50. Z5.\nM30\n", lathe()).lines().back().end);
}

void expect_place(const std::string& blocks, double x, double z) {
  const Point place = place_behind(blocks);
  EXPECT_NEAR(place.x, x, 1e-12) << blocks;
  EXPECT_NEAR(place.z, z, 1e-12) << blocks;
}

// The radius of the nose behind the blocks, by which the middle stands off X20.
double nose_behind(const std::string& blocks) {
  const Reading reading =
      read_well(blocks + "\nT0404\nG97 S600 M3\nG0 X40. Z5.\nG42 G0 X20.\nG1 Z-20. F0.1\nG40 G0 X60.\nM30\n", lathe());
  return at(reading.lines()[1].end, base::Axis::X);
}

TEST(LatheOffsets, AreGeometryAndWear) {
  expect_place("", 15, -25);
  expect_place("G10 P10004 X-8. Z-7.", 21, -2);
  expect_place("G10 P4 X0.2 Z-0.1", 15.1, -25.1);
  expect_place("G10 P10004 X-8. Z-7.\nG10 P4 X0.2 Z-0.1", 21.1, -2.1);
  expect_place("G10 P4 X0.2 Z-0.1\nG10 P4 Z0.3\nG10 P5 X7.", 15.1, -24.7);
  expect_place("G20\nG10 P4 X0.2\nG21", 25 - 10 + 2.54, -25);
}

TEST(LatheOffsets, AreAddedToByUAndW) {
  expect_place("G0 X70. Z3.\nG10 P4 X0.2 Z-0.1\nG10 P4 U0.04 W0.02\nG10 P4 U0.04", 15.14, -25.08);
  expect_place("G10 P10004 U1. W2.", 15.5, -23);
  expect_place("G10 P4 U0.2 Z0.1", 15.1, -24.9);
}

// Of coordinate systems too, wherever the tool stands.
TEST(LatheOffsets, OfCoordinatesAreAddedToByUAndW) {
  const std::string stands = "G0 X70. Z3.\n", there = "\nG54 G0 X0 Z0\nM30\n";
  const auto origin = [&](const std::string& blocks) {
    return xyz(read_well(stands + blocks + there, in_dialect(Dialect::fanuc_lathe)).lines().back().end);
  };
  EXPECT_EQ(origin("G10 L2 P1 X8. Z5.\nG10 L2 P1 U1. W-2."), (Point{4.5, 0, 3}));
  EXPECT_EQ(origin("G10 L2 P1 X8. Z5.\nG10 L2 P0 U1."), (Point{4.5, 0, 5}));
  const std::string further = "G10 L20 P1 Z8.\nG10 L20 P1 W-2.\nG54.1 P1\nG0 X1. Z0\nM30\n";
  EXPECT_EQ(xyz(read_well(stands + further, in_dialect(Dialect::fanuc_lathe)).lines().back().end), (Point{0.5, 0, 6}));
  expect_place("G10 L1 P4 U1. W2.", 15.5, -23);
  EXPECT_EQ(read("G10 L2 P10 U1.\nM30\n", in_dialect(Dialect::fanuc_lathe)).problems(), "1:8 bad-value; ");
}

TEST(LatheOffsets, HaveANoseOfGeometryAndWear) {
  const double offset = nose_behind("") - 0.4;
  EXPECT_NEAR(nose_behind("G10 P10004 R0.8"), offset + 0.8, 1e-12);
  EXPECT_NEAR(nose_behind("G10 P4 R0.05"), offset + 0.45, 1e-12);
  EXPECT_NEAR(nose_behind("G10 P4 R0.05\nG10 P4 C-0.02"), offset + 0.43, 1e-12);
  EXPECT_NEAR(nose_behind("G10 P10004 C0.2"), offset + 0.6, 1e-12);
  // Fanuc's 3: what is programmed is 0.4 below the middle, whichever of the two says it.
  EXPECT_NEAR(nose_behind("G10 P4 Q3"), offset, 1e-12);
  EXPECT_NEAR(nose_behind("G10 P10004 Q3"), offset, 1e-12);
}

TEST(LatheOffsets, HoldFromTheNextT) {
  const Reading reading = read_well("T0404\nG10 P4 X0.2\nG0 X50. Z5.\nT0404\nG0 Z6.\nX50.\nM30\n", lathe());
  EXPECT_EQ(reading.lines()[0].end[0], 15);
  EXPECT_EQ(reading.lines().back().end[0], 15.1);
}

TEST(LatheOffsets, AreRefusedWhereTheyAreNone) {
  const auto problems = [](const std::string& block, const machine::Machine& machine = nine_axes()) {
    Conditions conditions = lathe();
    conditions.machine = machine;
    return read(block + "\nM30\n", conditions).problems();
  };
  for (const std::string p : {"0", "100", "10000", "10100", "101", "-1", "4.5"}) {
    EXPECT_EQ(problems("G10 P" + p + " X1. U1. C1."), "1:5 bad-value; ") << p;
  }
  EXPECT_EQ(problems("G10 P99 X1.\nG10 P10099 R1."), "");
  EXPECT_EQ(problems("G10 P4"), "1:1 missing-word; ");
  EXPECT_EQ(problems("G10 P4 Q10"), "1:8 bad-value; ");
  EXPECT_EQ(problems("G10 P4 I5. X1."), "1:8 unused-word; ");
  EXPECT_EQ(problems("G10 P4 X1. U1."), "1:12 unused-word; ");
  EXPECT_EQ(problems("G10 P4 R1. C1."), "1:12 unused-word; ");
  EXPECT_EQ(problems("G10 P4 X1. A1."), "1:12 unused-word; ");
  EXPECT_EQ(problems("G10 P4 U1. W1. C1.", machine::mill3()), "");
}

// Without L a mill's P R may be a length or a radius.
TEST(LatheOffsets, AreNoneOfMills) {
  for (const Dialect dialect : {Dialect::fanuc, Dialect::haas}) {
    const Reading reading = read("G10 P1 R50.\nM30\n", in_dialect(dialect));
    EXPECT_EQ(reading.problems(), "1:1 missing-word; ");
    const std::string length = "G10 L10 P1 R50.", radius = "G10 L12 P1 R5.", coordinates = "G10 L2 P1 X0 Y0 Z0";
    EXPECT_EQ(reading.diagnostics.front().hint,
              length + " for a tool's length, " + radius + " for its radius, " + coordinates + " for coordinates");
    read_well(length + "\n" + radius + "\n" + coordinates + "\nM30\n", in_dialect(dialect));
  }
}

// L12 and L13: a way of radius and wear off the line.
TEST(ToolRegisters, HoldTheWearOfARadius) {
  const std::string cut = "G0 X0 Y20.\nG41 D1 G1 X20. F100.\nY40.\nG40 X0\nM30\n";
  const auto x_of_cut = [&](const std::string& blocks) {
    return at(read_well(blocks + cut, in_dialect(Dialect::fanuc)).lines()[2].end, base::Axis::X);
  };
  EXPECT_NEAR(x_of_cut("G10 L12 P1 R5.\n"), 15, 1e-12);
  EXPECT_NEAR(x_of_cut("G10 L12 P1 R5.\nG10 L13 P1 R-0.1\n"), 15.1, 1e-12);
  EXPECT_NEAR(x_of_cut("G10 L12 P1 R5.\nG10 L13 P1 R-0.1\nG91 G10 L13 P1 R-0.2\nG90\n"), 15.3, 1e-12);
}

// A negative radius is on the other side, whichever register it comes from.
TEST(ToolRegisters, KeepTheSignOfARadius) {
  const std::string cut = "G0 X0 Y20.\nG41 D1 G1 X20. F100.\nY40.\nG40 X0\nM30\n";
  for (const Dialect dialect : {Dialect::fanuc, Dialect::haas}) {
    for (const std::string blocks :
         {"G10 L12 P1 R-5.\n", "G10 L12 P1 R0.4\nG10 L13 P1 R-5.4\n", "G10 L12 P1 R-2.\nG91 G10 L12 P1 R-3.\nG90\n"}) {
      const Reading reading = read_well(blocks + cut, in_dialect(dialect));
      EXPECT_NEAR(at(reading.lines()[2].end, base::Axis::X), 25, 1e-12) << blocks;
    }
  }
}

// What has no meaning there is not passed over.
TEST(ToolRegisters, TakeRAlone) {
  const auto problems = [](const std::string& block, Dialect dialect) {
    return read(block + "\nM30\n", in_dialect(dialect)).problems();
  };
  for (const Dialect dialect : {Dialect::fanuc, Dialect::haas}) {
    for (const std::string l : {"01", "10", "11", "12", "13"}) {
      for (const std::string word : {"Q3", "I5", "J5", "Z5", "X5"}) {
        EXPECT_EQ(problems("G10 L" + l + " P1 R5. " + word, dialect), "1:16 unused-word; ") << l << word;
      }
      EXPECT_EQ(problems("G10 L" + l + " P1", dialect), "1:1 missing-word; ") << l;
    }
    for (const std::string word : {"Q3", "I5", "J5"}) {
      EXPECT_EQ(problems("G10 L2 P1 X5. " + word, dialect), "1:15 unused-word; ");
    }
    EXPECT_EQ(problems("G10 L2 P1 X5. R5.", dialect), "");
  }
  for (const std::string l : {"10", "11", "12", "13"}) {
    EXPECT_EQ(problems("G10 L" + l + " P1 R5. Q3", Dialect::fanuc_lathe), "1:5 bad-value; ") << l;
  }
  const Reading reading = read("G10 L11 P1 Q3 R5.\nM30\n", in_dialect(Dialect::fanuc));
  EXPECT_EQ(reading.diagnostics.front().hint, "R alone is what G10 L11 sets: G10 L11 P1 R-0.1");
}

}  // namespace test_lathe_offsets
}  // namespace leadscrew::gcode
