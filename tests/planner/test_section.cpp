#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/planner/section.hpp>
#include <planned.hpp>

namespace test_section {

using namespace leadscrew;
using planner::Section;
using planner::Side;
using testing_support::arc_piece;
using testing_support::line_piece;
using toolpath::Piece;

/// Pieces in order, each beginning where the one before ends, no two with the same feed.
std::vector<Piece> random_pieces() {
  std::vector<Piece> pieces;
  geometry::Point at{};
  for (int k = *rc::gen::inRange(1, 12); k > 0; --k) {
    const double feed = 10 + k;
    if (*rc::gen::arbitrary<bool>()) {
      const double radius = *rc::gen::inRange(1, 20000) / 1000.0;
      pieces.push_back(arc_piece(at, at[0] + radius, at[1], *rc::gen::inRange(1, 6000) / 1000.0, feed, k));
    } else {
      geometry::Point to = at;
      to[0] += *rc::gen::inRange(1, 20000) / 1000.0;
      to[2] += *rc::gen::inRange(-20000, 20001) / 1000.0;
      pieces.push_back(line_piece(at, to, feed, k));
    }
    at = geometry::end(pieces.back().curve);
  }
  return pieces;
}

Section section_of(const std::vector<Piece>& pieces) {
  Section section;
  for (const Piece& piece : pieces) section.append(piece);
  return section;
}

RC_GTEST_PROP(Section, LaysPiecesEndToEnd, ()) {
  const std::vector<Piece> pieces = random_pieces();
  const Section section = section_of(pieces);
  RC_ASSERT(section.size() == pieces.size() && !section.empty());
  long double sum = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    RC_ASSERT(std::abs(section.offset(k) - sum) <= 1e-15L * static_cast<long double>(k + 1) * sum);
    RC_ASSERT(section.piece(k).line == pieces[k].line);
    sum += geometry::length(pieces[k].curve);
  }
  RC_ASSERT(section.length() == section.offset(pieces.size()));
  RC_ASSERT(std::abs(section.length() - sum) <= 2e-15L * static_cast<long double>(pieces.size()) * sum);
}

RC_GTEST_PROP(Section, KnowsThePieceOnEitherSideOfABorder, ()) {
  const std::vector<Piece> pieces = random_pieces();
  const Section section = section_of(pieces);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const double begin = section.offset(k), end = section.offset(k + 1);
    RC_ASSERT(section.piece_at(begin, Side::right) == k);
    RC_ASSERT(section.piece_at(begin, Side::left) == (k == 0 ? 0 : k - 1));
    RC_ASSERT(section.piece_at(end, Side::left) == k);
    RC_ASSERT(section.greatest_speed(begin, Side::right, section.jets(begin, Side::right)) == pieces[k].feed);
    RC_ASSERT(section.greatest_speed(end, Side::left, section.jets(end, Side::left)) == pieces[k].feed);
    for (const Side side : {Side::left, Side::right}) RC_ASSERT(section.piece_at((begin + end) / 2, side) == k);
  }
  RC_ASSERT(section.piece_at(section.length(), Side::right) == pieces.size() - 1);
}

RC_GTEST_PROP(Section, SeesEachSidesDerivativesAtABorder, ()) {
  const std::vector<Piece> pieces = random_pieces();
  const Section section = section_of(pieces);
  const auto agree = [](const geometry::PointJet& a, const geometry::PointJet& b) {
    // Where one axis has nothing of a derivative another may have much, which turns into it.
    double second = 0, third = 0;
    for (const numeric::Jet<>& q : b) second += std::abs(q.second), third += std::abs(q.third);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double size = 1e-9;
      RC_ASSERT(std::abs(a[i].value - b[i].value) <= size);
      RC_ASSERT(std::abs(a[i].first - b[i].first) <= size);
      RC_ASSERT(std::abs(a[i].second - b[i].second) <= size * (1 + second));
      RC_ASSERT(std::abs(a[i].third - b[i].third) <= size * (1 + third + second));
    }
  };
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const geometry::Curve& curve = pieces[k].curve;
    agree(section.jets(section.offset(k), Side::right), geometry::jets(curve, 0));
    agree(section.jets(section.offset(k + 1), Side::left), geometry::jets(curve, geometry::length(curve)));
  }
}

RC_GTEST_PROP(Section, ForgetsWhatEndsBeforeAPlace, ()) {
  const std::vector<Piece> pieces = random_pieces();
  const Section whole = section_of(pieces);
  const double s = whole.length() * *rc::gen::inRange(0, 1001) / 1000.0;
  Section rest = whole;
  const double shift = rest.forget_before(s);
  RC_ASSERT(shift <= s);
  RC_ASSERT(rest.offset(0) == 0);
  const std::size_t gone = pieces.size() - rest.size();
  RC_ASSERT(shift == whole.offset(gone));
  RC_ASSERT(gone + 1 == pieces.size() || whole.offset(gone + 1) > s);  // and no more than that could have gone
  for (std::size_t k = 0; k < rest.size(); ++k) RC_ASSERT(rest.piece(k).line == pieces[gone + k].line);
  RC_ASSERT(std::abs(rest.length() + shift - whole.length()) <= 1e-14 * whole.length());
  const double place = s + (whole.length() - s) * *rc::gen::inRange(1, 1000) / 1000.0;
  const geometry::PointJet before = whole.jets(place, Side::left), after = rest.jets(place - shift, Side::left);
  const double rounding = 1e-13 * whole.length();
  for (std::size_t i = 0; i < before.size(); ++i) {
    RC_ASSERT(std::abs(before[i].value - after[i].value) <= 2 * rounding);
    RC_ASSERT(std::abs(before[i].first - after[i].first) <= rounding * (1 + std::abs(before[i].second)) * 1e3);
  }
}

