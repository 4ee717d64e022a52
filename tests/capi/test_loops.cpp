#include <leadscrew/servo/follower.hpp>
#include <leadscrew/servo/tracking.hpp>

#include "called.hpp"

// Simulated loops, the servo period, and the rules by which words step along curves.

using namespace leadscrew;
using namespace leadscrew::capi_tests;

namespace test_loops {

struct FreeLoops {
  void operator()(leadscrew_loops* loops) const { leadscrew_loops_free(loops); }
};
using Loops = std::unique_ptr<leadscrew_loops, FreeLoops>;

leadscrew_loop_options loop_options(int controller) {
  leadscrew_loop_options options{};
  options.size = sizeof options;
  options.controller = controller;
  return options;
}

Loops begun(const leadscrew_loop_options& options) {
  leadscrew_loops* loops = nullptr;
  leadscrew_error error = sized_error();
  EXPECT_EQ(leadscrew_loops_begin(mill().get(), &options, &loops, &error), LEADSCREW_OK) << error.message;
  return Loops(loops);
}

leadscrew_followed follow(leadscrew_loops* loops, const leadscrew_word& word) {
  leadscrew_followed followed{};
  followed.size = sizeof followed;
  leadscrew_error error = sized_error();
  EXPECT_EQ(leadscrew_loops_follow(loops, &word, sizeof word, &followed, &error), LEADSCREW_OK) << error.message;
  return followed;
}

leadscrew_loop_figures figures_of(const leadscrew_loops* loops) {
  leadscrew_loop_figures figures{};
  figures.size = sizeof figures;
  EXPECT_EQ(leadscrew_loops_figures(loops, &figures, nullptr), LEADSCREW_OK);
  return figures;
}

/// A corner and an arc.
constexpr const char* corner = "G64 P0.01\nG1 X8 F3000\nY5\nG3 X2 Y5 I-3 J0\nM2\n";

/// As servo::Follower has it, bit for bit, and measured by the same Tracking.
void expect_as_the_rooms(int controller, const machine::Machine& machine, servo::LoopKind kind) {
  auto follower = servo::Follower::create(machine, kind);
  ASSERT_TRUE(follower);
  servo::Tracking tracking(machine.axis_set(), machine.period);
  leadscrew_loop_options options = loop_options(controller);
  if (controller == LEADSCREW_PID) {
    options.proportional = 2;
    options.integral = 2;
    options.derivative = 15;
  }
  const Loops loops = begun(options);
  const std::vector<leadscrew_word> words = words_of(program(corner).get());
  const std::vector<base::Word> same = pipeline_words(corner);
  std::int64_t periods = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const leadscrew_followed found = follow(loops.get(), words[i]);
    const auto expected = follower->follow(same[i]);
    ASSERT_EQ(found.tick, expected ? base::count(expected->word.tick) : -1) << i;
    if (!expected) continue;
    ++periods;
    tracking.observe(*expected);
    ASSERT_EQ(std::memcmp(found.position, expected->position.data(), sizeof found.position), 0) << i;
    ASSERT_EQ(std::memcmp(found.velocity, expected->velocity.data(), sizeof found.velocity), 0) << i;
    ASSERT_EQ(std::memcmp(found.control, expected->control.data(), sizeof found.control), 0) << i;
    ASSERT_EQ(std::memcmp(found.current, expected->current.data(), sizeof found.current), 0) << i;
  }
  const leadscrew_loop_figures figures = figures_of(loops.get());
  EXPECT_EQ(figures.periods, periods);
  EXPECT_EQ(figures.greatest[0], tracking.axis(base::Axis::X).greatest);
  EXPECT_EQ(figures.rms[1], tracking.axis(base::Axis::Y).rms);
  EXPECT_EQ(figures.feed_greatest, tracking.feed().measured_max);
  EXPECT_GT(figures.greatest[0], 0);
}

TEST(Loops, AreThoseOfTheRooms) {
  machine::Machine machine = machine::mill3();
  expect_as_the_rooms(LEADSCREW_OWN_LOOPS, machine, servo::LoopKind::words);
  expect_as_the_rooms(LEADSCREW_PULSE_LOOP, machine, servo::LoopKind::pulses);
  for (machine::AxisDrive& drive : machine.drives) {
    drive.controller = machine::AxisDrive::Controller::pid;
    drive.proportional = drive.integral = 2;
    drive.derivative = 15;
    drive.velocity_forward = drive.acceleration_forward = 0;
  }
  expect_as_the_rooms(LEADSCREW_PID, machine, servo::LoopKind::words);
}

