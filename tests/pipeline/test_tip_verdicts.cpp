#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <leadscrew/referee/referee.hpp>
#include <numbers>
#include <string>
#include <vector>

// What the referee says of anyone's joints under tool centre point control: tip and direction of the tool apart, by traces
// that are made here by formulas of their own for a trunnion,
//
//     M = Rx(A)(Rz(C)(P − pc) + pc − pa) + pa

namespace test_tip_verdicts {

using namespace leadscrew;

struct TestedPose {
  double x = 0, y = 0, z = 0;  // of the tip, mm
  double a = 0, c = 0;         // degrees
};

constexpr double center_x = 3, center_y = -5, tilt_z = -40;  // pc = (3, -5, 0), pa = (0, 0, -40)

machine::Machine trunnion() {
  machine::Machine machine = machine::mill3();
  machine::RotaryChain chain = *machine::preset_chain("table-table-ac");
  for (machine::RotaryAxis& axis : chain.axes)
    axis.point = axis.axis == base::Axis::C ? machine::Vector{center_x, center_y, 0} : machine::Vector{0, 0, tilt_z};
  machine.rotary_chain = chain;
  for (const base::Axis axis : {base::Axis::A, base::Axis::C})
    machine.axes[base::index(axis)] = machine::AxisLimits{-360, 360, 100, 1000, 20000, 0.001};
  return machine;
}

base::AxisVector joints(const TestedPose& pose) {
  const double a = pose.a * std::numbers::pi / 180, c = pose.c * std::numbers::pi / 180;
  const double u = pose.x - center_x, v = pose.y - center_y;
  const double x = std::cos(c) * u - std::sin(c) * v + center_x;
  const double y = std::sin(c) * u + std::cos(c) * v + center_y;
  const double z = pose.z - tilt_z;
  return {x, std::cos(a) * y - std::sin(a) * z, std::sin(a) * y + std::cos(a) * z + tilt_z, pose.a, 0, pose.c};
}

/// Every axis straight from pose to pose, as an interpolator does that knows nothing of the tip.
std::vector<base::AxisVector> joint_linear(const std::vector<TestedPose>& poses, int words) {
  std::vector<base::AxisVector> trace = {joints(poses.front())};
  for (std::size_t k = 1; k < poses.size(); ++k) {
    const base::AxisVector from = joints(poses[k - 1]), to = joints(poses[k]);
    for (int i = 1; i <= words; ++i) {
      base::AxisVector word{};
      for (std::size_t q = 0; q < word.size(); ++q) word[q] = from[q] + (to[q] - from[q]) * i / words;
      trace.push_back(word);
    }
  }
  return trace;
}

/// The tip straight and the rotary axes evenly.
std::vector<base::AxisVector> tip_linear(const TestedPose& from, const TestedPose& to, int words) {
  std::vector<base::AxisVector> trace;
  for (int i = 0; i <= words; ++i) {
    const double t = static_cast<double>(i) / words;
    trace.push_back(joints({from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t, from.z + (to.z - from.z) * t,
                            from.a + (to.a - from.a) * t, from.c + (to.c - from.c) * t}));
  }
  return trace;
}

referee::Verdict verdict_on(const std::string& program, const std::vector<base::AxisVector>& trace,
                            base::Period period = {1'000'000}) {
  machine::Machine machine = trunnion();
  machine.period = period;
  const machine::ToolTable tools;
  gcode::ReaderOptions options;
  options.start = trace.front();
  gcode::Reader reader(gcode::text_source(program), machine, tools, options,
                       [](const base::Diagnostic& problem) { ADD_FAILURE() << problem.message; });
  referee::Referee referee([&](gcode::Move& move) { return reader.next(move); }, machine, machine.period);
  for (const base::AxisVector& word : trace) referee.observe(word);
  return referee.conclude();
}

bool names(const referee::Verdict& verdict, const std::string& what) {
  return std::ranges::any_of(verdict.violations, [&](const auto& each) { return each.what == what; });
}

/// A table that turns by Δ under a tip at the distance r: joints that go straight lead the tip r(1 − cos Δ/2) inwards.
TEST(TipVerdicts, TellTheSagOfStraightJoints) {
  constexpr double r = 100, turned = 2;
  const TestedPose from{center_x + r, center_y, 10, 0, 0}, to{center_x + r, center_y, 10, 0, turned};
  const auto verdict = verdict_on("G21 G90 G61\nG43.4 H0\nG1 C2 F120\nM2\n", joint_linear({from, to}, 1000));
  const double sag = r * (1 - std::cos(turned / 2 * std::numbers::pi / 180));
  ASSERT_TRUE(verdict.tip_deviation_mm);
  EXPECT_NEAR(*verdict.tip_deviation_mm, sag, 1e-9);
  EXPECT_NEAR(sag, 0.01523, 1e-5);
  EXPECT_NEAR(*verdict.orientation_deviation_deg, 0, 1e-6);
  EXPECT_TRUE(names(verdict, "deviation"));
  EXPECT_FALSE(names(verdict, "orientation"));
}

/// A tilting table: both ends of the chord lie on a circle about A's axis, whatever else moves.
TEST(TipVerdicts, TellTheSagOfATiltedTable) {
  constexpr double r = 60, turned = 30;
  const TestedPose from{20, 0, tilt_z + r, 0, 0}, to{20, 0, tilt_z + r, turned, 0};
  const auto verdict = verdict_on("G21 G90 G61\nG43.4 H0\nG1 A30 F600\nM2\n", joint_linear({from, to}, 2000));
  const double sag = r * (1 - std::cos(turned / 2 * std::numbers::pi / 180));
  EXPECT_NEAR(*verdict.tip_deviation_mm, sag, 1e-6);
  EXPECT_LE(*verdict.orientation_deviation_deg, 2);
}

/// Joints of the tip's own path are found on it to rounding, at the programmed feed.
TEST(TipVerdicts, FindNothingOnTheTipsPath) {
  const TestedPose from{20, -10, 10, 5, 0}, to{50, 30, 10, 25, 60};
  const auto verdict = verdict_on("G21 G90 G61\nG43.4 H0\nG1 X50 Y30 A25 C60 F1500\nM2\n", tip_linear(from, to, 2000));
  EXPECT_LE(*verdict.tip_deviation_mm, 1e-10);
  EXPECT_LE(*verdict.orientation_deviation_deg, 1e-9);
  EXPECT_FALSE(names(verdict, "deviation"));
  EXPECT_NEAR(verdict.feed_max_ratio, 1, 1e-6);  // 50 mm in 2 s
  const auto faster = verdict_on("G21 G90 G61\nG43.4 H0\nG1 X50 Y30 A25 C60 F1400\nM2\n", tip_linear(from, to, 2000));
  EXPECT_NEAR(faster.feed_max_ratio, 15. / 14, 1e-6);
  EXPECT_TRUE(names(faster, "feed"));
}

/// An axis that is off by 0.05° turns the tool by as much, and the tip about that axis.
TEST(TipVerdicts, CatchAShiftedAxis) {
  const TestedPose from{0, 0, 20, 10, 0}, to{30, 0, 20, 10, 0};
  std::vector<base::AxisVector> trace = tip_linear(from, to, 1500);
  const std::vector<base::AxisVector> sound = trace;
  for (base::AxisVector& word : trace) word[3] += 0.05;
  const std::string program = "G21 G90 G61\nG43.4 H0\nG1 X30 F1200\nM2\n";
  const machine::Machine machine = trunnion();
  EXPECT_LE(*verdict_on(program, sound).orientation_deviation_deg, 1e-9);
  const machine::ToolTable tools;
  gcode::ReaderOptions options;
  options.start = sound.front();
  gcode::Reader reader(gcode::text_source(program), machine, tools, options, nullptr);
  referee::Referee referee([&](gcode::Move& move) { return reader.next(move); }, machine, machine.period);
  for (const base::AxisVector& word : trace) referee.observe(word);
  const auto verdict = referee.conclude();
  EXPECT_NEAR(*verdict.orientation_deviation_deg, 0.05, 1e-9);
  // A turns about (y, z) = (0, -40), and the tip runs along it at the distance 60.
  EXPECT_NEAR(*verdict.tip_deviation_mm, 2 * 60 * std::sin(0.025 * std::numbers::pi / 180), 1e-9);
  EXPECT_TRUE(names(verdict, "orientation"));
  EXPECT_TRUE(names(verdict, "deviation"));
}

/// P is the tip's and E the direction's: neither is held against the other.
TEST(TipVerdicts, HoldTheDirectionToItsOwnTolerance) {
  const std::string program = "G21 G90 G64 P0.01 E0.5\nG43.4 H0\nG1 X30 A12 F1200\nM2\n";
  for (const double off : {0.4, 0.6}) {
    SCOPED_TRACE(off);
    std::vector<base::AxisVector> trace = tip_linear({0, 0, 20, 10, 0}, {30, 0, 20, 12, 0}, 1500);
    const std::size_t middle = trace.size() / 2;
    for (std::size_t k = middle - 300; k < middle + 300; ++k) {
      const double share = static_cast<double>(k) / 1500;
      trace[k] = joints({30 * share, 0, 20, 10 + 2 * share + off, 0});
    }
    const auto verdict = verdict_on(program, trace);
    EXPECT_NEAR(*verdict.orientation_deviation_deg, off, 0.03);
    EXPECT_EQ(verdict.orientation_tolerance_deg, 0.5);
    EXPECT_EQ(names(verdict, "orientation"), off > 0.5);
    EXPECT_FALSE(names(verdict, "deviation"));
  }
}

/// The tip comes by twice, the tool otherwise each time.
TEST(TipVerdicts, TellPlacesApartByTheToolsDirection) {
  const std::string program = "G21 G90 G61\nG43.4 H0\nG1 X30 F1200\nA20\nX0\nM2\n";
  std::vector<base::AxisVector> there = tip_linear({0, 0, 20, 0, 0}, {30, 0, 20, 0, 0}, 1500);
  std::vector<base::AxisVector> back = tip_linear({30, 0, 20, 0, 0}, {0, 0, 20, 0, 0}, 1500);
  there.insert(there.end(), back.begin() + 1, back.end());
  const auto verdict = verdict_on(program, there);
  // 20° at 50 mm are 17.45 mm: as far as that the tip is off the end where it has not turned, then the tool is.
  EXPECT_NEAR(*verdict.orientation_deviation_deg, 20, 1e-6);
  EXPECT_LE(*verdict.tip_deviation_mm, 17.5);
  EXPECT_NEAR(verdict.deviation_mm, 17.45, 0.05);
  EXPECT_TRUE(verdict.objects());
}

/// At long periods all words of slow lines are as near to each other as at rest. One lies beyond the tolerance of the last
/// line and within that at which it is still a candidate; the end is not there, nor where the way to it leads away from it.
TEST(TipVerdicts, FollowSlowLinesToWhereControlEnds) {
  for (const double to : {0.3, -0.15}) {
    SCOPED_TRACE(to);
    const TestedPose from{0, 0, 0, 0, 0}, corner{0.1, 0, 0, 0, 0}, end{0.1 + to, 0.1, 0, 0, 0};
    const std::string lines = "G1 X0.1 Y0\nG1 X" + std::to_string(end.x) + " Y0.1\n";
    std::vector<base::AxisVector> trace;
    for (double x = 0; x < corner.x - 1e-9; x += 0.001) trace.push_back(joints({x + 0.0005, 0, 0, 0, 0}));
    trace.front() = joints(from);
    const auto second = tip_linear(corner, end, 200);
    trace.insert(trace.end(), second.begin(), second.end());
    trace.push_back(trace.back());
    const auto verdict = verdict_on("G21 G90 G64 P0.004\nG43.4 H0\nF60\n" + lines + "G49\nM2\n", trace, {14'552'000});
    EXPECT_EQ(verdict.violation_count, 0);
    EXPECT_LE(verdict.deviation_mm, 0.0005);
  }
}

/// A trace that lies beside the program all along comes to the part under tool centre point control beside it.
TEST(TipVerdicts, FollowAShiftedTraceIntoTipControl) {
  const std::string program = "G21 G90 G61\nG0 A10\nG43.4 H0\nG1 X30 F1200\nM2\n";
  std::vector<base::AxisVector> trace;
  const base::AxisVector rest = joints({0, 0, 20, 10, 0});
  for (int i = 0; i <= 200; ++i) {
    trace.push_back(rest);
    const double t = i / 200.0;
    trace.back()[3] = 10 * (3 * t * t - 2 * t * t * t);
  }
  for (int i = 0; i < 10; ++i) trace.push_back(rest);
  const auto tip = tip_linear({0, 0, 20, 10, 0}, {30, 0, 20, 10, 0}, 1500);
  trace.insert(trace.end(), tip.begin(), tip.end());
  EXPECT_LE(verdict_on(program, trace).deviation_mm, 1e-6);
  base::AxisVector start = trace.front();
  for (base::AxisVector& word : trace) word[3] += 0.05;
  const machine::Machine machine = trunnion();
  const machine::ToolTable tools;
  gcode::ReaderOptions options;
  options.start = start;
  gcode::Reader reader(gcode::text_source(program), machine, tools, options, nullptr);
  referee::Referee referee([&](gcode::Move& move) { return reader.next(move); }, machine, machine.period);
  for (const base::AxisVector& word : trace) referee.observe(word);
  const auto verdict = referee.conclude();
  ASSERT_TRUE(verdict.orientation_deviation_deg);
  EXPECT_NEAR(*verdict.orientation_deviation_deg, 0.05, 1e-6);
  EXPECT_LE(verdict.deviation_mm, 0.1);
}

}  // namespace test_tip_verdicts