TEST(Section, ForgetsNothingOfThePieceItIsOn) {
  Section section = section_of({line_piece({}, {10}, 1), line_piece({10}, {30}, 2), line_piece({30}, {60}, 3)});
  EXPECT_EQ(section.forget_before(9.999), 0);
  EXPECT_EQ(section.size(), 3u);
  EXPECT_EQ(section.forget_before(10), 10);
  EXPECT_EQ(section.size(), 2u);
  EXPECT_EQ(section.length(), 50);
  section.append(line_piece({60}, {61}, 4));
  EXPECT_EQ(section.offset(2), 50);
  EXPECT_EQ(section.forget_before(50), 50);
  EXPECT_EQ(section.greatest_speed(0.5, Side::left, section.jets(0.5, Side::left)), 4);
  EXPECT_EQ(section.forget_before(1), 0);  // the last piece stays
  section.clear();
  EXPECT_TRUE(section.empty());
  EXPECT_EQ(section.length(), 0);
}

// ---------------------------------------------------------------------------------------------------------------------

bool runs_through(const Piece& from, const Piece& to, double speed, const machine::Machine& machine) {
  return planner::runs_through(geometry::jets(from.curve, geometry::length(from.curve)), geometry::jets(to.curve, 0),
                               speed, machine);
}

RC_GTEST_PROP(RunsThrough, CollinearLines, ()) {
  geometry::Point a{}, b{}, c{};
  for (const std::size_t i : {0, 1, 2}) {
    a[i] = *rc::gen::inRange(-400000, 400001) / 1000.0;
    b[i] = a[i] + *rc::gen::inRange(1000, 100001) / 1000.0;
  }
  // As a program says it: the middle rounded to a double, not to a thousandth.
  const double share = *rc::gen::inRange(100, 901) / 1000.0;
  for (const std::size_t i : {0, 1, 2}) c[i] = a[i] + share * (b[i] - a[i]);
  RC_ASSERT(runs_through(line_piece(a, c, 100), line_piece(c, b, 100), 100, machine::mill3()));
}

RC_GTEST_PROP(RunsThrough, PiecesOfOneCircle, ()) {
  const double radius = *rc::gen::inRange(100, 100000) / 1000.0;
  const double first = *rc::gen::inRange(10, 3000) / 1000.0, second = *rc::gen::inRange(10, 3000) / 1000.0;
  const Piece one = arc_piece({radius}, 0, 0, first, 100);
  const Piece other = arc_piece(geometry::end(one.curve), 0, 0, second, 100);
  RC_ASSERT(runs_through(one, other, 100, machine::mill3()));
  const Piece back = arc_piece(geometry::end(one.curve), 0, 0, -second, 100);
  RC_ASSERT(!runs_through(one, back, 100, machine::mill3()));
}

TEST(RunsThrough, NoCornerNorReversal) {
  const machine::Machine machine = machine::mill3();
  EXPECT_FALSE(runs_through(line_piece({}, {10}, 100), line_piece({10}, {10, 10}, 100), 100, machine));
  EXPECT_FALSE(runs_through(line_piece({}, {10}, 100), line_piece({10}, {}, 100), 100, machine));
  EXPECT_FALSE(runs_through(line_piece({}, {10}, 100), line_piece({10}, {20, 0.001}, 100), 100, machine));
}

TEST(RunsThrough, NoStepOfCurvature) {
  const machine::Machine machine = machine::mill3();
  const Piece line = line_piece({}, {10}, 100), arc = arc_piece({10}, 10, 20, 1, 100);
  EXPECT_FALSE(runs_through(line, arc, 100, machine));
  EXPECT_FALSE(runs_through(arc_piece({10}, 10, 20, 1, 100), arc_piece({10}, 10, -20, -1, 100), 100, machine));
}

/// What words show of a step Δq′ or Δq″ over one period is a jerk of Δq′ v/T² or Δq″ v²/T: a ten-thousandth of the
/// limit passes, and so it scales with speed, period, jerk and the axis' own limit.
RC_GTEST_PROP(RunsThrough, StepsThatWordsDoNotShow, ()) {
  machine::Machine machine = machine::mill3();
  machine.period = {*rc::gen::element<std::int64_t>(10'000, 250'000, 1'000'000, 20'000'000)};
  const std::size_t i = *rc::gen::inRange<std::size_t>(0, 3);
  machine.axes[i]->jerk = *rc::gen::element(500.0, 20000.0, 3e6);
  const double speed = *rc::gen::inRange(1, 3000) / 10.0, period = machine.period.seconds();
  const bool of_direction = *rc::gen::arbitrary<bool>();
  const double greatest =
      1e-4 * machine.axes[i]->jerk * (of_direction ? period * period / speed : period / (speed * speed));
  geometry::PointJet leaving{}, entering{};
  const auto passes = [&](double step) {
    entering = leaving;
    (of_direction ? entering[i].first : entering[i].second) = step;
    return planner::runs_through(leaving, entering, speed, machine) &&
           planner::runs_through(entering, leaving, speed, machine);
  };
  RC_ASSERT(passes(greatest * 0.999));
  RC_ASSERT(!passes(greatest * 1.001));
  RC_ASSERT(passes(-greatest * 0.999));
  RC_ASSERT(!passes(-greatest * 1.001));
}

TEST(RunsThrough, AnAxisTheMachineLacksIfItStands) {
  // A, B, C are not there to be asked for limits.
  EXPECT_TRUE(planner::runs_through({}, {}, 100, machine::mill3()));
}

}  // namespace test_section
