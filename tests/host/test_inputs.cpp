#include <limits>

#include "paths.hpp"

// Inputs that a host answers for (LinuxCNC manual, "M66 Wait on Input"): the program is read on when it has said.

namespace test_inputs {

using namespace leadscrew;
using namespace leadscrew::host_tests;

constexpr const char* goes_by_an_input =
    "G21 G90 G61 F3000\nG1 X10\nM8\nM66 P3 L3 Q2.5\no1 if [#5399 EQ 1]\nG1 X20\no1 else\nG1 Y[5 + #5399]\no1 "
    "endif\nM2\n";

struct Host {
  std::vector<std::string> codes;
  std::unique_ptr<host::Motion> motion;

  explicit Host(const char* text) {
    host::MotionOptions options;
    options.has_inputs = true;
    options.on_event = [this](const base::PassedEvent& event) { codes.emplace_back(base::code_of(event)); };
    motion = program(text, options);
  }
};

TEST(HostInputs, AreAskedForWhereMotionRests) {
  Host host(goes_by_an_input);
  const auto words = words_of(*host.motion);
  ASSERT_FALSE(words.empty());
  EXPECT_NEAR(words.back().position[0], 10, 0.01);
  EXPECT_EQ(host.motion->progress(), pipeline::Progress::wants_input);
  EXPECT_EQ(host.codes, (std::vector<std::string>{"M8", "M66"}));
  const auto input = host.motion->input();
  ASSERT_TRUE(input);
  EXPECT_EQ(input->output, 3);
  EXPECT_EQ(input->value, 3);
  EXPECT_EQ(input->q, 2.5);
  EXPECT_EQ(words_of(*host.motion).size(), 0U);
}

TEST(HostInputs, SayHowTheProgramGoesOn) {
  const auto end = [](double value) {
    Host host(goes_by_an_input);
    auto words = words_of(*host.motion);
    EXPECT_TRUE(host.motion->input_is(value));
    EXPECT_FALSE(host.motion->input_is(value));
    const auto rest = words_of(*host.motion);
    EXPECT_EQ(base::count(rest.front().tick), base::count(words.back().tick) + 1);
    EXPECT_EQ(host.motion->progress(), pipeline::Progress::ended);
    EXPECT_EQ(host.codes, (std::vector<std::string>{"M8", "M66", "M2"}));
    return rest.back().position;
  };
  EXPECT_EQ(end(1)[0], 20);
  EXPECT_EQ(end(0)[1], 5);
  EXPECT_EQ(end(-1)[1], 4);  // the time is over
}

TEST(HostInputs, OneBehindAnother) {
  Host host("G21 G90 F3000\nM66 P0\n#1=#5399\nM66 E1\nG1 X[#1 + #5399]\nM66 P2\nM2\n");
  for (const double value : {1.0, 2.5, 7.0}) {
    words_of(*host.motion);
    ASSERT_TRUE(host.motion->input_is(value));
  }
  EXPECT_EQ(words_of(*host.motion).back().position[0], 3.5);
  EXPECT_EQ(host.motion->progress(), pipeline::Progress::ended);
  EXPECT_EQ(host.codes, (std::vector<std::string>{"M66", "M66", "M66", "M2"}));
}

TEST(HostInputs, AreOffWhereNobodyAnswers) {
  EXPECT_EQ(words_of(*program(goes_by_an_input)).back().position[1], 4);
  Host host(goes_by_an_input);
  const auto planned = host.motion->plan();
  ASSERT_TRUE(planned);
  EXPECT_EQ(planned->at(planned->duration()).position[1], 4);
}

TEST(HostInputs, AreToldOnlyWhereTheyAreAskedForAndFinite) {
  Host host(goes_by_an_input);
  EXPECT_EQ(host.motion->input_is(1).error().code, "input-idle");
  words_of(*host.motion);
  EXPECT_EQ(host.motion->input_is(std::numeric_limits<double>::infinity()).error().code, "move-finite");
  EXPECT_TRUE(host.motion->input_is(1));
}

/// It is read whole before it moves as if the input were off.
TEST(HostInputs, EndMotionWhereTheyLeadToAnError) {
  Host host("G21 G90 F3000\nG1 X10\nM66 P0\no1 if [#5399 EQ 1]\nG1 X9000\no1 endif\nG1 X20\nM2\n");
  words_of(*host.motion);
  ASSERT_TRUE(host.motion->input_is(1));
  words_of(*host.motion);
  EXPECT_EQ(host.motion->progress(), pipeline::Progress::ended);
  ASSERT_TRUE(host.motion->failure());
  EXPECT_EQ(host.motion->failure()->code, "travel");
}

}  // namespace test_inputs
