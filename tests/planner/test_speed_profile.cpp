#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/planner/rest_to_rest.hpp>
#include <leadscrew/planner/speed_profile.hpp>
#include <leadscrew/planner/time_bound.hpp>
#include <optional>

#include "random_section.hpp"

namespace test_speed_profile {

using namespace leadscrew;
using planner::Knots;
using planner::PlannedRange;
using planner::Section;
using planner::Side;
using planner::SpeedProfile;
using testing_support::any;
using testing_support::line_piece;
using testing_support::section_of;

constexpr std::size_t plenty = 1'000'000;
constexpr double cold = 20;  // first gap, from creep

/// A random section and where its knots lie from rest to rest.
struct Random {
  machine::Machine machine = testing_support::random_machine();
  std::vector<toolpath::Piece> pieces;
  Section section;
  Knots knots;

  Random(int most_pieces, double ramps) {
    pieces = testing_support::random_path(most_pieces);
    testing_support::soften(machine, pieces, ramps);
    section = section_of(pieces);
    knots = placed(section, machine, section.length());
  }
  static Knots placed(const Section& section, const machine::Machine& machine, double end, bool at_rest = true) {
    PlannedRange range;
    range.end = end;
    range.ends_at_rest = at_rest;
    return place_knots(section, machine, range, plenty);
  }
  SpeedProfile profile() const { return {section, machine, knots}; }
};

/// ∫ x^(−1/2) ds from one knot to another, by Simpson's rule; and on a ramp of constant path jerk, x ∝ s^(4/3),
/// 3s₁/√x₁.
double travel_time(const SpeedProfile& profile, std::size_t from, std::size_t to) {
  double time = 0;
  for (std::size_t k = from; k < to; ++k) {
    double sum = 0;
    for (int i = 0; i <= 16; ++i) {
      const double weight = i == 0 || i == 16 ? 1 : (i % 2 == 1 ? 4 : 2);
      sum += weight / std::sqrt(profile.square(k, i / 16.0));
    }
    time += profile.width(k) * sum / 48;
  }
  if (from == 0) time += 3 * profile.knots().start_ramp / std::sqrt(profile.square(0, 0));
  const std::size_t n = profile.intervals();
  if (to == n) time += 3 * profile.knots().end_ramp / std::sqrt(profile.square(n - 1, 1));
  return time;
}
double travel_time(const SpeedProfile& profile) {
  return travel_time(profile, 0, profile.intervals());
}

/// The largest ratio of any limit between knots, from the spline: q̇ = q′√x, q̈ = q″x + q′x′/2,
/// q⃛ = (q‴x + 3q″x′/2 + q′x″/2)√x.
double brute_force_ratio(const SpeedProfile& profile, const Section& section, const machine::Machine& machine) {
  double worst = 0;
  for (std::size_t k = 0; k < profile.intervals(); ++k) {
    for (const double u : {0.02, 0.3, 0.5, 0.7, 0.98}) {
      const double s = profile.knots().s[k] + u * profile.width(k), x = profile.square(k, u);
      const double slope = profile.square_slope(k, u), bend = profile.square_bend(k, u), speed = std::sqrt(x);
      worst = std::max(worst, speed / section.greatest_speed(s, Side::left, section.jets(s, Side::left)));
      const auto jet = section.jets(s, Side::left);
      for (const base::Axis axis : base::all_axes) {
        if (!machine.has(axis)) continue;
        const auto& q = jet[base::index(axis)];
        const machine::AxisLimits& limits = machine.limits(axis);
        const double acceleration = q.second * x + q.first * slope / 2;
        const double jerk = (q.third * x + 1.5 * q.second * slope + q.first * bend / 2) * speed;
        worst = std::max({worst, std::abs(q.first) * speed / limits.velocity,
                          std::abs(acceleration) / limits.acceleration, std::abs(jerk) / limits.jerk});
      }
    }
  }
  return worst;
}

RC_GTEST_PROP(SpeedProfile, CreepsStrictlyInsideEveryLimit, ()) {
  const Random random(12, 60);
  const SpeedProfile profile = random.profile();
  RC_ASSERT(profile.greatest_ratio() < 0.9);
  RC_ASSERT(profile.greatest_ratio() > 0);
  RC_ASSERT(brute_force_ratio(profile, random.section, random.machine) < 1);
  for (std::size_t k = 0; k < profile.intervals(); ++k) RC_ASSERT(profile.square(k, 0.5) > 0);
}

/// Axes a hundred times as slow as their neighbours.
RC_GTEST_PROP(SpeedProfile, CreepsInsideHoweverUnequalTheAxes, ()) {
  Random random(4, 20);
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z, base::Axis::A}) {
    auto& limits = *random.machine.axes[base::index(axis)];
    limits.velocity *= testing_support::logarithmic(0.1, 1);
    const double slower = testing_support::logarithmic(0.01, 1);
    limits.acceleration *= slower;
    limits.jerk *= slower;
  }
  random.knots = Random::placed(random.section, random.machine, random.section.length());
  RC_ASSERT(random.profile().greatest_ratio() < 0.9);
}

