// What is told of a drive, and the wishes that are understood.

#include <gtest/gtest.h>

#include <leadscrew/machine/machine.hpp>
#include <leadscrew/serve/live_events.hpp>
#include <nlohmann/json.hpp>

namespace leadscrew::serve {
namespace test_live_events {

nlohmann::json data_of(const std::string& event, const std::string& name) {
  const std::string head = "event: " + name + "\ndata: ";
  EXPECT_TRUE(event.starts_with(head) && event.ends_with("\n\n")) << event;
  EXPECT_EQ(event.find('\n', head.size()), event.size() - 2) << "an event is one line of data";
  return nlohmann::json::parse(event.substr(head.size()));
}

TEST(LiveEvents, TellTheMachineAndWhereItIs) {
  const machine::Machine machine = machine::mill3();
  const auto told = data_of(machine_event(machine, {"part \"1\"\n.ngc", true, false}), "machine");
  EXPECT_EQ(told["program"], "part \"1\"\n.ngc");
  EXPECT_EQ(told["axes"].size(), 3);
  EXPECT_EQ(told["axes"][0]["velocity"], 200.0);
  drive::Feedback feedback;
  feedback.word.tick = base::Tick{1500};
  feedback.word.position = {1, 2, 3};
  feedback.word.line = base::Line{7};
  feedback.word.feed = 50;
  feedback.actual = {1.25, 2, 3};
  const auto sample = data_of(sample_event(machine, feedback, {LiveState::Kind::paused, 0.5, 9}), "sample");
  EXPECT_EQ(sample["t"], 1.5);
  EXPECT_EQ(sample["position"], (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(sample["actual"], (std::vector<double>{1.25, 2, 3}));
  EXPECT_EQ(sample["line"], 7);
  EXPECT_EQ(sample["state"], "paused");
  EXPECT_EQ(sample["override"], 0.5);
  EXPECT_EQ(sample["pause_line"], 9);
  EXPECT_FALSE(sample.contains("tip"));
}

TEST(LiveEvents, UnderstandWishesAndNothingElse) {
  const auto wish = wish_of(R"({"hold": false, "override": 0.8})");
  ASSERT_TRUE(wish);
  EXPECT_EQ(wish->hold, false);
  EXPECT_EQ(wish->override_factor, 0.8);
  EXPECT_FALSE(wish->stop || wish->go_on);
  EXPECT_TRUE(wish_of(R"({"stop": true})")->stop);
  EXPECT_TRUE(wish_of(R"({"go_on": true})")->go_on);
  for (const char* other : {"", "{}", "[]", "null", "{", R"({"hold": 1})", R"({"override": 0})", R"({"override": 2.1})",
                            R"({"override": "1"})", R"({"stop": false})", R"({"hold": true, "faster": true})"})
    EXPECT_FALSE(wish_of(other)) << other;
}

}  // namespace test_live_events
}  // namespace leadscrew::serve
