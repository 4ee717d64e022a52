// What run, check and verify find: figures, JSON and traces.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numbers>
#include <regex>
#include <tuple>
#include <utility>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_results {

using Row = std::vector<double>;

struct Table {
  std::vector<std::string> columns;
  std::vector<Row> rows;
};

Table read_csv(const std::string& text) {
  Table table;
  std::istringstream lines(text);
  std::string line, field;
  std::getline(lines, line);
  for (std::istringstream fields(line); std::getline(fields, field, ',');) table.columns.push_back(field);
  while (std::getline(lines, line)) {
    Row& row = table.rows.emplace_back();
    for (std::istringstream fields(line); std::getline(fields, field, ',');) {
      char* end = nullptr;
      row.push_back(std::strtod(field.c_str(), &end));
      EXPECT_EQ(*end, '\0') << field;
    }
  }
  return table;
}

/// By the columns given in this order.
std::string csv_text(const Table& table, const std::vector<std::size_t>& columns) {
  std::string text;
  for (const std::size_t c : columns) text += (text.empty() ? "" : ",") + table.columns[c];
  char digits[40];
  for (const Row& row : table.rows) {
    char separator = '\n';
    for (const std::size_t c : columns) {
      std::snprintf(digits, sizeof digits, "%c%.17g", std::exchange(separator, ','), row[c]);
      text += digits;
    }
  }
  return text + "\n";
}

/// The values of a NumPy file of version 1, doubles in C order.
std::vector<double> read_npy(const std::string& bytes) {
  EXPECT_TRUE(bytes.starts_with("\x93NUMPY\x01"));
  const std::size_t begin = 10 + static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
  std::vector<double> values((bytes.size() - begin) / sizeof(double));
  std::memcpy(values.data(), bytes.data() + begin, values.size() * sizeof(double));
  return values;
}

