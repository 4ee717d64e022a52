#include <gtest/gtest.h>

#include <leadscrew/toolpath/builder.hpp>
#include <leadscrew/toolpath/event_marks.hpp>

// Events that travel: on which piece they come to lie, and where.

namespace test_event_marks {

using namespace leadscrew;
using gcode::Move;
using toolpath::Builder;
using toolpath::EventMark;
using toolpath::Piece;
using Kind = base::Event::Kind;

/// A program of lines, each with the event of its number before it.
struct Moves {
  std::vector<Move> moves;
  base::AxisVector at{};
  double tolerance = 0;

  Moves& line_to(double x, double y) {
    Move move;
    move.start = at;
    move.end = at = {x, y};
    move.feed = {gcode::Feed::Mode::units_per_second, 50};
    move.path_mode = tolerance > 0 ? gcode::PathMode::blend : gcode::PathMode::exact_path;
    move.tolerance = move.naive_cam_tolerance = tolerance;
    moves.push_back(move);
    return *this;
  }
  Moves& event(Kind kind, double value, bool waits = false) {
    Move move;
    move.kind = Move::Kind::event;
    move.start = move.end = at;
    move.event = {kind, value, {}, 0, waits};
    moves.push_back(move);
    return *this;
  }
  Moves& dwell() {
    Move move;
    move.kind = Move::Kind::dwell;
    move.start = move.end = at;
    moves.push_back(move);
    return *this;
  }
  std::vector<toolpath::Element> elements() const {
    Builder builder;
    std::vector<toolpath::Element> elements;
    for (const Move& move : moves) builder.push(move);
    builder.finish();
    while (auto element = builder.pop()) elements.push_back(*element);
    return elements;
  }
};

/// Values of events with where they lie on the whole path; of those that stand by themselves too.
std::vector<std::pair<double, double>> places(const std::vector<toolpath::Element>& elements) {
  std::vector<std::pair<double, double>> places;
  double length = 0;
  for (const toolpath::Element& element : elements) {
    if (const auto* event = std::get_if<base::Event>(&element)) places.emplace_back(event->value, length);
    const auto* piece = std::get_if<Piece>(&element);
    if (!piece) continue;
    for (const EventMark& mark : toolpath::events_of(*piece)) {
      EXPECT_LT(mark.s, geometry::length(piece->curve));
      places.emplace_back(mark.event.value, length + mark.s);
    }
    length += geometry::length(piece->curve);
  }
  return places;
}

using Places = std::vector<std::pair<double, double>>;

TEST(EventMarks, LieWhereTheNextMoveBegins) {
  Moves program;
  program.event(Kind::spindle_speed, 1).line_to(10, 0).event(Kind::coolant_flood, 2).event(Kind::spindle_speed, 3);
  program.line_to(10, 0).line_to(10, 5).event(Kind::spindle_speed, 4);
  EXPECT_EQ(places(program.elements()), (Places{{1, 0}, {2, 10}, {3, 10}, {4, 15}}));
}

/// Three lines that run straight on are one.
TEST(EventMarks, LieOnLinesThatAreMadeOne) {
  Moves program;
  program.tolerance = 0.1;
  program.line_to(10, 0).event(Kind::spindle_speed, 1).line_to(15, 0).event(Kind::spindle_speed, 2).line_to(40, 0);
  EXPECT_EQ(program.elements().size(), 1u);
  EXPECT_EQ(places(program.elements()), (Places{{1, 10}, {2, 15}}));
}

TEST(EventMarks, LieInTheMiddleOfTheBlendOfACorner) {
  Moves program;
  program.tolerance = 0.1;
  program.line_to(10, 0).event(Kind::spindle_speed, 1).line_to(10, 10);
  const auto elements = program.elements();
  ASSERT_EQ(elements.size(), 3u);
  const Piece& blend = std::get<Piece>(elements[1]);
  ASSERT_EQ(toolpath::events_of(blend).size(), 1u);
  EXPECT_NEAR(toolpath::events_of(blend)[0].s, geometry::length(blend.curve) / 2, 1e-9);
}

/// What is to come with motion waits for it; the rest stands before the dwell.
TEST(EventMarks, StandByThemselvesWhereMotionRests) {
  Moves program;
  program.line_to(10, 0).event(Kind::spindle_speed, 1).event(Kind::analog_output_with_motion, 2).dwell();
  program.event(Kind::coolant_flood, 3).line_to(20, 0).event(Kind::analog_output_with_motion, 4);
  program.event(Kind::program_end, 5, true);
  const auto elements = program.elements();
  EXPECT_EQ(places(elements), (Places{{1, 10}, {2, 10}, {3, 10}, {4, 20}, {5, 20}}));
  EXPECT_EQ(std::get<base::Event>(elements[1]).value, 1);
  EXPECT_TRUE(std::holds_alternative<toolpath::Dwell>(elements[2]));
  EXPECT_EQ(toolpath::events_of(std::get<Piece>(elements[3])).size(), 2u);
}

TEST(EventMarks, AreNeitherLostNorDoubledWhereAPieceIsParted) {
  const std::vector<EventMark> marks = {{0, {}}, {2, {}}, {2.5, {}}, {5, {}}};
  const auto first = toolpath::events_on({0, 2.5, 5}, marks), second = toolpath::events_on({2.5, 5, 5}, marks, 2);
  ASSERT_EQ(first.size(), 2u);
  ASSERT_EQ(second.size(), 2u);
  EXPECT_EQ(first[1].s, 2);
  EXPECT_EQ(second[0].s, 0);
  EXPECT_EQ(second[1].s, 5);
}

/// Where a move begins that is made with another tool, and only to who asks.
TEST(EventMarks, TellOfTheToolWhereAMoveBeginsWithAnother) {
  Moves moves;
  moves.line_to(3, 4).line_to(3, 10).line_to(3, 12).line_to(0, 12);
  moves.moves[1].tool = moves.moves[2].tool = {0, 0, 7};
  moves.moves[3].tool = {1, 0, 7};
  for (const bool asks : {false, true}) {
    Builder builder;
    if (asks) builder.tell_tool();
    for (const Move& move : moves.moves) builder.push(move);
    builder.finish();
    std::vector<std::pair<double, base::Event>> told;
    double length = 0;
    while (auto element = builder.pop()) {
      const Piece& piece = std::get<Piece>(*element);
      for (const EventMark& mark : toolpath::events_of(piece)) told.emplace_back(length + mark.s, mark.event);
      length += geometry::length(piece.curve);
    }
    ASSERT_EQ(told.size(), asks ? 2u : 0u);
    if (!asks) continue;
    EXPECT_EQ(told[0], std::pair(5.0, base::Event{Kind::tool_offset, 7, {}, 2, false}));
    EXPECT_EQ(told[1], std::pair(13.0, base::Event{Kind::tool_offset, 1, {}, 0, false}));
  }
}

}  // namespace test_event_marks
