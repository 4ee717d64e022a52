// The interpolators by name: published figures, conventions, registers beside their definitions, what is refused.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/nc/pulse_figures.hpp>
#include <leadscrew/nc/pulse_reason.hpp>
#include <leadscrew/pulse/free_circle.hpp>
#include <numbers>
#include <set>
#include <string>

namespace leadscrew::nc {
namespace test_pulse_methods {

using pulse::Direction;
using pulse::Point;

constexpr auto line = PulseCurve::Shape::line;
constexpr auto arc = PulseCurve::Shape::arc;

constexpr PulseCurve quarter{arc, {5, 0}, {0, 5}, {}, Direction::counterclockwise};

PulseFigures figures_of(PulseMethod method, const PulseCurve& curve, const MethodOptions& options = {}) {
  return measure(PulseRun(method, curve, options), curve);
}

std::int64_t value_of(const PulseRun& run, std::string_view name) {
  const Registers registers = run.registers();
  for (const Register& each : registers.all()) {
    if (each.name == name) return each.value;
  }
  ADD_FAILURE() << "no register " << name;
  return 0;
}

TEST(PulseMethods, GiveTheFpgaTableByDefault) {
  struct Published {
    PulseMethod method;
    std::int64_t clocks, pulses;
    double error;
  };
  for (const auto& [method, clocks, pulses, error] :
       {Published{PulseMethod::point_comparison, 10, 10, 0.877}, Published{PulseMethod::min_error, 7, 7, 0.385},
        Published{PulseMethod::improved_min_error, 7, 7, 0.385}, Published{PulseMethod::dda, 8, 7, 0.385}}) {
    const PulseFigures figures = figures_of(method, quarter);
    EXPECT_EQ(figures.clocks, clocks) << name(method);
    EXPECT_EQ(figures.pulses, pulses) << name(method);
    EXPECT_NEAR(figures.max_error, error, 5e-4) << name(method);
    EXPECT_EQ(figures.end, quarter.end) << name(method);
  }
  EXPECT_NEAR(figures_of(PulseMethod::point_comparison, quarter, {.tie = pulse::OnCircle::inward}).max_error, 1, 1e-12);
  EXPECT_EQ(figures_of(PulseMethod::point_comparison, quarter).worst, (Point{4, 1}));
}

/// (10, 0) in 4 bits: an overflow whenever a sixteenth of 10 a clock adds up to a whole one.
TEST(PulseMethods, DrawALineOf4BitsIn16Clocks) {
  const PulseCurve level{line, {3, 4}, {13, 4}, {}, {}};
  PulseRun run(PulseMethod::dda, level, {.bits = 4});
  for (std::int64_t clock = 1; !run.done(); ++clock) {
    run.step();
    EXPECT_EQ(run.at(), (Point{3 + clock * 10 / 16, 4})) << clock;
    EXPECT_EQ(value_of(run, "rx"), clock * 10 % 16) << clock;
  }
  EXPECT_EQ(run.clock(), 16);
  EXPECT_EQ(run.conventions().capacity, 16);
  EXPECT_EQ(PulseRun(PulseMethod::dda, level).conventions().bits, 4);
}

/// Registers of Koren's hardware: the capacity is that of the longest line, whatever the line.
TEST(PulseMethods, DrawALineInRegistersOfAnyCapacity) {
  const PulseCurve level{line, {3, 4}, {13, 4}, {}, {}};
  for (const PulseMethod method : {PulseMethod::dda, PulseMethod::koren}) {
    PulseRun run(method, level, {.capacity = 120, .preload = pulse::Preload::none, .tie = {}, .order = {}});
    for (std::int64_t clock = 1; !run.done(); ++clock) {
      run.step();
      EXPECT_EQ(run.at(), (Point{3 + clock * 10 / 120, 4})) << clock;
      EXPECT_EQ(value_of(run, "rx"), clock * 10 % 120) << clock;
      EXPECT_EQ(value_of(run, "q"), 120);
    }
    EXPECT_EQ(run.clock(), 120);
    EXPECT_EQ(run.conventions().capacity, 120);
    EXPECT_FALSE(run.conventions().bits.has_value());
  }
}

/// A quarter of 100 in registers of 1200: the bare generator's places, until the counters end it after 1200·π/2 clocks.
TEST(PulseMethods, DrawAnArcInRegistersOfAnyCapacity) {
  const PulseCurve arc_of_100{arc, {7, 100}, {-93, 200}, {-93, 100}, Direction::counterclockwise};
  for (const auto& [method, order] :
       {std::pair{PulseMethod::dda, pulse::Order::parallel}, {PulseMethod::koren, pulse::Order::x_first}}) {
    PulseRun run(method, arc_of_100, {.capacity = 1200, .preload = pulse::Preload::none, .tie = {}, .order = {}});
    pulse::FreeCircle bare({100, 0}, 1200, 0, order, pulse::Accumulation::sign_magnitude);
    while (!run.done() && bare.at().x > 0 && bare.at().y < 100) {
      run.step();
      bare.step();
      ASSERT_EQ(run.at(), (Point{bare.at().x - 93, bare.at().y + 100})) << run.clock();
    }
    while (!run.done()) run.step();
    EXPECT_EQ(run.at(), (Point{-93, 200}));
    EXPECT_NEAR(static_cast<double>(run.clock()), 1200 * std::numbers::pi / 2, 1200 / 10.0);
    EXPECT_EQ(run.conventions().capacity, 1200);
  }
}

/// However remainders take negative integrands, the free arc goes where the bare generator does; and each sum and each
/// overflow or borrow that is told leads to its pulse.
TEST(PulseMethods, RunFreelyByEveryAccumulation) {
  using pulse::Accumulation, pulse::Order;
  constexpr std::int64_t r = 50;
  const PulseCurve turn{arc, {r, 0}, {r, 0}, {}, Direction::counterclockwise};
  for (const auto accumulation : all_accumulations) {
    for (const auto order : {Order::parallel, Order::x_first}) {
      for (const auto preload : {pulse::Preload::none, pulse::Preload::half}) {
        MethodOptions options{.preload = preload, .tie = {}, .order = order, .free = true};
        options.accumulation = accumulation;
        ASSERT_EQ(conflict_of(options, turn), "");
        PulseRun run(PulseMethod::koren, turn, options);
        EXPECT_EQ(run.conventions().accumulation, accumulation);
        pulse::FreeCircle bare({r, 0}, r, preload == pulse::Preload::half ? r / 2 : 0, order, accumulation);
        while (!run.done()) {
          const std::vector<Addition> made = next_additions(run);
          const auto step = run.step().step;
          EXPECT_EQ(made[0].overflows(), step[0] != 0);
          EXPECT_EQ(made[1].overflows(), step[1] != 0);
          bare.step();
          ASSERT_EQ(run.at(), bare.at()) << name(accumulation) << " " << name(order) << " " << run.clock();
        }
      }
    }
  }
}

/// With places of the radius in the capacity an irrational radius keeps the feed: a turn takes 2πR of so many places.
TEST(PulseMethods, KeepPlacesOfTheRadius) {
  const PulseCurve quarter_of_50{arc, {5, 5}, {-5, 5}, {}, Direction::counterclockwise};
  MethodOptions options{};
  options.places = 8;
  ASSERT_EQ(conflict_of(options, quarter_of_50), "");
  PulseRun run(PulseMethod::dda, quarter_of_50, options);
  EXPECT_EQ(run.conventions().capacity, 1810);  // √50 · 2⁸
  EXPECT_NEAR(*clocks_per_blu(PulseMethod::dda, quarter_of_50, run.conventions()), 1, 1e-3);
  while (!run.done()) run.step();
  EXPECT_EQ(run.at(), (Point{-5, 5}));
  options.capacity = 10;
  EXPECT_NE(conflict_of(options, quarter_of_50), "");
  options = {};
  options.accumulation = pulse::Accumulation::floor;
  EXPECT_NE(conflict_of(options, quarter_of_50), "");
  options.free = true;
  options.preload = pulse::Preload::minus_one;
  EXPECT_NE(conflict_of(options, quarter_of_50), "");
}

TEST(PulseMethods, SayWhichConventionsAreInForce) {
  const auto of_arc = [](PulseMethod method) { return conventions_of(method, quarter, {}); };
  EXPECT_EQ(of_arc(PulseMethod::dda).capacity, 5);
  EXPECT_EQ(of_arc(PulseMethod::dda).order, pulse::Order::parallel);
  EXPECT_EQ(of_arc(PulseMethod::dda).preload, pulse::Preload::half_lagging);
  EXPECT_EQ(of_arc(PulseMethod::koren).order, pulse::Order::x_first);
  EXPECT_EQ(of_arc(PulseMethod::koren).preload, pulse::Preload::half);
  EXPECT_EQ(of_arc(PulseMethod::point_comparison).tie, "outward");
  EXPECT_FALSE(of_arc(PulseMethod::min_error).capacity.has_value());
  EXPECT_EQ(conventions_of(PulseMethod::dda, quarter, {.bits = 3}).capacity, 8);
  EXPECT_EQ(conventions_of(PulseMethod::koren, {line, {}, {3, 5}, {}, {}}, {}).capacity, 6);
}

TEST(PulseMethods, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const PulseMethod method : all_pulse_methods) names.insert(name(method));
  for (const pulse::Preload preload : all_preloads) names.insert(name(preload));
  for (const pulse::Order order : all_orders) names.insert(name(order));
  for (const pulse::OnCircle tie : all_ties) names.insert(name(tie));
  for (const pulse::Accumulation each : all_accumulations) names.insert(name(each));
  EXPECT_EQ(names.size(), all_pulse_methods.size() + all_preloads.size() + all_orders.size() + all_ties.size() +
                              all_accumulations.size());
}

// ---------------------------------------------------------------------------------------------------------------------

/// Loads half in the axis with the shorter distance alone.
TEST(HalfLagging, LoadsTheShorterAxisOfALine) {
  const PulseRun run(PulseMethod::dda, {line, {}, {9, -4}, {}, {}},
                     {.bits = 4, .preload = pulse::Preload::half_lagging, .tie = {}, .order = {}});
  EXPECT_EQ(value_of(run, "rx"), 0);
  EXPECT_EQ(value_of(run, "ry"), 8);
}

PulseMethod any_method() {
  return *rc::gen::elementOf(all_pulse_methods);
}

Direction any_direction() {
  return *rc::gen::element(Direction::clockwise, Direction::counterclockwise);
}

/// The start, turned and mirrored onto another of the eight points that are as far from the centre.
Point moved(Point at) {
  if (*rc::gen::arbitrary<bool>()) at = {at.y, at.x};
  const bool flips_x = *rc::gen::arbitrary<bool>(), flips_y = *rc::gen::arbitrary<bool>();
  return {flips_x ? -at.x : at.x, flips_y ? -at.y : at.y};
}

PulseCurve any_arc() {
  const auto coordinate = rc::gen::inRange<std::int64_t>(-60, 61);
  Point from_center{*coordinate, *coordinate};
  if (from_center == Point{}) from_center = {7, 0};
  const Point center{*coordinate, *coordinate}, to = moved(from_center);
  return {arc,
          {center.x + from_center.x, center.y + from_center.y},
          {center.x + to.x, center.y + to.y},
          center,
          any_direction()};
}

/// What the registers hold, by what they mean.
void expect_meaning(const PulseRun& run, const PulseCurve& curve, std::int64_t square) {
  const std::int64_t x = value_of(run, "x"), y = value_of(run, "y");
  RC_ASSERT(x == run.at().x - curve.center.x);
  RC_ASSERT(y == run.at().y - curve.center.y);
  if (run.conventions().capacity) {
    const std::int64_t q = value_of(run, "q");
    RC_ASSERT(q == *run.conventions().capacity);
    // A clock overflows once at most, and a coordinate may be beyond R by its error.
    RC_ASSERT(value_of(run, "rx") >= 0 && value_of(run, "rx") <= q + 2);
    RC_ASSERT(value_of(run, "ry") >= 0 && value_of(run, "ry") <= q + 2);
  } else {
    RC_ASSERT(value_of(run, "F") == x * x + y * y - square);
  }
}

RC_GTEST_PROP(PulseMethods, RegistersOfAnArcMeanWhatTheySay, ()) {
  const PulseCurve curve = any_arc();
  const PulseMethod method = any_method();
  RC_ASSERT(problems_of(curve, std::nullopt).empty());
  PulseRun run(method, curve);
  const Point start{curve.start.x - curve.center.x, curve.start.y - curve.center.y};
  const std::int64_t square = start.x * start.x + start.y * start.y;
  Point before = run.at();
  double worst = 0;
  while (!run.done()) {
    expect_meaning(run, curve, square);
    const auto pulse = run.step();
    RC_ASSERT(run.at() == (Point{before.x + pulse.step[0], before.y + pulse.step[1]}));
    before = run.at();
    const double x = static_cast<double>(before.x - curve.center.x), y = static_cast<double>(before.y - curve.center.y);
    worst = std::max(worst, std::abs(std::hypot(x, y) - std::sqrt(static_cast<double>(square))));
    RC_ASSERT(run.clock() < 2000);
  }
  RC_ASSERT(run.at() == curve.end);
  const PulseFigures figures = figures_of(method, curve);
  RC_ASSERT(std::abs(figures.max_error - worst) < 1e-9);
  RC_ASSERT(figures.clocks == run.clock());
  RC_ASSERT(figures.rms_error <= figures.max_error);
}

RC_GTEST_PROP(PulseMethods, LinesEndAtTheirEnds, ()) {
  const auto coordinate = rc::gen::inRange<std::int64_t>(-90, 91);
  const PulseCurve curve{line, {*coordinate, *coordinate}, {*coordinate, *coordinate}, {}, {}};
  RC_PRE(curve.start != curve.end);
  const PulseMethod method = any_method();
  const PulseFigures figures = figures_of(method, curve);
  RC_ASSERT(figures.end == curve.end);
  const auto [a, b] = curve.delta();
  const std::int64_t longer = std::max(std::abs(a), std::abs(b));
  const bool is_nearest = method == PulseMethod::koren || rate_of(method) == CommandRate::longest_axis;
  const double bound = is_nearest ? 0.7072 : 1;
  RC_ASSERT(figures.max_error < bound);
  RC_ASSERT(figures.pulses >= longer && figures.pulses <= std::abs(a) + std::abs(b));
  if (method == PulseMethod::dda) RC_ASSERT(figures.clocks == *conventions_of(method, curve, {}).capacity);
  // Across the line: the area of the parallelogram of line and place, by the line's length.
  const double expected =
      std::abs(static_cast<double>(a * (figures.worst.y - curve.start.y) - b * (figures.worst.x - curve.start.x))) /
      std::hypot(static_cast<double>(a), static_cast<double>(b));
  RC_ASSERT(std::abs(figures.max_error - expected) < 1e-9);
}

RC_GTEST_PROP(RegisterRange, IsAsWideAsTwosComplementNeeds, (std::int32_t a, std::int32_t b)) {
  const RegisterRange range{"F", std::min(a, b), std::max(a, b)};
  const auto holds = [&](int bits) {
    const std::int64_t half = std::int64_t{1} << (bits - 1);
    return range.least >= -half && range.greatest < half;
  };
  RC_ASSERT(holds(range.width()));
  const bool is_least = range.width() == 1 || !holds(range.width() - 1);
  RC_ASSERT(is_least);
}

// ---------------------------------------------------------------------------------------------------------------------

struct Refused {
  PulseCurve curve;
  std::optional<int> bits;
  const char* code;
  const char* said;
};

TEST(PulseProblems, NameTheRegisterOrTheValue) {
  constexpr auto ccw = Direction::counterclockwise;
  for (const auto& [curve, bits, code, said] : {
           Refused{{line, {3, 4}, {3, 4}, {}, {}}, {}, "no-way", "(3, 4)"},
           Refused{{line, {}, {256, 3}, {}, {}},
                   8,
                   "register-overflow",
                   "distance along x is 256: register Jx of 8 bits holds no more than 255"},
           Refused{{line, {0, 100}, {5, -28}, {}, {}},
                   7,
                   "register-overflow",
                   "distance along y is -128: register Jy of 7 bits"},
           Refused{
               {line, {}, {std::int64_t{1} << 31, 0}, {}, {}}, {}, "register-overflow", "x of the end is 2147483648"},
           Refused{{line, {-(std::int64_t{1} << 30), 0}, {1, 0}, {}, {}},
                   {},
                   "register-overflow",
                   "register Jx holds no more than 1073741824"},
           Refused{{arc, {2, 1}, {5, 5}, {2, 1}, ccw}, {}, "zero-radius", "(2, 1)"},
           Refused{{arc, {5, 0}, {0, 4}, {}, ccw},
                   {},
                   "end-off-circle",
                   "(0, 4) is 4.000 BLU from the centre, the start 5.000"},
           Refused{{arc, {5, 0}, {}, {}, ccw}, {}, "end-off-circle", "0.000"},
           Refused{{arc, {8, 0}, {0, 8}, {}, ccw}, 3, "register-overflow", "register x of 3 bits holds no more than 7"},
           Refused{{arc, {10, 7}, {10, -7}, {4, 0}, Direction::clockwise},
                   3,
                   "register-overflow",
                   "x where the arc passes an axis is 9: register x of 3 bits"},
       }) {
    const auto problems = problems_of(curve, bits);
    ASSERT_FALSE(problems.empty()) << said;
    EXPECT_EQ(problems.front().code, code) << said;
    EXPECT_EQ(problems.front().severity, base::Severity::error);
    EXPECT_NE(problems.front().message.find(said), std::string::npos) << problems.front().message;
  }
}

TEST(PulseProblems, EveryRegisterIsNamed) {
  EXPECT_EQ(problems_of({line, {}, {300, 300}, {}, {}}, 8).size(), 2u);
  EXPECT_TRUE(problems_of({line, {}, {255, -255}, {}, {}}, 8).empty());
  // The same arc, but it passes no axis.
  EXPECT_TRUE(problems_of({arc, {10, -7}, {11, -6}, {4, 0}, Direction::counterclockwise}, 3).empty());
}

/// Every coordinate below 8, but not the capacity: of the arc the radius 8.6, of the line the length. DDAs of hardware
/// have 2ⁿ.
TEST(PulseProblems, TheCapacityIsNamedWhereBitsDoNotHoldIt) {
  const PulseCurve segment{line, {}, {7, 7}, {}, {}}, piece{arc, {7, 5}, {5, 7}, {}, Direction::counterclockwise};
  MethodOptions options;
  EXPECT_FALSE(capacity_problem(PulseMethod::koren, segment, options));
  options.bits = 3;
  for (const auto& [curve, said] :
       {std::pair{segment, "the length, rounded up, is 10: register q of 3 bits holds no more than 7"},
        {piece, "the radius, rounded, is 9: register q of 3 bits"}}) {
    EXPECT_TRUE(problems_of(curve, options.bits).empty());
    const auto problem = capacity_problem(PulseMethod::koren, curve, options);
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->code, "register-overflow");
    EXPECT_NE(problem->message.find(said), std::string::npos) << problem->message;
    EXPECT_EQ(problem->hint, "4 bits would hold it");
    EXPECT_FALSE(capacity_problem(PulseMethod::dda, curve, options));
  }
  EXPECT_FALSE(capacity_problem(PulseMethod::koren, {arc, {5, 5}, {4, 6}, {}, Direction::counterclockwise}, options));
  options.bits = 4;
  EXPECT_FALSE(capacity_problem(PulseMethod::koren, segment, options));
}

