#include <leadscrew/pipeline/lost_time.hpp>
#include <string>
#include <vector>

#include "called.hpp"

// A machine's limits, a program that is checked, what codes mean, and the figures and blocks of what is planned.

using namespace leadscrew;
using namespace leadscrew::capi_tests;

namespace test_programs {

leadscrew_limits limits_of(const leadscrew_machine* machine) {
  leadscrew_limits limits{};
  limits.size = sizeof limits;
  EXPECT_EQ(leadscrew_machine_limits(machine, &limits, nullptr), LEADSCREW_OK);
  return limits;
}

TEST(Capi, TellsLimits) {
  const leadscrew_limits limits = limits_of(mill().get());
  const machine::Machine expected = machine::mill3();
  EXPECT_EQ(limits.axes, 7);
  EXPECT_EQ(limits.tolerance, expected.tolerance);
  EXPECT_EQ(limits.chord_error, expected.chord_error);
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) {
    const std::size_t i = base::index(axis);
    EXPECT_EQ(limits.least[i], expected.limits(axis).travel_min);
    EXPECT_EQ(limits.greatest[i], expected.limits(axis).travel_max);
    EXPECT_EQ(limits.velocity[i], expected.limits(axis).velocity);
    EXPECT_EQ(limits.acceleration[i], expected.limits(axis).acceleration);
    EXPECT_EQ(limits.jerk[i], expected.limits(axis).jerk);
  }
  EXPECT_EQ(limits.jerk[3], 0);
}

TEST(Capi, MakesAMachineOfOtherLimits) {
  const Machine machine = mill();
  leadscrew_limits limits = limits_of(machine.get());
  limits.jerk[0] /= 8;
  limits.tolerance = 0.02;
  leadscrew_machine* made = nullptr;
  ASSERT_EQ(leadscrew_machine_limited(machine.get(), &limits, &made, nullptr), LEADSCREW_OK);
  const Machine slower(made);
  EXPECT_EQ(limits_of(made).jerk[0], limits.jerk[0]);
  EXPECT_EQ(limits_of(made).tolerance, 0.02);
  EXPECT_NE(limits_of(machine.get()).tolerance, 0.02);
  const std::string text = "G21 G90 G0 X100\nM2\n";
  const auto time = [&](const leadscrew_machine* of) {
    leadscrew_motion* motion = nullptr;
    EXPECT_EQ(leadscrew_motion_of_program(of, text.data(), text.size(), nullptr, &motion, nullptr), LEADSCREW_OK);
    return words_of(Motion(motion).get()).size();
  };
  EXPECT_GT(time(made), time(machine.get()));

  leadscrew_error error = sized_error();
  leadscrew_machine* none = nullptr;
  limits.jerk[0] = 0;
  EXPECT_EQ(leadscrew_machine_limited(machine.get(), &limits, &none, &error), LEADSCREW_REJECTED);
  EXPECT_STREQ(error.field, "jerk.x");
  limits = limits_of(machine.get());
  limits.axes = 15;
  EXPECT_EQ(leadscrew_machine_limited(machine.get(), &limits, &none, &error), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_machine_limited(machine.get(), nullptr, &none, &error), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_machine_limited(nullptr, &limits, &none, &error), LEADSCREW_MISUSE);
  EXPECT_EQ(none, nullptr);
}

struct Found {
  std::vector<leadscrew_error> all;

  leadscrew_options options() {
    leadscrew_options options = no_options();
    options.user = this;
    options.on_diagnostic = [](const leadscrew_error* error, void* user) {
      static_cast<Found*>(user)->all.push_back(*error);
    };
    return options;
  }
};

leadscrew_checked sized_checked() {
  leadscrew_checked checked{};
  checked.size = sizeof checked;
  return checked;
}

