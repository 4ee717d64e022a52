// `leadscrew study`, and the rule of parameter steps that `run` takes.

#include <gtest/gtest.h>

#include <algorithm>
#include <leadscrew/realtime/share_out.hpp>
#include <vector>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_study {

TEST(Study, ListNamesWhatThereIs) {
  const Folder folder;
  const Outcome text = leadscrew(folder, {"study", "list"});
  EXPECT_EQ(text.status, 0);
  const Json object = leadscrew(folder, {"study", "list", "--json"}).json();
  EXPECT_EQ(object["schema"], "leadscrew.study/2");
  ASSERT_TRUE(object["studies"].is_array());
  Names names;
  for (const Json& study : object["studies"]) {
    names.insert(study["name"]);
    EXPECT_TRUE(contains(text.output, study["name"].get<std::string>()));
    EXPECT_TRUE(contains(text.output, study["title"].get<std::string>()));
  }
  EXPECT_EQ(names, (Names{"butterfly", "feed-fluctuation", "limits", "table-1", "orders", "10001", "fpga-table-1",
                          "lecture", "closed-loop-pulses", "real-time-vs-offline", "adaptive-force", "koren-feed",
                          "digital-integrals", "bounds", "tube", "five-axes", "surface"}));
}

TEST(ShareOut, DoesEachPartOnce) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{1000}}) {
    std::vector<int> done(count);
    realtime::share_out(count, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(count, 1));
  }
}