/// The least that takes a quarter of 5 and a line of 7 along one axis; no other method has a capacity.
TEST(PulseProblems, TheCapacityAskedForTakesEveryIntegrand) {
  const PulseCurve segment{line, {2, 0}, {-2, -7}, {}, {}};
  for (const PulseMethod method : {PulseMethod::dda, PulseMethod::koren}) {
    for (const auto& [curve, least, said] :
         {std::tuple{quarter, 5, "the radius, rounded, is 5: integrators of capacity 4 take no more"},
          {segment, 7, "the longer distance along an axis is 7: integrators of capacity 6 take no more"}}) {
      EXPECT_FALSE(capacity_problem(method, curve, {.capacity = least}));
      const auto problem = capacity_problem(method, curve, {.capacity = least - 1});
      ASSERT_TRUE(problem);
      EXPECT_EQ(problem->code, "register-overflow");
      EXPECT_NE(problem->message.find(said), std::string::npos) << problem->message;
      EXPECT_EQ(problem->hint, "a capacity of " + std::to_string(least) + " would do");
    }
  }
  EXPECT_FALSE(capacity_problem(PulseMethod::min_error, quarter, {.capacity = 4}));
}

/// (3, 4) is 5 from the centre; (4, 4) .66 more, (5, 1) .1 more.
TEST(PulseProblems, AnEndMayBeHalfABluOffTheCircle) {
  const auto to = [](Point end) { return problems_of({arc, {5, 0}, end, {}, {}}, std::nullopt).size(); };
  EXPECT_EQ(to({3, 4}), 0u);
  EXPECT_EQ(to({5, 1}), 0u);
  EXPECT_EQ(to({4, 4}), 1u);
}

}  // namespace test_pulse_methods
}  // namespace leadscrew::nc
