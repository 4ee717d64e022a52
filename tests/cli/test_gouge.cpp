// `check --gouge`: what it prints and how it ends.

#include <gtest/gtest.h>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_gouge {

/// A trough 20 mm wide, 4.5 mm deep: concave with a radius of 11.1 mm at its bottom.
const std::string trough = "G6.4 D1 P3 Q2 I3 J2\nX0 Y0 Z9\nX10 Z0\nX20 Z9\nX0 Y20\nX10 Z0\nX20 Z9\n";
const std::string tools = "T1 D10 R5 L40 H60 K50\nT2 D40 R20 L60\nT3 D10\nT4 D10 R5 L12 H60 K50\n";

std::string program(int tool, const std::string& more = "") {
  return "T" + std::to_string(tool) + " M6\nG0 Z50\n" + trough + "G6.5 D1 Q3 L2 Z30 F3000\n" + more + "M2\n";
}

Outcome check(const Folder& folder, const std::string& text, std::vector<std::string> more = {}) {
  folder.write("part.ngc", text);
  folder.write("tools.tbl", tools);
  std::vector<std::string> words = {"check", "--gouge", "part.ngc", "--tools", "tools.tbl"};
  words.insert(words.end(), more.begin(), more.end());
  return leadscrew(folder, words);
}

TEST(CheckGouge, IsContentWithToolsThatFit) {
  const Folder folder;
  const auto outcome = check(folder, program(1));
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("none beyond 0.01 mm"), std::string::npos) << outcome.output;
  const auto gouging = check(folder, program(1), {"--json"}).json()["gouging"];
  EXPECT_EQ(gouging["gouges"], false);
  EXPECT_EQ(gouging["surfaces"], 1);
  EXPECT_EQ(gouging["tolerance_mm"], 0.01);
  EXPECT_NEAR(gouging["worst"]["depth_mm"].get<double>(), 0, 1e-5);
  EXPECT_NEAR(gouging["least_clearance"]["clearance_per_mm"].get<double>(), 1 / 5.0 - 0.09, 1e-6);  // 1/R − 9/10²
  EXPECT_TRUE(gouging["blocks"].empty());
  EXPECT_FALSE(check(folder, program(1), {"--json"}).json().contains("gouge"));
}

TEST(CheckGouge, EndsWith1WhereTheToolIsTooLarge) {
  const Folder folder;
  const auto outcome = check(folder, program(2));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.errors.find("part.ngc:10: error: the tool gouges beside its contact with surface 1 at u 0.5"),
            std::string::npos)
      << outcome.errors;
  EXPECT_NE(outcome.errors.find("[gouge-contact]"), std::string::npos);
  EXPECT_NE(outcome.errors.find("[gouge]"), std::string::npos);
  const auto json = check(folder, program(2), {"--json"}).json();
  EXPECT_EQ(json["gouging"]["gouges"], true);
  EXPECT_EQ(json["gouging"]["blocks"][0]["line"], 10);
  EXPECT_EQ(json["gouging"]["blocks"][0]["part"], "cutter");
  EXPECT_LT(json["gouging"]["contacts"][0]["clearance_per_mm"], 0);
  EXPECT_EQ(json["errors"], 2);
}

/// A run that may gouge tells it in its report; others look for nothing.
TEST(CheckGouge, IsShownInTheReportOfARun) {
  const Folder folder;
  folder.write("tools.tbl", tools);
  const Surroundings surroundings = without_page(folder);
  const auto page_of = [&](const std::string& text, bool may_gouge) {
    folder.write("part.ngc", text);
    std::vector<std::string> words = {"run", "part.ngc", "--tools", "tools.tbl", "--report", "part.html"};
    if (may_gouge) words.emplace_back("--allow-gouge");
    const auto outcome = leadscrew(folder, words, surroundings);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return folder.read("part.html");
  };
  const std::string gouging = page_of(program(2), true);
  EXPECT_NE(gouging.find("The tool gouges, as it was allowed to"), std::string::npos);
  EXPECT_NE(gouging.find("G6.5 D1 Q3 L2 Z30 F3000</td><td class=\"over-limit\">"), std::string::npos);
  EXPECT_NE(gouging.find("beside contact</td><td class=\"text\">pass "), std::string::npos);
  EXPECT_NE(gouging.find("<a class=\"place gouge\""), std::string::npos);
  EXPECT_NE(page_of(program(1), true).find("Nowhere: no tool is more than 10 µm"), std::string::npos);
  EXPECT_EQ(page_of(program(1), false).find("Where the tool gouges"), std::string::npos);
}

TEST(CheckGouge, NamesTheHolder) {
  const Folder folder;
  const auto outcome = check(folder, program(4, "G1 X30 Y10 Z1\nG0 Z50\n"));
  EXPECT_EQ(outcome.status, 0) << outcome.errors;  // the holder is above the rims: 9 mm
  const auto low = check(folder, program(4, "G0 X40 Y10\nG1 Z-5\nG0 Z50\n"));
  EXPECT_EQ(low.status, 1);
  EXPECT_NE(low.errors.find("part.ngc:12: error: the holder is"), std::string::npos) << low.errors;
}

TEST(CheckGouge, SaysWhatItDidNotLookAt) {
  const Folder folder;
  const auto unknown = check(folder, program(1, "T3 M6\nG1 Z0\nG0 Z50\n"));
  EXPECT_EQ(unknown.status, 0);
  EXPECT_NE(unknown.errors.find("2 moves were not looked at"), std::string::npos) << unknown.errors;
  EXPECT_NE(unknown.errors.find("[gouge-no-shape]"), std::string::npos);
  const auto many = check(folder, "T1 M6\nG0 Z50\n" + trough +
                                      "#1=0\no1 while [#1 LT 1001]\n#1=[#1+1]\nG10 L2 P1 X[#1/100]\n"
                                      "G6.5 D1 Q19 L2 Z30 F3000\no1 endwhile\nM2\n");
  EXPECT_EQ(many.status, 3);
  EXPECT_NE(many.errors.find("[gouge-too-large]"), std::string::npos) << many.errors;
}

TEST(CheckGouge, SaysWhereTrianglesAreCoarse) {
  const Folder folder;
  std::string wavy = "T1 M6\nG0 Z50\nG6.4 D1 P4 Q4 I40 J40\n";
  for (int j = 0; j < 40; ++j) {
    for (int i = 0; i < 40; ++i)
      wavy += "X" + std::to_string(i * 4) + " Y" + std::to_string(j * 4) + " Z" + std::to_string((i * j) % 3) + "\n";
  }
  const auto outcome =
      check(folder, wavy + "G6.5 D1 Q80 Z30 I0 J0.01 F3000\nM2\n", {"--gouge-tolerance", "0.0001", "--start", "Z50"});
  EXPECT_NE(outcome.errors.find("[gouge-coarse]"), std::string::npos) << outcome.errors;
}

}  // namespace test_gouge
}  // namespace leadscrew::cli::testing