RC_GTEST_PROP(SpeedProfile, IsFasterThanCreepAndSlowerThanTheBoundWithoutJerk, ()) {
  const Random random(8, 20);
  SpeedProfile profile = random.profile();
  const double creep = travel_time(profile);
  profile.optimize(cold, 1e-3);
  const double time = travel_time(profile);
  planner::TimeBound bound(random.machine);
  for (const toolpath::Piece& piece : random.pieces) bound.push(piece);
  bound.finish();
  RC_ASSERT(profile.greatest_ratio() <= 1);
  RC_ASSERT(time <= creep);
  RC_ASSERT(time >= bound.seconds() * (1 - 2e-4));
  // Between the rows a little may stick out; what is emitted is looked at and planned again.
  RC_ASSERT(brute_force_ratio(profile, random.section, random.machine) <= 1.02);
  profile.level_cruises();
  RC_ASSERT(profile.greatest_ratio() <= 1 + 1e-12);
  RC_ASSERT(travel_time(profile) <= time * (1 + 1e-12));
}

/// What exceeds limits by little is lowered by so much, and nothing else rises above what it was.
RC_GTEST_PROP(SpeedProfile, MovesInsideAsFarAsItExceedsLimits, ()) {
  const Random random(6, 40);
  SpeedProfile profile = random.profile();
  profile.optimize(cold, 5e-4);
  std::size_t tightest = 3;
  for (std::size_t k = 3; k + 3 < profile.intervals(); ++k) {
    if (profile.margin(k).rows < profile.margin(tightest).rows) tightest = k;
  }
  RC_PRE(profile.intervals() > 6 && profile.margin(tightest).rows < 1.01);
  const double exceeding = 1 + 1e-5 * any(1, 31), before = profile.margin(tightest).rows, time = travel_time(profile);
  const double greatest = profile.greatest_ratio();
  std::vector<planner::Ratios> far(profile.intervals()), near = far;
  far[tightest].rows = 1.5;
  RC_ASSERT(!profile.move_inside(far));
  RC_ASSERT(travel_time(profile) == time);
  near[tightest].rows = exceeding;
  RC_PRE(profile.move_inside(near));
  RC_ASSERT(profile.margin(tightest).rows > before * exceeding);
  RC_ASSERT(profile.greatest_ratio() <= greatest * (1 + 1e-9));
  RC_ASSERT(travel_time(profile) > time);
  RC_ASSERT(travel_time(profile) < 1.02 * time);
}

RC_GTEST_PROP(SpeedProfile, ComesBackFromOptimumToFarInside, ()) {
  const Random random(6, 10);
  SpeedProfile profile = random.profile();
  profile.optimize(cold, 1e-3);
  const double optimum = travel_time(profile);
  const auto tight = any<std::size_t>(0, profile.intervals());
  profile.tighten(tight, {1, 1.001});
  profile.retreat(0.1);
  RC_ASSERT(profile.greatest_ratio() < 1);
  RC_ASSERT(travel_time(profile) > optimum);
  profile.optimize(0.1, 1e-3);
  RC_ASSERT(profile.greatest_ratio() <= 1);
  RC_ASSERT(std::abs(travel_time(profile) / optimum - 1) <= 5e-3);
  const double before = travel_time(profile), factor = any(500, 1000) / 1000.0;
  profile.slow_down(factor);
  RC_ASSERT(std::abs(travel_time(profile) * factor / before - 1) <= 1e-12);
  RC_ASSERT(profile.greatest_ratio() < 1);
}

// ---------------------------------------------------------------------------------------------------------------------

struct Limits {
  double feed, acceleration, jerk;
};
class LineProfile : public testing::TestWithParam<Limits> {};

