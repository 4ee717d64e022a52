#include <algorithm>
#include <leadscrew/referee/referee.hpp>

#include "called.hpp"

// A trajectory whose feed somebody changes and holds on its way.

using namespace leadscrew;
using namespace leadscrew::capi_tests;

namespace test_feed_changes {

Trajectory planned(const std::string& text, const std::vector<double>& times, const std::vector<double>& factors) {
  leadscrew_trajectory* trajectory = nullptr;
  leadscrew_error error = sized_error();
  EXPECT_EQ(leadscrew_motion_plan_changed(program(text).get(), times.data(), factors.data(), times.size(), &trajectory,
                                          &error),
            LEADSCREW_OK)
      << error.message;
  return Trajectory(trajectory);
}

leadscrew_state at(const Trajectory& trajectory, double time) {
  leadscrew_state state{};
  state.size = sizeof state;
  EXPECT_EQ(leadscrew_trajectory_at(trajectory.get(), time, &state, nullptr), LEADSCREW_OK);
  return state;
}

double duration(const Trajectory& trajectory) {
  return leadscrew_trajectory_duration(trajectory.get());
}

/// What the referee holds against its words.
std::int64_t objections(const Trajectory& trajectory, const std::string& text) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, nullptr);
  referee::Referee referee([&](gcode::Move& move) { return reader.next(move); }, machine, machine.period);
  const auto words = static_cast<std::int64_t>(std::ceil(duration(trajectory) / 1e-3 - 1e-9));
  for (std::int64_t word = 0; word <= words; ++word) {
    const leadscrew_state state = at(trajectory, static_cast<double>(word) / 1000);
    base::AxisVector position{};
    std::copy_n(state.position, LEADSCREW_AXES, position.begin());
    referee.observe(position, state.feed);
  }
  return referee.conclude().violation_count;
}

const std::string far = "G21 G90 F3000\nG1 X100\nM2\n";
const std::string around = "G21 G90 G64 P0.02 F3000\nG1 X30\nY20\nG3 X10 Y20 I-10 J0\nG1 Y0\nX0\nM2\n";

TEST(FeedChanges, NoneGiveTheSameMotion) {
  const Trajectory plain = planned(around, {}, {}), late = planned(around, {1000}, {0});
  for (double time = 0; time < duration(plain) + 0.1; time += 0.0137) {
    EXPECT_EQ(at(plain, time).position[0], at(late, time).position[0]) << time;
    EXPECT_EQ(at(plain, time).position[1], at(late, time).position[1]) << time;
  }
}

TEST(FeedChanges, AHoldBrakesStandsAndGoesOn) {
  for (const std::string& text : {far, around}) {
    const Trajectory plain = planned(text, {}, {}), held = planned(text, {0.6, 2.6}, {0, 1});
    EXPECT_EQ(at(held, 0.6).position[0], at(plain, 0.6).position[0]);
    EXPECT_GT(at(held, 0.62).speed, 0) << "it does not stand at once";
    EXPECT_EQ(at(held, 2).speed, 0);
    EXPECT_GT(at(held, 2.9).speed, 0);
    EXPECT_LT(at(held, 2).path_length, at(plain, 2).path_length);
    // So long it stood, and what braking and the new start take.
    EXPECT_GT(duration(held), duration(plain) + 1.7);
    EXPECT_LT(duration(held), duration(plain) + 2.1);
    EXPECT_EQ(objections(held, text), 0);
  }
}

TEST(FeedChanges, AHoldWithoutAnEndEndsThere) {
  const Trajectory held = planned(far, {0.6}, {0});
  EXPECT_LT(duration(held), 0.9);
  EXPECT_GT(duration(held), 0.62);
  EXPECT_EQ(at(held, duration(held)).speed, 0);
  EXPECT_LT(at(held, duration(held)).position[0], 50);
  EXPECT_EQ(at(held, 100).position[0], at(held, duration(held)).position[0]);
}

TEST(FeedChanges, AnOverrideActsFromItsTimeOn) {
  const Trajectory halved = planned(far, {1}, {0.5});
  EXPECT_NEAR(at(halved, 0.9).feed, 50, 1e-9);
  EXPECT_NEAR(at(halved, 1.3).feed, 25, 1e-9);
  EXPECT_EQ(objections(halved, far), 0);
}

TEST(FeedChanges, AHoldAtTheBeginningWaits) {
  const Trajectory held = planned(far, {0, 0.5}, {0, 1});
  EXPECT_EQ(at(held, 0.5).position[0], 0);
  EXPECT_NEAR(duration(held), duration(planned(far, {}, {})) + 0.5, 1e-9);
}

TEST(FeedChanges, InADwellWaitForItsEndAndGoOnWithIt) {
  const std::string text = "G21 G90 F3000\nG1 X10\nG4 P1\nX20\nM2\n";
  const Trajectory plain = planned(text, {}, {}), held = planned(text, {0.7, 1.7}, {0, 1});
  EXPECT_NEAR(duration(held), duration(plain) + 1, 0.01);
  EXPECT_EQ(objections(held, text), 0);
}

TEST(FeedChanges, AtAnyInstantLimitsAndPathAreKept) {
  const double end = duration(planned(around, {}, {}));
  for (double time = 0.013; time < end; time += end / 17) {
    const Trajectory held = planned(around, {time, time + 0.05, time + 0.4, time + 1}, {0, 0.7, 0, 1});
    EXPECT_EQ(objections(held, around), 0) << time;
    EXPECT_NEAR(at(held, duration(held)).position[1], 0, 1e-9) << time;
  }
}

TEST(FeedChanges, RefuseWhatIsNone) {
  leadscrew_trajectory* trajectory = nullptr;
  const Motion motion = program(far);
  const double one = 1, many[] = {2, 1}, factors[] = {0, 1}, three = 3;
  leadscrew_error error = sized_error();
  EXPECT_EQ(leadscrew_motion_plan_changed(motion.get(), &one, nullptr, 1, &trajectory, nullptr), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_motion_plan_changed(motion.get(), many, factors, 2, &trajectory, &error), LEADSCREW_REJECTED);
  EXPECT_STREQ(error.code, "override");
  EXPECT_EQ(leadscrew_motion_plan_changed(motion.get(), &one, &three, 1, &trajectory, &error), LEADSCREW_REJECTED);
  EXPECT_STREQ(error.code, "override");
}

}  // namespace test_feed_changes
