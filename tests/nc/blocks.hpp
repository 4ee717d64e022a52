#pragma once
// Blocks for the NC program, given by hand.

#include <leadscrew/nc/nc_program.hpp>
#include <utility>
#include <vector>

namespace leadscrew::nc::testing {

/// One after the other.
inline NcProgram::BlockSource source(std::vector<Block> blocks) {
  return [blocks = std::move(blocks), i = std::size_t{0}]() mutable {
    return i < blocks.size() ? std::optional(blocks[i++]) : std::nullopt;
  };
}

inline Block with_word(Block block, std::int64_t word, PulseMethod method = PulseMethod::koren) {
  ArcTape tape;
  count_commands(block, method, {}, tape);
  block.feed_word = word;
  block.greatest_word = std::int64_t{1} << 40;
  return block;
}

inline Block line(const LatticeVector& delta, std::int64_t word, PulseMethod method = PulseMethod::koren) {
  Block block;
  block.delta = delta;
  return with_word(block, word, method);
}

inline Block arc(const pulse::Arc& arc, std::int64_t word, PulseMethod method = PulseMethod::koren,
                 const LatticeVector& delta = {}) {
  Block block;
  block.kind = Block::Kind::arc;
  block.arc = arc;
  block.delta = delta;
  return with_word(block, word, method);
}

}  // namespace leadscrew::nc::testing
