#pragma once
// Words and sinks for the tests of writers and readers.

#include <algorithm>
#include <cstring>
#include <leadscrew/base/sink.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/machine/machine.hpp>
#include <random>
#include <string>
#include <vector>

namespace leadscrew::testing_support {

inline constexpr base::Period millisecond{1'000'000};

inline base::ByteSink into(std::string& text) {
  return [&text](std::string_view bytes) -> base::Result<void> {
    text += bytes;
    return {};
  };
}

/// Takes `room` bytes and fails from then on.
inline base::ByteSink failing_after(std::size_t room) {
  return [room](std::string_view bytes) mutable -> base::Result<void> {
    if (bytes.size() > room) {
      base::Diagnostic diagnostic;
      diagnostic.code = "disk-full";
      return base::failure(diagnostic);
    }
    room -= bytes.size();
    return {};
  };
}

/// The text in pieces of at most `piece` bytes.
inline base::ByteSource from(std::string text, std::size_t piece = 1 << 20) {
  return [text = std::move(text), piece,
          at = std::size_t{0}](std::span<char> buffer) mutable -> base::Result<std::size_t> {
    const std::size_t count = std::min({buffer.size(), piece, text.size() - at});
    if (count > 0) std::memcpy(buffer.data(), text.data() + at, count);
    at += count;
    return count;
  };
}

/// A smooth random motion of all nine axes; `block_words` words a block on the average.
inline std::vector<base::Word> random_train(std::size_t count, std::uint64_t seed, double block_words = 20) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> push;
  std::bernoulli_distribution next_block(1 / block_words);
  std::vector<base::Word> words(count);
  base::AxisVector velocity{};
  base::Word word;
  word.line = base::Line{1};
  for (std::size_t i = 0; i < count; ++i) {
    word.tick = base::Tick{static_cast<std::int64_t>(i)};
    for (std::size_t a = 0; a < base::axis_count && i > 0; ++a) {
      velocity[a] += push(random) - 0.01 * velocity[a];
      word.position[a] += velocity[a] * 1e-3;
    }
    word.feed = std::abs(velocity[0]) + std::abs(velocity[1]);
    word.path_length += word.feed * 1e-3;
    if (i > 0 && next_block(random)) word.line = base::Line{base::number(word.line) + 1};
    words[i] = word;
  }
  return words;
}

}  // namespace leadscrew::testing_support
