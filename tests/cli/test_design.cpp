// `leadscrew design`: the lecture's and Koren's figures, and what it refuses.

#include <gtest/gtest.h>

#include <cmath>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_design {

using Words = std::vector<std::string>;

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

const Words machine = {"design", "--travel", "600", "--blu", "0.01", "--max-feed", "12000", "--min-distance", "50"};
const Words lecture = with(machine, {"--from", "20,10", "--to", "120,60", "--feed", "3000"});
const Words koren = {"design", "--inverse-time", "--travel", "12", "--blu", "0.0001", "--max-feed", "30"};

TEST(Design, GivesTheLecturesFigures) {
  const Folder folder;
  const Outcome outcome = leadscrew(folder, with(lecture, {"--json"}));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.errors, "");
  const Json object = outcome.json();
  EXPECT_EQ(object["schema"], "leadscrew.design/1");
  EXPECT_EQ(object["blu_mm"], 0.01);
  EXPECT_EQ(object["axis_bits"], 16);
  EXPECT_EQ(object["feed_bits"], 12);
  EXPECT_EQ(object["feed_word_max"], 2400);
  EXPECT_EQ(std::floor(object["clock_pps"].get<double>()), 447392);
  EXPECT_EQ(object["feed_word"], 268);
  EXPECT_EQ(object["pulses"], Json({10000, 5000}));
  EXPECT_NEAR(object["axis_pps"][0], 4466.67, 0.005);
  EXPECT_NEAR(object["axis_pps"][1], 2233.33, 0.005);
  EXPECT_NEAR(object["feed_error"], -0.0012, 5e-5);
  EXPECT_NEAR(object["time_s"], 2.2388, 5e-5);
  const Json& ideal = object["ideal"];
  EXPECT_NEAR(ideal["feed_pps"], 29308.59, 0.005);
  EXPECT_NEAR(ideal["axis_pps"][0], 4472.14, 0.005);
  EXPECT_NEAR(ideal["axis_pps"][1], 2236.07, 0.005);
  EXPECT_NEAR(ideal["feed_error"], 0, 1e-12);
  EXPECT_NEAR(ideal["feed_word"], 268.33, 0.005);
}

TEST(Design, OfAMachineAloneNeedsNoLine) {
  const Folder folder;
  const Json object = leadscrew(folder, with(machine, {"--json"})).json();
  EXPECT_EQ(object["axis_bits"], 16);
  EXPECT_FALSE(object.contains("feed_word"));
}

/// Three axes, from the machine's zero, and back.
TEST(Design, TakesAnyNumberOfAxes) {
  const Folder folder;
  const Json object = leadscrew(folder, with(machine, {"--to", "-20,30,60", "--feed", "3000", "--json"})).json();
  EXPECT_EQ(object["pulses"], Json({-2000, 3000, 6000}));
  EXPECT_EQ(object["feed_word"], 429);  // 10 · 300000/7000
  EXPECT_NEAR(object["ideal"]["axis_pps"][2], 4285.71, 0.005);
}

TEST(Design, GivesTheTimersRegister) {
  const Folder folder;
  const Json object = leadscrew(folder, {"design", "--timer", "--clock", "1024", "--delays", "2,4,8", "--json"}).json();
  EXPECT_EQ(object["bits"], 13);
  EXPECT_EQ(object["register_max"], 8191);
  EXPECT_EQ(object["loads"], Json({4, 2, 1}));
  EXPECT_EQ(object["seconds"], Json({2.0, 4.0, 8.0}));
}

TEST(Design, GivesKorensClocksAndFeedWords) {
  const Folder folder;
  const Json object = leadscrew(folder, with(koren, {"--distance", "2", "--feed", "10", "--json"})).json();
  EXPECT_EQ(object["q"], 120000);
  EXPECT_EQ(object["q0"], 10000);
  EXPECT_NEAR(object["clock_pps"], 2e6, 1e-6);
  EXPECT_EQ(object["feed_word"], 50);
  EXPECT_EQ(object["time_inverse_per_min"], 5.0);
  EXPECT_EQ(object["software"]["q0"], 3000);
  EXPECT_NEAR(object["software"]["clock_pps"], 5000, 1e-9);
  EXPECT_NEAR(object["software"]["interrupt_us"], 200, 1e-9);
  EXPECT_EQ(object["software"]["feed_word"], 1000);
  const Json arc = leadscrew(folder, with(koren, {"--radius", "7", "--feed", "10", "--json"})).json();
  EXPECT_EQ(arc["feed_word"], 14);
  EXPECT_NEAR(arc["feed_error"], -0.02, 1e-9);
  EXPECT_NEAR(arc["ideal"]["feed_word"], 14.2857, 5e-5);
}

