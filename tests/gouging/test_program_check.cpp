// Programs that gouge, and others.

#include <gtest/gtest.h>

#include <leadscrew/gouging/program_check.hpp>
#include <sstream>

#include "../surfaces/patches.hpp"

namespace leadscrew::gouging {
namespace test_program_check {

/// G6.4 of a surface with uniform knots.
std::string definition(int number, const surfaces::SurfaceForm& form) {
  std::ostringstream text;
  text.precision(17);
  text << "G6.4 D" << number << " P" << form.degree[0] + 1 << " Q" << form.degree[1] + 1 << " I" << form.count[0]
       << " J" << form.count[1] << '\n';
  for (const auto& point : form.net)
    text << 'X' << point.position[0] << " Y" << point.position[1] << " Z" << point.position[2] << " R" << point.weight
         << '\n';
  return text.str();
}

surfaces::SurfaceForm wall(double y, double height) {
  surfaces::SurfaceForm form{{1, 1}, {surfaces::uniform_knots(2, 1), surfaces::uniform_knots(2, 1)}, {2, 2}, {}};
  for (const double z : {0.0, height}) {
    for (const double x : {0.0, 60.0}) form.net.push_back({{x, y, z}, 1});
  }
  return form;
}

machine::ToolTable tools() {
  const auto tool = [](int number, double diameter, std::optional<double> corner, double length, double holder) {
    machine::Tool made;
    made.number = number;
    made.diameter = diameter;
    made.corner_radius = corner;
    made.length = length;
    made.holder_diameter = holder;
    made.holder_length = holder > 0 ? 50 : 0;
    made.offset[2] = length;
    return made;
  };
  return machine::ToolTable({tool(1, 10, 5, 40, 40), tool(2, 90.8, 45.4, 0, 0), tool(3, 91, 45.5, 0, 0),
                             tool(4, 10, std::nullopt, 0, 0), tool(5, 10, 5, 80, 40), tool(6, 10, 0, 50, 0),
                             tool(7, 60, 30, 60, 0)});
}

GougeVerdict verdict_of(const std::string& text, std::string_view kinematics = {}) {
  machine::Machine machine = machine::mill3();
  if (!kinematics.empty()) {
    machine.kinematics = kinematics;
    machine.rotary_chain = machine::preset_chain(kinematics);
    for (const machine::RotaryAxis& axis : machine.rotary_chain->axes)
      machine.axes[base::index(axis.axis)] = machine::AxisLimits{-72000, 72000, 100, 1000, 10000, 0.001};
  }
  const machine::ToolTable table = tools();
  gcode::ReaderOptions options;
  options.allows_gouging = true;
  return check_gouging(
      [&] {
        return gcode::Reader(gcode::text_source(text), machine, table, options, [](const base::Diagnostic& problem) {
          EXPECT_NE(problem.severity, base::Severity::error) << problem.message << ' ' << problem.place.line;
        });
      },
      machine, table, {machine.tolerance, {}});
}

const std::string patch = definition(1, surfaces::test::patch_a());

TEST(GougeCheck, FindsNothingWhereNothingIs) {
  const GougeVerdict verdict = verdict_of("T1 M6\nG43 H1\nG0 Z100\n" + patch + "G6.5 D1 H0.04 Z40 F3000\nM2\n");
  EXPECT_FALSE(verdict.gouged());
  EXPECT_EQ(verdict.surfaces, 1u);
  EXPECT_EQ(verdict.moves_unknown, 0);
  EXPECT_GT(verdict.moves, 100);  // 50 passes, links, the way there and back
  ASSERT_TRUE(verdict.worst);
  EXPECT_LT(std::abs(verdict.worst->depth), 1e-5);  // it touches
  ASSERT_TRUE(verdict.least);
  EXPECT_GT(verdict.least->clearance, 0.17);  // 1/5 − 0.022
  EXPECT_EQ(verdict.sag, verdict.tolerance / 4);
}

TEST(GougeCheck, FindsBallsThatAreTooLargeForPatchA) {
  const auto program = [](int tool) {
    return "T" + std::to_string(tool) + " M6\nG0 Z200\n" + patch + "G6.5 D1 Q3 Z150 F3000\nM2\n";
  };
  const GougeVerdict fits = verdict_of(program(2)), gouges = verdict_of(program(3));
  EXPECT_TRUE(fits.local.empty());
  EXPECT_TRUE(fits.gouges.empty());
  ASSERT_EQ(gouges.local.size(), 1u);
  const LocalClearance& local = gouges.local.begin()->second;
  EXPECT_EQ(base::number(local.line), 20);
  EXPECT_EQ(local.surface, 1);
  EXPECT_LT(local.clearance, 0);
  EXPECT_NEAR(std::min(local.u, local.v), 0, 0.05);
  EXPECT_NEAR(std::max(local.u, local.v), 0.9, 0.05);
}

/// z = 20 − 80 s + 80 s² at x = 60 s: by how much a ball of this radius and centre is inside, by trying.
double depth_in_valley(double radius, double x, double z) {
  double nearest = 1e300;
  for (int k = 0; k <= 600'000; ++k) {
    const double s = k / 600'000.0;
    nearest = std::min(nearest, std::hypot(60 * s - x, 20 - 80 * s + 80 * s * s - z));
  }
  return radius - nearest;
}

/// A ball of 60 mm along a valley that is rounder at its bottom: every pass that is too deep, and no other, as deep as it is.
TEST(GougeCheck, TellsEachPassThatIsTooDeep) {
  constexpr double radius = 30;
  surfaces::SurfaceForm valley{{2, 1}, {surfaces::uniform_knots(3, 2), surfaces::uniform_knots(2, 1)}, {3, 2}, {}};
  for (const double y : {0.0, 20.0})
    valley.net.insert(valley.net.end(), {{{0, y, 20}, 1}, {{30, y, -20}, 1}, {{60, y, 20}, 1}});
  const std::string text = "T7 M6\nG43 H7\nG0 Z60\n" + definition(1, valley) + "G6.5 D1 Q2 L2 Z50 F3000\nM2\n";
  const GougeVerdict verdict = verdict_of(text);
  gcode::ReaderOptions options;
  options.allows_gouging = true;
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable table = tools();
  gcode::Reader reader(gcode::text_source(text), machine, table, options, nullptr);
  std::map<std::size_t, double> expected;
  std::size_t passes = 0;
  for (gcode::Move move; reader.next(move);) {
    if (!reader.machined().surface || reader.machined().part != gcode::MachinedMove::Part::pass) continue;
    ++passes;
    const double depth = depth_in_valley(radius, move.start[0], move.start[2] - table.find(7)->offset[2] + radius);
    if (depth > verdict.tolerance) expected[reader.machined().pass] = depth;
  }
  EXPECT_GT(expected.size(), 10u);
  EXPECT_LT(expected.size(), passes);
  std::size_t told = 0;
  double worst = 0;
  for (const auto& [key, gouge] : verdict.gouges_of_passes) {
    const auto& [line, part, pass] = key;
    if (base::number(line) != 11) continue;  // from the machine's zero, which is below the valley
    EXPECT_EQ(gouge.of, part);
    EXPECT_EQ(gouge.pass, pass);
    EXPECT_EQ(gouge.offset[2], table.find(7)->offset[2]);
    worst = std::max(worst, gouge.depth);
    if (part != gcode::MachinedMove::Part::pass) continue;
    ++told;
    ASSERT_TRUE(expected.contains(pass)) << pass;
    EXPECT_NEAR(gouge.depth, expected[pass], 1e-6) << pass;
  }
  EXPECT_EQ(told, expected.size());
  EXPECT_EQ(verdict.gouges.rbegin()->second.depth, worst);
}

TEST(GougeCheck, FindsTheHolderAgainstAWallThatIsMachinedToo) {
  const auto program = [](int tool) {
    const std::string number = std::to_string(tool);
    return "T" + number + " M6\nG43 H" + number + "\nG0 Z150\n" + patch + definition(2, wall(-12, 60)) +
           "G6.5 D1 H0.4 Z100 F3000\nG0 Z200\nY-60\nG6.5 D2 Q10 R1 Z120\nM2\n";
  };
  const GougeVerdict verdict = verdict_of(program(1));
  ASSERT_TRUE(verdict.gouged());
  EXPECT_EQ(verdict.surfaces, 2u);
  const Gouge& gouge = verdict.gouges.begin()->second;
  EXPECT_EQ(gouge.part, Part::Kind::holder);
  EXPECT_EQ(gouge.surface, 2);
  EXPECT_EQ(base::number(gouge.line), 26);
  EXPECT_TRUE(gouge.pass);
  EXPECT_GT(gouge.depth, 7);
  EXPECT_NEAR(gouge.place[1], -12, 1e-9);
  EXPECT_NEAR(gouge.pose.tip[2] + 40, gouge.place[2], 20);
  for (const auto& [line, found] : verdict_of(program(5)).gouges) ADD_FAILURE() << base::number(line) << found.depth;
}

TEST(GougeCheck, FindsLinesAndArcsThatCutIntoASurface) {
  const std::string begin = "T1 M6\nG43 H1\nG0 Z100\n" + patch + "G6.5 D1 Q6 Z40 F3000\nG0 X30 Y30 Z40\n";
  const GougeVerdict plunge = verdict_of(begin + "G1 Z5.5\nG0 Z40\nM2\n");
  ASSERT_EQ(plunge.gouges.size(), 1u);
  const Gouge& deepest = plunge.gouges.begin()->second;
  EXPECT_FALSE(deepest.pass);
  EXPECT_EQ(deepest.part, Part::Kind::cutter);
  EXPECT_NEAR(deepest.depth, 0.4375, 0.005);  // below S(.5, .5), a little off along its normal
  EXPECT_NEAR(deepest.u, 0.5, 0.01);
  EXPECT_FALSE(verdict_of(begin + "G1 Z5.95\nG0 Z40\nM2\n").gouged());
  // Half a turn up from the surface, and down into it
  EXPECT_FALSE(verdict_of(begin + "Z10\nG18 G3 X40 I5 K0 F100\nG0 Z40\nM2\n").gouged());
  EXPECT_TRUE(verdict_of(begin + "Z10\nG18 G2 X40 I5 K0 F100\nG0 Z40\nM2\n").gouged());
}

TEST(GougeCheck, KnowsTheToolThatAMoveIsMadeWith) {
  const std::string begin = "T1 M6\nG43 H1\nG0 Z100\n" + patch + "G6.5 D1 Q6 Z40 F3000\nG0 X30 Y30 Z60\n";
  // The same surface for a tool of another length: 40 mm
  const GougeVerdict other = verdict_of(begin + "T5 M6\nG43 H5\nG0 Z40\nG1 Z6\nG0 Z60\nM2\n");
  EXPECT_FALSE(other.gouged());
  EXPECT_TRUE(verdict_of(begin + "T5 M6\nG43 H5\nG0 Z40\nG1 Z5\nG0 Z60\nM2\n").gouged());
  const GougeVerdict unknown = verdict_of(begin + "T4 M6\nG1 Z0\nG0 Z60\nM2\n");
  EXPECT_FALSE(unknown.gouged());
  EXPECT_EQ(unknown.moves_unknown, 2);
}

TEST(GougeCheck, SeesToolsThatLeanOnMachinesOfFiveAxes) {
  const auto program = [](double lead) {
    return "T1 M6\nG43.4 H1\nG0 Z100\n" + patch + "G6.5 D1 Q12 A" + std::to_string(lead) + " B0 Z60 F3000\nM2\n";
  };
  for (const char* kinematics : {"table-table-ac", "head-head-bc"}) {
    const GougeVerdict upright = verdict_of(program(5), kinematics);
    EXPECT_FALSE(upright.gouged()) << kinematics;
    ASSERT_TRUE(upright.worst);
    EXPECT_LT(std::abs(upright.worst->depth), 1e-4);
    // So flat that the holder meets the surface
    const GougeVerdict flat = verdict_of(program(70), kinematics);
    ASSERT_FALSE(flat.gouges.empty()) << kinematics;
    EXPECT_EQ(flat.worst->part, Part::Kind::holder);
  }
}

TEST(GougeCheck, KnowsWhatIsMachinedInOtherSystems) {
  // The same surface twice, 100 mm apart, and once more where it was
  const GougeVerdict verdict = verdict_of("T1 M6\nG43 H1\nG0 Z100\n" + patch +
                                          "G10 L2 P2 X100\nG6.5 D1 Q6 Z40 F3000\nG55\nG6.5 D1 Q6 Z40\nG54\n"
                                          "G6.5 D1 Q8 Z40\nM2\n");
  EXPECT_EQ(verdict.surfaces, 2u);
  EXPECT_FALSE(verdict.gouged());
}

TEST(GougeCheck, CountsFromWhereTheToolIsClearFirst) {
  // It begins at machine zero, with its tip 40 mm below the surface.
  const std::string end = patch + "G6.5 D1 Q6 Z40 F3000\n";
  EXPECT_FALSE(verdict_of("T1 M6\nG43 H1\nG0 X30 Y30\nZ100\n" + end + "M2\n").gouged());
  EXPECT_EQ(verdict_of("T1 M6\nG43 H1\nG0 X30 Y30\nZ100\nG1 Z0 F100\nG0 Z100\n" + end + "M2\n").gouges.size(), 1u);
  EXPECT_TRUE(verdict_of("T1 M6\nG43 H1\nG1 X30 Y30 F600\nG0 Z100\n" + end + "M2\n").gouged());  // no rapid
}

TEST(GougeCheck, SaysNothingOfProgramsWithoutSurfaces) {
  const GougeVerdict verdict = verdict_of("T1 M6\nG1 X10 F600\nM2\n");
  EXPECT_EQ(verdict.surfaces, 0u);
  EXPECT_EQ(verdict.moves, 0);
  EXPECT_FALSE(verdict.worst);
}

}  // namespace test_program_check
}  // namespace leadscrew::gouging
