// Two drives never keep one state, nobody else can keep it in their place, and no lock outlives its holder.

#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <leadscrew/drive/state_lock.hpp>
#include <optional>

#include "driven.hpp"

namespace leadscrew::drive {
namespace test_state_lock {

using cli::testing::Folder;
using cli::testing::Names;

constexpr const char* lock_name = ".leadscrew-state.lock";

std::string state_in(const Folder& folder) {
  return folder.path() / "state";
}

TEST(StateLock, LiesBesideTheStateForItsUserAloneAndGoes) {
  const Folder folder;
  {
    const auto lock = StateLock::hold(state_in(folder));
    ASSERT_TRUE(lock.has_value());
    struct stat status = {};
    ASSERT_EQ(::stat((folder.path() / lock_name).c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0600U);
    EXPECT_EQ(status.st_uid, ::geteuid());
  }
  EXPECT_EQ(folder.names(), Names{});
}

TEST(StateLock, IsHeldByOneAtATime) {
  const Folder folder;
  std::optional<StateLock> first(std::move(*StateLock::hold(state_in(folder))));
  const auto second = StateLock::hold(state_in(folder));
  ASSERT_FALSE(second.has_value());
  EXPECT_EQ(second.error().code, "state-busy");
  first.reset();
  EXPECT_TRUE(StateLock::hold(state_in(folder)).has_value());
}

/// A killed drive leaves the file, and with it nothing that is held.
TEST(StateLock, IsTakenOverFromADriveThatWasKilled) {
  const Folder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    const auto lock = StateLock::hold(state_in(folder));
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(folder.names(), Names{lock_name});
  EXPECT_TRUE(StateLock::hold(state_in(folder)).has_value());
  EXPECT_EQ(folder.names(), Names{});
}

/// Who waits for a lock may get it on a file that was removed meanwhile; that is none.
TEST(StateLock, IsNotThatOfAFileThatHasNoNameAnyMore) {
  const Folder folder;
  std::optional<StateLock> first(std::move(*StateLock::hold(state_in(folder))));
  std::filesystem::remove(folder.path() / lock_name);
  const auto second = StateLock::hold(state_in(folder));
  ASSERT_TRUE(second.has_value());
  EXPECT_FALSE(StateLock::hold(state_in(folder)).has_value());
}

TEST(StateLock, IsNoLinkToAnotherFile) {
  const Folder folder;
  folder.write("victim", "of somebody else");
  std::filesystem::create_symlink("victim", folder.path() / lock_name);
  const auto lock = StateLock::hold(state_in(folder));
  ASSERT_FALSE(lock.has_value());
  EXPECT_EQ(lock.error().code, "io-open");
}

TEST(StateLock, IsThatOfTheFileALinkLeadsTo) {
  const Folder folder;
  std::filesystem::create_symlink("state", folder.path() / "link");
  const auto lock = StateLock::hold(folder.path() / "link");
  ASSERT_TRUE(lock.has_value());
  EXPECT_EQ(folder.names(), (Names{lock_name, "link"}));
}

TEST(StateLock, IsNotNeededForWhatIsNoFile) {
  EXPECT_TRUE(StateLock::hold("/dev/null").has_value());
  EXPECT_TRUE(StateLock::hold("/dev/null").has_value());
}

}  // namespace test_state_lock
}  // namespace leadscrew::drive
