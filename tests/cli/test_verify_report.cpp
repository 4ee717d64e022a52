// `verify --report` and `--picture`: traces of this and of other controllers, drawn with the referee's verdict.

#include <gtest/gtest.h>

#include <cmath>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_verify_report {

const std::string there_and_back = "G21 G90 G61\nG0 X10\nG1 X20 F600\nG0 X0\nM2\n";

/// Columns t and X alone, each move at constant speed at once: 10 mm at 100 mm/s, 10 mm at 10 mm/s, 20 mm at 100 mm/s.
std::string hasty_trace(double feed) {
  std::ostringstream rows;
  rows << "t,X\n0,0\n";
  double x = 0;
  int k = 0;
  const auto go_to = [&](double end, double speed) {
    for (const double from = x, count = std::round(std::fabs(end - from) / speed * 1000); x != end;) {
      const double left = std::fabs(end - x) - speed / 1000;
      x = left < 1e-9 ? end : x + (end > from ? 1 : -1) * speed / 1000;
      rows << ++k / 1000.0 << ',' << x << '\n';
      if (k > 10 * count + 10000) break;
    }
  };
  go_to(10, 100);
  go_to(20, feed);
  go_to(0, 100);
  return rows.str();
}

TEST(VerifyReport, ShowsAnotherControllersTraceAndWhatIsWrongWithIt) {
  const Folder folder;
  folder.write("part.ngc", there_and_back);
  folder.write("other.csv", hasty_trace(12));
  const auto outcome =
      leadscrew(folder, {"verify", "other.csv", "part.ngc", "--report", "r.html", "--picture", "p.svg"});
  EXPECT_EQ(outcome.status, 1) << outcome.errors;
  EXPECT_TRUE(contains(outcome.output, "wrote      r.html"));
  const std::string page = folder.read("r.html"), picture = folder.read("p.svg");
  for (const char* text :
       {"Judgement of a trace", "<h1>other.csv</h1>", "Judged by part.ngc.", "Exceeds what was asked",
        "Exceeds the programmed feed by 20 %", "Exceeds the jerk limit of axis X", "What the referee objects to",
        "G1 X20 F600</td><td class=\"text\">feed</td><td class=\"over-limit\">12</td><td>10</td>", "<b>jerk</b>",
        "Rows of the trace", "rapids up to 6000"}) {
    EXPECT_TRUE(contains(page, text)) << text;
  }
  for (const char* text : {"Keeps every limit", "planned</th>", "without jerk limit", "Where time is lost"})
    EXPECT_FALSE(contains(page, text)) << text;
  // The trace has no column for lines: the referee knows which rows are of rapids.
  EXPECT_TRUE(contains(picture, ">720 mm/min</text>"));
  EXPECT_TRUE(contains(picture, ">rapids</text>"));
}

TEST(VerifyReport, FindsNothingWrongWithTheWordsOfRun) {
  const Folder folder;
  folder.write("part.ngc", there_and_back);
  leadscrew(folder, {"run", "part.ngc", "--trace", "t.csv", "--picture", "words.svg", "--charts", "words.charts.svg"});
  const auto outcome = leadscrew(folder, {"verify", "t.csv", "part.ngc", "--json", "--report", "r.html", "--picture",
                                          "trace.svg", "--charts", "charts.svg"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_TRUE(contains(folder.read("r.html"), "Keeps every limit"));
  EXPECT_FALSE(contains(folder.read("r.html"), "What the referee objects to"));
  EXPECT_TRUE(contains(folder.read("trace.svg"), ">600 mm/min</text>"));
  EXPECT_EQ(outcome.json()["violation_count"], 0);
  // The same words, under the name of the trace.
  std::string words = folder.read("words.charts.svg"), trace = folder.read("charts.svg");
  EXPECT_TRUE(contains(trace, "velocity, % of the limit"));
  EXPECT_EQ(words.substr(words.find("<style>")).size(), trace.substr(trace.find("<style>")).size() + 3);
  EXPECT_EQ(words.substr(words.find("class=\"name\"")), trace.substr(trace.find("class=\"name\"")));
}

TEST(VerifyReport, IsNotWrittenOverWhatIsRead) {
  const Folder folder;
  folder.write("part.html", there_and_back);
  folder.write("other.csv", hasty_trace(10));
  const auto over = leadscrew(folder, {"verify", "other.csv", "part.html", "--report", "./part.html"});
  EXPECT_EQ(over.status, 2);
  EXPECT_TRUE(contains(over.errors, "./part.html is the program itself")) << over.errors;
  EXPECT_EQ(leadscrew(folder, {"verify", "other.csv", "part.html", "--report", "other.csv/r.html"}).status, 4);
  EXPECT_EQ(folder.read("part.html"), there_and_back);
  EXPECT_EQ(folder.names(), (Names{"part.html", "other.csv"}));
}

}  // namespace test_verify_report
}  // namespace leadscrew::cli::testing