TEST(Design, IsReadByPeopleToo) {
  const Folder folder;
  const std::string text = leadscrew(folder, lecture).output;
  for (const char* part : {"447392.43", "4466.67, 2233.33", "4472.14, 2236.07", "-0.122", "2996.33"})
    EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
  EXPECT_FALSE(contains(text, " \n"));
  EXPECT_EQ(leadscrew(folder, with(lecture, {"--quiet"})).output, "");
}

struct Misuse {
  Words arguments;
  const char* said;
};

TEST(DesignUsage, ErrorsSayWhatIsMissingOrMeant) {
  const Folder folder;
  for (const auto& [arguments, said] : {
           Misuse{{"design"}, "--travel, --blu, --max-feed, --min-distance are missing"},
           Misuse{{"design", "--timer", "--clock", "1kHz", "--delays", "2"}, "--clock 1kHz: is not a number; units"},
           Misuse{{"design", "--travel", "600", "--blu", "0.01", "--max-feed", "9"}, "--min-distance is missing"},
           Misuse{{"design", "--travel", "600mm"}, "--travel 600mm: is not a number"},
           Misuse{with(machine, {"--to", "1,2"}), "--feed is missing"},
           Misuse{with(machine, {"--from", "1,2"}), "--to is missing"},
           Misuse{with(machine, {"--from", "1,2", "--to", "1,2,3", "--feed", "9"}), "one has more axes"},
           Misuse{with(machine, {"--to", "1,,3", "--feed", "9"}), "--to 1,,3: needs numbers"},
           Misuse{with(machine, {"--clock", "9"}), "--clock is not for a linear interpolator"},
           Misuse{{"design", "--timer", "--delays", "9"}, "--clock is missing"},
           Misuse{{"design", "--timer", "--clock", "9"}, "--delays is missing"},
           Misuse{{"design", "--timer", "--inverse-time"}, "one at a time"},
           Misuse{{"design", "--timer", "--clock", "9", "--delays", "1", "--blu", "1"}, "--blu is not for --timer"},
           Misuse{with(koren, {"--to", "1"}), "--to is not for --inverse-time"},
           Misuse{with(koren, {"--feed", "1"}), "--distance is missing"},
           Misuse{with(koren, {"--feed", "1", "--radius", "1", "--distance", "1"}), "one of them"},
           Misuse{with(koren, {"--digits", "0"}), "from 1 to 9"},
           Misuse{with(lecture, {"--trvel", "1"}), "did you mean --travel?"},
           Misuse{{"desing"}, "did you mean design?"},
       }) {
    const Outcome outcome = leadscrew(folder, arguments);
    EXPECT_EQ(outcome.status, 2) << said;
    EXPECT_EQ(outcome.output, "") << said;
    EXPECT_TRUE(contains(outcome.errors, said)) << said << "\n" << outcome.errors;
  }
}

TEST(DesignRejection, NamesTheRegisterOrTheValue) {
  const Folder folder;
  for (const auto& [arguments, said] : {
           Misuse{{"design", "--travel", "600", "--blu", "0", "--max-feed", "9", "--min-distance", "9"},
                  "the BLU is 0 [not-positive]"},
           Misuse{with(machine, {"--to", "700,0", "--feed", "3000"}), "register of axis 1 of 16 bits"},
           Misuse{with(machine, {"--to", "1,0", "--feed", "3000"}), "feed register S of 12 bits"},
           Misuse{with(machine, {"--to", "0,0", "--feed", "3000"}), "[no-way]"},
           Misuse{{"design", "--timer", "--clock", "1024", "--delays", "2,-4"}, "the delay is -4"},
           Misuse{with(koren, {"--distance", "0.001", "--feed", "30"}), "f of 4 digits"},
       }) {
    EXPECT_EQ(leadscrew(folder, arguments).status, 3) << said;
    const Outcome outcome = leadscrew(folder, with(arguments, {"--json"}));
    EXPECT_EQ(outcome.status, 3) << said;
    EXPECT_TRUE(contains(outcome.errors, said)) << outcome.errors;
    EXPECT_EQ(outcome.json()["schema"], "leadscrew.design/1");
    EXPECT_EQ(outcome.json()["diagnostics"].size(), 1u);
  }
}

TEST(Design, HelpShowsExamples) {
  const Folder folder;
  const Outcome outcome = leadscrew(folder, {"design", "--help"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(contains(outcome.output, "leadscrew design --timer --clock 1024 --delays 2,4,8"));
}

}  // namespace test_design
}  // namespace leadscrew::cli::testing
