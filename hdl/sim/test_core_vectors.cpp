#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "core_program.hpp"

// The same vectors in a second simulator, iverilog; script/hardware-mutants breaks the core and runs them too.

namespace leadscrew::hardware {
namespace test_core_vectors {

/// Units side by side, each of 26 bits.
std::uint64_t units_of(const CoreCommand& command, std::int64_t Decision::* which) {
  return bits_of(command.unit[0].*which, 26) | bits_of(command.unit[1].*which, 26) << 26;
}

void write(std::ostream& to, const CoreCommand& command) {
  std::uint64_t source = 0, backward = 0;
  for (std::size_t axis = 0; axis < core_axes; ++axis) {
    source |= std::uint64_t{command.source[axis]} << (4 * axis);
    backward |= std::uint64_t{command.backward[axis]} << axis;
  }
  to << std::hex << command.count << ' ' << int{command.dwell} << ' ' << int{command.final} << ' ' << command.feed
     << ' ' << command.feed_straight << ' ' << source << ' ' << backward << ' ' << bits_of(command.curve, 2) << ' '
     << units_of(command, &Decision::decision) << ' ' << units_of(command, &Decision::straight) << ' '
     << units_of(command, &Decision::diagonal) << '\n';
}

void write(std::ostream& to, const CorePulse& pulse) {
  int strobes = 0, senses = 0;
  for (std::size_t axis = 0; axis < core_axes; ++axis) {
    strobes |= (pulse.step[axis] != 0 ? 1 : 0) << axis;
    senses |= (pulse.step[axis] < 0 ? 1 : 0) << axis;
  }
  to << strobes << ' ' << senses << '\n';
}

TEST(CoreVectors, AreTheSameByIverilog) {
  std::ofstream commands("core_commands.txt"), steps("core_steps.txt");
  const RandomProgram program(1001);
  std::int64_t tick = 0;
  for (const CoreCommand& command : program.commands) write(commands, command);
  for (const Step& step : program.steps) {
    while (++tick < step.tick) write(steps, CorePulse{});
    write(steps, step.pulse);
  }
  while (tick++ < program.ticks()) write(steps, CorePulse{});
  commands.close();
  steps.close();
  const std::string rtl = LEADSCREW_SOURCE_DIR "/hdl/rtl/", bench = LEADSCREW_SOURCE_DIR "/hdl/sim/iverilog/";
  std::string sources = bench + "core_vectors.sv";
  for (const char* name : {"motion_core", "engine", "decision_unit", "command_fifo", "position_counter", "step_shaper"})
    sources += " " + rtl + name + ".sv";
  ASSERT_EQ(std::system(("iverilog -g2012 -o core_vectors.vvp -s core_vectors " + sources).c_str()), 0);
  ASSERT_EQ(std::system("vvp core_vectors.vvp +commands=core_commands.txt +steps=core_steps.txt > core_vectors.txt"),
            0);
  std::ifstream said("core_vectors.txt");
  std::string word;
  said >> word;
  EXPECT_EQ(word, "passed");
}

}  // namespace test_core_vectors
}  // namespace leadscrew::hardware
