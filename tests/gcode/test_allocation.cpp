#include <gtest/gtest.h>

#include "allocations.hpp"
#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_allocation {

std::int64_t allocations_of(std::string_view block, int count) {
  std::string text = "G64 P0.01\nG0 Z10\nF60 #1=2\n";
  for (int i = 0; i < count; ++i) text += block;
  text += "M2\n";
  const machine::Machine machine = nine_axes();
  const machine::ToolTable tools;
  Reader reader(text_source(text), machine, tools, {}, [](const base::Diagnostic& d) { ADD_FAILURE() << d.message; });
  Move move;
  EXPECT_TRUE(reader.next(move));
  const std::int64_t before = testing_support::allocations();
  while (reader.next(move)) continue;
  return testing_support::allocations() - before;
}

TEST(Memory, IsNotAllocatedForBlocks) {
  const char* const blocks[] = {
      "G1 X1 Y2\nX2\n",
      "G2 X5 Y0 R7\nG3 X10 Y0 R7\nI-5\n",
      "G81 X1 Y1 Z-1 R1\nX2\n",
      "S100 M3 M8\nG4 P1 (remark)\n",
      "G0 X[SIN[#1 * 3] + #1] Y 1 . 5\n",
      "#1=[#1 + 0.001]\n",
      "G1 X0 Y0\nG5 I1 J1 P1 Q1 X9 Y2\nP1 Q1 X5\nG5.1 X0 I1\nG1 X1\n",
      "G0 X0 Y0\nG5.2 X1 Y1\nX2 Y0 P3\nX9 Y9\nG5.3\n",
      "G0 X0 Y0\nG6.2 P3 K0 R2\nK0 X5\nK0 Y3\nK1\nK1\nK1\nM8\n",
      "G10 L2 P2 X1\nG55 G0 X1\nG92 X1\nG92.1\nG54\n",
  };
  for (const char* block : blocks) {
    const std::int64_t few = allocations_of(block, 10), many = allocations_of(block, 1000);
    EXPECT_EQ(few, many) << block;
  }
}

}  // namespace test_allocation
}  // namespace leadscrew::gcode