/// Without feed-forward a line is left at v/Kv behind, and never sideways where all axes have one gain.
TEST(Loops, LagByTheirGain) {
  leadscrew_loop_options options = loop_options(LEADSCREW_CASCADE);
  options.position_gain = 50;
  const Loops loops = begun(options);
  for (const leadscrew_word& word : words_of(program("G1 X40 Y30 F3000\nM2\n").get())) follow(loops.get(), word);
  const leadscrew_loop_figures figures = figures_of(loops.get());
  EXPECT_NEAR(figures.greatest[0], 40.0 / 50, 0.02);
  EXPECT_NEAR(figures.greatest[1], 30.0 / 50, 0.02);
  EXPECT_LT(figures.contour, 0.003);
  EXPECT_GE(figures.contour, figures.contour_rms);
}

/// A scale on the slide sees the play that an encoder at the screw does not.
TEST(Loops, MeasureAtTheScrewOrOnTheSlide) {
  const auto left_over = [](int encoder) {
    leadscrew_loop_options options = loop_options(LEADSCREW_CASCADE);
    options.encoder = encoder;
    options.forward = 1;
    options.backlash = 0.1;
    const Loops loops = begun(options);
    std::vector<leadscrew_word> words = words_of(program("G1 X10 F600\nM2\n").get());
    leadscrew_followed last{};
    for (int more = 0; more < 1500; ++more) {
      words.push_back(words.back());
      ++words.back().tick;
    }
    for (const leadscrew_word& word : words) last = follow(loops.get(), word);
    return std::fabs(last.position[0] - 10);
  };
  EXPECT_NEAR(left_over(LEADSCREW_ROTARY_ENCODER), 0.05, 0.005);
  EXPECT_LT(left_over(LEADSCREW_LINEAR_ENCODER), 0.02);
}

TEST(Loops, RefuseWhatIsNotSound) {
  leadscrew_loops* none = nullptr;
  leadscrew_error error = sized_error();
  leadscrew_loop_options options = loop_options(LEADSCREW_PID);
  options.derivative = -1;
  EXPECT_EQ(leadscrew_loops_begin(mill().get(), &options, &none, &error), LEADSCREW_REJECTED);
  EXPECT_STREQ(error.code, "servo-controller");
  EXPECT_STREQ(error.field, "derivative");
  options = loop_options(LEADSCREW_CASCADE);
  options.forward = 2;
  EXPECT_EQ(leadscrew_loops_begin(mill().get(), &options, &none, &error), LEADSCREW_REJECTED);
  EXPECT_STREQ(error.field, "forward");
  options.forward = 0;
  options.position_gain = 1e6;
  EXPECT_EQ(leadscrew_loops_begin(mill().get(), &options, &none, &error), LEADSCREW_REJECTED);
  EXPECT_STREQ(error.code, "servo-unstable");
  options = loop_options(4);
  EXPECT_EQ(leadscrew_loops_begin(mill().get(), &options, &none, &error), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_loops_begin(nullptr, nullptr, &none, &error), LEADSCREW_MISUSE);
  const leadscrew_word word{};
  EXPECT_EQ(leadscrew_loops_follow(nullptr, &word, sizeof word, nullptr, &error), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_loops_figures(nullptr, nullptr, &error), LEADSCREW_MISUSE);
  EXPECT_EQ(none, nullptr);
  leadscrew_loops_free(none);
}

TEST(Period, IsALimitThatMayBeChanged) {
  const Machine machine = mill();
  leadscrew_limits limits{};
  limits.size = sizeof limits;
  ASSERT_EQ(leadscrew_machine_limits(machine.get(), &limits, nullptr), LEADSCREW_OK);
  EXPECT_EQ(limits.period, leadscrew_machine_period(machine.get()));
  const auto period_of = [&](double period) {
    limits.period = period;
    leadscrew_machine* made = nullptr;
    if (leadscrew_machine_limited(machine.get(), &limits, &made, nullptr) != LEADSCREW_OK) return -1.0;
    return leadscrew_machine_period(Machine(made).get());
  };
  EXPECT_EQ(period_of(0.0005), 0.0005);
  EXPECT_EQ(period_of(0), leadscrew_machine_period(machine.get()));
  for (const double wrong : {1e-6, 1.0, 1e300, -0.001, std::nan("")}) EXPECT_EQ(period_of(wrong), -1) << wrong;
}

