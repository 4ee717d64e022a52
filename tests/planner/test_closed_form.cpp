#include <gtest/gtest.h>

#include <leadscrew/planner/piece_limits.hpp>
#include <leadscrew/planner/planner.hpp>

namespace test_closed_form {

using namespace leadscrew;
using planner::Chunk;
using planner::Planner;

/// Where a slice ends as motion begins to brake, its tail is what is left: as good as at the end, and no nearer to it.
TEST(ClosedForm, GoesOnWhereItStoppedJustBeforeTheEnd) {
  const machine::Machine machine = machine::mill3();
  for (int k = 1; k <= 300; ++k) {
    const double length = 0.37 * k;
    geometry::Point end{};
    end[0] = length;
    const toolpath::Piece piece{geometry::Line({}, end, length), 50.0 + k / 7.0};
    const planner::RestToRest motion = planner::plan_piece(piece, machine);
    Planner planner(machine, {});
    planner.slice(motion.duration() - 2 * motion.jerk_time - motion.acceleration_time);
    planner.push(piece);
    planner.finish();
    ASSERT_TRUE(planner.pop());
    if (planner.pop()) planner.refuse();
    std::optional<Chunk> last;
    int chunks = 0;
    while (std::optional<Chunk> chunk = planner.pop()) {
      ASSERT_LT(++chunks, 100);
      last = std::move(chunk);
    }
    if (last) {
      EXPECT_EQ(last->rest, end) << length;
    }
    EXPECT_EQ(planner.refused_windows(), 0);
  }
}

/// A hold that is given up in the last phase of its stop passes through rest; here just where a slice ends. What follows
/// may come late there: no tail may go on in its place.
TEST(ClosedForm, StandsWhereASliceEndsAtRest) {
  const machine::Machine machine = machine::mill3();
  constexpr double slice = 1.0 / 64;
  geometry::Point end{};
  end[0] = 20;
  Planner planner(machine, {});
  planner.slice(slice);
  planner.push(toolpath::Piece{geometry::Line({}, end, end[0]), 100});
  planner.finish();
  int through_rest = 0;
  for (int popped = 0;; ++popped) {
    if (popped == 2) planner.override_feed(0);  // two slices of acceleration, six of the stop
    if (popped == 7) planner.override_feed(1);
    const std::optional<Chunk> chunk = planner.pop();
    if (!chunk) break;
    ASSERT_LT(popped, 200);
    const planner::Segment& last = chunk->segments.back();
    const planner::PathState state = evaluate(last, (chunk->end() - last.begin).value());
    if (!is_rest(state)) continue;
    EXPECT_TRUE(chunk->stop_tail.empty()) << "after slice " << popped;
    EXPECT_EQ(chunk->tail_length, 0);
    through_rest += chunk->rest != end;
  }
  EXPECT_EQ(through_rest, 1);
}

}  // namespace test_closed_form
