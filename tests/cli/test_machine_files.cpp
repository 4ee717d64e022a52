// Machine files: what is wrong with one is said with its line; those of the project are sound.

#include <gtest/gtest.h>

#include <ostream>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_machine_files {

std::string replaced(const std::string& what, const std::string& by) {
  std::string text = machine_text();
  return text.replace(text.find(what), what.size(), by);
}

struct BadMachine {
  const char* name;
  std::string text;
  int line;
  const char* code;
  const char* said;  ///< somewhere in message and hint

  friend void PrintTo(const BadMachine& bad, std::ostream* stream) { *stream << bad.name; }
};

class RejectedMachine : public ::testing::TestWithParam<BadMachine> {};

TEST_P(RejectedMachine, IsNamedWithLineAndCodeAndNothingMoves) {
  const BadMachine& bad = GetParam();
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("m.toml", bad.text);
  const auto run = leadscrew(folder, {"run", "part.ngc", "--machine", "m.toml", "--trace", "t.csv", "--json"});
  EXPECT_EQ(run.status, 3);
  const Json object = run.json();
  EXPECT_TRUE(object["machine"].is_null());
  ASSERT_EQ(object["diagnostics"].size(), 1u) << object.dump(1);
  const Json& problem = object["diagnostics"][0];
  EXPECT_EQ(problem["file"], "m.toml");
  EXPECT_EQ(problem["line"], bad.line);
  EXPECT_EQ(problem["code"], bad.code);
  EXPECT_EQ(problem["severity"], "error");
  const std::string text = problem["message"].get<std::string>() + " / " + problem["hint"].get<std::string>();
  EXPECT_TRUE(contains(text, bad.said)) << text;
  if (bad.line > 0) {
    EXPECT_TRUE(run.errors.starts_with("m.toml:" + std::to_string(bad.line) + ":")) << run.errors;
  }
  EXPECT_TRUE(contains(run.errors, std::string(" [") + bad.code + "]\n")) << run.errors;
  EXPECT_EQ(folder.names(), (Names{"m.toml", "part.ngc"}));
}

// Lines 1 to 5 are the machine's; [axis.X] is line 6, travel 7, velocity 8, acceleration 9, jerk 10, blu 11.
INSTANTIATE_TEST_SUITE_P(
    Every, RejectedMachine,
    ::testing::Values(
        BadMachine{"UnknownKey", replaced("tolerance_mm", "tolerence_mm"), 4, "machine-key", "tolerance_mm"},
        BadMachine{"UnknownKeyOfAxis", replaced("blu_mm = 0.001", "blu_mm = 0.001\ncolour = 3"), 12, "machine-key",
                   "colour"},
        BadMachine{"KeyOfRotaryAxis", replaced("max_velocity_mm_s", "max_velocity_deg_s"), 8, "machine-key",
                   "max_velocity_mm_s"},
        BadMachine{"UnknownAxis", replaced("[axis.Y]", "[axis.Q]"), 12, "machine-key", "Q"},
        BadMachine{"MissingKey", replaced("max_jerk_mm_s3 = 20000\n", ""), 6, "machine-missing", "max_jerk_mm_s3"},
        BadMachine{"StringForNumber", replaced("= 200", "= \"200\""), 8, "machine-type", "a string"},
        BadMachine{"NumberForString", replaced("\"other\"", "3"), 1, "machine-type", "an integer"},
        BadMachine{"NumberForTravel", replaced("[-500, 500]", "500"), 7, "machine-type", "an integer"},
        BadMachine{"OneNumberForTravel", replaced("[-500, 500]", "[500]"), 7, "machine-type", "a list, but not of two"},
        BadMachine{"TravelBackwards", replaced("[-500, 500]", "[500, -500]"), 7, "machine-travel", "axis X"},
        BadMachine{"VelocityZero", replaced("= 200", "= 0"), 8, "machine-limit", "axis X"},
        BadMachine{"AccelerationNegative", replaced("= 1000\nmax_jerk", "= -1\nmax_jerk"), 9, "machine-limit",
                   "axis X"},
        BadMachine{"JerkZero", replaced("= 20000", "= 0.0"), 10, "machine-limit", "axis X"},
        BadMachine{"JerkNotANumber", replaced("= 20000", "= nan"), 10, "machine-limit", "axis X"},
        BadMachine{"UnitZero", replaced("blu_mm = 0.001", "blu_mm = 0"), 11, "machine-limit", "axis X"},
        BadMachine{"PeriodTooShort", replaced("= 1000", "= 9.999"), 3, "machine-period", "10 and 20000"},
        BadMachine{"PeriodTooLong", replaced("= 1000", "= 20001"), 3, "machine-period", "10 and 20000"},
        BadMachine{"ToleranceNegative", replaced("= 0.01\n", "= -0.01\n"), 4, "machine-tolerance", ""},
        BadMachine{"Syntax", replaced("= 1000", "="), 3, "machine-syntax", "TOML"},
        BadMachine{"KeyTwice", replaced("period_us = 1000", "period_us = 1000\nperiod_us = 1000"), 4, "machine-syntax",
                   "TOML"},
        BadMachine{"UnknownKinematics", replaced("cartesian", "delta"), 2, "machine-kinematics", "delta"},
        BadMachine{"MisspeltKinematics", replaced("cartesian", "cartesain"), 2, "machine-kinematics",
                   "did you mean cartesian?"},
        BadMachine{"NoAxis", "name = \"none\"\n", 0, "machine-axes", "[axis.X]"},
        BadMachine{"Empty", "", 0, "machine-axes", "[axis.X]"}),
    [](const auto& bad) { return std::string(bad.param.name); });

