// Tasks of an archive: which there are, what determines them, and programs that are not as they should be.

#include <gtest/gtest.h>

#include <leadscrew/sweep/archive.hpp>
#include <leadscrew/sweep/table.hpp>

#include "command.hpp"

namespace test_archive {

using namespace leadscrew;
using cli::testing::Folder;
using cli::testing::square;

sweep::ArchiveSetup setup_of(const Folder& folder, const std::vector<std::string>& names) {
  sweep::ArchiveSetup setup;
  for (const std::string& name : names) setup.programs.push_back(folder.path() / name);
  setup.machines = {{"mill3", machine::mill3(), "mill3"}};
  setup.parameters = sweep::Grid{.tolerances = {0.001, 0.01}}.combinations();
  return setup;
}

sweep::Archive archive_of(const sweep::ArchiveSetup& setup) {
  std::vector<sweep::SurveyedProgram> programs;
  for (std::size_t k = 0; k < setup.programs.size(); ++k) programs.push_back(*sweep::survey(setup, k));
  return {setup, programs};
}

TEST(Archive, HasEachProgramOnEachMachineWithAllParameters) {
  sweep::Grid grid{.tolerances = {0.001, 0.01, 0.1}, .jerks = {1, 2}};
  const auto all = grid.combinations();
  ASSERT_EQ(all.size(), 6U);
  EXPECT_EQ(all[1].tolerance, 0.001);
  EXPECT_EQ(all[1].jerk, 2);
  EXPECT_EQ(all[2].tolerance, 0.01);
  const machine::Machine changed = all[1].applied_to(machine::mill3());
  EXPECT_EQ(changed.limits(base::Axis::Y).jerk, 2 * machine::mill3().limits(base::Axis::Y).jerk);
  EXPECT_EQ(sweep::Grid().combinations().size(), 1U);
}

TEST(Archive, KnowsTasksByTheirContentNotByTheirNames) {
  const Folder folder;
  folder.write("a.ngc", square);
  folder.write("same.ngc", square);
  folder.write("other.ngc", square + "\n");
  const auto setup = setup_of(folder, {"a.ngc", "same.ngc", "other.ngc"});
  const auto work = archive_of(setup);
  ASSERT_EQ(work.count(), 6);
  EXPECT_EQ(work.key(0), work.key(2));
  EXPECT_NE(work.key(0), work.key(1));
  EXPECT_NE(work.key(0), work.key(4));
  auto other = setup;
  other.machines[0].text = "another";
  EXPECT_NE(archive_of(other).key(0), work.key(0));
}

TEST(Archive, KnowsTheSubprogramsOfAProgram) {
  const Folder folder;
  folder.write("calls.ngc", "G21 G90 F600\no<side> call\nM2\n");
  folder.write("side.ngc", "o<side> sub\nG1 X1\no<side> endsub\n");
  const auto setup = setup_of(folder, {"calls.ngc"});
  const auto before = archive_of(setup).key(0);
  folder.write("side.ngc", "o<side> sub\nG1 X2\no<side> endsub\n");
  EXPECT_NE(archive_of(setup).key(0), before);
}

TEST(Archive, MakesBadProgramsResults) {
  const Folder folder;
  folder.write("bad.ngc", "G21\nG1 X\nM2\n");
  const auto setup = setup_of(folder, {"bad.ngc", "none.ngc"});
  auto work = archive_of(setup);
  const auto bad = work.result(0), none = work.result(2);
  ASSERT_TRUE(bad && none);
  EXPECT_EQ(*bad->find("status")->text(), "rejected");
  EXPECT_EQ(bad->find("line")->integer(), 2);
  EXPECT_EQ(*none->find("status")->text(), "unreadable");
  EXPECT_EQ(*none->find("code")->text(), "io-open");
}

TEST(Archive, TellsOfAProgramThatHasChangedMeanwhileAndOfNoOther) {
  const Folder folder;
  for (const char* const name : {"a.ngc", "b.ngc", "c.ngc"}) folder.write(name, square);
  const auto setup = setup_of(folder, {"a.ngc", "b.ngc", "c.ngc"});
  auto work = archive_of(setup);
  folder.write("a.ngc", square + "(more)\n");
  std::filesystem::remove(folder.path() / "b.ngc");
  for (const int task : {0, 2}) {
    const auto changed = work.result(task);
    ASSERT_FALSE(changed) << task;
    EXPECT_EQ(changed.error().code, "program-changed");
  }
  const auto same = work.result(4);
  ASSERT_TRUE(same);
  EXPECT_NEAR(*same->find("time_s")->number(), 4.179, 0.002);
}

TEST(Archive, ObeysAnOverrideAndJudgesByIt) {
  const Folder folder;
  folder.write("line.ngc", "G21 G90 F600\nG1 X100\nM2\n");
  auto setup = setup_of(folder, {"line.ngc"});
  setup.parameters = sweep::Grid{.overrides = {0.5, 1, 2}}.combinations();
  auto work = archive_of(setup);
  for (int task = 0; task < 3; ++task) {
    const auto result = work.result(task);
    ASSERT_TRUE(result);
    EXPECT_EQ(*result->find("status")->text(), "kept");
    EXPECT_NEAR(*result->find("time_s")->number(), 100 / (10 * std::array{0.5, 1.0, 2.0}.at(task)), 0.2);
  }
}

TEST(Table, HasAColumnForEachNumberAndText) {
  const auto row = [](const char* text) { return *json::Json::parse(text); };
  const std::vector<json::Json> rows = {row(R"({"task":0,"name":"a,\"b\"","time_s":1.5,"lost":{"x":1}})"),
                                        row(R"({"task":1,"name":"c","errors":3})")};
  sweep::TableColumns found;
  for (const json::Json& each : rows) found.observe(each);
  const auto columns = found.columns();
  ASSERT_EQ(columns.size(), 4U);
  std::string csv, npy;
  const auto into = [](std::string& text) {
    return [&text](std::string_view part) -> base::Result<void> {
      text += part;
      return {};
    };
  };
  sweep::CsvTable as_csv(columns, into(csv));
  sweep::NpyTable as_npy(columns, 2, into(npy));
  for (const json::Json& each : rows) ASSERT_TRUE(as_csv.write(each) && as_npy.write(each));
  ASSERT_TRUE(as_csv.finish() && as_npy.finish());
  EXPECT_EQ(csv, "task,name,time_s,errors\n0,\"a,\"\"b\"\"\",1.5,\n1,c,,3\n");
  EXPECT_NE(npy.find("('task', '<i8'), ('name', '|S5'), ('time_s', '<f8'), ('errors', '<f8')"), std::string::npos);
  const std::size_t header = 10 + static_cast<unsigned char>(npy[8]) + 256 * static_cast<unsigned char>(npy[9]);
  EXPECT_EQ(header % 64, 0U);
  EXPECT_EQ(npy.size(), header + 2 * (8 + 5 + 8 + 8));
}

}  // namespace test_archive
