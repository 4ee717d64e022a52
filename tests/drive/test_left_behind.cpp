// What killed drives have left is gone with the next start; what living ones write is not.

#include <gtest/gtest.h>

#include <leadscrew/files/output_file.hpp>

#include "driven.hpp"

namespace leadscrew::cli::testing {
namespace test_left_behind {

Names temporary_names(const Folder& folder) {
  Names names;
  for (const std::string& name : folder.names()) {
    if (name.starts_with(".leadscrew-")) names.insert(name);
  }
  return names;
}

TEST(LeftBehind, ByADriveOfWhichAllWasKilledIsGoneWithTheNext) {
  const Folder folder;
  folder.write("part.ngc", part);
  folder.write(".leadscrew-of-mine.csv", "no temporary file");
  Running first(folder, {"drive", "part.ngc", "--trace", "1.csv", "--axes", "axes.csv", "--state", "state", "--quiet"});
  ASSERT_TRUE(comes_to(folder, 5));
  first.send_to_child(SIGKILL);
  first.send(SIGKILL);
  first.wait();
  ASSERT_TRUE(eventually([&] { return is_left(folder); }));
  EXPECT_GE(temporary_names(folder).size(), 2U);
  EXPECT_EQ(leadscrew(folder, {"drive", "part.ngc", "--resume", "state", "--trace", "2.csv", "--quiet"}).status, 0);
  EXPECT_EQ(folder.names(), (Names{"part.ngc", "state", "2.csv", ".leadscrew-of-mine.csv"}));
}

TEST(LeftBehind, IsNothingThatIsStillWritten) {
  const Folder folder;
  const std::string path = folder.path() / "part.csv";
  auto file = files::OutputFile::create(path, files::OutputFile::Access::sequential);
  ASSERT_TRUE(file.has_value());
  files::remove_left_behind(path);
  EXPECT_EQ(temporary_names(folder).size(), 1U);
  EXPECT_TRUE(file->write("t,X\n").has_value());
  EXPECT_TRUE(file->publish().has_value());
  EXPECT_EQ(folder.read("part.csv"), "t,X\n");
  folder.write(".leadscrew-1-0.tmp", "of one that was killed");
  files::remove_left_behind(path);
  EXPECT_EQ(folder.names(), Names{"part.csv"});
}

}  // namespace test_left_behind
}  // namespace leadscrew::cli::testing
