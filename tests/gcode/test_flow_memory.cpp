// Loops, conditions and subprograms take no memory that grows with the program: lines are made as they are asked for, and
// what the process has grown by is measured.

#include <sys/resource.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <sanitizers.hpp>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_flow_memory {

using testing_support::is_sanitized;

/// Peak resident memory of the process so far, bytes.
std::int64_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

constexpr std::int64_t width = 32;  // of each line, with its line feed

/// Writes line `number`, from 0, without its line feed; nothing behind the last.
using Line = int (*)(std::int64_t number, char* text);

int print(char* text, const char* form, std::int64_t a, std::int64_t b) {
  return std::snprintf(text, static_cast<std::size_t>(width), form, static_cast<long>(a), static_cast<long>(b));
}

constexpr std::int64_t blocks = 250'000;

/// A million lines: a condition and a move each time.
int conditions(std::int64_t number, char* text) {
  const std::int64_t of = number / 4;
  if (of == blocks) return number % 4 == 0 ? print(text, "M2", 0, 0) : 0;
  switch (number % 4) {
    case 0:
      return print(text, "o%ld if [%ld GT 3]", of + 1, of % 7);
    case 1:
      return print(text, "G0 X%ld Y%ld", of % 90, of % 7);
    case 2:
      return print(text, "o%ld endif", of + 1, 0);
    default:
      return print(text, "G0 X%ld", of % 80, 0);
  }
}

/// As many calls of one subprogram.
int calls(std::int64_t number, char* text) {
  constexpr std::array<const char*, 4> begin = {"o1 sub", "#<local>=#1", "G0 X#<local> Y#2", "o1 endsub"};
  if (number < 4) return print(text, begin[static_cast<std::size_t>(number)], 0, 0);
  if (number == blocks + 4) return print(text, "M2", 0, 0);
  return number > blocks + 4 ? 0 : print(text, "o1 call [%ld] [%ld]", number % 90, number % 7);
}

/// A loop whose body is so long.
int long_body(std::int64_t number, char* text) {
  if (number == 0) return print(text, "o1 repeat [3]", 0, 0);
  if (number == blocks + 1) return print(text, "o1 endrepeat", 0, 0);
  if (number == blocks + 2) return print(text, "M2", 0, 0);
  return number > blocks + 2 ? 0 : print(text, "G0 X%ld Y%ld", number % 90, number % 7);
}

/// The text of these lines from an offset on.
ByteSource source_of(Line line, std::int64_t offset) {
  return [line, at = offset](std::span<char> buffer) mutable -> base::Result<std::size_t> {
    std::size_t filled = 0;
    std::array<char, width + 1> text{};
    while (filled < buffer.size()) {
      const int length = line(at / width, text.data());
      if (length <= 0) break;
      std::memset(text.data() + length, ' ', static_cast<std::size_t>(width - length));
      text[width - 1] = '\n';
      const auto from = static_cast<std::size_t>(at % width);
      const std::size_t count = std::min(static_cast<std::size_t>(width) - from, buffer.size() - filled);
      std::memcpy(buffer.data() + filled, text.data() + from, count);
      filled += count;
      at += static_cast<std::int64_t>(count);
    }
    return filled;
  };
}

/// By how much memory grows while the program is read, bytes; `moves`: how many it makes.
std::int64_t growth_of(Line line, bool comes_once, std::int64_t moves) {
  const machine::Machine machine = nine_axes();
  const machine::ToolTable tools;
  ReaderOptions options;
  if (!comes_once) {
    options.opener = [line](const std::string&, std::int64_t offset) -> base::Result<base::OpenedText> {
      return base::OpenedText{source_of(line, offset), "lines.ngc"};
    };
  }
  Reader reader(source_of(line, 0), machine, tools, options,
                [](const base::Diagnostic& d) { ADD_FAILURE() << d.place.line << ": " << d.message; });
  Move move;
  const std::int64_t before = peak_memory();
  std::int64_t count = 0;
  while (reader.next(move)) count += move.kind == Move::Kind::line;
  EXPECT_EQ(count, moves);
  return peak_memory() - before;
}

/// How many moves a sequence of places makes, from X0 Y0; next(i, x, y) says where the i-th leads to, of `count`.
template <class Next>
std::int64_t moves_of(std::int64_t count, const Next& next) {
  std::int64_t moves = 0, x = 0, y = 0;
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t x_before = x, y_before = y;
    next(i, x, y);
    moves += x != x_before || y != y_before;
  }
  return moves;
}

// Of conditions 65 536 places are remembered; a text that comes but once is kept up to 16 MiB.
constexpr std::int64_t most_of_file = std::int64_t{12} << 20, most_of_stream = std::int64_t{48} << 20;

void expect_bounded(Line line, std::int64_t moves) {
  if (is_sanitized) GTEST_SKIP() << "memory of the sanitizers";
  EXPECT_LE(growth_of(line, false, moves), most_of_file);
  EXPECT_LE(growth_of(line, true, moves), most_of_stream);
}

TEST(MemoryOfFlow, IsBoundedOverConditions) {
  expect_bounded(conditions, moves_of(2 * blocks, [](std::int64_t i, std::int64_t& x, std::int64_t& y) {
                   const std::int64_t of = i / 2;
                   if (i % 2 == 1) {
                     x = of % 80;
                   } else if (of % 7 > 3) {
                     x = of % 90;
                     y = of % 7;
                   }
                 }));
}

TEST(MemoryOfFlow, IsBoundedOverCalls) {
  expect_bounded(calls, moves_of(blocks, [](std::int64_t i, std::int64_t& x, std::int64_t& y) {
                   x = (i + 4) % 90;
                   y = (i + 4) % 7;
                 }));
}

TEST(MemoryOfFlow, IsBoundedOverALongBody) {
  expect_bounded(long_body, moves_of(3 * blocks, [](std::int64_t i, std::int64_t& x, std::int64_t& y) {
                   const std::int64_t number = i % blocks + 1;
                   x = number % 90;
                   y = number % 7;
                 }));
}

}  // namespace test_flow_memory
}  // namespace leadscrew::gcode
