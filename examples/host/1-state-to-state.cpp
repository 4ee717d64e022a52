// From rest in one position to rest in another, in six axes, as fast as their limits allow: the slowest sets the time.
#include <cstdio>
#include <leadscrew/host/motion.hpp>

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
  motion.finish();

  std::puts("    s       X       Y       Z       A       B       C");
  TraceFile trace(argc, argv, "XYZABC", robot.period);
  std::array<base::Word, 100> words;
  while (const std::size_t count = motion.next(words)) {
    for (std::size_t i = 0; i < count; ++i) trace.write(words[i]);
    const base::Word& word = words[count - 1];
    std::printf("%5.3f", base::seconds(word.tick, robot.period));
    for (std::size_t axis = 0; axis < 6; ++axis) std::printf(" %7.2f", word.position[axis]);
    std::puts("");
  }
  std::printf("%.3f s\n", motion.summary().time_s);
}
