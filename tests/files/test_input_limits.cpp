// What can be read only once is copied up to a limit, and the copying ends when it is interrupted.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <string>

namespace leadscrew::files::testing {
namespace test_input_limits {

/// A pipe that holds so many bytes and then ends, as a path.
class FilledPipe {
 public:
  explicit FilledPipe(std::size_t bytes) {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) std::abort();
    const std::string text(bytes, 'x');
    EXPECT_EQ(::write(ends_[1], text.data(), text.size()), static_cast<ssize_t>(bytes));
    ::close(ends_[1]);
  }
  ~FilledPipe() { ::close(ends_[0]); }
  FilledPipe(const FilledPipe&) = delete;
  FilledPipe& operator=(const FilledPipe&) = delete;

  std::string path() const { return "/dev/fd/" + std::to_string(ends_[0]); }

 private:
  std::array<int, 2> ends_{};
};

TEST(Copies, HaveALimit) {
  const auto file = InputFile::open(FilledPipe(4096).path(), "program-changed", 4096);
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->size(), 4096);
  const FilledPipe longer(4097);
  const auto refused = InputFile::open(longer.path(), "program-changed", 4096);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "input-too-large");
  EXPECT_EQ(refused.error().message, "is larger than 4 KiB");
  EXPECT_EQ(refused.error().place.file, longer.path());
}

TEST(Copies, OfADeviceWithoutEndAreRefused) {
  const auto refused = InputFile::open("/dev/zero", "program-changed", 3'000'001);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "input-too-large");
  EXPECT_EQ(refused.error().message, "is larger than 3000001 bytes");
}

TEST(Copies, AreOneGibibyteAtMost) {
  EXPECT_EQ(largest_copy, std::int64_t{1} << 30);
}

TEST(SmallFiles, OfAnyKindHaveALimit) {
  const auto refused = read_whole("/proc/self/exe", 1 << 10);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "input-too-large");
  EXPECT_EQ(refused.error().message, "is larger than 1 KiB");
  const auto device = read_whole("/dev/zero", 1 << 10);
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().code, "input-too-large");
  EXPECT_EQ(*read_whole(FilledPipe(1 << 10).path(), 1 << 10), std::string(1 << 10, 'x'));
}

/// In a process of its own, for the interruption stays.
TEST(CopiesDeathTest, EndWhenTheyAreInterrupted) {
  EXPECT_EXIT(
      {
        watch_signals();
        ::raise(SIGINT);
        const auto refused = InputFile::open("/dev/zero");
        std::exit(!refused && refused.error().code == "interrupted" ? 7 : 1);
      },
      ::testing::ExitedWithCode(7), "");
}

}  // namespace test_input_limits
}  // namespace leadscrew::files::testing