Names keys(const Json& object) {
  Names keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

void expect_axes(const Json& axes) {
  Names names;
  for (const Json& axis : axes) {
    EXPECT_EQ(keys(axis), (Names{"name", "velocity_ratio", "acceleration_ratio", "jerk_ratio"}));
    names.insert(axis["name"]);
    for (const char* ratio : {"velocity_ratio", "acceleration_ratio", "jerk_ratio"})
      EXPECT_TRUE(axis[ratio].is_number()) << ratio;
  }
  EXPECT_EQ(names, (Names{"X", "Y", "Z"}));
}

TEST(RunJson, HasTheKeysAndTypesOfTheContract) {
  const Folder folder;
  folder.write("part.ngc", square);
  const auto run = leadscrew(folder, {"run", "part.ngc", "--json"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.errors, "");
  const Json object = run.json();
  EXPECT_EQ(keys(object),
            (Names{"schema",    "program", "machine", "period_s",    "words",           "blocks",       "moves",
                   "length_mm", "time_s",  "dwell_s", "bound_s",     "deviation_mm",    "tolerance_mm", "feed",
                   "axes",      "plan",    "cpu",     "diagnostics", "violation_count", "extents",      "losses"}));
  EXPECT_EQ(object["schema"], "leadscrew.run/1");
  EXPECT_EQ(object["program"], "part.ngc");
  EXPECT_EQ(object["machine"], "mill3");
  for (const char* key : {"period_s", "length_mm", "time_s", "dwell_s", "deviation_mm", "tolerance_mm"})
    EXPECT_TRUE(object[key].is_number()) << key;
  for (const char* key : {"words", "blocks", "moves", "violation_count"})
    EXPECT_TRUE(object[key].is_number_integer()) << key;
  EXPECT_TRUE(object["bound_s"].is_null() || object["bound_s"].is_number());
  EXPECT_EQ(keys(object["feed"]), (Names{"programmed_max_mm_s", "max_ratio", "ripple"}));
  EXPECT_EQ(keys(object["cpu"]), (Names{"read_s", "plan_s", "words_s", "cycle_ns"}));
  EXPECT_EQ(keys(object["cpu"]["cycle_ns"]), (Names{"p50", "p99", "max"}));
  expect_axes(object["axes"]);
  expect_axes(object["plan"]);
  EXPECT_EQ(object["diagnostics"], Json::array());
}

TEST(RunJson, AgreesWithItselfAndWithTheTrace) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G61.1\nG1 X10 F600\nG4 P0.5\nY10\nG2 X20 Y20 I10 J0\nM2\n");
  for (const auto& [period, seconds] : {std::pair("1ms", 1e-3), {"250us", 250e-6}, {"62.5us", 62.5e-6}}) {
    const Json run = leadscrew(folder, {"run", "part.ngc", "--json", "--trace", "t.csv", "--period", period}).json();
    EXPECT_EQ(run["period_s"], seconds);
    const auto words = run["words"].get<std::int64_t>();
    EXPECT_NEAR(run["time_s"].get<double>(), static_cast<double>(words) * seconds, 1e-12);
    EXPECT_EQ(run["blocks"], 6);
    EXPECT_EQ(run["moves"], 3);
    EXPECT_NEAR(run["length_mm"].get<double>(), 20 + 5 * std::numbers::pi, 1e-9);
    EXPECT_NEAR(run["dwell_s"].get<double>(), 0.5, 1e-12);
    EXPECT_EQ(run["feed"]["programmed_max_mm_s"], 10.0);
    const Table trace = read_csv(folder.read("t.csv"));
    EXPECT_EQ(trace.columns, (std::vector<std::string>{"t", "line", "s", "feed", "X", "Y", "Z"}));
    ASSERT_EQ(trace.rows.size(), static_cast<std::size_t>(words) + 1);
    for (const Row& row : trace.rows) ASSERT_EQ(row.size(), 7u);
    EXPECT_EQ(trace.rows.front()[0], 0);
    EXPECT_EQ(trace.rows.back()[0], run["time_s"].get<double>());
    EXPECT_EQ((Row{trace.rows.back().begin() + 4, trace.rows.back().end()}), (Row{20, 20, 0}));
  }
}

TEST(RunJson, CarriesDiagnosticsOfAProgramThatMoves) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 F600\nG1 X1\n");
  const auto run = leadscrew(folder, {"run", "part.ngc", "--json"});
  EXPECT_EQ(run.status, 0);
  const Json note = run.json()["diagnostics"].at(0);
  EXPECT_EQ(keys(note), (Names{"file", "line", "column", "code", "severity", "message", "hint"}));
  EXPECT_EQ(note["code"], "program-end");
  EXPECT_EQ(note["severity"], "note");
}

TEST(RunJson, HoldsSeveralProgramsInOneObject) {
  const Folder folder;
  folder.write("a.ngc", square);
  folder.write("b.ngc", with_feed(square, "6000"));
  const Json both = leadscrew(folder, {"run", "a.ngc", "b.ngc", "--json"}).json();
  EXPECT_EQ(both["schema"], "leadscrew.runs/1");
  ASSERT_EQ(both["programs"].size(), 2u);
  EXPECT_EQ(both["programs"][0]["words"], 4179);
  EXPECT_EQ(both["programs"][1]["program"], "b.ngc");
}

TEST(CheckJson, HasItsKeys) {
  const Folder folder;
  folder.write("part.ngc", square);
  const auto check = leadscrew(folder, {"check", "part.ngc", "--json"});
  EXPECT_EQ(check.status, 0);
  EXPECT_EQ(check.errors, "");
  EXPECT_EQ(check.json(), Json::parse(R"({"schema": "leadscrew.check/1", "program": "part.ngc", "machine": "mill3",
      "blocks": 6, "moves": 4, "extents": [{"name": "X", "least": 0.0, "greatest": 10.0},
      {"name": "Y", "least": 0.0, "greatest": 10.0}, {"name": "Z", "least": 0.0, "greatest": 0.0}],
      "bound_s": 4.04, "errors": 0, "warnings": 0, "message_count": 0, "messages": [], "diagnostics": []})"));
}

struct Timing {
  const char* feed;
  double acceleration, jerk, seconds;
};