TEST(MachineFiles, TellEveryProblemInOnePass) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("m.toml", "nmae = \"a\"\nperiod_us = 5\nkinematics = 4\n[axis.X]\nblu_mm = \"x\"\n");
  const Json object = leadscrew(folder, {"check", "part.ngc", "--machine", "m.toml", "--json"}).json();
  Names found;
  for (const Json& problem : object["diagnostics"])
    found.insert(std::to_string(problem["line"].get<int>()) + " " + problem["code"].get<std::string>());
  EXPECT_EQ(found,
            (Names{"1 machine-key", "2 machine-period", "3 machine-type", "4 machine-missing", "5 machine-type"}));
}

TEST(MachineFiles, TakePeriodsAtBothEnds) {
  const Folder folder;
  folder.write("part.ngc", square);
  for (const auto& [text, seconds] : {std::pair("10", 10e-6), {"20000", 20e-3}}) {
    folder.write("m.toml", replaced("= 1000", std::string("= ") + text));
    const auto run = leadscrew(folder, {"run", "part.ngc", "--machine", "m.toml", "--json"});
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.json()["period_s"], seconds);
    EXPECT_EQ(run.json()["machine"], "other");
  }
}

TEST(MachineFiles, OfTheProjectAllLoad) {
  const Folder folder;
  folder.write("part.ngc", square);
  int machines = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_folder / "machines")) {
    if (entry.path().extension() != ".toml") continue;
    ++machines;
    const auto run = leadscrew(folder, {"run", "part.ngc", "--machine", entry.path(), "--json"});
    EXPECT_EQ(run.status, 0) << entry.path() << run.errors;
    EXPECT_EQ(run.json()["machine"], entry.path().stem().string());
  }
  EXPECT_GE(machines, 4);
}

TEST(MachineFiles, Mill3IsTheBuiltInMachine) {
  const Folder folder;
  const std::filesystem::path part = source_folder / "examples" / "05-finishing.ngc";
  ASSERT_EQ(leadscrew(folder, {"run", part, "--trace", "a.csv"}).status, 0);
  ASSERT_EQ(leadscrew(folder, {"run", part, "--trace", "b.csv", "--machine", source_folder / "machines" / "mill3.toml"})
                .status,
            0);
  ASSERT_EQ(
      leadscrew(folder, {"run", part, "--trace", "c.csv", "--machine", source_folder / "machines" / "heavy3.toml"})
          .status,
      0);
  EXPECT_TRUE(folder.read("a.csv") == folder.read("b.csv"));
  EXPECT_FALSE(folder.read("a.csv") == folder.read("c.csv"));
}

}  // namespace test_machine_files
}  // namespace leadscrew::cli::testing
