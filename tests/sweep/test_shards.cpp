// What a process that is killed, or a disk that lies, leaves of a shard.

#include <gtest/gtest.h>

#include <fstream>
#include <leadscrew/sweep/shards.hpp>

#include "command.hpp"

namespace test_shards {

using namespace leadscrew;
using cli::testing::Folder;
using sweep::Key;

json::Json result(int number) {
  return json::Json::object({{"status", "kept"}, {"time_s", 0.1 * number}});
}

std::vector<Key> keys_in(const Folder& folder) {
  std::vector<Key> keys;
  EXPECT_TRUE(sweep::for_each_line(folder.path() / "shards", [&](const sweep::ShardLine& line) {
    EXPECT_TRUE(json::Json::parse(line.text).has_value());
    const auto number = static_cast<double>(line.key.low);
    EXPECT_EQ(sweep::parts_of(line).result, result(static_cast<int>(number)).written_in_line());
    EXPECT_EQ(json::Json::parse(sweep::parts_of(line).spent)->find("processor_s")->number(), number);
    keys.push_back(line.key);
  }));
  std::ranges::sort(keys);
  return keys;
}

std::string path_of_only_shard(const Folder& folder) {
  return std::filesystem::directory_iterator(folder.path() / "shards")->path();
}

void write_three(const Folder& folder) {
  sweep::ShardWriter shard(folder.path() / "shards", "a build");
  for (int k = 1; k <= 3; ++k)
    ASSERT_TRUE(shard.add({1, static_cast<std::uint64_t>(k)}, result(k), {.processor = 1.0 * k}));
}

TEST(Shards, GiveBackWhatWasAdded) {
  const Folder folder;
  EXPECT_TRUE(keys_in(folder).empty());
  write_three(folder);
  write_three(folder);  // a second process
  EXPECT_EQ(keys_in(folder), (std::vector<Key>{{1, 1}, {1, 1}, {1, 2}, {1, 2}, {1, 3}, {1, 3}}));
}

TEST(Shards, PassOverALineThatWasNotWrittenToItsEnd) {
  const Folder folder;
  write_three(folder);
  const std::string path = path_of_only_shard(folder);
  const auto whole = std::filesystem::file_size(path);
  for (std::uintmax_t size = whole - 1; size > whole - 40; size -= 7) {
    std::filesystem::resize_file(path, size);
    EXPECT_EQ(keys_in(folder), (std::vector<Key>{{1, 1}, {1, 2}})) << size;
  }
}

TEST(Shards, PassOverALineWithAWrongBit) {
  const Folder folder;
  write_three(folder);
  const std::string path = path_of_only_shard(folder);
  std::string text = folder.read(std::filesystem::path(path).lexically_relative(folder.path()));
  const std::size_t second = text.find('\n') + 1;
  for (const std::size_t at : {std::size_t{12}, std::size_t{40}, std::size_t{90}}) {
    std::string broken = text;
    broken[second + at] = static_cast<char>(broken[second + at] ^ 1);
    std::ofstream(path, std::ios::binary) << broken;
    EXPECT_EQ(keys_in(folder), (std::vector<Key>{{1, 1}, {1, 3}})) << at;
  }
}

TEST(Shards, AreAwaitedWhileTheyAreWritten) {
  const Folder folder;
  const std::string shards = folder.path() / "shards";
  {
    sweep::ShardWriter shard(shards, "a build");
    ASSERT_TRUE(shard.add({1, 1}, result(1), {}));
    const auto free = sweep::await_writers(shards, 0);
    ASSERT_FALSE(free);
    EXPECT_EQ(free.error().code, "sweep-in-use");
  }
  EXPECT_TRUE(sweep::await_writers(shards, 0));
}

TEST(Keys, TellPartsApartAndComeBackFromText) {
  sweep::KeyMaker one, other, pieces;
  one.add("ab"), one.add("c");
  other.add("a"), other.add("bc");
  EXPECT_NE(one.key(), other.key());
  EXPECT_EQ(sweep::key_of_text(sweep::text_of(one.key())), one.key());
  EXPECT_EQ(sweep::text_of({0, 0xabc}), "00000000000000000000000000000abc");
  EXPECT_FALSE(sweep::key_of_text("0123"));
  EXPECT_FALSE(sweep::key_of_text(std::string(31, '0') + "g"));
}

}  // namespace test_shards
