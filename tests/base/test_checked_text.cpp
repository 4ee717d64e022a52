// What is read again is what was read first, piece by piece, or nothing of it.

#include <gtest/gtest.h>

#include <cstring>
#include <leadscrew/base/checked_text.hpp>
#include <string>

namespace leadscrew::base {
namespace test_checked_text {

constexpr std::size_t piece = CheckedText::piece_size;

/// Of xxHash's own documentation and of its sanity checks.
TEST(Hash, IsThatOfXxh64) {
  const auto hash_of = [](std::string_view text) {
    Hash hash;
    hash.add(text);
    return hash.value();
  };
  EXPECT_EQ(hash_of(""), 0xEF46DB3751D8E999u);
  EXPECT_EQ(hash_of("a"), 0xD24EC4F1A98C6E5Bu);
  EXPECT_EQ(hash_of("abc"), 0x44BC2CF5AD770999u);
  EXPECT_EQ(hash_of("Nobody inspects the spammish repetition"), 0xFBCEA83C8A378BF1u);
}

TEST(Hash, IsTheSameHoweverTheTextIsParted) {
  std::string text;
  for (int k = 0; k < 300; ++k) text += static_cast<char>(k * 37 % 251);
  Hash whole;
  whole.add(text);
  for (std::size_t first = 0; first <= 100; ++first) {
    Hash parted;
    parted.add(std::string_view(text).substr(0, first));
    for (std::size_t at = first; at < text.size(); at += 13) parted.add(std::string_view(text).substr(at, 13));
    EXPECT_EQ(parted.value(), whole.value()) << first;
    EXPECT_EQ(parted.count(), text.size());
  }
}

Diagnostic changed() {
  return problem("text-changed", "was changed", "");
}

/// Reads `text` as it stands then, so many bytes at a time.
ByteSource source_of(const std::string& text, std::size_t at_once) {
  return [&text, at_once, at = std::size_t{0}](std::span<char> buffer) mutable -> Result<std::size_t> {
    const std::size_t count = std::min({buffer.size(), at_once, text.size() - std::min(at, text.size())});
    if (count > 0) std::memcpy(buffer.data(), text.data() + at, count);
    at += count;
    return count;
  };
}

struct Read {
  std::string text;
  std::string error;  ///< its code
};

Read read(ByteSource source, std::size_t at_once = 1000) {
  Read read;
  std::string buffer(at_once, '\0');
  while (true) {
    const auto got = source(buffer);
    if (!got) read.error = got.error().code;
    if (!got || *got == 0) return read;
    read.text += buffer.substr(0, *got);
  }
}

std::string text_of(std::size_t size) {
  std::string text;
  while (text.size() < size) text += "G1 X" + std::to_string(text.size()) + "\n";
  text.resize(size);
  return text;
}

TEST(CheckedText, IsReadAsItIsAgainAndAgain) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, piece - 1, piece, piece + 1, 3 * piece, 200'000ul}) {
    const std::string text = text_of(size);
    CheckedText checked(changed());
    for (const std::size_t at_once : {7ul, 1000ul, 1'000'000ul}) {
      const Read again = read(checked.source(source_of(text, at_once)), at_once);
      EXPECT_EQ(again.error, "");
      EXPECT_TRUE(again.text == text) << size << " by " << at_once;
    }
  }
}

/// A byte that was changed, wherever it stands, keeps all bytes of its piece and of those behind it back.
TEST(CheckedText, HandsOnNothingOfAPieceThatWasChanged) {
  const std::string text = text_of(3 * piece + 100);
  for (const std::size_t at : {std::size_t{0}, piece - 1, piece, 2 * piece + 77, 3 * piece, 3 * piece + 99}) {
    CheckedText checked(changed());
    ASSERT_EQ(read(checked.source(source_of(text, 1000))).error, "");
    std::string other = text;
    other[at] ^= 1;
    const Read again = read(checked.source(source_of(other, 1000)));
    EXPECT_EQ(again.error, "text-changed") << at;
    EXPECT_TRUE(again.text == text.substr(0, at / piece * piece)) << at;
  }
}

TEST(CheckedText, IsAnotherOneWhereItHasShrunkOrGrown) {
  for (const std::size_t size : {2 * piece, 2 * piece + 100}) {
    const std::string text = text_of(size);
    CheckedText checked(changed());
    ASSERT_EQ(read(checked.source(source_of(text, 1000))).error, "");
    for (const std::string& other : {text.substr(0, size - 1), text.substr(0, 10), text.substr(0, piece), text + "G"})
      EXPECT_EQ(read(checked.source(source_of(other, 1000))).error, "text-changed") << size << " " << other.size();
  }
}

/// A program ends with M2, before the end of its text: what lies behind it is taken as it is.
TEST(CheckedText, TakesWhatNobodyHasReadYetAsItIs) {
  const std::string text = text_of(3 * piece);
  std::string other = text;
  other[2 * piece] ^= 1;
  CheckedText checked(changed());
  auto first = checked.source(source_of(text, 1000));
  std::string buffer(piece, '\0');
  ASSERT_TRUE(first(buffer).has_value());
  EXPECT_TRUE(read(checked.source(source_of(other, 1000))).text == other);
  EXPECT_EQ(read(checked.source(source_of(text, 1000))).error, "text-changed");
}

TEST(CheckedText, IsReadFromAnyPlaceAsItWas) {
  const std::string text = text_of(3 * piece + 100);
  std::string now = text;
  CheckedText checked(changed());
  const auto read_from = [&](std::size_t offset) {
    return read(checked.source_at(static_cast<std::int64_t>(offset), [&now](std::int64_t from) {
      return [&now, at = static_cast<std::size_t>(from)](std::span<char> buffer) mutable -> Result<std::size_t> {
        const std::size_t count = std::min(buffer.size(), now.size() - std::min(at, now.size()));
        if (count > 0) std::memcpy(buffer.data(), now.data() + at, count);
        at += count;
        return count;
      };
    }));
  };
  // Also what nobody has come to yet.
  for (const std::size_t offset :
       {2 * piece + 5, std::size_t{0}, std::size_t{1}, piece - 1, piece, 3 * piece + 99, text.size()}) {
    EXPECT_TRUE(read_from(offset).text == text.substr(offset)) << offset;
  }
  now[piece + 7] ^= 1;
  EXPECT_EQ(read_from(2 * piece).error, "");
  EXPECT_EQ(read_from(piece + 9).error, "text-changed");
  EXPECT_EQ(read_from(piece + 9).text, "");
}

TEST(CheckedText, PassesTheErrorOfItsSourceOn) {
  CheckedText checked(changed());
  const auto broken = [](std::span<char>) -> Result<std::size_t> { return failure(problem("io-read", "no", "")); };
  EXPECT_EQ(read(checked.source(broken)).error, "io-read");
}

}  // namespace test_checked_text
}  // namespace leadscrew::base