/// On the plane cubic of the real-time paper Taylor's rules make other words than arc length does.
TEST(StepRules, AreThoseOfTheInterpolator) {
  const std::string text =
      "G5.2 X0 Y0 P1 L3\nX6.6666666666667 Y-3.3333333333333\nX13.333333333333 Y20\nX20 Y20\nG5.3\nM2\n";
  const std::string curve = "F600\n" + text;
  std::vector<std::vector<leadscrew_word>> all;
  for (const int rule : {LEADSCREW_ARC_LENGTH, LEADSCREW_TAYLOR1, LEADSCREW_UNIFORM}) {
    leadscrew_options options = no_options();
    options.step_rule = rule;
    all.push_back(words_of(program(curve, options).get()));
    ASSERT_GT(all.back().size(), 100U);
  }
  const auto farthest = [&](std::size_t rule) {
    double most = 0;
    for (std::size_t i = 0; i < std::min(all[0].size(), all[rule].size()); ++i)
      most = std::max(most, std::fabs(all[0][i].position[0] - all[rule][i].position[0]));
    return most;
  };
  EXPECT_GT(farthest(1), 1e-6);
  EXPECT_LT(farthest(1), 0.05);
  EXPECT_GT(farthest(2), 0.1);
  leadscrew_options wrong = no_options();
  wrong.step_rule = 5;
  leadscrew_motion* none = nullptr;
  leadscrew_error error = sized_error();
  EXPECT_EQ(leadscrew_motion_of_program(mill().get(), curve.data(), curve.size(), &wrong, &none, &error),
            LEADSCREW_REJECTED);
  EXPECT_STREQ(error.code, "step-rule");
  EXPECT_STREQ(error.field, "step_rule");
}

/// s of a program with corners.
double time_of(const leadscrew_options& options) {
  const Motion motion = program("G21 G90 G64 P0.01 F3000\nG1 X10\nG1 Y10\nG1 X0\nM2\n", options);
  leadscrew_trajectory* planned = nullptr;
  EXPECT_EQ(leadscrew_motion_plan(motion.get(), &planned, nullptr), LEADSCREW_OK);
  const Trajectory trajectory(planned);
  return leadscrew_trajectory_duration(planned);
}

TEST(Options, SayHowMovesAreJoined) {
  const double programmed = time_of(no_options());
  leadscrew_options asked = no_options();
  asked.path_mode = LEADSCREW_BLEND;
  EXPECT_EQ(time_of(asked), programmed);
  asked.has_tolerance = 1;
  asked.tolerance = 0.5;
  EXPECT_LT(time_of(asked), programmed - 0.001);
  asked.path_mode = LEADSCREW_EXACT_STOP;
  EXPECT_GT(time_of(asked), programmed + 0.001);
}

TEST(Options, ThatJoinMovesOtherwiseAreRefused) {
  const std::string text = "M2\n";
  const auto refused = [&](const leadscrew_options& options, const char* code, const char* field) {
    leadscrew_motion* none = nullptr;
    leadscrew_error error = sized_error();
    EXPECT_EQ(leadscrew_motion_of_program(mill().get(), text.data(), text.size(), &options, &none, &error),
              LEADSCREW_REJECTED);
    EXPECT_STREQ(error.code, code);
    EXPECT_STREQ(error.field, field);
  };
  leadscrew_options wrong = no_options();
  wrong.path_mode = 3;
  refused(wrong, "path-mode", "path_mode");
  wrong.path_mode = LEADSCREW_AS_PROGRAMMED;
  wrong.has_tolerance = 1;
  for (const double tolerance : {-1e-3, HUGE_VAL, std::nan("")}) {
    wrong.tolerance = tolerance;
    refused(wrong, "path-tolerance", "tolerance");
  }
}

}  // namespace test_loops