TEST(Square, TakesTheTimeOfTheClosedForm) {
  const Folder folder;
  for (const Timing& timing : {Timing{"600", 1000, 20000, 4.1789}, Timing{"6000", 1000, 20000, 1.0246},
                               Timing{"600", 200, 5000, 4.3600}, Timing{"6000", 200, 5000, 1.9560}}) {
    folder.write("part.ngc", with_feed(square, timing.feed));
    folder.write("machine.toml", machine_text(timing.acceleration, timing.jerk));
    for (const auto& [period, seconds] : {std::pair("1ms", 1e-3), {"250us", 250e-6}, {"10us", 10e-6}}) {
      const auto run =
          leadscrew(folder, {"run", "part.ngc", "--machine", "machine.toml", "--period", period, "--json"});
      EXPECT_EQ(run.status, 0);
      // The times above have four decimals.
      EXPECT_NEAR(run.json()["time_s"].get<double>(), timing.seconds, seconds + 5e-5) << timing.feed << " " << period;
    }
  }
}

TEST(Trace, IsTheSameBytesEachTime) {
  const Folder folder;
  folder.write("part.ngc", square);
  for (const std::string ending : {".csv", ".npy"}) {
    ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "a" + ending}).status, 0);
    ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "b" + ending}).status, 0);
    EXPECT_GT(folder.read("a" + ending).size(), 100'000u);
    EXPECT_TRUE(folder.read("a" + ending) == folder.read("b" + ending));
  }
}

TEST(Trace, HoldsTheSameDoublesAsCsvAndAsNpy) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90\nG3 X3 Y4 I1.5 J2 F700\nG1 X0.1\nM2\n");
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "t.csv"}).status, 0);
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "t.npy"}).status, 0);
  std::vector<double> from_csv;
  for (const Row& row : read_csv(folder.read("t.csv")).rows) from_csv.insert(from_csv.end(), row.begin(), row.end());
  const std::vector<double> from_npy = read_npy(folder.read("t.npy"));
  ASSERT_EQ(from_csv.size(), from_npy.size());
  ASSERT_GT(from_csv.size(), 1000u);
  for (std::size_t i = 0; i < from_csv.size(); ++i)
    ASSERT_EQ(std::bit_cast<std::uint64_t>(from_csv[i]), std::bit_cast<std::uint64_t>(from_npy[i])) << i;
}

TEST(Trace, OfALongPeriodIsContainedInThatOfAShortOne) {
  const Folder folder;
  folder.write("part.ngc", with_feed(square, "6000"));
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "long.csv", "--period", "1ms"}).status, 0);
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "short.csv", "--period", "10us"}).status, 0);
  const auto coarse = read_csv(folder.read("long.csv")).rows, fine = read_csv(folder.read("short.csv")).rows;
  ASSERT_GT(coarse.size(), 1000u);
  for (std::size_t i = 0; i + 1 < coarse.size(); ++i)
    for (std::size_t column = 4; column < 7; ++column) ASSERT_EQ(coarse[i][column], fine.at(100 * i)[column]) << i;
}

TEST(Trace, BeginsWhereStartSays) {
  const Folder folder;
  folder.write("part.ngc", square);
  for (const char* start : {"1,2,3", "X1,Y2,Z3", "z3,y2,x1", "+1,2.0,Z3"}) {
    ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "t.csv", "--start", start}).status, 0) << start;
    const Row first = read_csv(folder.read("t.csv")).rows.front();
    EXPECT_EQ((Row{first.begin() + 4, first.end()}), (Row{1, 2, 3})) << start;
  }
}

/// A folder with the square, its trace and the referee's word on any trace.
class Referee : public ::testing::Test {
 protected:
  void SetUp() override {
    folder.write("part.ngc", square);
    ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "t.csv"}).status, 0);
    trace = read_csv(folder.read("t.csv"));
    ASSERT_EQ(trace.rows.size(), 4180u);
  }

  Outcome verify(const std::string& name, const std::string& program = "part.ngc") const {
    return leadscrew(folder, {"verify", name, program, "--json"});
  }

  /// The words it objected to.
  static Names objections(const Outcome& outcome) {
    Names found;
    const Json object = outcome.json();
    for (const Json& violation : object["violations"]) found.insert(violation["what"]);
    EXPECT_EQ(object["violations"].size(), std::min<std::size_t>(object["violation_count"].get<std::size_t>(), 1000));
    return found;
  }

  Folder folder;
  Table trace;
};

