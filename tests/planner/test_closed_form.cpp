#include <gtest/gtest.h>

#include <leadscrew/planner/piece_limits.hpp>
#include <leadscrew/planner/planner.hpp>

namespace {

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

}  // namespace
