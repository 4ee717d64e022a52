// The page of a sweep: what it says, by rows whose figures are known.

#include <gtest/gtest.h>

#include <leadscrew/sweep/results_page.hpp>

#include "command.hpp"

namespace test_results_page {

using namespace leadscrew;
using cli::testing::contains;

json::Json row(const std::string& text) {
  return *json::Json::parse(text);
}

std::string ran(const char* program, const char* machine, double tolerance, double time, const char* more = "") {
  return R"({"program":")" + std::string(program) + R"(","machine":")" + machine + R"(","tolerance_mm":)" +
         std::to_string(tolerance) + R"(,"override":1,"status":"kept","time_s":)" + std::to_string(time) + more + "}";
}

std::string refused(const char* program, const char* machine, double tolerance) {
  return R"({"program":")" + std::string(program) + R"(","machine":")" + machine + R"(","tolerance_mm":)" +
         std::to_string(tolerance) + R"(,"override":1,"status":"rejected","code":"travel","line":7,"message":"a<b"})";
}

std::string page_of(const std::vector<std::string>& rows) {
  sweep::ResultsPage page;
  sweep::Summary summary;
  for (const std::string& each : rows) {
    page.observe(row(each));
    sweep::observe(row(each), summary);
  }
  summary.tasks = summary.rows;
  return page.written(summary, "folder & more");
}

TEST(ResultsPage, AddsUpTheTimesOfProgramsThatRunWithEveryValue) {
  const std::string page = page_of({ran("a", "m", 0.01, 3), ran("a", "m", 0.1, 2), ran("b", "m", 0.01, 40),
                                    refused("b", "m", 0.1), ran("c", "m", 0.01, 5), ran("c", "m", 0.1, 4)});
  EXPECT_TRUE(contains(page, "Tolerance, mm"));
  EXPECT_TRUE(contains(page, "m, 2 programs, 0.01: 8.000 s")) << page;
  EXPECT_TRUE(contains(page, "m, 2 programs, 0.1: 6.000 s"));
  EXPECT_FALSE(contains(page, "Override of the feed"));
  EXPECT_FALSE(contains(page, "<h3>Machine"));
}

TEST(ResultsPage, ComparesMachinesByWhatAllOfThemRun) {
  const std::string page = page_of(
      {ran("a", "slow", 0.01, 3), ran("a", "fast", 0.01, 2), ran("b", "slow", 0.01, 30), refused("b", "fast", 0.01)});
  EXPECT_TRUE(contains(page, "Machine, 1 program that all of them run"));
  EXPECT_TRUE(contains(page, "<td class=\"text\">slow</td><td data-value=\"3\">3.000 s</td>")) << page;
  EXPECT_TRUE(contains(page, "<td class=\"text\">fast</td><td data-value=\"2\">2.000 s</td>"));
}

TEST(ResultsPage, SaysWhereTimeIsLostInTheFirstVariantOfAMachine) {
  const std::string page =
      page_of({ran("a", "m", 0.01, 8, R"(,"lost":{"jerk X":1,"stops":0.5})"),
               ran("a", "m", 0.1, 8, R"(,"lost":{"jerk X":100})"), ran("b", "m", 0.01, 2, R"(,"lost":{"jerk X":1})")});
  EXPECT_TRUE(contains(page, "m: 2.500 s of 10.000 s")) << page;
  EXPECT_TRUE(contains(page, "jerk X</td><td>2.000 s</td><td>20 %"));
}

TEST(ResultsPage, ListsARefusalOnceAMachineAndNoTextAsMarkup) {
  const std::string page = page_of({refused("a", "m", 0.01), refused("a", "m", 0.1), refused("a", "n", 0.01)});
  EXPECT_TRUE(contains(page, "a&lt;b</td><td>2</td>")) << page;
  EXPECT_TRUE(contains(page, "a&lt;b</td><td>1</td>"));
  EXPECT_FALSE(contains(page, "a<b"));
  EXPECT_TRUE(contains(page, "folder &amp; more"));
}

TEST(ResultsPage, TellsTheWorstOfEachKindOfACampaign) {
  const std::string page = page_of(
      {R"({"kind":"arcs","seed":1,"number":4,"status":"kept","time_s":1,"jerk_ratio":0.5,"deviation_mm":1,"allowed_mm":4})",
       R"({"kind":"arcs","seed":9007199254740993,"number":5,"status":"not-kept","broken":"jerk","time_s":1,"jerk_ratio":1.25})"});
  EXPECT_TRUE(contains(page, "<td data-value=\"1.25\">1.25</td>")) << page;
  EXPECT_TRUE(contains(page, "<td data-value=\"0.25\">0.25</td>"));
  EXPECT_TRUE(contains(page, "seed 9007199254740993, number 5 (arcs)</td><td class=\"text long bad\">jerk"));
  EXPECT_TRUE(contains(page, "verdict bad"));
}

TEST(ResultsPage, SaysThatAllIsKeptWhereSomethingRanAndAllOfItWas) {
  const std::string kept = ran("a", "m", 0.01, 3), changed = R"(,"changed":"jerk X")";
  EXPECT_TRUE(contains(page_of({kept}), "verdict good\">Every motion keeps"));
  for (const auto& rows : {std::vector<std::string>{}, {refused("a", "m", 0.01)}}) {
    const std::string page = page_of(rows);
    EXPECT_TRUE(contains(page, "<p class=\"verdict\">No program has run.")) << page;
    EXPECT_FALSE(contains(page, "Every motion keeps"));
  }
  std::string variant = ran("a", "m", 0.01, 2, changed.c_str());
  variant.replace(variant.find("\"kept\""), 6, "\"not-kept\"");
  const std::string page = page_of({kept, variant});
  EXPECT_TRUE(contains(page, "verdict bad\">1 of the tasks did not keep")) << page;
}

TEST(ResultsPage, IsWrittenByASweepAndNeedsNoOtherFile) {
  const cli::testing::Folder folder;
  folder.write("a.ngc", cli::testing::square);
  ASSERT_EQ(cli::testing::leadscrew(folder, {"sweep", "--programs", "a.ngc", "--jerk", "1,2", "--out", "out"}).status,
            0);
  const std::string page = folder.read("out/results.html");
  EXPECT_TRUE(contains(page, "Jerk of every axis"));
  for (const char* const other : {"http:", "https:", "src=", "<link", "@import", "url("})
    EXPECT_FALSE(contains(page, other)) << other;
}

}  // namespace test_results_page