TEST(Capi, ChecksAProgram) {
  Found found;
  const leadscrew_options options = found.options();
  leadscrew_checked checked = sized_checked();
  const std::string text = "G21 G90 G1 X10 Y-5 F90000\nG0 X30 Z4\nM2\n";
  ASSERT_EQ(leadscrew_program_check(mill().get(), text.data(), text.size(), &options, &checked, nullptr), LEADSCREW_OK);
  EXPECT_EQ(checked.blocks, 3);
  EXPECT_EQ(checked.moves, 2);
  EXPECT_GT(checked.bound, 0);
  EXPECT_LT(checked.bound, static_cast<double>(words_of(program(text).get()).size()) * 1e-3);
  EXPECT_NEAR(checked.least[1], -5, 0.02);
  EXPECT_NEAR(checked.greatest[0], 30, 1e-9);
  ASSERT_EQ(found.all.size(), 1U);  // that the axes are slower than this feed: what check --json alone looks for
  EXPECT_STREQ(found.all[0].code, "feed-beyond-axis");
  EXPECT_EQ(found.all[0].severity, 1);
  EXPECT_EQ(found.all[0].line, 1);
  EXPECT_EQ(found.all[0].column, 20);
}

TEST(Capi, TellsAllErrorsOfAProgram) {
  Found found;
  const leadscrew_options options = found.options();
  leadscrew_checked checked = sized_checked();
  checked.bound = 7;
  leadscrew_error error = sized_error();
  const std::string text = "G21 G90 G1 X10 F600\nG1 X1Q\nG2 X5 I1\n";
  ASSERT_EQ(leadscrew_program_check(mill().get(), text.data(), text.size(), &options, &checked, &error),
            LEADSCREW_REJECTED);
  ASSERT_GE(found.all.size(), 2U);
  EXPECT_STREQ(error.code, found.all[0].code);
  EXPECT_EQ(error.line, 2);
  EXPECT_EQ(found.all.back().line, 3);
  EXPECT_EQ(checked.blocks, 3);
  EXPECT_EQ(checked.bound, 0);
  EXPECT_EQ(leadscrew_program_check(mill().get(), text.data(), text.size(), nullptr, nullptr, nullptr),
            LEADSCREW_REJECTED);
}

TEST(Capi, RefusesToCheckWhatItCannot) {
  leadscrew_error error = sized_error();
  leadscrew_checked checked{};  // of no size
  EXPECT_EQ(leadscrew_program_check(mill().get(), "M2", 2, nullptr, &checked, &error), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_program_check(nullptr, "M2", 2, nullptr, nullptr, &error), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_program_check(mill().get(), nullptr, 2, nullptr, nullptr, &error), LEADSCREW_MISUSE);
  leadscrew_options options = no_options();
  options.on_progress = [](double, void*) { return 1; };
  EXPECT_EQ(leadscrew_program_check(mill().get(), "M2", 2, &options, nullptr, &error), LEADSCREW_INTERRUPTED);
}

TEST(Capi, SaysWhatCodesMean) {
  char text[2048];
  const std::size_t length = leadscrew_explain(mill().get(), "G64", text, sizeof text);
  EXPECT_EQ(length, std::strlen(text));
  EXPECT_NE(std::string(text).find("G64"), std::string::npos);
  char little[5];
  EXPECT_EQ(leadscrew_explain(mill().get(), "G64", little, sizeof little), length);
  EXPECT_EQ(std::string(little), std::string(text, 4));
  EXPECT_EQ(leadscrew_explain(mill().get(), "G64", nullptr, 0), length);
  EXPECT_EQ(leadscrew_explain(mill().get(), "?", text, sizeof text), 0U);
  EXPECT_EQ(leadscrew_explain(nullptr, "G64", text, sizeof text), 0U);
}

Trajectory plan(leadscrew_motion* motion) {
  leadscrew_trajectory* planned = nullptr;
  EXPECT_EQ(leadscrew_motion_plan(motion, &planned, nullptr), LEADSCREW_OK);
  return Trajectory(planned);
}

/// Of the command's own way to run a program.
struct Moved {
  pipeline::Summary summary;
  std::vector<pipeline::BlockTime> blocks;
};

Moved moved_by_the_command(const std::string& text) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  Moved result;
  pipeline::Program run(gcode::text_source(text), machine, tools, {}, nullptr);
  pipeline::LostTime lost(machine, [&](const pipeline::BlockTime& block) { result.blocks.push_back(block); });
  run.on_move([&](const gcode::Move& move) { lost.observe(move); });
  while (run.prepare()) lost.observe(run.cycle());
  lost.finish();
  result.summary = run.summary();
  return result;
}

