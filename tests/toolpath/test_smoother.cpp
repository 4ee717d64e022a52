// Where smoothed paths go: within the tolerance, in one piece, without jumps, and as programmed where that is asked for.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <leadscrew/toolpath/frechet.hpp>

#include "smoothed_programs.hpp"

namespace leadscrew::toolpath::testing {
namespace test_smoother {

/// Places along a curve, in mm, so dense that their chords are off by no more than a few thousandths of the tolerance.
void append_places(Polyline& places, const geometry::Curve& curve, double tolerance) {
  const auto breaks = geometry::breaks(curve);
  std::vector<double> borders{0};
  borders.insert(borders.end(), breaks.begin(), breaks.end());
  borders.push_back(geometry::length(curve));
  int count = 1;
  if (const auto* arc = std::get_if<geometry::Arc>(&curve)) {
    const double angle = std::abs(arc->angle_rate()) * arc->length();
    count = static_cast<int>(std::ceil(angle * std::sqrt(arc->radius() / (0.02 * tolerance))));
  }
  if (std::holds_alternative<geometry::Nurbs>(curve)) count = borders.size() <= 4 ? 120 : 15;
  places.push_back(ToleranceSpace{}.to_millimetres(geometry::start(curve)));
  for (std::size_t i = 1; i < borders.size(); ++i) {
    for (int k = 1; k <= count; ++k) {
      const double s = borders[i - 1] + (borders[i] - borders[i - 1]) * k / count;
      places.push_back(ToleranceSpace{}.to_millimetres(geometry::evaluate(curve, s)));
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

}  // namespace test_smoother
}  // namespace leadscrew::toolpath::testing
