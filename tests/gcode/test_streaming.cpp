
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstring>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_streaming {

// Gives out the text in chunks of these sizes, over and over.
ByteSource in_chunks(std::string text, std::vector<std::size_t> sizes) {
  return [text = std::move(text), sizes = std::move(sizes), at = std::size_t{0},
          turn = std::size_t{0}](std::span<char> buffer) mutable -> base::Result<std::size_t> {
    const std::size_t wanted = std::max<std::size_t>(1, sizes.empty() ? 1 : sizes[turn++ % sizes.size()]);
    const std::size_t count = std::min({wanted, buffer.size(), text.size() - at});
    std::memcpy(buffer.data(), text.data() + at, count);
    at += count;
    return count;
  };
}

void expect_same(const Reading& a, const Reading& b) {
  RC_ASSERT(a.moves.size() == b.moves.size());
  for (std::size_t i = 0; i < a.moves.size(); ++i) {
    RC_ASSERT(a.moves[i].kind == b.moves[i].kind);
    RC_ASSERT(a.moves[i].line == b.moves[i].line);
    RC_ASSERT(a.moves[i].end == b.moves[i].end);
    RC_ASSERT(a.moves[i].event == b.moves[i].event);
    RC_ASSERT(a.moves[i].curve == b.moves[i].curve);
  }
  RC_ASSERT(a.problems() == b.problems());
  RC_ASSERT(a.blocks == b.blocks);
}

std::string some_program() {
  const std::vector<std::string> lines = {"G0 X1 Y2",
                                          "x-3.25\r",
                                          "",
                                          "G1 F100 Z[1+#5420]",
                                          "(remark)",
                                          "G2 X5 R70",
                                          "Q1",
                                          "M3 S1000",
                                          "#1=5",
                                          "G81 X1 Z-2 R1",
                                          "G0 X#1",
                                          "G5 I1 J1 P2 Q3 X9",
                                          "G5.2 X1 Y1\nX2 Y2 P3\nG5.3",
                                          "G6.2 P2 K0\nK0 X5\nK1\nK1"};
  std::string text;
  for (const auto& line : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(lines))) text += line + "\n";
  return text + *rc::gen::element<std::string>("", "M2", "M2\n", " ");
}

RC_GTEST_PROP(Streaming, GivesTheSameMovesHoweverTheTextIsCut, ()) {
  const std::string text = some_program();
  const auto sizes = *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(1, 40));
  expect_same(read_source(in_chunks(text, sizes), {}), read(text));
}

RC_GTEST_PROP(Streaming, CutsLongLinesAtTheSamePlace, ()) {
  const auto length = *rc::gen::inRange<std::size_t>(65'500, 65'600);
  const std::string text = "G0 X1\nG0 X2 (" + std::string(length - 8, 'a') + ")\nG0 X3\nM2\n";
  const auto size = *rc::gen::element<std::size_t>(7, 1000, 65'536, 65'537, 100'000);
  const Reading reading = read_source(in_chunks(text, {size}), {});
  expect_same(reading, read(text));
  RC_ASSERT(reading.problems() == (length > 65'536 ? "2:65537 line-too-long; " : ""));
  RC_ASSERT(reading.lines().size() == (length > 65'536 ? 2u : 3u));
}

TEST(Lines, MayBeAsLongAs64KiB) {
  EXPECT_EQ(read("G0 X1" + std::string(65'536 - 5, ' ') + "\nM2\n").problems(), "");
  EXPECT_EQ(read("G0 X1" + std::string(65'537 - 5, ' ') + "\nM2\n").problems(), "1:65537 line-too-long; ");
}

TEST(Streaming, SkipsALineOfAnyLength) {
  for (const bool closed : {true, false}) {
    std::size_t left = 200'000'000;
    bool head = true;
    ByteSource source = [&](std::span<char> buffer) -> base::Result<std::size_t> {
      if (head) {
        head = false;
        std::memcpy(buffer.data(), "G0 X1\n", 6);
        return 6;
      }
      const std::size_t count = std::min(buffer.size(), left);
      std::memset(buffer.data(), 'X', count);
      left -= count;
      if (left == 0 && count > 0 && closed) buffer[count - 1] = '\n';
      return count;
    };
    const Reading reading = read_source(source, {});
    EXPECT_EQ(reading.problems(), "2:65537 line-too-long; ");
    EXPECT_EQ(reading.lines().size(), 1u);
    EXPECT_LE(reading.diagnostics[0].source.size(), 200u);
  }
}

TEST(Streaming, TakesNoMoreThanItIsAskedFor) {
  // A source of many blocks: the reader never asks for more than a chunk, and its moves come before the text has ended.
  std::int64_t given = 0;
  const std::string blocks = "G0X1\nG0X2\n";
  ByteSource source = [&](std::span<char> buffer) -> base::Result<std::size_t> {
    EXPECT_LE(buffer.size(), 64u * 1024);
    if (given > 100'000'000) return 0;
    std::size_t count = 0;
    for (; count + blocks.size() <= buffer.size(); count += blocks.size()) {
      std::memcpy(buffer.data() + count, blocks.data(), blocks.size());
    }
    given += static_cast<std::int64_t>(count);
    return count;
  };
  const machine::Machine machine = nine_axes();
  const machine::ToolTable tools;
  Reader reader(source, machine, tools, {}, [](const base::Diagnostic&) {});
  Move move;
  std::int64_t moves = 0;
  while (reader.next(move)) {
    ++moves;
    ASSERT_LE(given - 5 * moves, 3 * 64 * 1024);
  }
  EXPECT_EQ(moves, given / 5 + 1);
}

TEST(Source, ThatFailsEndsTheReading) {
  int calls = 0;
  ByteSource source = [&](std::span<char> buffer) -> base::Result<std::size_t> {
    if (++calls > 1) return base::failure({base::Severity::error, "read-failed", "gone", "", {}, {}});
    std::memcpy(buffer.data(), "G0 X1\nG0 X2", 11);
    return 11;
  };
  const machine::Machine machine = nine_axes();
  const machine::ToolTable tools;
  Reader reader(source, machine, tools, {}, [](const base::Diagnostic&) { ADD_FAILURE(); });
  Move move;
  EXPECT_TRUE(reader.next(move));
  EXPECT_FALSE(reader.next(move));
  ASSERT_TRUE(reader.source_failure());
  EXPECT_EQ(reader.source_failure()->code, "read-failed");
  EXPECT_EQ(calls, 2);
}

}  // namespace test_streaming
}  // namespace leadscrew::gcode
