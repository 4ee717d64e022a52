// A file that is read again is the file that was read, or an error.

#include <gtest/gtest.h>

#include <algorithm>
#include <leadscrew/files/input_file.hpp>
#include <thread>
#include <utility>

#include "command.hpp"

namespace leadscrew::files {
namespace test_input_file {

using cli::testing::Folder;
using cli::testing::Names;

struct Read {
  std::string text, error;  ///< its code
};

Read read(const InputFile& file) {
  Read read;
  auto source = file.source();
  std::string buffer(10'000, '\0');
  while (true) {
    const auto got = source(buffer);
    if (!got) read.error = got.error().code;
    if (!got || *got == 0) return read;
    read.text += buffer.substr(0, *got);
  }
}

TEST(InputFile, IsReadAgainAsItWas) {
  const Folder folder;
  const std::string text(200'000, 'x');
  folder.write("part.ngc", text);
  const auto file = InputFile::open(folder.path() / "part.ngc");
  ASSERT_TRUE(file.has_value());
  for (int times = 0; times < 3; ++times) {
    EXPECT_TRUE(read(*file).text == text);
    EXPECT_EQ(read(*file).error, "");
  }
}

/// As old as before, and as long: nothing but its bytes tells.
TEST(InputFile, ThatWasWrittenOverIsReadNoFurther) {
  const Folder folder;
  const auto path = folder.path() / "part.ngc";
  std::string text(200'000, 'x');
  folder.write("part.ngc", text);
  const auto time = std::filesystem::last_write_time(path);
  const auto file = InputFile::open(path);
  ASSERT_TRUE(file.has_value());
  ASSERT_EQ(read(*file).error, "");
  text[100'000] = 'y';
  folder.write("part.ngc", text);
  std::filesystem::last_write_time(path, time);
  EXPECT_TRUE(file->unchanged().has_value());
  const Read again = read(*file);
  EXPECT_EQ(again.error, "program-changed");
  EXPECT_EQ(again.text, std::string(65'536, 'x'));
}

TEST(InputFile, ThatEndsBeforeItsSizeIsAnErrorNotWaitedFor) {
  const auto source = [given = false](std::span<char> to) mutable -> base::Result<std::size_t> {
    if (std::exchange(given, true)) return std::size_t{0};
    std::ranges::copy(std::string_view("G1 X"), to.begin());
    return std::size_t{4};
  };
  EXPECT_EQ(all_of(source, 4, "part.ngc").value_or(""), "G1 X");
  const auto cut = all_of(source, 9, "part.ngc");
  ASSERT_FALSE(cut.has_value());
  EXPECT_EQ(cut.error().code, "io-read");
  EXPECT_EQ(cut.error().place.file, "part.ngc");
  EXPECT_NE(cut.error().message.find("ends at byte 4 but had 9"), std::string::npos) << cut.error().message;
}

TEST(InputFile, TellsThatItWasWrittenTo) {
  const Folder folder;
  folder.write("part.ngc", "G1 X1\n");
  const auto file = InputFile::open(folder.path() / "part.ngc", "trace-changed");
  ASSERT_TRUE(file.has_value());
  folder.write("part.ngc", "G1 X1\nG1 X2\n");
  ASSERT_FALSE(file->unchanged().has_value());
  EXPECT_EQ(file->unchanged().error().code, "trace-changed");
  EXPECT_EQ(read(*file).text, "G1 X1\n");  // what is appended is not part of it
}

TEST(InputFile, ThatIsAPipeIsWaitedForAndReadTwice) {
  const Folder folder;
  const std::string pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::jthread writer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::ofstream file(pipe);
    file << "G1 X1\n" << std::flush;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    file << "G1 X2\n";
  });
  const auto file = InputFile::open(pipe);
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ(read(*file).text, "G1 X1\nG1 X2\n");
  EXPECT_EQ(read(*file).text, "G1 X1\nG1 X2\n");
}

TEST(InputFile, OfATextHoldsIt) {
  const auto file = InputFile::of_text("G1 X1\n", "curve:star");
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ(file->name(), "curve:star");
  EXPECT_EQ(read(*file).text, "G1 X1\n");
}

}  // namespace test_input_file
}  // namespace leadscrew::files
