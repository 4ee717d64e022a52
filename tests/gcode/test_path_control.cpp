#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_path_control {

struct Control {
  PathMode mode;
  double tolerance;
  double naive_cam_tolerance;
  friend bool operator==(const Control&, const Control&) = default;
};
std::ostream& operator<<(std::ostream& out, const Control& c) {
  return out << static_cast<int>(c.mode) << " " << c.tolerance << " " << c.naive_cam_tolerance;
}

Control control(std::string_view before, const Conditions& conditions = {}) {
  const Move move = read_well(std::string(before) + "\nG0 X1\nM2\n", conditions).lines().back();
  return {move.path_mode, move.tolerance, move.naive_cam_tolerance};
}

TEST(PathControl, BeginsBlendingWithTheToleranceOfTheMachine) {
  EXPECT_EQ(control(""), (Control{PathMode::blend, 0.01, 0.01}));
}
TEST(PathControl, IsG61) {
  EXPECT_EQ(control("G61"), (Control{PathMode::exact_path, 0, 0}));
}
TEST(PathControl, IsG61_1) {
  EXPECT_EQ(control("G61.1"), (Control{PathMode::exact_stop, 0, 0}));
}
TEST(PathControl, IsG64WithTolerances) {
  EXPECT_EQ(control("G61\nG64 P0.05"), (Control{PathMode::blend, 0.05, 0.05}));
  EXPECT_EQ(control("G64 P0.05 Q0.02"), (Control{PathMode::blend, 0.05, 0.02}));
  EXPECT_EQ(control("G64 P0.05 Q0.02\nG64"), (Control{PathMode::blend, 0.01, 0.01}));
  EXPECT_EQ(control("G64 P0"), (Control{PathMode::blend, 0, 0}));
  EXPECT_EQ(control("G20 G64 P0.001"), (Control{PathMode::blend, 0.0254, 0.0254}));
}

TEST(PathControl, IsOverriddenByTheOptions) {
  Conditions conditions;
  conditions.options.path_mode = PathMode::exact_stop;
  EXPECT_EQ(control("G64 P0.05", conditions), (Control{PathMode::exact_stop, 0, 0}));
  conditions.options.path_mode = PathMode::blend;
  EXPECT_EQ(control("G61", conditions), (Control{PathMode::blend, 0.01, 0.01}));
  conditions.options.tolerance = 0.3;
  EXPECT_EQ(control("G64 P0.05", conditions), (Control{PathMode::blend, 0.3, 0.3}));
}

TEST(PathControl, RefusesNegativeTolerances) {
  EXPECT_EQ(read("G64 P-1\nM2\n").problems(), "1:5 bad-value; ");
  EXPECT_EQ(read("G64 P1 Q-1\nM2\n").problems(), "1:8 bad-value; ");
}

}  // namespace test_path_control
}  // namespace leadscrew::gcode
