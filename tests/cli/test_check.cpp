// What check tells of a program without moving: where its path goes, the least time it takes, and feeds beyond the machine.

#include <gtest/gtest.h>

#include <cmath>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_check {

Json checked(const Folder& folder, const std::string& text, int status = 0) {
  folder.write("part.ngc", text);
  const auto outcome = leadscrew(folder, {"check", "part.ngc", "--json"});
  EXPECT_EQ(outcome.status, status) << outcome.errors;
  return outcome.json();
}

/// line:column of each feed beyond an axis.
Names excesses(const Json& check) {
  Names places;
  for (const std::string& place : places_of(check["diagnostics"])) {
    const std::size_t code = place.find(" feed-beyond-axis");
    if (code != std::string::npos) places.insert(place.substr(0, code));
  }
  EXPECT_EQ(check["warnings"], places.size());
  return places;
}

TEST(CheckOfAPath, HasTheExtentsAndTheBoundOfItsRun) {
  const Folder folder;
  for (const char* name : {"03-arcs-in-three-planes", "05-finishing", "09-butterfly", "11-splines"}) {
    const std::string program = source_folder / "examples" / (std::string(name) + ".ngc");
    const Json check = leadscrew(folder, {"check", program, "--json"}).json();
    const Json run = leadscrew(folder, {"run", program, "--json"}).json();
    const double bound = run["bound_s"];
    EXPECT_NEAR(check["bound_s"].get<double>(), bound, 1e-6 * bound) << name;
    ASSERT_EQ(check["extents"].size(), run["extents"].size());
    for (std::size_t i = 0; i < run["extents"].size(); ++i) {
      EXPECT_EQ(check["extents"][i]["name"], run["extents"][i]["name"]);
      for (const auto& [end, sign] : {std::pair("least", -1), {"greatest", 1}}) {
        // Between two words the path goes on by what acceleration makes of a period, and no less far than words do.
        const double beyond = sign * (check["extents"][i][end].get<double>() - run["extents"][i][end].get<double>());
        EXPECT_GE(beyond, -1e-9) << name << i << end;
        EXPECT_LE(beyond, 1000 * 1e-3 * 1e-3) << name << i << end;
      }
    }
  }
}

TEST(CheckOfAPath, FindsWhereAnArcBulges) {
  const Folder folder;
  const Json extents = checked(folder, "G21 G90 G61\nG3 X-6 Y8 I-10 J0 F600\nM2\n", 3)["extents"];
  EXPECT_EQ(extents, Json::array());  // the arc does not end on its circle
  const Json of_arc = checked(folder, "G21 G90 G61\nG3 X-16 Y8 I-10 J0 F600\nM2\n")["extents"];
  EXPECT_NEAR(of_arc[0]["least"].get<double>(), -16, 1e-9);
  EXPECT_EQ(of_arc[0]["greatest"], 0.0);
  EXPECT_NEAR(of_arc[1]["greatest"].get<double>(), 10, 1e-9);
}

TEST(CheckOfAPath, TellsNeitherOfAProgramWithErrors) {
  const Folder folder;
  const Json check = checked(folder, "G21 G90\nG1 X10 F600\nG1 X20 Q\nM2\n", 3);
  EXPECT_TRUE(check["bound_s"].is_null());
  EXPECT_EQ(check["extents"], Json::array());
}

/// mill3: 12 000 mm/min for each axis.
TEST(CheckOfFeeds, WarnsWhereAnAxisIsSlower) {
  const Folder folder;
  const std::string head = "G21 G90 G61\n";
  EXPECT_EQ(excesses(checked(folder, head + "G1 X10 F12000\nY10 F12010\nM2\n")), Names{});
  EXPECT_EQ(excesses(checked(folder, head + "G1 X10 F12100\nM2\n")), Names{"2:8"});
  // Along a diagonal two axes share it; round a circle each takes all of it somewhere.
  EXPECT_EQ(excesses(checked(folder, head + "G1 X10 Y10 F16900\nM2\n")), Names{});
  EXPECT_EQ(excesses(checked(folder, head + "G1 X10 Y10 F17000\nM2\n")), Names{"2:12"});
  EXPECT_EQ(excesses(checked(folder, head + "G2 X10 Y0 I5 J0 F13000\nM2\n")), Names{"2:17"});
  // Where the block has no F word, at its first word.
  EXPECT_EQ(excesses(checked(folder, head + "G1 X10 Y10 F16900\n X0 (back)\nM2\n")), Names{"3:2"});
  EXPECT_EQ(excesses(checked(folder, head + "G93 G1 X10 F1210\nX0 F1100\nM2\n")), Names{"2:12"});
  EXPECT_EQ(excesses(checked(folder, head + "G0 X10\nM2\n")), Names{});
}

TEST(CheckOfFeeds, WarnsOfEachLineOnce) {
  const Folder folder;
  const Json check = checked(folder, "G21 G90\nG81 X10 Y10 Z-2 R1 F30000 L3\nG80\nM2\n");
  EXPECT_EQ(check["moves"], 8);
  EXPECT_EQ(excesses(check), Names{"2:20"});
}

TEST(CheckOfFeeds, WarnsOfCurvesOfManyBlocks) {
  const Folder folder;
  EXPECT_EQ(excesses(checked(folder, "G21 G90\n G5.2 P1 X10 Y5 F40000\nX20 Y20 P1\nX30 Y0 P1\nG5.3\nM2\n")),
            Names{"2:2"});
}

TEST(CheckOfFeeds, NamesTheAxisAndWhatItCan) {
  const Folder folder;
  const Json warning = checked(folder, "G21 G90\nG1 X3 Y4 F30000\nM2\n")["diagnostics"].at(0);
  EXPECT_EQ(warning["severity"], "warning");
  EXPECT_EQ(warning["message"], "a feed of 30000 mm/min is more than the velocity of axis Y allows here");
  EXPECT_EQ(warning["hint"], "no more than 15000 mm/min can be kept throughout this block");
}

TEST(CheckOfFeeds, IsNoMatterOfARun) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90\nG1 X10 F30000\nM2\n");
  const Json run = leadscrew(folder, {"run", "part.ngc", "--json"}).json();
  EXPECT_EQ(run["diagnostics"], Json::array());  // `losses` says what it costs
}

}  // namespace test_check
}  // namespace leadscrew::cli::testing
