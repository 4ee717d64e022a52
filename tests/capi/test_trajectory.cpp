#include <string>
#include <vector>

#include "called.hpp"

// Tools, progress, and motion that is planned at once.

using namespace leadscrew;
using namespace leadscrew::capi_tests;

namespace test_trajectory {

leadscrew_state at(const leadscrew_trajectory* trajectory, double time) {
  leadscrew_state state{};
  state.size = sizeof state;
  EXPECT_EQ(leadscrew_trajectory_at(trajectory, time, &state, nullptr), LEADSCREW_OK);
  return state;
}

Trajectory plan(leadscrew_motion* motion) {
  leadscrew_trajectory* planned = nullptr;
  EXPECT_EQ(leadscrew_motion_plan(motion, &planned, nullptr), LEADSCREW_OK);
  return Trajectory(planned);
}

TEST(Capi, PlansAProgramWithItsWords) {
  const Motion motion = program(plate);
  const Trajectory planned = plan(motion.get());
  const auto words = words_of(motion.get());
  for (const leadscrew_word& word : words) {
    const leadscrew_state state = at(planned.get(), static_cast<double>(word.tick) * 1e-3);
    ASSERT_EQ(std::memcmp(state.position, word.position, sizeof word.position), 0) << word.tick;
    ASSERT_EQ(state.path_length, word.path_length);
    ASSERT_EQ(state.speed, word.speed);
    ASSERT_EQ(state.feed, word.feed);
    ASSERT_EQ(state.line, word.line);
    ASSERT_EQ(state.state, word.state);
  }
  const double end = static_cast<double>(words.back().tick) * 1e-3,
               duration = leadscrew_trajectory_duration(planned.get());
  EXPECT_LE(duration, end);
  EXPECT_GT(duration, end - 1e-3);
}

TEST(Capi, SamplesATrajectoryAtManyTimes) {
  const Motion motion = program(plate);
  const Trajectory planned = plan(motion.get());
  const double duration = leadscrew_trajectory_duration(planned.get());
  std::vector<double> times;
  for (double time = -0.01; time < duration + 0.01; time += 0.0007) times.push_back(time);
  times.insert(times.end(), {duration / 2, duration / 3, duration / 3, 2 * duration, duration / 5});
  std::vector<leadscrew_state> states(times.size());
  std::vector<leadscrew_pose> poses(times.size());
  ASSERT_EQ(leadscrew_trajectory_sample(planned.get(), times.data(), times.size(), states.data(), sizeof states[0],
                                        poses.data(), sizeof poses[0], nullptr),
            LEADSCREW_OK);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const leadscrew_state state = at(planned.get(), times[i]);
    ASSERT_EQ(std::memcmp(&states[i], &state, sizeof state), 0) << times[i];
    leadscrew_pose pose{};
    pose.size = sizeof pose;
    ASSERT_EQ(leadscrew_trajectory_pose(planned.get(), times[i], &pose, nullptr), LEADSCREW_OK);
    ASSERT_EQ(std::memcmp(&poses[i], &pose, sizeof pose), 0) << times[i];
  }
}

TEST(Capi, PlansMovesBeforeTheyGo) {
  const Motion motion = moves();
  const leadscrew_move there = line(100, 0, 0, 40);
  ASSERT_EQ(leadscrew_motion_push(motion.get(), &there, nullptr), LEADSCREW_OK);
  const Trajectory planned = plan(motion.get());
  const double jerk = machine::mill3().limits(base::Axis::X).jerk, ramp = std::sqrt(40 / jerk);
  EXPECT_NEAR(leadscrew_trajectory_duration(planned.get()), 2.5 + 2 * ramp, 1e-9);
  EXPECT_NEAR(at(planned.get(), 1).velocity[0], 40, 1e-9);
  EXPECT_NEAR(at(planned.get(), ramp / 2).acceleration[0], jerk * ramp / 2, 1e-6);
  EXPECT_NEAR(at(planned.get(), ramp / 2).jerk[0], jerk, 1e-6);
  EXPECT_EQ(at(planned.get(), 10).position[0], 100);
  words_of(motion.get());
  leadscrew_error error = sized_error();
  leadscrew_trajectory* late = nullptr;
  EXPECT_EQ(leadscrew_motion_plan(motion.get(), &late, &error), LEADSCREW_REJECTED);
  EXPECT_STREQ(error.code, "motion-moves");
  EXPECT_EQ(late, nullptr);
}

