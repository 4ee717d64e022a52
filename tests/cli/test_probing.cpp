// A probe that the machine file simulates, through the verbs.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_probing {

const std::string probing_machine = R"(
[probe]
plane_mm = {Z = -3}
[axis.Z]
travel_mm = [-500, 500]
max_velocity_mm_s = 200
max_acceleration_mm_s2 = 1000
max_jerk_mm_s3 = 20000
blu_mm = 0.001
)";

const std::string program =
    "G21 F600 (PROBEOPEN points.txt)\nG1 Z-1\nG38.2 Z-10\n(PROBECLOSE)\nG1 Z[#5063*2]\n(PRINT,%.1f#5063 %d#5070)\nM2\n";

TEST(Probing, EndsMotionAtThePlane) {
  const Folder folder;
  folder.write("m.toml", probing_machine);
  folder.write("a.ngc", program);
  const auto ran = leadscrew(folder, {"run", "a.ngc", "--machine", "m.toml", "--json", "--trace", "a.csv"});
  ASSERT_EQ(ran.status, 0) << ran.errors;
  EXPECT_EQ(ran.errors, "-3.0 1\n");
  EXPECT_EQ(nlohmann::json::parse(ran.output)["length_mm"], 6);
  EXPECT_EQ(folder.read("points.txt"),
            "0.000000 0.000000 -3.000000 0.000000 0.000000 0.000000 0.000000 0.000000 0.000000\n");
  EXPECT_EQ(leadscrew(folder, {"verify", "a.csv", "a.ngc", "--machine", "m.toml", "--quiet"}).status, 0);
}

/// Around a ball in G31 and G38.2, and into a bore: verify reads the places that the run has found.
TEST(Probing, FindsBodiesAsTheVerifierDoes) {
  const Folder folder;
  std::string machine =
      "[probe]\nsphere_mm = [[20, 10, -20, 13]]\nbox_mm = [[-50, -50, -60, -10, 50, -5]]\n"
      "bore_mm = [[-30, 0, -30, -30, 0, 0, 9]]\n";
  const std::string z = probing_machine.substr(probing_machine.find("[axis.Z]"));
  for (const char axis : {'X', 'Y', 'Z'}) machine += std::string(z).replace(z.find('Z'), 1, 1, axis);
  folder.write("m.toml", machine);
  folder.write(
      "a.ngc",
      "G21 G61 F600\nG0 X40 Y15 Z-20\nG31 X20\n#1=#5061\nG1 X40\nG0 Z5\nX20 Y10\nG38.2 Z-30\n(PRINT,%.4f#1 #5063)\n"
      "G0 Z5\nX-33 Y0\nG1 Z-12\nG38.3 X-60\n#2=#5061\nG38.5 X-25\nG38.3 X0\n(PRINT,%.4f#2 #5061)\nG0 Z5\nM2\n");
  const auto ran = leadscrew(folder, {"run", "a.ngc", "--machine", "m.toml", "--json", "--trace", "a.csv"});
  ASSERT_EQ(ran.status, 0) << ran.errors;
  EXPECT_EQ(ran.errors, "32.0000 -7.0000\n-39.0000 -21.0000\n");
  const auto judged = leadscrew(folder, {"verify", "a.csv", "a.ngc", "--machine", "m.toml", "--json"});
  EXPECT_EQ(judged.status, 0) << judged.errors;
  EXPECT_LT(nlohmann::json::parse(judged.output)["deviation_mm"].get<double>(), 1e-9);
  folder.write("n.toml", std::string(machine).replace(machine.find("13]"), 2, "12"));
  EXPECT_EQ(leadscrew(folder, {"verify", "a.csv", "a.ngc", "--machine", "n.toml", "--quiet"}).status, 1);
}

TEST(Probing, RestsBeforeAndBehind) {
  const Folder folder;
  folder.write("m.toml", probing_machine);
  folder.write("a.ngc", program);
  folder.write("b.ngc", "G21 F600\nG1 Z-1\nG4 P0\nG1 Z-3\nG4 P0\nG1 Z-6\nM2\n");
  const auto time = [&](const std::string& name) {
    const auto ran = leadscrew(folder, {"run", name, "--machine", "m.toml", "--json", "--quiet"});
    return nlohmann::json::parse(ran.output)["time_s"].get<double>();
  };
  EXPECT_EQ(time("a.ngc"), time("b.ngc"));
}

TEST(Probing, FailsWhereItMustFind) {
  const Folder folder;
  folder.write("m.toml", probing_machine);
  folder.write("a.ngc", "G21 F600\nG38.2 Z-2\nM2\n");
  const auto ran = leadscrew(folder, {"run", "a.ngc", "--machine", "m.toml"});
  EXPECT_EQ(ran.status, 3);
  EXPECT_NE(ran.errors.find("a.ngc:2:1: error: "), std::string::npos) << ran.errors;
  EXPECT_NE(ran.errors.find("[probe-failed]"), std::string::npos) << ran.errors;
}

TEST(Probing, IsTakenForGrantedWithoutAProbe) {
  const Folder folder;
  folder.write("a.ngc", program);
  const auto ran = leadscrew(folder, {"check", "a.ngc"});
  EXPECT_EQ(ran.status, 0);
  EXPECT_NE((ran.output + ran.errors).find("[probe-not-simulated]"), std::string::npos) << ran.errors;
}

TEST(Probing, IsACanonicalCallToThePointProgrammed) {
  const Folder folder;
  folder.write("m.toml", probing_machine);
  folder.write("a.ngc", program);
  const auto told = leadscrew(folder, {"canon", "a.ngc", "--machine", "m.toml"}).output;
  EXPECT_NE(told.find("TURN_PROBE_ON()\n"), std::string::npos) << told;
  EXPECT_NE(told.find("STRAIGHT_PROBE(0.0000, 0.0000, -10.0000,"), std::string::npos) << told;
  EXPECT_NE(told.find("TURN_PROBE_OFF()\n"), std::string::npos) << told;
  EXPECT_NE(told.find("STRAIGHT_FEED(0.0000, 0.0000, -6.0000,"), std::string::npos) << told;
}

}  // namespace test_probing
}  // namespace leadscrew::cli::testing
