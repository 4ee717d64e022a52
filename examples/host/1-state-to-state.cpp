// From rest in one position to rest in another, in six axes, as fast as their limits allow: the slowest sets the time. It
// is known before anything moves, and so is where each axis is at any time, and how fast.
#include <array>
#include <cstdio>
#include <leadscrew/motion.hpp>

#include "trace_file.hpp"

using namespace leadscrew;

int main(int argc, char** argv) {
  using enum base::Axis;
  machine::Machine robot;
  robot.name = "six joints";
  robot.period = {1'000'000};  // ns
  for (const base::Axis joint : {A, B, C}) {
    // Travel, degrees; then velocity, acceleration and jerk, and the resolution of a step.
    robot.axes[base::index(joint)] = machine::AxisLimits{-180, 180, 120, 600, 6000, 0.001};
  }
  for (const base::Axis axis : {X, Y, Z})
    robot.axes[base::index(axis)] = machine::AxisLimits{0, 800, 500, 2500, 40000, 0.001};

  host::Motion motion(robot);
  const base::AxisVector target = {400, 250, 90, 45, -60, 10};  // X Y Z A B C
  if (const auto pushed = motion.push(host::line(target, host::rapid)); !pushed)
    return std::fprintf(stderr, "%s\n", pushed.error().message.c_str()), 1;

  const auto planned = motion.plan();
  if (!planned) return std::fprintf(stderr, "%s\n", planned.error().message.c_str()), 1;
  std::puts("    s       X       Y       Z       A       B       C   X mm/s  X mm/s²  X mm/s³");
  for (int i = 0; i <= 10; ++i) {
    const double t = planned->duration() * i / 10;
    const host::TrajectoryState at = planned->at(t);
    std::printf("%5.3f", t);
    for (std::size_t axis = 0; axis < 6; ++axis) std::printf(" %7.2f", at.position[axis]);
    std::printf(" %8.2f %8.1f %8.0f\n", at.velocity[0], at.acceleration[0], at.jerk[0]);
  }
  std::printf("%.3f s\n", planned->duration());

  // The same motion in words, a servo period apart.
  motion.finish();
  TraceFile trace(argc, argv, "XYZABC", robot.period);
  std::array<base::Word, 100> words;
  while (const std::size_t count = motion.next(words)) {
    for (std::size_t i = 0; i < count; ++i) trace.write(words[i]);
  }
}
