// Reference pulses by the C interface: rows, copies, sentences, and a code for every misuse.

#include <array>
#include <leadscrew/nc/pulse_reason.hpp>

#include "called.hpp"

using namespace leadscrew;
using namespace leadscrew::capi_tests;

namespace test_pulses {

struct FreePulses {
  void operator()(leadscrew_pulses* pulses) const { leadscrew_pulses_free(pulses); }
};
using Pulses = std::unique_ptr<leadscrew_pulses, FreePulses>;
using Row = std::vector<std::int64_t>;

leadscrew_pulse_task task_of(int kind, const char* method) {
  leadscrew_pulse_task task{};
  task.size = sizeof task;
  task.kind = kind;
  task.method = method;
  task.turns = 1;
  return task;
}

/// From (6, 8) to (−8, 6) clockwise, in registers of 4 bits.
leadscrew_pulse_task teaching_arc() {
  leadscrew_pulse_task task = task_of(LEADSCREW_ARC, "dda");
  task.turns = -1;
  task.bits = 4;
  task.start[0] = 6;
  task.start[1] = 8;
  task.end[0] = -8;
  task.end[1] = 6;
  task.preload = "zero";
  return task;
}

Pulses loaded(const leadscrew_pulse_task& task) {
  leadscrew_pulses* pulses = nullptr;
  leadscrew_error error = sized_error();
  EXPECT_EQ(leadscrew_pulses_load(&task, &pulses, &error), LEADSCREW_OK) << error.message;
  return Pulses(pulses);
}

std::vector<std::string> columns_of(const Pulses& pulses) {
  std::vector<std::string> columns;
  while (const char* name = leadscrew_pulses_column(pulses.get(), columns.size())) columns.emplace_back(name);
  return columns;
}

Row row_of(const Pulses& pulses) {
  Row row(columns_of(pulses).size());
  EXPECT_EQ(leadscrew_pulses_row(pulses.get(), row.data(), nullptr), LEADSCREW_OK);
  return row;
}

std::string why_of(const Pulses& pulses) {
  std::string text(leadscrew_pulses_why(pulses.get(), nullptr, 0) + 1, '?');
  leadscrew_pulses_why(pulses.get(), text.data(), text.size());
  text.pop_back();
  return text;
}

leadscrew_pulse_figures figures_of(const Pulses& pulses) {
  leadscrew_pulse_figures figures{};
  figures.size = sizeof figures;
  EXPECT_EQ(leadscrew_pulses_figures(pulses.get(), &figures, nullptr), LEADSCREW_OK);
  return figures;
}

TEST(CapiPulses, AreThoseOfTheRun) {
  const Pulses pulses = loaded(teaching_arc());
  EXPECT_EQ(columns_of(pulses), (std::vector<std::string>{"clock", "dx", "dy", "X", "Y", "x", "y", "rx", "ry", "nx",
                                                          "ny", "q", "quadrant", "Jx", "Jy", "Sx", "Sy", "ox", "oy"}));
  const nc::PulseCurve curve{nc::PulseCurve::Shape::arc, {6, 8}, {-8, 6}, {}, pulse::Direction::clockwise};
  nc::PulseRun run(nc::PulseMethod::dda, curve, {.bits = 4, .preload = pulse::Preload::none}), before = run;
  for (std::size_t count = 1; count > 0;) {
    const Row row = row_of(pulses);
    EXPECT_EQ(row[0], run.clock());
    EXPECT_EQ(row[1], run.last().step[0]);
    EXPECT_EQ(row[4], run.at().y);
    EXPECT_EQ(row[7], run.registers().all()[2].value);
    EXPECT_EQ(row[15], nc::flow_of(before, run, curve).all()[3].value);
    EXPECT_EQ(why_of(pulses), nc::reason_of(before, run, curve));
    Row next(row.size());
    ASSERT_EQ(leadscrew_pulses_next(pulses.get(), next.data(), 1, &count, nullptr), LEADSCREW_OK);
    if (count == 0) break;
    EXPECT_EQ(next, row_of(pulses));
    before = run;
    run.step();
  }
  EXPECT_TRUE(run.done());
  const leadscrew_pulse_figures figures = figures_of(pulses);
  EXPECT_EQ(figures.clocks, 80);
  EXPECT_EQ(figures.pulses, 52);
  EXPECT_NEAR(figures.max_error, 1.180, 5e-4);
  EXPECT_EQ(figures.position[0], -8);
  EXPECT_NE(figures.is_done, 0);
}

TEST(CapiPulses, ComeBackToACopy) {
  const Pulses pulses = loaded(teaching_arc());
  std::size_t count = 0;
  ASSERT_EQ(leadscrew_pulses_next(pulses.get(), nullptr, 33, &count, nullptr), LEADSCREW_OK);
  EXPECT_EQ(count, 33U);
  leadscrew_pulses* made = nullptr;
  ASSERT_EQ(leadscrew_pulses_copy(pulses.get(), &made, nullptr), LEADSCREW_OK);
  const Pulses copy(made);
  const Row there = row_of(pulses);
  const std::string why = why_of(pulses);
  leadscrew_pulses_next(pulses.get(), nullptr, 1000, &count, nullptr);
  EXPECT_EQ(count, 47U);
  EXPECT_EQ(row_of(copy), there);
  EXPECT_EQ(why_of(copy), why);
  EXPECT_EQ(figures_of(copy).clocks, 33);
}

TEST(CapiPulses, ListMethodsAndWhatTheyHave) {
  std::vector<std::string> methods;
  while (const char* name = leadscrew_pulse_name(LEADSCREW_METHODS, methods.size())) methods.emplace_back(name);
  EXPECT_EQ(methods.size(), nc::all_pulse_methods.size());
  EXPECT_STREQ(leadscrew_pulse_name(LEADSCREW_TIES, 1), "inward");
  EXPECT_EQ(leadscrew_pulse_name(LEADSCREW_ORDERS, 4), nullptr);
  EXPECT_EQ(leadscrew_pulse_name(9, 0), nullptr);
  EXPECT_EQ(leadscrew_pulse_uses("koren"), 1 << LEADSCREW_PRELOADS | 1 << LEADSCREW_ORDERS | 1 << LEADSCREW_CAPACITY |
                                               1 << LEADSCREW_ELLIPSES | 1 << LEADSCREW_FREE |
                                               1 << LEADSCREW_ACCUMULATIONS | 1 << LEADSCREW_PLACES);
  EXPECT_STREQ(leadscrew_pulse_name(LEADSCREW_ACCUMULATIONS, 2), "symmetric");
  EXPECT_EQ(leadscrew_pulse_name(LEADSCREW_PLACES, 0), nullptr);
  EXPECT_EQ(leadscrew_pulse_uses("point-comparison"), 1 << LEADSCREW_TIES);
  EXPECT_EQ(leadscrew_pulse_uses("none"), 0);
}

/// From (12, 0) to (0, −7) clockwise along the ellipse with these semi-axes.
leadscrew_pulse_task elliptic_arc() {
  leadscrew_pulse_task task = task_of(LEADSCREW_ARC, "koren");
  task.turns = -1;
  task.start[0] = 12;
  task.end[1] = -7;
  task.semi_axes[0] = 12;
  task.semi_axes[1] = 7;
  return task;
}

TEST(CapiPulses, DrawEllipses) {
  const Pulses pulses = loaded(elliptic_arc());
  const nc::PulseCurve curve{nc::PulseCurve::Shape::arc, {12, 0}, {0, -7}, {}, pulse::Direction::clockwise,
                             pulse::SemiAxes{12, 7}};
  nc::PulseRun run(nc::PulseMethod::koren, curve);
  EXPECT_EQ(columns_of(pulses), columns_of(loaded(teaching_arc())));
  Row row(columns_of(pulses).size());
  for (std::size_t count = 1; !run.done();) {
    const pulse::Pulse<2> pulse = run.step();
    ASSERT_EQ(leadscrew_pulses_next(pulses.get(), row.data(), 1, &count, nullptr), LEADSCREW_OK);
    EXPECT_EQ(row[1], pulse.step[0]);
    EXPECT_EQ(row[2], pulse.step[1]);
    EXPECT_EQ(row[11], 12 * 12 * 7);
  }
  EXPECT_EQ(figures_of(pulses).position[1], -7);
  leadscrew_pulse_conventions found{};
  found.size = sizeof found;
  ASSERT_EQ(leadscrew_pulses_conventions(pulses.get(), &found, nullptr), LEADSCREW_OK);
  EXPECT_EQ(found.capacity, 12);
  EXPECT_EQ(found.scale, 84);
}

TEST(CapiPulses, RunFreelyWhereTheyAreAskedTo) {
  leadscrew_pulse_task task = task_of(LEADSCREW_ARC, "koren");
  task.start[0] = 10'000;
  task.end[0] = -10'000;
  task.is_free = 1;
  task.preload = "minus-one";
  const Pulses pulses = loaded(task);
  std::size_t count = 0;
  ASSERT_EQ(leadscrew_pulses_next(pulses.get(), nullptr, 100'000, &count, nullptr), LEADSCREW_OK);
  EXPECT_EQ(count, 31'415U);
  EXPECT_EQ(figures_of(pulses).position[0], -10'001);
}

TEST(CapiPulses, TakeAccumulationsAndPlaces) {
  leadscrew_pulse_task task = task_of(LEADSCREW_ARC, "koren");
  task.start[0] = 50;
  task.end[0] = -50;
  task.is_free = 1;
  task.accumulation = "floor";
  const Pulses pulses = loaded(task);
  leadscrew_pulse_conventions found{};
  found.size = sizeof found;
  ASSERT_EQ(leadscrew_pulses_conventions(pulses.get(), &found, nullptr), LEADSCREW_OK);
  EXPECT_STREQ(found.accumulation, "floor");
  std::size_t count = 0;
  ASSERT_EQ(leadscrew_pulses_next(pulses.get(), nullptr, 2, &count, nullptr), LEADSCREW_OK);
  std::string why(200, ' ');
  why.resize(leadscrew_pulses_why(pulses.get(), why.data(), why.size()));
  EXPECT_NE(why.find("borrow, X −1"), std::string::npos) << why;
  task.is_free = 0;
  task.accumulation = nullptr;
  task.places = 8;
  const Pulses with_places = loaded(task);
  ASSERT_EQ(leadscrew_pulses_conventions(with_places.get(), &found, nullptr), LEADSCREW_OK);
  EXPECT_EQ(found.places, 8);
  EXPECT_EQ(found.capacity, 50 * 256);
  EXPECT_DOUBLE_EQ(found.clocks_per_blu, 1);
}

/// One that was compiled before there were ellipses says nothing of them.
TEST(CapiPulses, TakeTheTaskOfTheFirstVersion) {
  leadscrew_pulse_task task = teaching_arc();
  task.size = offsetof(leadscrew_pulse_task, semi_axes);
  task.semi_axes[0] = 3;
  const Pulses pulses = loaded(task);
  std::size_t count = 0;
  ASSERT_EQ(leadscrew_pulses_next(pulses.get(), nullptr, 1000, &count, nullptr), LEADSCREW_OK);
  EXPECT_EQ(count, 80U);
}

TEST(CapiPulses, TellTheConventionsInForce) {
  const Pulses pulses = loaded(teaching_arc());
  leadscrew_pulse_conventions found{};
  found.size = sizeof found;
  ASSERT_EQ(leadscrew_pulses_conventions(pulses.get(), &found, nullptr), LEADSCREW_OK);
  EXPECT_EQ(found.bits, 4);
  EXPECT_EQ(found.capacity, 16);
  EXPECT_STREQ(found.preload, "zero");
  EXPECT_STREQ(found.order, "parallel");
  EXPECT_DOUBLE_EQ(found.clocks_per_blu, 1.6);
}

TEST(CapiPulses, SayWhatIsWrongWithEachField) {
  leadscrew_pulse_task task = teaching_arc();
  task.end[0] = 40;
  task.end[1] = -50;
  leadscrew_error error = sized_error();
  EXPECT_EQ(leadscrew_pulses_problem(&task, 0, &error), LEADSCREW_REJECTED);
  EXPECT_STREQ(error.code, "register-overflow");
  EXPECT_STREQ(error.field, "end.x");
  EXPECT_STREQ(error.hint, "6 bits would hold it");
  EXPECT_EQ(leadscrew_pulses_problem(&task, 1, &error), LEADSCREW_REJECTED);
  EXPECT_STREQ(error.field, "end.y");
  EXPECT_EQ(leadscrew_pulses_problem(&task, 2, &error), LEADSCREW_OK);
  leadscrew_pulses* pulses = nullptr;
  EXPECT_EQ(leadscrew_pulses_load(&task, &pulses, &error), LEADSCREW_REJECTED);
  EXPECT_STREQ(error.field, "end.x");
  EXPECT_EQ(pulses, nullptr);
}

TEST(CapiPulses, SayWhatIsWrongWithAnEllipse) {
  const auto error_of = [](const auto& change) {
    leadscrew_pulse_task task = elliptic_arc();
    change(task);
    leadscrew_error error = sized_error();
    EXPECT_EQ(leadscrew_pulses_problem(&task, 0, &error), LEADSCREW_REJECTED);
    return std::pair{std::string(error.code), std::string(error.field)};
  };
  using Told = std::pair<std::string, std::string>;
  EXPECT_EQ(error_of([](auto& task) { task.semi_axes[1] = -7; }), Told("zero-radius", "semi_axes.y"));
  EXPECT_EQ(error_of([](auto& task) { task.start[1] = 5; }), Told("off-ellipse", "start"));
  EXPECT_EQ(error_of([](auto& task) { task.bits = 3; }), Told("register-overflow", "semi_axes.x"));
  EXPECT_EQ(error_of([](auto& task) { task.method = "bresenham"; }), Told("no-ellipse", "method"));
}

TEST(CapiPulses, TellMisuse) {
  const auto code_of = [](const auto& change) {
    leadscrew_pulse_task task = teaching_arc();
    change(task);
    leadscrew_pulses* pulses = nullptr;
    const int code = leadscrew_pulses_load(&task, &pulses, nullptr);
    leadscrew_pulses_free(pulses);
    return code;
  };
  EXPECT_EQ(code_of([](auto&) {}), LEADSCREW_OK);
  EXPECT_EQ(code_of([](auto& task) { task.size = 3; }), LEADSCREW_MISUSE);
  EXPECT_EQ(code_of([](auto& task) { task.kind = LEADSCREW_CURVE; }), LEADSCREW_MISUSE);
  EXPECT_EQ(code_of([](auto& task) { task.turns = 2; }), LEADSCREW_MISUSE);
  EXPECT_EQ(code_of([](auto& task) { task.bits = 31; }), LEADSCREW_MISUSE);
  EXPECT_EQ(code_of([](auto& task) { task.capacity = 20; }), LEADSCREW_MISUSE);
  EXPECT_EQ(code_of([](auto& task) { task.method = "ellipse"; }), LEADSCREW_MISUSE);
  EXPECT_EQ(code_of([](auto& task) { task.method = nullptr; }), LEADSCREW_MISUSE);
  EXPECT_EQ(code_of([](auto& task) { task.preload = "some"; }), LEADSCREW_MISUSE);
  EXPECT_EQ(code_of([](auto& task) { task.tie = "inward"; }), LEADSCREW_MISUSE);
  EXPECT_EQ(code_of([](auto& task) { task.accumulation = "floor"; }), LEADSCREW_MISUSE);
  EXPECT_EQ(code_of([](auto& task) { task.places = 4; }), LEADSCREW_MISUSE);  // beside bits
  EXPECT_EQ(code_of([](auto& task) { task.places = 17; }), LEADSCREW_MISUSE);
  EXPECT_EQ(code_of([](auto& task) {
              task.method = "min-error";
              task.preload = nullptr;
              task.is_free = 1;
            }),
            LEADSCREW_MISUSE);
  EXPECT_EQ(code_of([](auto& task) {
              task.semi_axes[0] = task.semi_axes[1] = 10;
              task.is_free = 1;
            }),
            LEADSCREW_MISUSE);
  const leadscrew_pulse_task task = teaching_arc();
  std::size_t count = 0;
  EXPECT_EQ(leadscrew_pulses_load(&task, nullptr, nullptr), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_pulses_next(nullptr, nullptr, 1, &count, nullptr), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_pulses_row(nullptr, nullptr, nullptr), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_pulses_column(nullptr, 0), nullptr);
  EXPECT_EQ(leadscrew_pulses_why(nullptr, nullptr, 0), 0U);
  leadscrew_pulses_free(nullptr);
}

/// Radius over that of the start after so many steps.
double radius_after(int rule, double angle, std::size_t steps) {
  const std::array<double, 2> start = {6, 8};
  std::vector<double> places(2 * (steps + 1));
  EXPECT_EQ(leadscrew_circle_places(rule, angle, start.data(), places.data(), steps + 1, nullptr), LEADSCREW_OK);
  EXPECT_EQ(places[0], 6);
  EXPECT_EQ(places[1], 8);
  return std::hypot(places[2 * steps], places[2 * steps + 1]) / 10;
}

TEST(CirclePlaces, KeepTheRadiusAsTheirRuleDoes) {
  constexpr double t = 0.1;
  constexpr std::size_t steps = 63;
  const double growth = std::sqrt(1 + t * t);
  EXPECT_NEAR(radius_after(LEADSCREW_EULER, t, steps), std::pow(growth, steps), 1e-12);
  EXPECT_NEAR(radius_after(LEADSCREW_HEUN, t, steps), std::pow(std::sqrt(1 + std::pow(t, 4) / 4), steps), 1e-12);
  EXPECT_NEAR(radius_after(LEADSCREW_TUSTIN, t, steps), 1, 1e-13);
  EXPECT_NEAR(radius_after(LEADSCREW_STATE_TRANSITION, -t, steps), 1, 1e-13);
  EXPECT_NEAR(radius_after(LEADSCREW_RUNGE_KUTTA, t, steps), 1, 1e-6);
  EXPECT_NE(radius_after(LEADSCREW_RUNGE_KUTTA, t, steps), 1);
  const double off = std::fabs(radius_after(LEADSCREW_X_FIRST, t, steps) - 1);  // an ellipse, T/4 off at most
  EXPECT_LT(off, 1.1 * t / 2);
  EXPECT_GT(off, 1e-5);
}

TEST(CirclePlaces, OfNoRuleAngleOrRoomAreMisuse) {
  const std::array<double, 2> start = {1, 0};
  std::array<double, 2> places{};
  leadscrew_error error{};
  error.size = sizeof error;
  const auto call = [&](int rule, double angle, const double* from, double* to, std::size_t count) {
    return leadscrew_circle_places(rule, angle, from, to, count, &error);
  };
  EXPECT_EQ(call(6, 0.1, start.data(), places.data(), 1), LEADSCREW_MISUSE);
  EXPECT_EQ(call(-1, 0.1, start.data(), places.data(), 1), LEADSCREW_MISUSE);
  EXPECT_EQ(call(0, HUGE_VAL, start.data(), places.data(), 1), LEADSCREW_MISUSE);
  EXPECT_EQ(call(0, 0.1, nullptr, places.data(), 1), LEADSCREW_MISUSE);
  EXPECT_EQ(call(0, 0.1, start.data(), nullptr, 1), LEADSCREW_MISUSE);
  EXPECT_EQ(call(0, 0.1, start.data(), places.data(), 0), LEADSCREW_MISUSE);
  EXPECT_EQ(call(0, 0.1, start.data(), places.data(), 1), LEADSCREW_OK);
}

}  // namespace test_pulses