TEST(Study, RowsAreWhatTheContractSays) {
  const Folder folder;
  const Outcome outcome = leadscrew(folder, {"study", "feed-fluctuation", "--json"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.errors, "");
  const Json object = outcome.json();
  EXPECT_EQ(object["schema"], "leadscrew.study/2");
  EXPECT_EQ(object["name"], "feed-fluctuation");
  ASSERT_GT(object["rows"].size(), 100u);
  Names whats;
  for (const Json& row : object["rows"]) {
    EXPECT_TRUE(row["what"].is_string() && row["verdict"].is_string() && row["why"].is_string()) << row;
    EXPECT_TRUE(row["published"].is_number() || row["published"].is_null()) << row;
    EXPECT_TRUE(row["ours"].is_number() || row["ours"].is_null()) << row;
    EXPECT_TRUE(row["unit"].is_string()) << row;
    EXPECT_TRUE(row["expected"].is_number() || row["expected"].is_null()) << row;
    EXPECT_EQ(row["published"].is_null(), row["source"].is_null()) << row;
    EXPECT_TRUE(row["source"].is_null() || (row["source"]["paper"].is_string() && row["source"]["where"].is_string()));
    EXPECT_EQ(row["published"].is_null() && row["expected"].is_null(), row["verdict"] == "measured") << row;
    EXPECT_TRUE(whats.insert(row["what"]).second) << "twice: " << row["what"];
  }
  EXPECT_TRUE(whats.contains("expected: plane cubic, V 10 mm/s: length"));
}

TEST(Study, TableHasColoursOnlyWhenAskedFor) {
  const Folder folder;
  const Outcome plain = leadscrew(folder, {"study", "feed-fluctuation"});
  EXPECT_EQ(plain.status, 0);
  EXPECT_TRUE(contains(plain.output, "verdict"));
  EXPECT_TRUE(contains(plain.output, "29.8413"));
  EXPECT_FALSE(contains(plain.output, "\033["));
  EXPECT_TRUE(contains(leadscrew(folder, {"study", "feed-fluctuation", "--color", "always"}).output, "\033["));
}

/// The column, in characters, at which a text begins in the line that holds it.
std::size_t column(const std::string& text, const std::string& part) {
  const std::size_t at = text.find(part);
  if (at == std::string::npos) return std::string::npos;
  const std::size_t line = text.rfind('\n', at) + 1;
  return static_cast<std::size_t>(std::count_if(text.begin() + static_cast<std::ptrdiff_t>(line),
                                                text.begin() + static_cast<std::ptrdiff_t>(at),
                                                [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

TEST(Study, ColumnsAreAligned) {
  const Folder folder;
  const std::string table = leadscrew(folder, {"study", "feed-fluctuation"}).output;
  const std::size_t verdicts = column(table, "verdict");
  EXPECT_EQ(column(table, "exact"), verdicts);
  EXPECT_EQ(column(table, "reproduced"), verdicts);
  EXPECT_EQ(column(table, "differs"), verdicts);  // behind a µ, of two bytes
  EXPECT_EQ(column(table, "Lin and Koren, section 4"), column(table, "why"));
  EXPECT_EQ(column(table, "29.8413  "), column(table, "expected") + 1);
}

TEST(Study, UnknownNameIsAUsageErrorThatSaysWhatWasMeant) {
  const Folder folder;
  struct Misuse {
    std::vector<std::string> arguments;
    const char* said;
  };
  for (const auto& [arguments, said] : {
           Misuse{{"study", "buterfly"}, "no study \"buterfly\"; did you mean butterfly?"},
           Misuse{{"study", "feed-fluctuations"}, "did you mean feed-fluctuation?"},
           Misuse{{"study", "zzz"},
                  "there are list, butterfly, feed-fluctuation, limits, tube, table-1, orders, 10001, fpga-table-1, "
                  "lecture, "
                  "closed-loop-pulses, real-time-vs-offline, five-axes, surface, adaptive-force, koren-feed, "
                  "digital-integrals, "
                  "bounds"},
           Misuse{{"study"}, "NAME"},
           Misuse{{"study", "butterfly", "--words", "made"}, "--words: there is none of butterfly; there is of tube"},
           Misuse{{"study", "tube", "--picture", "made.svg"},
                  "--picture: there is none of tube; there is of real-time-vs-offline, five-axes"},
           Misuse{{"study", "list", "--machine", "mill3"}, "no option --machine"},
           Misuse{{"stduy", "list"}, "did you mean study?"},
           Misuse{{"run", "part.ngc", "--interpolator", "taylor3"},
                  "is none of arc-length, taylor1, taylor2, newton, uniform"},
           Misuse{{"check", "part.ngc", "--interpolator", "taylor1"}, "no option --interpolator"},
       }) {
    const Outcome outcome = leadscrew(folder, arguments);
    EXPECT_EQ(outcome.status, 2) << said;
    EXPECT_EQ(outcome.output, "") << said;
    EXPECT_TRUE(contains(outcome.errors, said)) << outcome.errors;
  }
}

TEST(LongStudy, WritesWordsThatVerifyJudgesKept) {
  const Folder folder;
  ASSERT_EQ(leadscrew(folder, {"study", "tube", "--words", "made/words"}).status, 0);
  for (const std::string name : {"corner-90", "square", "engraving", "pocket"}) {
    const std::string file = "made/words/" + name;
    const Outcome outcome = leadscrew(folder, {"verify", file + ".csv", file + ".ngc", "--json"});
    EXPECT_EQ(outcome.status, 0) << name;
    EXPECT_EQ(outcome.errors, "") << name;
    EXPECT_EQ(outcome.json()["violation_count"], 0) << name;
  }
}

TEST(Study, HelpShowsAnExample) {
  const Folder folder;
  const Outcome outcome = leadscrew(folder, {"study", "--help"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(contains(outcome.output, "leadscrew study butterfly"));
  EXPECT_TRUE(contains(leadscrew(folder, {"run", "--help"}).output, "--interpolator"));
}

TEST(Interpolator, EveryRuleIsTaken) {
  const Folder folder;
  folder.write("part.ngc", square);
  for (const char* rule : {"arc-length", "taylor1", "taylor2", "newton", "uniform"})
    EXPECT_EQ(leadscrew(folder, {"run", "part.ngc", "--interpolator", rule, "--quiet"}).status, 0) << rule;
}

TEST(Study, DrawsTheFeedsThatItMeasured) {
  const Folder folder;
  const auto outcome = leadscrew(folder, {"study", "real-time-vs-offline", "--quiet", "--picture", "feeds.svg"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  const std::string picture = folder.read("feeds.svg");
  std::size_t lines = 0, points = 0, ends_at_rest = 0;
  for (std::size_t at = 0; (at = picture.find("class=\"line c", at)) != std::string::npos; ++at) {
    ++lines;
    points += static_cast<std::size_t>(std::count(picture.begin() + static_cast<std::ptrdiff_t>(at),
                                                  picture.begin() + static_cast<std::ptrdiff_t>(picture.find("/>", at)),
                                                  'L'));
    // The last point is as low as the first, which is before anything moves: axes stand.
    const std::string line = picture.substr(at, picture.find("\"/>", at) - at);
    const double first = std::stod(line.substr(line.find(' ', line.find('M')))),
                 last = std::stod(line.substr(line.rfind(' ')));
    ends_at_rest += std::fabs(last - first) < 1.1 ? 1 : 0;  // of 170 units for 16 mm/s
  }
  EXPECT_EQ(lines, 8U);
  EXPECT_EQ(ends_at_rest, 8U);
  // A point every 10 ms: twice two times 3.0 s and 10.4 s, and on until axes stand.
  EXPECT_GT(static_cast<double>(points), 4 * (300 + 1040));
  EXPECT_LT(static_cast<double>(points), 4 * (300 + 1040) + 8 * 300);
  EXPECT_TRUE(contains(picture, "leadscrew study real-time-vs-offline: feed at the tachometers, mm/s</title>"));
  const auto none = leadscrew(folder, {"study", "butterfly", "--picture", "none.svg"});
  EXPECT_EQ(none.status, 2);
  EXPECT_TRUE(contains(none.errors, "there is none of butterfly; there is of real-time-vs-offline")) << none.errors;
  const auto nowhere = leadscrew(folder, {"study", "real-time-vs-offline", "--picture", "feeds.svg/more.svg"});
  EXPECT_EQ(nowhere.status, 4);
  EXPECT_EQ(folder.names(), Names{"feeds.svg"});
}

TEST(Study, EndsWhenInterrupted) {
  const Folder folder;
  Running running(folder, {"study", "limits"});
  ASSERT_TRUE(eventually([&] { return running.handles(SIGINT); }));
  running.send(SIGINT);
  const auto outcome = running.wait();
  EXPECT_EQ(outcome.status, 130);
  EXPECT_EQ(outcome.output, "");
  EXPECT_TRUE(contains(outcome.errors, "[interrupted]")) << outcome.errors;
}

}  // namespace test_study
}  // namespace leadscrew::cli::testing
