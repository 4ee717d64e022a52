#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <leadscrew/planner/speed_problem.hpp>
#include <vector>

#include "random_section.hpp"

namespace test_speed_problem {

using namespace leadscrew;
using planner::Knots;
using planner::PlannedRange;
using planner::Section;
using planner::SpeedProblem;
using testing_support::any;

/// Knots from one of these on, as a window has them that begins in motion there, and farther.
Knots gone_on(const Section& section, const machine::Machine& machine, const Knots& before, std::size_t from) {
  PlannedRange range;
  const auto first = static_cast<std::ptrdiff_t>(from);
  range.kept.assign(before.s.begin() + first, before.s.end());
  range.kept_breaks.assign(before.breaks.begin() + first, before.breaks.end());
  range.begin = range.kept.front();
  range.end = section.length();
  range.starts_at_rest = false;
  range.ends_at_rest = true;
  planner::Effort effort;
  return place_knots(section, machine, range, before.intervals + 50, effort);
}

bool are_same(const SpeedProblem& a, const SpeedProblem& b) {
  const auto same_site = [](const SpeedProblem::Site& x, const SpeedProblem::Site& y) {
    return x.interval == y.interval && x.first_block == y.first_block && x.end_block == y.end_block &&
           x.hull == y.hull && x.place == y.place && x.pairs == y.pairs && x.x == y.x;
  };
  const auto same_block = [](const SpeedProblem::Block& x, const SpeedProblem::Block& y) { return x.by == y.by; };
  return std::ranges::equal(a.sites(), b.sites(), same_site) &&
         std::ranges::equal(a.blocks(), b.blocks(), same_block) && a.caps().knots == b.caps().knots &&
         a.caps().middles == b.caps().middles && a.caps().coefficients == b.caps().coefficients &&
         a.inequalities() == b.inequalities() && std::ranges::equal(a.creep(), b.creep());
}

/// What is taken over from the window before is, to the last bit, what would be found again; at another feed it is not taken.
RC_GTEST_PROP(SpeedProblem, IsTheSameWithRowsOfTheWindowBefore, ()) {
  machine::Machine machine = testing_support::random_machine();
  const std::vector<toolpath::Piece> pieces = testing_support::random_path(12);
  testing_support::soften(machine, pieces, 40);
  const Section section = testing_support::section_of(pieces);
  PlannedRange range;
  range.end = section.length();
  planner::Effort effort;
  const auto most = any<std::size_t>(40, 120);
  const Knots knots = place_knots(section, machine, range, most, effort);
  RC_PRE(knots.intervals > 20);
  SpeedProblem before(section, machine, knots, 1);
  before.settle();
  const Knots next = gone_on(section, machine, knots, any<std::size_t>(1, knots.intervals / 2));
  RC_PRE(next.intervals > 2);
  for (const double feed_factor : {1.0, 0.5})
    RC_ASSERT(are_same({section, machine, next, feed_factor, &before}, {section, machine, next, feed_factor}));
}

}  // namespace test_speed_problem