TEST_P(LineProfile, TakesTheTimeOfTheClosedForm) {
  const auto& [feed, acceleration, jerk] = GetParam();
  machine::Machine machine = machine::mill3();
  for (auto& axis : machine.axes) {
    if (axis) axis->velocity = 500, axis->acceleration = acceleration, axis->jerk = jerk;
  }
  const Section section = section_of({line_piece({}, {10}, feed)});
  SpeedProfile profile(section, machine, Random::placed(section, machine, 10));
  ASSERT_LT(profile.greatest_ratio(), 0.9);
  profile.optimize(cold, 1e-3);
  profile.level_cruises();
  const double optimum = planner::rest_to_rest(10, {feed, acceleration, jerk}).duration();
  EXPECT_GE(travel_time(profile), optimum * (1 - 1e-6));
  EXPECT_LE(travel_time(profile), optimum * (1 + 2e-3));
}

INSTANTIATE_TEST_SUITE_P(Sets, LineProfile,
                         testing::Values(Limits{100, 1000, 20000}, Limits{100, 200, 5000}, Limits{10, 1000, 20000},
                                         Limits{10, 200, 5000}, Limits{200, 5000, 2e5}, Limits{100, 1000, 1e5},
                                         Limits{300, 3000, 1e4}, Limits{1, 1000, 20000}, Limits{50, 100, 300},
                                         // The jerk of rest to rest alone; acceleration reached, speed not.
                                         Limits{400, 1e5, 1e4}, Limits{400, 100, 1e5}));

/// The same line in pieces, in a direction of several axes: the axis that limits, limits along the path.
RC_GTEST_PROP(SpeedProfile, OfALineIsTheClosedForm, ()) {
  machine::Machine machine = testing_support::random_machine();
  std::vector<toolpath::Piece> pieces = testing_support::collinear_lines(6);
  for (toolpath::Piece& piece : pieces) piece.feed = pieces[0].feed;
  testing_support::soften(machine, pieces, 15);
  const Section section = section_of(pieces);
  SpeedProfile profile(section, machine, Random::placed(section, machine, section.length()));
  profile.optimize(cold, 1e-3);
  profile.level_cruises();
  const auto jet = section.jets(0, Side::right);
  const machine::Derivatives limits = planner::tangent_limits(jet, machine);
  const double speed = std::sqrt(constraints::Constraints(machine).greatest_square({jet, pieces[0].feed}));
  const double optimum = planner::rest_to_rest(section.length(), {speed, limits.acceleration, limits.jerk}).duration();
  RC_ASSERT(travel_time(profile) >= optimum * (1 - 1e-6));
  RC_ASSERT(travel_time(profile) <= optimum * (1 + 2e-3));
}

// ---------------------------------------------------------------------------------------------------------------------

double stop_time(const SpeedProfile& profile, const Section& section, const machine::Machine& machine, std::size_t k) {
  const auto limits = planner::tangent_limits(section.jets(profile.knots().s[k], Side::right), machine);
  const double v = std::sqrt(profile.square(k, 0)), a = limits.acceleration, j = limits.jerk;
  return v > a * a / j ? v / a + a / j : 2 * std::sqrt(v / j);
}

/// A window that ends in motion, and from one of its knots another, on which the whole of the section is known.
struct InTwo {
  std::size_t split = 0;
  double ahead = 0;                          ///< times to stop between the split and the first window's end
  double first_ratio = 0, second_ratio = 0;  ///< as each begins
  double joint = 0;                          ///< largest difference of x, x′, x″ where they meet, relative
  double time = 0;
  bool made = false;
};

