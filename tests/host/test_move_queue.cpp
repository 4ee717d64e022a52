// Moves that are given by several are taken whole or not at all.

#include <gtest/gtest.h>

#include <leadscrew/host/move_queue.hpp>
#include <leadscrew/host/moves.hpp>

namespace test_move_queue {

using namespace leadscrew;

gcode::Move line_to_x(double x, int number) {
  base::AxisVector end{};
  end[0] = x;
  gcode::Move move = host::line(end, 10);
  move.line = base::line_at(number);
  return move;
}

TEST(MoveQueue, TakesAllOfSeveralMovesOrNone) {
  const machine::Machine machine = machine::mill3();
  host::MoveQueue queue(machine, {});
  ASSERT_TRUE(queue.push({line_to_x(1, 1), line_to_x(2, 2)}));
  const auto refused = queue.push({line_to_x(3, 3), line_to_x(1e6, 4), line_to_x(5, 5)});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "travel");
  EXPECT_EQ(queue.waiting().size(), 2U);
  EXPECT_EQ(queue.end()[0], 2);
  queue.end_for_now();
  EXPECT_EQ(queue.waiting().back().line, base::line_at(2));
  EXPECT_EQ(queue.waiting().back().end[0], 2);
  ASSERT_TRUE(queue.push({line_to_x(3, 3)}));
  EXPECT_EQ(queue.waiting().back().start[0], 2);
}

}  // namespace test_move_queue
