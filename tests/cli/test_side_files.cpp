// The file beside an NPY trace, which tells what its columns are.

#include <gtest/gtest.h>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_side_files {

TEST(SideFile, NamesTheColumnsOfAnArray) {
  const Folder folder;
  folder.write("part.ngc", square);
  const auto run = leadscrew(folder, {"run", "part.ngc", "--period", "250us", "--trace", "t.npy"});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_NE(run.output.find("t.npy.json"), std::string::npos) << run.output;
  EXPECT_EQ(Json::parse(folder.read("t.npy.json")),
            Json::parse(R"({"schema": "leadscrew.trace/1", "trace": "t.npy", "program": "part.ngc", "machine": "mill3",
      "period_s": 0.00025, "columns": [{"name": "t", "unit": "s"}, {"name": "line", "unit": ""}, {"name": "s", "unit": "mm"},
      {"name": "feed", "unit": "mm/s"}, {"name": "X", "unit": "mm"}, {"name": "Y", "unit": "mm"},
      {"name": "Z", "unit": "mm"}]})"));
}

TEST(SideFile, HasTheColumnsOfTheSameTraceAsCsv) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90\nS1000 M3\nG1 X3 F6000\nM2\n");
  for (const std::vector<std::string>& verb :
       {std::vector<std::string>{"simulate"}, {"run", "--machine", source_folder / "machines/laser.toml"}}) {
    for (const char* name : {"t.npy", "t.csv"}) {
      std::vector<std::string> words = verb;
      words.insert(words.end(), {"part.ngc", "--quiet", "--trace", name});
      EXPECT_EQ(leadscrew(folder, words).status, 0);
    }
    std::string header;
    const Json side = Json::parse(folder.read("t.npy.json"));
    for (const Json& column : side["columns"]) header += "," + column["name"].get<std::string>();
    const std::string csv = folder.read("t.csv");
    EXPECT_EQ(header.substr(1), csv.substr(0, csv.find('\n')));
  }
}

TEST(SideFile, StandsBesideArraysOnly) {
  const Folder folder;
  folder.write("part.ngc", square);
  EXPECT_EQ(leadscrew(folder, {"run", "part.ngc", "--quiet", "--trace", "t.csv"}).status, 0);
  EXPECT_EQ(folder.names(), (Names{"part.ngc", "t.csv"}));
}

TEST(SideFile, AppearsWithItsTraceOrNotAtAll) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("bad.ngc", "G21\nG1 X\nM2\n");
  EXPECT_EQ(leadscrew(folder, {"run", "bad.ngc", "--trace", "t.npy"}).status, 3);
  std::filesystem::create_directory(folder.path() / "t.npy.json");
  EXPECT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "t.npy"}).status, 4);
  EXPECT_EQ(folder.names(), (Names{"part.ngc", "bad.ngc", "t.npy.json"}));
}

TEST(SideFile, IsNotWrittenOverWhatIsRead) {
  const Folder folder;
  folder.write("t.npy.json", square);
  EXPECT_EQ(leadscrew(folder, {"run", "t.npy.json", "--trace", "t.npy"}).status, 2);
  EXPECT_EQ(leadscrew(folder, {"drive", "t.npy.json", "--axes", "t.npy"}).status, 2);
  EXPECT_EQ(folder.read("t.npy.json"), square);
}

}  // namespace test_side_files
}  // namespace leadscrew::cli::testing