InTwo in_two(const Random& random, double share_known, double share_split, bool levels) {
  InTwo two;
  Knots knots = Random::placed(random.section, random.machine, random.section.length() * share_known, false);
  if (knots.intervals < 12) return two;
  SpeedProfile first(random.section, random.machine, std::move(knots));
  two.first_ratio = first.greatest_ratio();
  first.optimize(cold, 3e-5);
  if (levels) first.level_cruises();
  const std::size_t n = first.intervals(),
                    k = two.split = 1 + static_cast<std::size_t>(share_split * static_cast<double>(n - 3));
  if (!first.continuation(k)) first.unlevel();
  const double first_time = travel_time(first, 0, k);
  two.ahead = travel_time(first, k, n) / stop_time(first, random.section, random.machine, k);
  PlannedRange range;
  range.begin = first.knots().s[k];
  range.end = random.section.length();
  range.starts_at_rest = false;
  range.kept.assign(first.knots().s.begin() + static_cast<std::ptrdiff_t>(k), first.knots().s.end());
  range.kept_breaks.assign(first.knots().breaks.begin() + static_cast<std::ptrdiff_t>(k), first.knots().breaks.end());
  const std::optional<planner::Continuation> after = first.continuation(k);
  if (!after) return two;  // not made
  SpeedProfile second(random.section, random.machine, place_knots(random.section, random.machine, range, plenty),
                      *after);
  two.second_ratio = second.greatest_ratio();
  const double x = first.square(k, 0), h = std::min(first.width(k), second.width(0));
  two.joint =
      std::max({std::abs(second.square(0, 0) - x), std::abs(second.square_slope(0, 0) - first.square_slope(k, 0)) * h,
                std::abs(second.square_bend(0, 0) - first.square_bend(k, 0)) * h * h}) /
      x;
  second.optimize(0.3, 3e-5);
  two.time = first_time + travel_time(second);
  two.made = second.greatest_ratio() <= 1;
  return two;
}

RC_GTEST_PROP(SpeedProfile, GoesOnStrictlyInsideFromAnyInterval, ()) {
  const Random random(8, 40);
  const InTwo two = in_two(random, any(300, 999) / 1000.0, any(0, 1000) / 1000.0, any(0, 2) == 0);
  if (two.split == 0) return;
  RC_ASSERT(two.first_ratio < 0.9);
  RC_ASSERT(two.second_ratio < 1);
  RC_ASSERT(two.joint <= 1e-9);
  RC_ASSERT(two.made);
}

/// From any place of an interval and on more knots, x(s) is as it was as far as it must stay.
RC_GTEST_PROP(SpeedProfile, GoesOnInTheSameWayOnMoreKnots, ()) {
  const Random random(8, 40);
  SpeedProfile first = random.profile();
  first.optimize(cold, 1e-3);
  const std::size_t n = first.intervals();
  const auto k = any<std::size_t>(1, n - 2);
  const double u = any(0, 3) == 0 ? 0.0 : any(0, 1000) / 1000.0;
  const std::optional<planner::Continuation> after = first.continuation(k, u);
  RC_ASSERT(after.has_value());
  RC_ASSERT(!first.continuation(n, u).has_value());
  planner::Knots knots{after->s, after->breaks, n - k, 0, after->end_ramp};
  for (int count = any(0, 20); count > 0 && n - k > 12; --count) {
    const auto at = any<std::size_t>(0, knots.intervals - 10);
    const double s = knots.s[at] + (knots.s[at + 1] - knots.s[at]) * any(100, 900) / 1000.0;
    knots.s.insert(knots.s.begin() + static_cast<std::ptrdiff_t>(at) + 1, s);
    knots.breaks.insert(knots.breaks.begin() + static_cast<std::ptrdiff_t>(at) + 1, false);
    ++knots.intervals;
  }
  const SpeedProfile second(random.section, random.machine, knots, *after);
  std::size_t of_first = k;
  for (std::size_t i = 0; i < second.intervals(); ++i) {
    for (const double share : {0.0, 0.3, 0.5, 0.9}) {
      const double s = second.knots().s[i] + share * second.width(i);
      while (of_first + 1 < n && s >= first.knots().s[of_first + 1]) ++of_first;
      const double place = (s - first.knots().s[of_first]) / first.width(of_first);
      const double x = first.square(of_first, place);
      const double rounded = 1e-15 * random.section.length() * std::abs(first.square_slope(of_first, place));
      RC_ASSERT(std::abs(second.square(i, share) - x) <= 1e-9 * x + rounded);
    }
  }
}

/// With four and a half times to stop ahead of the split, what was not known cost nothing.
RC_GTEST_PROP(SpeedProfile, LosesLittleInWindows, ()) {
  const Random random(8, 40);
  const InTwo two = in_two(random, any(600, 999) / 1000.0, any(50, 600) / 1000.0, false);
  if (two.split == 0 || two.ahead < 4.5) return;
  SpeedProfile whole = random.profile();
  whole.optimize(cold, 3e-5);
  RC_LOG() << "loses " << two.time / travel_time(whole) - 1 << " with " << two.ahead << " ahead\n";
  RC_ASSERT(two.time <= travel_time(whole) * (1 + 5e-4));
}

}  // namespace test_speed_profile
