#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/planner/knots.hpp>

#include "random_section.hpp"

namespace test_knots {

using namespace leadscrew;
using planner::Knots;
using planner::PlannedRange;
using planner::Section;
using testing_support::any;
using testing_support::line_piece;
using testing_support::section_of;

constexpr std::size_t plenty = 1'000'000;

struct Placed {
  machine::Machine machine;
  std::vector<toolpath::Piece> pieces;
  Section section;
  PlannedRange range;
  Knots knots;
};

Placed random_placement(std::size_t most = plenty) {
  Placed placed;
  placed.machine = testing_support::random_machine();
  placed.pieces = testing_support::random_path(8);
  testing_support::soften(placed.machine, placed.pieces, 60);
  placed.section = section_of(placed.pieces);
  placed.range.end = placed.section.length();
  placed.knots = place_knots(placed.section, placed.machine, placed.range, most);
  return placed;
}

void increase(const Knots& knots) {
  RC_ASSERT(knots.s.size() == knots.breaks.size());
  RC_ASSERT(knots.intervals + 1 <= knots.s.size());
  for (std::size_t k = 1; k < knots.s.size(); ++k) RC_ASSERT(knots.s[k - 1] < knots.s[k]);
}

double width(const Knots& knots, std::size_t k) {
  return knots.s[k + 1] - knots.s[k];
}

RC_GTEST_PROP(Knots, IncreaseFromRampToRamp, ()) {
  const Placed placed = random_placement();
  const Knots& knots = placed.knots;
  increase(knots);
  RC_ASSERT(knots.intervals + 1 == knots.s.size());
  RC_ASSERT(knots.start_ramp > 0 && knots.end_ramp > 0);
  RC_ASSERT(knots.s.front() == placed.range.begin + knots.start_ramp);
  RC_ASSERT(knots.s.back() == placed.range.end - knots.end_ramp);
  RC_ASSERT(!knots.breaks.front() && !knots.breaks.back());
}

/// A part of a section, from rest to rest.
RC_GTEST_PROP(Knots, LieWhereTheyAreAskedFor, ()) {
  Placed placed = random_placement();
  const double length = placed.section.length();
  placed.range.begin = length * any(0, 400) / 1000.0;
  placed.range.end = length * any(600, 1001) / 1000.0;
  const Knots knots = place_knots(placed.section, placed.machine, placed.range, plenty);
  increase(knots);
  RC_ASSERT(knots.s.front() == placed.range.begin + knots.start_ramp);
  RC_ASSERT(knots.s.back() == placed.range.end - knots.end_ramp);
}

/// What t₁ is short for: the ramp of constant path jerk ends long before any acceleration is reached.
RC_GTEST_PROP(Knots, LeaveRestByAShortRamp, ()) {
  const Placed placed = random_placement();
  const auto jet = placed.section.jets(0, planner::Side::right);
  const machine::Derivatives limits = planner::tangent_limits(jet, placed.machine);
  const double distance = 6 * placed.knots.start_ramp, j = limits.jerk, a = limits.acceleration;
  const double time = std::max(std::cbrt(distance / j), std::sqrt(distance / a));
  const double rise = std::sqrt((placed.range.end - placed.range.begin) / a);
  RC_ASSERT(time <= 0.0101 * std::max(a / j, 0.02 * rise));
  double bend = 0;
  for (const auto& q : jet) bend += q.second * q.second;
  RC_ASSERT(placed.knots.start_ramp * std::sqrt(bend) <= 1e-3);
}

/// Does q‴ step there by more than a five-hundredth of an axis' jerk, as fast as motion may be?
bool is_noticed(const Placed& placed, const toolpath::Piece& piece, double s) {
  const constraints::Constraints constraints(placed.machine);
  const geometry::PointJet left = planner::one_sided_jets(piece.axes(), s, planner::Side::left),
                           right = planner::one_sided_jets(piece.axes(), s, planner::Side::right);
  const double square = constraints.greatest_square({left, piece.greatest_speed(s, left)});
  for (const base::Axis axis : base::all_axes) {
    if (!placed.machine.has(axis)) continue;
    const std::size_t i = base::index(axis);
    const double step = std::abs(right[i].third - left[i].third) * square * std::sqrt(square);
    if (step > 0.00201 * placed.machine.limits(axis).jerk) return true;
  }
  return false;
}

/// Ends of pieces that differ in feed, and knots of splines where jerk notices them, unless two lie within rounding of each other.
RC_GTEST_PROP(Knots, LieOnBreaks, ()) {
  const Placed placed = random_placement();
  const Knots& knots = placed.knots;
  std::vector<double> breaks;
  for (std::size_t p = 0; p < placed.section.size(); ++p) {
    const toolpath::Piece& piece = placed.section.piece(p);
    for (const double s : geometry::breaks(piece.curve)) {
      if (is_noticed(placed, piece, s)) breaks.push_back(placed.section.offset(p) + s);
    }
    if (p + 1 < placed.section.size() && piece.feed != placed.section.piece(p + 1).feed) {
      breaks.push_back(placed.section.offset(p + 1));
    }
  }
  for (const double s : breaks) {
    if (s <= knots.s.front() || s >= knots.s.back()) continue;
    const auto after = std::lower_bound(knots.s.begin(), knots.s.end(), s);
    const auto k = static_cast<std::size_t>(after - knots.s.begin());
    const double gap = width(knots, std::max<std::size_t>(k, 1) - 1);
    const bool here = knots.breaks[k] && knots.s[k] - s <= 1e-4 * gap;
    const bool before = k > 0 && knots.breaks[k - 1] && s - knots.s[k - 1] <= 1e-4 * gap;
    RC_ASSERT(here || before || k + 1 == knots.s.size());
  }
}

/// |dh/ds| ≤ 1/4 lets an interval be e^(1/4) = 1.28 times its neighbour. A whole number of intervals between breaks
/// makes all of them narrower by up to a half: by that where one and a bit becomes two.
RC_GTEST_PROP(Knots, AreGraded, ()) {
  const Knots knots = random_placement().knots;
  for (std::size_t k = 0; k + 2 < knots.s.size(); ++k) {
    const double ratio =
        std::max(width(knots, k), width(knots, k + 1)) / std::min(width(knots, k), width(knots, k + 1));
    RC_ASSERT(ratio <= (knots.breaks[k + 1] ? 2.6 : 1.35));
  }
}

RC_GTEST_PROP(Knots, AreGradedTowardsRest, ()) {
  const Placed placed = random_placement();
  const Knots& knots = placed.knots;
  for (std::size_t k = 0; k < knots.intervals; ++k) {
    RC_ASSERT(width(knots, k) <= 0.3 * (knots.s[k] - placed.range.begin));
    RC_ASSERT(width(knots, k) <= 0.3 * (placed.range.end - knots.s[k + 1]));
  }
}

RC_GTEST_PROP(Knots, AreNarrowWherePathTurns, ()) {
  Placed placed;
  placed.machine = testing_support::random_machine();
  placed.pieces = testing_support::parts_of_a_helix(8);
  testing_support::soften(placed.machine, placed.pieces, 60);
  placed.section = section_of(placed.pieces);
  placed.range.end = placed.section.length();
  const Knots knots = place_knots(placed.section, placed.machine, placed.range, plenty);
  double bend = 0;
  for (const auto& q : placed.section.jets(0, planner::Side::right)) bend += q.second * q.second;
  for (std::size_t k = 0; k < knots.intervals; ++k) RC_ASSERT(width(knots, k) * std::sqrt(bend) <= 0.0801);
}

RC_GTEST_PROP(Knots, AreNoMoreThanAskedFor, ()) {
  const Placed placed = random_placement();
  const auto most = static_cast<std::size_t>(any(20, 300));
  const Knots knots = place_knots(placed.section, placed.machine, placed.range, most);
  increase(knots);
  // As many more as it takes to come to rest are allowed where that is the end.
  constexpr std::size_t to_rest = 100;
  const bool all = placed.knots.intervals < most + to_rest;
  RC_ASSERT((knots.end_ramp > 0) == all);
  RC_ASSERT(knots.intervals <= (all ? most + to_rest : most));
  if (all) {
    RC_ASSERT(knots.s == placed.knots.s);
    return;
  }
  // It ends in motion, with three knots to go on with, and before the end by some of the stopping distance.
  RC_ASSERT(knots.s.size() == knots.intervals + 4);
  RC_ASSERT(knots.s.back() < placed.range.end);
  // As those of the whole stretch; what is not known shifts them by less than their distance.
  for (std::size_t k = 1; k < knots.s.size(); ++k) {
    RC_ASSERT(knots.s[k] > placed.knots.s[k - 1]);
    RC_ASSERT(knots.s[k] < placed.knots.s[k + 1]);
  }
}

RC_GTEST_PROP(Knots, OfAWindowGoOnWhereTheOneBeforeLeftThem, ()) {
  Placed placed = random_placement();
  placed.range.ends_at_rest = false;
  const double whole = placed.range.end;
  placed.range.end = whole * any(300, 1000) / 1000.0;
  const Knots first = place_knots(placed.section, placed.machine, placed.range, 320);
  increase(first);
  RC_PRE(first.intervals > 3);
  RC_ASSERT(first.end_ramp == 0 && first.s.size() == first.intervals + 4 && first.s.back() <= placed.range.end);
  const auto from = any<std::ptrdiff_t>(1, static_cast<std::ptrdiff_t>(first.intervals));
  PlannedRange next;
  next.kept.assign(first.s.begin() + from, first.s.end());
  next.kept_breaks.assign(first.breaks.begin() + from, first.breaks.end());
  next.begin = next.kept.front();
  next.end = whole;
  next.starts_at_rest = false;
  const Knots second = place_knots(placed.section, placed.machine, next, plenty);
  increase(second);
  RC_ASSERT(second.start_ramp == 0);
  RC_ASSERT(second.s.size() >= next.kept.size());
  RC_ASSERT(std::equal(next.kept.begin(), next.kept.end(), second.s.begin()));
  RC_ASSERT(std::equal(next.kept_breaks.begin(), next.kept_breaks.end() - 1, second.breaks.begin()));
  RC_ASSERT(second.s.back() == whole - second.end_ramp || second.s.size() == next.kept.size());
}

/// What is there may come to rest, by knots that lie ever closer; in a cruise far wider ones would do behind them.
TEST(Knots, GrowApartBehindThoseThatAreThere) {
  machine::Machine machine = machine::mill3();
  const Section section = section_of({line_piece({}, {100}, 1)});
  PlannedRange range;
  range.starts_at_rest = false;
  for (double to_rest = 1; to_rest > 1e-4; to_rest *= 0.9) range.kept.push_back(20 - to_rest);
  range.kept_breaks.assign(range.kept.size(), false);
  range.begin = range.kept.front();
  range.end = 100;
  const Knots knots = place_knots(section, machine, range, plenty);
  increase(knots);
  const std::size_t kept = range.kept.size();
  ASSERT_GT(knots.s.size(), kept + 20);
  for (std::size_t k = kept - 1; k < kept + 20; ++k) EXPECT_LT(width(knots, k), 1.4 * width(knots, k - 1)) << k - kept;
}

TEST(Knots, AreFewInACruise) {
  // A hundred times the length of a ramp: 40 intervals up, 40 down and not 4000 between them.
  machine::Machine machine = machine::mill3();
  const Section section = section_of({line_piece({}, {2000}, 100)});
  PlannedRange range;
  range.end = 2000;
  const Knots knots = place_knots(section, machine, range, plenty);
  EXPECT_LT(knots.intervals, 2200u);
  EXPECT_GT(knots.intervals, 200u);
}

TEST(TangentLimits, AreThoseOfTheAxisThatLimitsFirst) {
  machine::Machine machine = machine::mill3();
  machine.axes[0]->acceleration = 300;
  machine.axes[1]->jerk = 1000;
  const auto jet = geometry::jets(line_piece({}, {3, 4}, 1).curve, 0);
  const machine::Derivatives limits = planner::tangent_limits(jet, machine);
  EXPECT_DOUBLE_EQ(limits.acceleration, 300 / 0.6);
  EXPECT_DOUBLE_EQ(limits.jerk, 1000 / 0.8);
}

}  // namespace test_knots