leadscrew_hold hold(const leadscrew_trajectory* trajectory, double time, double feed_asked) {
  const leadscrew_state state = at(trajectory, time);
  leadscrew_hold hold{};
  hold.size = sizeof hold;
  EXPECT_EQ(leadscrew_trajectory_hold(trajectory, &state, feed_asked, &hold, nullptr), LEADSCREW_OK);
  return hold;
}

/// Jerk, then acceleration until 190 mm/s, then the feed; at 200 mm/s the axis' limit.
TEST(Capi, TellsWhatHoldsMotion) {
  const Motion motion = moves();
  const leadscrew_move slow = line(0, 100, 0, 190), fast = line(0, 300, 0, 200);
  ASSERT_EQ(leadscrew_motion_push(motion.get(), &slow, nullptr), LEADSCREW_OK);
  ASSERT_EQ(leadscrew_motion_push(motion.get(), &fast, nullptr), LEADSCREW_OK);
  const Trajectory planned = plan(motion.get());
  const auto kind = [&](double time, double asked) { return hold(planned.get(), time, asked).kind; };
  EXPECT_EQ(kind(0.02, 190), LEADSCREW_HELD_BY_JERK);
  EXPECT_EQ(hold(planned.get(), 0.02, 190).axis, 1);
  EXPECT_EQ(kind(0.1, 190), LEADSCREW_HELD_BY_ACCELERATION);
  EXPECT_EQ(kind(0.4, 190), LEADSCREW_HELD_BY_FEED);
  EXPECT_EQ(kind(0.4, 200), LEADSCREW_HELD_BY_WHAT_COMES);
  EXPECT_EQ(kind(1.2, 200), LEADSCREW_HELD_BY_VELOCITY);
  EXPECT_EQ(kind(10, inf), LEADSCREW_HELD_AT_REST);
}

TEST(Capi, TellsNoHoldOfWhatIsNoState) {
  const Motion motion = program(plate);
  const Trajectory planned = plan(motion.get());
  const leadscrew_state state = at(planned.get(), 1);
  leadscrew_hold hold{};
  hold.size = sizeof hold;
  leadscrew_error error = sized_error();
  EXPECT_EQ(leadscrew_trajectory_hold(nullptr, &state, 1, &hold, &error), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_trajectory_hold(planned.get(), nullptr, 1, &hold, &error), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_trajectory_hold(planned.get(), &state, std::nan(""), &hold, &error), LEADSCREW_MISUSE);
  hold.size = 3;
  EXPECT_EQ(leadscrew_trajectory_hold(planned.get(), &state, 1, &hold, &error), LEADSCREW_MISUSE);
}

TEST(Capi, OutlivesTheMotionThatWasPlanned) {
  Motion motion = program(plate);
  const Trajectory planned = plan(motion.get());
  motion.reset();
  EXPECT_GT(at(planned.get(), 1).path_length, 0);
}

TEST(Capi, TakesToolsAsTextAndFromAFile) {
  const std::string text = "G21 G90\nT3 M6\nG43\nG1 X1 Z-1 F600\nM2\n";
  const std::string table = "T3 P3 Z12.5 ;drill\n", path = testing::TempDir() + "capi-tools.tbl";
  std::ofstream(path) << table;
  leadscrew_options by_text = no_options(), by_file = no_options();
  by_text.tools = table.data();
  by_text.tools_length = table.size();
  by_file.tools_file = path.c_str();
  for (const leadscrew_options& options : {by_text, by_file})
    EXPECT_EQ(words_of(program(text, options).get()).back().position[2], 11.5);
  // Without a table the offset is 0, which a warning says; a table that lacks the tool is the wrong one.
  EXPECT_EQ(words_of(program(text, no_options()).get()).back().position[2], -1);
  const std::string other = "T4 P3 Z12.5\n";
  leadscrew_options by_other = no_options();
  by_other.tools = other.data();
  by_other.tools_length = other.size();
  leadscrew_motion* none = nullptr;
  EXPECT_EQ(leadscrew_motion_of_program(mill().get(), text.data(), text.size(), &by_other, &none, nullptr),
            LEADSCREW_REJECTED);
}

/// Says no when it has been asked so often.
struct Asked {
  int times = 0, most = 0;
  std::vector<double> shares;

  leadscrew_options options() {
    leadscrew_options options = no_options();
    options.user = this;
    options.on_progress = [](double share, void* user) {
      auto* const self = static_cast<Asked*>(user);
      self->shares.push_back(share);
      return ++self->times > self->most ? 1 : 0;
    };
    return options;
  }
};

