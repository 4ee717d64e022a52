#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/toolpath/builder.hpp>
#include <leadscrew/toolpath/frechet.hpp>
#include <numbers>

#include "polylines.hpp"

namespace leadscrew::toolpath::testing {
namespace {

using gcode::Move;

std::int64_t line_number(const Move& move) {
  return base::number(move.line);
}

/// A program that is made move by move; each on a line of its own, counted from 1.
struct Program {
  std::vector<Move> moves;
  Point at{};
  double tolerance = 0.01, cam_tolerance = 0.01, feed = 50;

  Move& add(Move::Kind kind, const Point& end) {
    Move move;
    move.kind = kind;
    move.line = base::Line{static_cast<std::int64_t>(moves.size()) + 1};
    move.start = at;
    move.end = at = end;
    move.feed = {gcode::Feed::Mode::units_per_second, feed};
    move.tolerance = tolerance;
    move.naive_cam_tolerance = cam_tolerance;
    moves.push_back(move);
    return moves.back();
  }
  void line_to(const Point& end) { add(Move::Kind::line, end); }
  /// In the plane of X and Y, about a centre, through an angle.
  void arc(double center_x, double center_y, double angle) {
    const double x = at[0] - center_x, y = at[1] - center_y;
    Point end = at;
    end[0] = center_x + x * std::cos(angle) - y * std::sin(angle);
    end[1] = center_y + x * std::sin(angle) + y * std::cos(angle);
    Move& move = add(Move::Kind::arc, end);
    move.center_first = center_x;
    move.center_second = center_y;
    move.turns = angle > 0 ? 1 : -1;
  }
  void dwell() { add(Move::Kind::dwell, at).dwell_seconds = 0.1; }
  void event() { add(Move::Kind::event, at).event = {base::Event::Kind::coolant_off, 0, moves.back().line}; }
};

enum class Popping { after_each, at_the_end };

std::vector<Element> path_of(const std::vector<Move>& moves, Popping popping = Popping::at_the_end) {
  Builder builder;
  std::vector<Element> path;
  const auto pop = [&] {
    while (std::optional<Element> element = builder.pop()) path.push_back(std::move(*element));
  };
  for (const Move& move : moves) {
    builder.push(move);
    if (popping == Popping::after_each) pop();
  }
  builder.finish();
  pop();
  return path;
}

std::vector<Piece> pieces_of(const std::vector<Move>& moves) {
  std::vector<Piece> pieces;
  for (const Element& element : path_of(moves)) {
    if (const auto* piece = std::get_if<Piece>(&element)) pieces.push_back(*piece);
  }
  return pieces;
}

/// Chords that turn now and then, by little and by much; sometimes arcs; in up to five axes; sometimes within
/// tolerances that change, at most that of the program.
Program random_program(int longest = 80) {
  Program program;
  program.tolerance = program.cam_tolerance = logarithmic(1e-3, 0.1);
  if (any(0, 3) == 0) program.cam_tolerance *= any(0, 3) / 2.0;
  program.feed = logarithmic(1, 300);
  std::vector<std::size_t> axes{0, 1};
  for (const std::size_t i : {2u, 3u, 4u}) {
    if (any(0, 3) == 0) axes.push_back(i);
  }
  const double most_turn = logarithmic(0.01, 3), chord = logarithmic(0.1, 10);
  const double greatest = program.tolerance;
  const bool varies = any(0, 3) == 0;
  Point direction = random_direction({0, 1});
  program.at = {uniform(-50, 50), uniform(-50, 50)};
  for (int count = any(1, longest); count > 0; --count) {
    if (varies && any(0, 3) == 0) program.tolerance = greatest * logarithmic(1e-2, 1);
    if (any(0, 10) == 0) {
      const double radius = logarithmic(0.5, 10), side = any(0, 2) == 0 ? 1 : -1;
      const double angle = uniform(0, 2 * std::numbers::pi);
      program.arc(program.at[0] + radius * std::cos(angle), program.at[1] + radius * std::sin(angle),
                  side * uniform(0.1, 3));
    } else {
      program.line_to(sum(program.at, chord * logarithmic(0.1, 10), direction));
    }
    direction = turned(direction, any(0, 5) == 0 ? uniform(0, most_turn) : uniform(0, most_turn / 10), axes);
    if (std::hypot(direction[0], direction[1]) < 0.1) direction = random_direction({0, 1});
  }
  program.tolerance = greatest;
  return program;
}

/// Places along a curve, in mm, so dense that their chords are off by no more than a few thousandths of the tolerance.
void append_places(Polyline& places, const geometry::Curve& curve, double tolerance) {
  std::vector<double> borders = geometry::breaks(curve);
  borders.insert(borders.begin(), 0);
  borders.push_back(geometry::length(curve));
  int count = 1;
  if (const auto* arc = std::get_if<geometry::Arc>(&curve)) {
    const double angle = std::abs(arc->angle_rate()) * arc->length();
    count = static_cast<int>(std::ceil(angle * std::sqrt(arc->radius() / (0.02 * tolerance))));
  }
  if (std::holds_alternative<geometry::Nurbs>(curve)) count = borders.size() <= 4 ? 120 : 15;
  places.push_back(to_millimetres(geometry::start(curve)));
  for (std::size_t i = 1; i < borders.size(); ++i) {
    for (int k = 1; k <= count; ++k) {
      const double s = borders[i - 1] + (borders[i] - borders[i - 1]) * k / count;
      places.push_back(to_millimetres(geometry::evaluate(curve, s)));
    }
  }
}

Polyline programmed(const Program& program) {
  Polyline places;
  for (const Move& move : program.moves) {
    for (const Piece& piece : toolpath::pieces_of(move)) append_places(places, piece.curve, program.tolerance);
  }
  return places;
}

Polyline travelled(const Program& program) {
  Polyline places;
  for (const Piece& piece : pieces_of(program.moves)) append_places(places, piece.curve, program.tolerance);
  return places;
}

RC_GTEST_PROP(Smoother, StaysWithinTheToleranceBothWays, ()) {
  const Program program = random_program(10);
  const Polyline a = programmed(program), b = travelled(program);
  RC_ASSERT(is_frechet_within(a, b, 1.01 * program.tolerance));
}

RC_GTEST_PROP(Smoother, BeginsAndEndsWhereItWasProgrammed, ()) {
  const Program program = random_program();
  const std::vector<Piece> pieces = pieces_of(program.moves);
  RC_ASSERT(!pieces.empty());
  RC_ASSERT(geometry::start(pieces.front().curve) == program.moves.front().start);
  RC_ASSERT(geometry::end(pieces.back().curve) == program.moves.back().end);
}

RC_GTEST_PROP(Smoother, MakesPiecesThatMeet, ()) {
  const std::vector<Piece> pieces = pieces_of(random_program().moves);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    RC_ASSERT(geometry::length(pieces[i].curve) > 0);
    RC_ASSERT(distance(geometry::end(pieces[i - 1].curve), geometry::start(pieces[i].curve)) <= 1e-12);
  }
}

/// The lines named along the path, one after another.
std::vector<std::int64_t> lines_of(const std::vector<Piece>& pieces) {
  std::vector<std::int64_t> lines;
  for (const Piece& piece : pieces) {
    lines.push_back(base::number(piece.line));
    if (!piece.lines) continue;
    double last = 0;
    for (const LineMark& mark : *piece.lines) {
      RC_ASSERT(mark.s >= last);
      RC_ASSERT(mark.s <= geometry::length(piece.curve));
      last = mark.s;
      lines.push_back(base::number(mark.line));
    }
  }
  return lines;
}

RC_GTEST_PROP(Smoother, NamesLinesInOrder, ()) {
  const std::vector<std::int64_t> lines = lines_of(pieces_of(random_program().moves));
  RC_ASSERT(std::is_sorted(lines.begin(), lines.end()));
}

/// A wave of lines of this length.
Program wave(double chord, double tolerance, double cam_tolerance) {
  Program program;
  program.tolerance = tolerance;
  program.cam_tolerance = cam_tolerance;
  double x = 0;
  for (int k = 0; k < 200; ++k) {
    x += chord / std::hypot(1, std::cos(x));
    program.line_to({x, std::sin(x)});
  }
  return program;
}

TEST(Smoother, NamesEveryLineOfAWave) {
  for (const double chord : {0.05, 0.3, 1.0}) {
    std::vector<std::int64_t> lines = lines_of(pieces_of(wave(chord, 0.01, 0.01).moves));
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    ASSERT_EQ(lines.size(), 200u) << chord;
    for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_EQ(lines[i], static_cast<std::int64_t>(i) + 1);
  }
}

TEST(Smoother, NamesBothLinesOfACorner) {
  Program program;
  program.tolerance = program.cam_tolerance = 0.01;
  program.line_to({10});
  program.line_to({10, 10});
  const std::vector<Piece> pieces = pieces_of(program.moves);
  ASSERT_EQ(pieces.size(), 3u);
  const double length = geometry::length(pieces[1].curve);
  EXPECT_EQ(base::number(pieces[1].line_at(0.49 * length)), 1);
  EXPECT_EQ(base::number(pieces[1].line_at(0.51 * length)), 2);
}

/// Lines of 1 mm that are one, up to a corner and from it on: the blend takes the place of some.
TEST(Smoother, NamesEveryLineThatABlendTakesThePlaceOf) {
  Program program;
  program.tolerance = program.cam_tolerance = 1;
  for (int k = 1; k <= 20; ++k) program.line_to({1.0 * k});
  for (int k = 1; k <= 20; ++k) program.line_to({20, 1.0 * k});
  std::vector<std::int64_t> lines = lines_of(pieces_of(program.moves));
  EXPECT_TRUE(std::is_sorted(lines.begin(), lines.end()));
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  EXPECT_EQ(lines.size(), 40u);
}

/// Each half of the blend at the feed of its line.
TEST(Smoother, ChangesTheFeedInTheMiddleOfACorner) {
  Program program;
  program.tolerance = program.cam_tolerance = 0.1;
  program.line_to({10});
  program.line_to({10, 10});
  program.moves.back().feed.value = 5 * program.moves.front().feed.value;
  const std::vector<Piece> pieces = pieces_of(program.moves);
  ASSERT_EQ(pieces.size(), 4u);
  EXPECT_EQ(pieces[1].feed, program.moves.front().feed.value);
  EXPECT_EQ(pieces[2].feed, program.moves.back().feed.value);
  EXPECT_EQ(base::number(pieces[1].last_line()), 1);
  EXPECT_EQ(base::number(pieces[2].line), 2);
  EXPECT_NEAR(geometry::length(pieces[1].curve), geometry::length(pieces[2].curve), 1e-6);
  EXPECT_EQ(geometry::end(pieces[1].curve), geometry::start(pieces[2].curve));
}

TEST(Smoother, NamesLinesWhereTheyWereProgrammed) {
  const Program program = wave(0.3, 0.01, 0.01);
  for (const Piece& piece : pieces_of(program.moves)) {
    if (!piece.lines) continue;
    for (const LineMark& mark : *piece.lines) {
      const Point& begin = program.moves[static_cast<std::size_t>(base::number(mark.line)) - 1].start;
      EXPECT_LE(distance(geometry::evaluate(piece.curve, mark.s), begin), 0.01);
    }
  }
}

TEST(Smoother, ChangesTheFeedWhereItWasProgrammed) {
  Program program = wave(0.1, 0.01, 0.01);
  for (Move& move : program.moves) move.feed.value = line_number(move) <= 100 ? 50 : line_number(move) <= 150 ? 80 : 20;
  std::vector<double> feeds;
  const Piece* last = nullptr;
  const std::vector<Piece> pieces = pieces_of(program.moves);
  for (const Piece& piece : pieces) {
    if (last && piece.feed != last->feed) {
      const std::size_t line = piece.feed == 80 ? 101 : 151;
      EXPECT_LE(distance(geometry::start(piece.curve), program.moves[line - 1].start), 0.01);
      EXPECT_EQ(piece.line, program.moves[line - 1].line);
    }
    if (feeds.empty() || feeds.back() != piece.feed) feeds.push_back(piece.feed);
    last = &piece;
  }
  EXPECT_EQ(feeds, (std::vector<double>{50, 80, 20}));
}

/// 0.02 mm at 50 mm/s is 0.4 ms.
TEST(Smoother, HoldsTheLeastOfFeedsThatFollowEachOtherAtOnce) {
  Program program = wave(0.02, 0.01, 0.01);
  const std::vector<Piece> at_one_feed = pieces_of(program.moves);
  for (Move& move : program.moves) move.feed.value = line_number(move) % 2 == 0 ? 49 : 50;
  const std::vector<Piece> pieces = pieces_of(program.moves);
  ASSERT_EQ(pieces.size(), at_one_feed.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    EXPECT_EQ(pieces[i].feed, 49);
    EXPECT_EQ(lines_of({pieces[i]}), lines_of({at_one_feed[i]}));
  }
}

TEST(Smoother, HoldsTheFeedOfAShortLineNoLongerThanSpeedTakesToChange) {
  Program program = wave(0.02, 0.01, 0.01);
  program.moves[99].feed.value = 20;
  double slow = 0;
  for (const Piece& piece : pieces_of(program.moves)) {
    if (piece.feed != 50) {
      EXPECT_EQ(piece.feed, 20);
      slow += geometry::length(piece.curve);
    }
  }
  EXPECT_GE(slow, 0.02 * (1 - 1e-3));
  EXPECT_LE(slow, 0.02 + 0.002 * 20);
}

RC_GTEST_PROP(Smoother, IsNoFasterThanTheLinesItNames, ()) {
  Program program = random_program();
  const int share = any(2, 8);
  for (Move& move : program.moves) move.feed.value = any(0, share) == 0 ? any(1, 40) : 60;
  for (const Piece& piece : pieces_of(program.moves)) {
    for (const std::int64_t line : lines_of({piece}))
      RC_ASSERT(piece.feed <= program.moves[static_cast<std::size_t>(line) - 1].feed.value);
  }
}

RC_GTEST_PROP(Smoother, EndsExactlyWhereTheProgramWaits, ()) {
  Program program;
  for (const Move& move : random_program().moves) {
    if (move.kind != Move::Kind::line) continue;
    program.line_to(move.end);
    const int kind = any(0, 10);
    if (kind == 0) program.dwell();
    if (kind == 1) program.event();
  }
  const Point* here = nullptr;
  std::size_t next = 0;
  for (const Element& element : path_of(program.moves)) {
    if (const auto* piece = std::get_if<Piece>(&element)) {
      here = &geometry::end(piece->curve);
      continue;
    }
    while (program.moves[next].kind == Move::Kind::line) ++next;
    const Move& waits = program.moves[next++];
    RC_ASSERT(here && *here == waits.start);
    if (const auto* dwell = std::get_if<Dwell>(&element)) {
      RC_ASSERT(dwell->position == waits.start);
      RC_ASSERT(dwell->line == waits.line);
    } else {
      RC_ASSERT(std::get<base::Event>(element) == waits.event);
    }
  }
  while (next < program.moves.size()) RC_ASSERT(program.moves[next++].kind == Move::Kind::line);
}

bool same(const Piece& a, const Piece& b) {
  const double length = geometry::length(a.curve);
  if (a.curve.index() != b.curve.index() || length != geometry::length(b.curve)) return false;
  for (int k = 0; k <= 10; ++k) {
    if (geometry::evaluate(a.curve, length * k / 10) != geometry::evaluate(b.curve, length * k / 10)) return false;
  }
  return a.feed == b.feed && a.stop == b.stop && lines_of({a}) == lines_of({b});
}

RC_GTEST_PROP(Smoother, IsTheSameWheneverItIsAsked, ()) {
  const Program program = random_program();
  const std::vector<Element> early = path_of(program.moves, Popping::after_each), late = path_of(program.moves);
  RC_ASSERT(early.size() == late.size());
  for (std::size_t i = 0; i < early.size(); ++i) RC_ASSERT(same(std::get<Piece>(early[i]), std::get<Piece>(late[i])));
}

TEST(Smoother, LetsGoOfWhatIsBehind) {
  Builder builder;
  std::size_t pieces = 0;
  const Program program = wave(0.5, 0.01, 0.01);
  for (const Move& move : program.moves) {
    builder.push(move);
    while (builder.pop()) ++pieces;
    if (line_number(move) == 150) break;
  }
  EXPECT_GT(pieces, 20u);
}

/// Piece for piece as programmed.
void expect_as_programmed(const Program& program) {
  const std::vector<Piece> pieces = pieces_of(program.moves);
  ASSERT_EQ(pieces.size(), program.moves.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const geometry::Curve curve = toolpath::pieces_of(program.moves[i]).at(0).curve;
    EXPECT_TRUE(same(pieces[i], {curve, program.feed, program.moves[i].line, pieces[i].stop, nullptr}));
    EXPECT_EQ(pieces[i].stop, program.moves[i].path_mode == gcode::PathMode::exact_stop);
  }
}

TEST(Smoother, LeavesExactPathsAlone) {
  for (const gcode::PathMode mode : {gcode::PathMode::exact_path, gcode::PathMode::exact_stop}) {
    Program program = wave(0.3, 0, 0);
    program.arc(program.at[0] + 5, program.at[1], 1);
    for (Move& move : program.moves) move.path_mode = mode;
    expect_as_programmed(program);
  }
}

TEST(Smoother, LeavesPathsAloneBelowTheLeastTolerance) {
  expect_as_programmed(wave(0.3, 1.9e-4, 1.9e-4));
  const std::vector<Piece> pieces = pieces_of(wave(0.3, 2e-4, 2e-4).moves);
  EXPECT_TRUE(std::any_of(pieces.begin(), pieces.end(),
                          [](const Piece& piece) { return std::holds_alternative<geometry::Nurbs>(piece.curve); }));
}

TEST(Smoother, FitsNoLinesWithoutACamTolerance) {
  // Each joint has a blend of its own, between what is left of its lines.
  std::size_t blends = 0, lines = 0;
  for (const Piece& piece : pieces_of(wave(0.3, 0.01, 0).moves)) {
    EXPECT_EQ(piece.lines != nullptr, !std::holds_alternative<geometry::Line>(piece.curve));
    std::holds_alternative<geometry::Line>(piece.curve) ? ++lines : ++blends;
  }
  EXPECT_EQ(blends, 199u);
  EXPECT_LE(lines, 200u);
}

void expect_no_jump(const std::vector<Piece>& pieces) {
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const geometry::Curve &a = pieces[i - 1].curve, &b = pieces[i].curve;
    const geometry::PointJet before = geometry::jets(a, geometry::length(a)), behind = geometry::jets(b, 0);
    for (std::size_t k = 0; k < 3; ++k) {
      RC_ASSERT(std::abs(before[k].first - behind[k].first) <= 1e-6);
      RC_ASSERT(std::abs(before[k].second - behind[k].second) <= 1e-5 * (1 + std::abs(before[k].second)));
    }
  }
}

RC_GTEST_PROP(Smoother, BendsNowhereByAJumpAlongAWave, ()) {
  expect_no_jump(pieces_of(wave(logarithmic(0.01, 0.5), logarithmic(1e-3, 0.1), 0.1).moves));
}

RC_GTEST_PROP(Smoother, BendsNowhereByAJumpWhereTolerancesChange, ()) {
  Program program = wave(logarithmic(0.01, 0.5), 0, 0);
  const double least = logarithmic(1e-3, 0.1);
  for (Move& move : program.moves) {
    move.tolerance = least * logarithmic(1, 5);
    move.naive_cam_tolerance = any(0, 3) == 0 ? move.tolerance : 5 * least;
  }
  expect_no_jump(pieces_of(program.moves));
}

}  // namespace
}  // namespace leadscrew::toolpath::testing