TEST_F(Referee, AcceptsOwnTraces) {
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "t.npy"}).status, 0);
  for (const char* name : {"t.csv", "t.npy"}) {
    const auto verdict = verify(name);
    EXPECT_EQ(verdict.status, 0) << name;
    EXPECT_EQ(verdict.errors, "");
    EXPECT_EQ(objections(verdict), Names{});
  }
}

TEST_F(Referee, SpeaksTheContractsJson) {
  const Json object = verify("t.csv").json();
  EXPECT_EQ(keys(object),
            (Names{"schema", "trace", "program", "machine", "period_s", "time_s", "deviation_mm", "tolerance_mm",
                   "start_error_mm", "end_error_mm", "axes", "feed", "violations", "violation_count", "diagnostics"}));
  EXPECT_EQ(object["schema"], "leadscrew.verify/1");
  EXPECT_EQ(object["trace"], "t.csv");
  EXPECT_EQ(object["period_s"], 0.001);
  EXPECT_NEAR(object["time_s"].get<double>(), 4.179, 1e-12);
  EXPECT_LT(object["deviation_mm"].get<double>(), 1e-9);
  EXPECT_EQ(keys(object["feed"]), (Names{"programmed_max_mm_s", "max_ratio", "ripple"}));
  EXPECT_LT(object["feed"]["ripple"].get<double>(), 1e-9);
  expect_axes(object["axes"]);
}

TEST_F(Referee, MeasuresWhatTheRunMeasured) {
  const Json run = leadscrew(folder, {"run", "part.ngc", "--json"}).json();
  EXPECT_EQ(verify("t.csv").json()["axes"], run["axes"]);
}

TEST_F(Referee, ObjectsToOneWordThatIsOff) {
  trace.rows[500][5] += 0.1;
  folder.write("off.csv", csv_text(trace, {0, 1, 2, 3, 4, 5, 6}));
  const auto verdict = verify("off.csv");
  EXPECT_EQ(verdict.status, 1);
  const Names found = objections(verdict);
  EXPECT_TRUE(found.contains("Y jerk")) << verdict.output;
  EXPECT_NEAR(verdict.json()["deviation_mm"].get<double>(), 0.1, 1e-6);
  const Json violation = verdict.json()["violations"].at(0);
  EXPECT_EQ(keys(violation), (Names{"t", "line", "what", "value", "limit"}));
  EXPECT_NEAR(violation["t"].get<double>(), 0.5, 0.01);
  EXPECT_EQ(violation["line"], 2);
}

TEST_F(Referee, ObjectsToATraceThatEndsEarly) {
  trace.rows.resize(2000);
  folder.write("early.csv", csv_text(trace, {0, 1, 2, 3, 4, 5, 6}));
  const auto verdict = verify("early.csv");
  EXPECT_EQ(verdict.status, 1);
  EXPECT_GT(verdict.json()["end_error_mm"].get<double>(), 1);
}

TEST_F(Referee, ObjectsToTheTraceOfAnotherProgram) {
  folder.write("slower.ngc", with_feed(square, "300"));
  folder.write("wider.ngc", "G21 G90 G61.1\nG1 X11 F600\nY10\nX0\nY0\nM2\n");
  EXPECT_EQ(verify("t.csv", "wider.ngc").status, 1);
  EXPECT_EQ(verify("t.csv", "slower.ngc").status, 1);
}

TEST_F(Referee, ObjectsWhereTheMachineIsSlower) {
  folder.write("slow.toml", machine_text(200, 5000));
  const auto verdict = leadscrew(folder, {"verify", "t.csv", "part.ngc", "--machine", "slow.toml", "--json"});
  EXPECT_EQ(verdict.status, 1);
  EXPECT_EQ(objections(verdict), (Names{"X acceleration", "X jerk", "Y acceleration", "Y jerk"}));
}