TEST(Capi, TellsTheFiguresOfAPlan) {
  const Motion motion = program(plate);
  leadscrew_figures figures{};
  figures.size = sizeof figures;
  ASSERT_EQ(leadscrew_trajectory_figures(plan(motion.get()).get(), &figures, nullptr), LEADSCREW_OK);
  const pipeline::Summary expected = moved_by_the_command(plate).summary;
  EXPECT_EQ(figures.words, expected.words);
  EXPECT_EQ(figures.time, expected.time_s);
  EXPECT_EQ(figures.bound, expected.bound_s);
  EXPECT_EQ(figures.dwell, expected.dwell_s);
  EXPECT_NEAR(figures.length, expected.length_mm, 1e-9);
  EXPECT_EQ(figures.feed_programmed, expected.feed_programmed_max);
  EXPECT_EQ(figures.tolerance, expected.tolerance_mm);
  EXPECT_EQ(figures.blocks, expected.blocks);
  EXPECT_EQ(figures.moves, expected.moves);
  EXPECT_EQ(figures.jerk[0], expected.plan.of_axis(base::Axis::X).jerk);
  EXPECT_EQ(figures.velocity[2], expected.plan.of_axis(base::Axis::Z).velocity);
  EXPECT_GT(figures.acceleration[1], 0.5);
  figures.size = 8;
  EXPECT_EQ(leadscrew_trajectory_figures(plan(motion.get()).get(), &figures, nullptr), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_trajectory_figures(nullptr, &figures, nullptr), LEADSCREW_MISUSE);
}

TEST(Capi, TellsWhatEachBlockTook) {
  const Motion motion = program(plate);
  const Trajectory planned = plan(motion.get());
  std::vector<leadscrew_block> blocks;
  const auto take = [](const leadscrew_block* block, void* user) {
    static_cast<std::vector<leadscrew_block>*>(user)->push_back(*block);
  };
  ASSERT_EQ(leadscrew_trajectory_blocks(planned.get(), take, &blocks, nullptr), LEADSCREW_OK);
  const Moved expected = moved_by_the_command(plate);
  ASSERT_EQ(blocks.size(), expected.blocks.size());
  double end = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    EXPECT_EQ(blocks[i].line, base::number(expected.blocks[i].line));
    EXPECT_EQ(blocks[i].seconds, expected.blocks[i].seconds);
    EXPECT_EQ(blocks[i].least_seconds, expected.blocks[i].least_seconds);
    EXPECT_EQ(blocks[i].feed_asked, expected.blocks[i].feed_asked);
    EXPECT_EQ(blocks[i].middle[0], expected.blocks[i].middle[0]);
    EXPECT_EQ(std::string(blocks[i].cause), pipeline::name(expected.blocks[i].cause));
    if (blocks[i].seconds == 0) continue;
    EXPECT_NEAR(blocks[i].begin, end, 1e-9) << i;
    end = blocks[i].begin + blocks[i].seconds;
  }
  EXPECT_NEAR(end, expected.summary.time_s, 2e-3);
  EXPECT_EQ(leadscrew_trajectory_blocks(planned.get(), nullptr, nullptr, nullptr), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_trajectory_blocks(nullptr, take, nullptr, nullptr), LEADSCREW_MISUSE);
}

TEST(Capi, PlansByTheFeedOverrideThatStands) {
  const std::string text = "G21 G90 G1 X100 F600\nM2\n";
  const Motion motion = program(text);
  const double whole = leadscrew_trajectory_duration(plan(motion.get()).get());
  ASSERT_EQ(leadscrew_motion_override(motion.get(), 0.5, nullptr), LEADSCREW_OK);
  EXPECT_NEAR(leadscrew_trajectory_duration(plan(motion.get()).get()), 2 * whole, 0.1);
  ASSERT_EQ(leadscrew_motion_override(motion.get(), 0, nullptr), LEADSCREW_OK);
  leadscrew_error error = sized_error();
  leadscrew_trajectory* none = nullptr;
  EXPECT_EQ(leadscrew_motion_plan(motion.get(), &none, &error), LEADSCREW_REJECTED);
  EXPECT_STREQ(error.code, "override");
}

}  // namespace test_programs
