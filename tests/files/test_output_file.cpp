// Outputs that go into a pipe.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <leadscrew/files/output_file.hpp>

#include "command.hpp"

namespace leadscrew::files {
namespace test_output_file {

using cli::testing::Folder;

TEST(OutputFile, IsAPipeThatNobodyReadsAnyMore) {
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  const Folder folder;
  const std::string pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  auto file = OutputFile::create(pipe, OutputFile::Access::sequential);
  ASSERT_TRUE(file.has_value());
  EXPECT_TRUE(file->write("t,X\n").has_value());
  ::close(reader);
  auto written = file->write("0,0\n");
  if (written) written = file->close();
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error().code, "io-pipe");
  std::signal(SIGPIPE, before);
}

}  // namespace test_output_file
}  // namespace leadscrew::files