TEST_F(Referee, NeedsOnlyTimeAndAxes) {
  folder.write("bare.csv", csv_text(trace, {0, 4, 5, 6}));
  EXPECT_EQ(verify("bare.csv").status, 0);
  EXPECT_EQ(verify("bare.csv").json()["axes"], verify("t.csv").json()["axes"]);
}

TEST_F(Referee, TakesColumnsInAnyOrder) {
  folder.write("foreign.csv", csv_text(trace, {6, 4, 0, 5}));
  EXPECT_EQ(verify("foreign.csv").status, 0);
  EXPECT_EQ(verify("foreign.csv").json()["axes"], verify("t.csv").json()["axes"]);
  std::swap(trace.columns[4], trace.columns[5]);
  folder.write("crossed.csv", csv_text(trace, {6, 4, 0, 5}));
  EXPECT_EQ(verify("crossed.csv").status, 1);
}

TEST_F(Referee, RejectsTracesThatAreNone) {
  folder.write("cut.csv", folder.read("t.csv").substr(0, 10000));
  folder.write("word.csv", "t,X,Y,Z\n0,0,0,0\n0.001,0,zero,0\n");
  folder.write("timeless.csv", "X,Y,Z\n0,0,0\n");
  folder.write("uneven.csv", "t,X,Y,Z\n0,0,0,0\n0.001,0,0,0\n0.005,0,0,0\n");
  folder.write("empty.csv", "");
  folder.write("bare.csv", "t,X,Y,Z\n");
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "t.npy"}).status, 0);
  folder.write("cut.npy", folder.read("t.npy").substr(0, 10000));
  for (const auto& [name, place, code] : {std::tuple("cut.csv", "cut.csv:145:31: ", "trace-column"),
                                          {"word.csv", "word.csv:3:9: ", "trace-number"},
                                          {"timeless.csv", "timeless.csv:1:", "trace-header"},
                                          {"uneven.csv", "uneven.csv: ", "trace-period"},
                                          {"empty.csv", "empty.csv", "trace-"},
                                          {"bare.csv", "bare.csv", "trace-empty"},
                                          {"cut.npy", "cut.npy: ", "trace-format"}}) {
    const auto verdict = leadscrew(folder, {"verify", name, "part.ngc"});
    EXPECT_EQ(verdict.status, 3) << name;
    EXPECT_EQ(verdict.output, "");
    EXPECT_TRUE(verdict.errors.starts_with(place)) << verdict.errors;
    EXPECT_TRUE(contains(verdict.errors, std::string("[") + code)) << verdict.errors;
    EXPECT_EQ(keys(verify(name).json()), (Names{"schema", "program", "machine", "diagnostics"}));
  }
}

TEST(Examples, RunAndKeepEveryLimit) {
  const Folder folder;
  int programs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_folder / "examples")) {
    if (entry.path().extension() != ".ngc") continue;
    ++programs;
    const std::string number = entry.path().filename().string().substr(0, 2);
    std::vector<std::string> arguments = {"run", entry.path(), "--json"};
    if (number == "01" || number == "06" || number >= "16")
      arguments.insert(arguments.end(), {"--tools", source_folder / "examples" / "tools.tbl"});
    // A program that needs more than the built-in mill names its machine.
    std::smatch named;
    std::ifstream file(entry.path());
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    if (std::regex_search(text, named, std::regex("machines/[a-z0-9-]+\\.toml")))
      arguments.insert(arguments.end(), {"--machine", source_folder / named[0].str()});
    const auto run = leadscrew(folder, arguments);
    EXPECT_EQ(run.status, 0) << entry.path() << run.errors;
    EXPECT_EQ(run.json()["violation_count"], 0) << entry.path();
    EXPECT_GT(run.json()["words"], 100) << entry.path();
  }
  EXPECT_GE(programs, 8);
}

}  // namespace test_results
}  // namespace leadscrew::cli::testing
