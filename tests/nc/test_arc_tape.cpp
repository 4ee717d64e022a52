#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/nc/arc_tape.hpp>
#include <leadscrew/nc/program_circle.hpp>

namespace leadscrew::nc::testing {
namespace test_arc_tape {

using pulse::Arc;
using pulse::Direction;

constexpr Arc turn{{300, 40}, {300, 40}, Direction::clockwise};

ProgramCircle circle_of(const Arc& arc) {
  return {arc, {pulse::Order::x_first, pulse::Preload::half, 16}};
}

/// Of arcs whose ends may be beside the circle, too.
RC_GTEST_PROP(ArcTape, PlaysWhatWasInterpolated, ()) {
  const auto radius = *rc::gen::inRange<std::int64_t>(2, 500), off = *rc::gen::inRange<std::int64_t>(-1, 2);
  const Arc arc{{radius, off}, {off, -radius}, Direction{*rc::gen::element<std::int8_t>(-1, 1)}};
  ArcTape tape;
  const std::int64_t commands = tape.record(arc, circle_of(arc));
  RC_ASSERT(tape.holds(arc));
  RC_ASSERT(tape.commands() == commands);
  ArcTape::Player player(tape);
  ProgramCircle circle = circle_of(arc);
  while (!circle.done()) {
    RC_ASSERT(!player.done());
    RC_ASSERT(player.step() == circle.step());
  }
  RC_ASSERT(player.done());
  RC_ASSERT(player.step() == pulse::Pulse<2>{});
}

TEST(ArcTape, HoldsTheArcLastRecordedAndNoOther) {
  ArcTape tape;
  EXPECT_FALSE(tape.holds(turn));
  tape.record(turn, circle_of(turn));
  EXPECT_TRUE(tape.holds(turn));
  Arc other = turn;
  other.direction = Direction::counterclockwise;
  EXPECT_FALSE(tape.holds(other));
  tape.record(other, circle_of(other));
  EXPECT_TRUE(tape.holds(other));
  EXPECT_FALSE(tape.holds(turn));
}

TEST(ArcTape, CountsWhatItIsTooShortFor) {
  const Arc arc{{3000, 0}, {3000, 0}, Direction::counterclockwise};
  ArcTape tape;
  std::int64_t commands = 0;
  for (ProgramCircle circle = circle_of(arc); !circle.done(); circle.step()) ++commands;
  ASSERT_GT(commands, ArcTape::most_commands);
  EXPECT_EQ(tape.record(arc, circle_of(arc)), commands);
  EXPECT_FALSE(tape.holds(arc));
}

}  // namespace test_arc_tape
}  // namespace leadscrew::nc::testing