const std::string many_lines = [] {
  std::string text = "G21 G90 G64 P0.01 F3000\n";
  for (int i = 0; i < 4000; ++i) text += "G1 X" + std::to_string(i % 7) + " Y" + std::to_string(i % 11) + "\n";
  return text + "M2\n";
}();

TEST(Capi, IsInterruptedWhileItReads) {
  Asked asked{.most = 3};
  const leadscrew_options options = asked.options();
  leadscrew_motion* motion = nullptr;
  leadscrew_error error = sized_error();
  EXPECT_EQ(leadscrew_motion_of_program(mill().get(), many_lines.data(), many_lines.size(), &options, &motion, &error),
            LEADSCREW_INTERRUPTED);
  EXPECT_EQ(motion, nullptr);
  EXPECT_STREQ(error.code, "interrupted");
  EXPECT_EQ(asked.times, 4);
  EXPECT_EQ(asked.shares.front(), 0);
  EXPECT_GT(asked.shares.back(), 0);
  EXPECT_LT(asked.shares.back(), 1);
}

TEST(Capi, IsInterruptedWhileItPlans) {
  Asked asked{.most = 1 << 20};
  const Motion motion = program(many_lines, asked.options());
  asked.most = 0;
  leadscrew_trajectory* planned = nullptr;
  EXPECT_EQ(leadscrew_motion_plan(motion.get(), &planned, nullptr), LEADSCREW_INTERRUPTED);
  EXPECT_EQ(planned, nullptr);
  asked.most = 1 << 20;
  std::vector<leadscrew_word> words(1000);
  std::size_t count = 0;
  ASSERT_EQ(leadscrew_motion_next(motion.get(), words.data(), sizeof words[0], words.size(), &count, nullptr),
            LEADSCREW_OK);
  ASSERT_EQ(count, words.size());
  asked.most = 0;
  std::int64_t before = words.back().tick;
  leadscrew_error error = sized_error();
  int code = LEADSCREW_OK;
  while ((code = leadscrew_motion_next(motion.get(), words.data(), sizeof words[0], words.size(), &count, &error)) ==
             LEADSCREW_OK &&
         count > 0) {
    EXPECT_EQ(words[0].tick, before + 1);
    before = words[count - 1].tick;
    EXPECT_EQ(words[count - 1].state == 0, count < words.size());
  }
  EXPECT_EQ(code, LEADSCREW_INTERRUPTED);
  EXPECT_STREQ(error.code, "interrupted");
}

/// Edges of a signal of a dump, up.
std::size_t pulses_of(const std::string& dump, const std::string& signal) {
  const std::size_t named = dump.find(" " + signal + " $end");
  if (named == std::string::npos) return 0;
  const std::string mark = dump.substr(dump.rfind(' ', named - 1) + 1, named - dump.rfind(' ', named - 1) - 1);
  std::size_t count = 0;
  const std::string up = "\n1" + mark + "\n";
  for (std::size_t at = dump.find(up); at != std::string::npos; at = dump.find(up, at + 1)) ++count;
  return count;
}

TEST(Capi, GivesStepsOfAllAxesAsADump) {
  const Motion motion = program("G21 G90 G61 F600\nG1 X1.5\nG1 Y-0.25\nM2\n");
  const Trajectory planned = plan(motion.get());
  std::string dump;
  const auto take = [](const char* text, std::size_t length, void* user) {
    static_cast<std::string*>(user)->append(text, length);
    return 0;
  };
  ASSERT_EQ(leadscrew_trajectory_steps(planned.get(), 1'000'000, take, &dump, nullptr), LEADSCREW_OK);
  EXPECT_EQ(pulses_of(dump, "X_step"), 1500U);  // of 0.001 mm
  EXPECT_EQ(pulses_of(dump, "Y_step"), 250U);
  EXPECT_EQ(pulses_of(dump, "Z_step"), 0U);
  leadscrew_error error = sized_error();
  EXPECT_EQ(leadscrew_trajectory_steps(planned.get(), 20'000, take, &dump, &error), LEADSCREW_REJECTED);
  EXPECT_STREQ(error.code, "step-rate");
  const auto refuse = [](const char*, std::size_t, void*) { return 1; };
  EXPECT_EQ(leadscrew_trajectory_steps(planned.get(), 1'000'000, refuse, nullptr, nullptr), LEADSCREW_INTERRUPTED);
  EXPECT_EQ(leadscrew_trajectory_steps(nullptr, 1'000'000, take, &dump, nullptr), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_trajectory_steps(planned.get(), 1'000'000, nullptr, &dump, nullptr), LEADSCREW_MISUSE);
}

}  // namespace test_trajectory
