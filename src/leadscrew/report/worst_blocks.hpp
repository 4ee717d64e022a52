#pragma once
// The ten worst of the blocks that come by.

#include <array>
#include <cstddef>
#include <leadscrew/report/recording.hpp>
#include <vector>

namespace leadscrew::report {

/// Keeps the ten blocks with the greatest `Figure`, the greatest first; of equals the earlier one stays in front.
template <class Block, double Block::* Figure>
class WorstBlocks {
 public:
  void offer(const Block& block) {
    if (!(block.*Figure > 0) || (count_ == blocks_.size() && !(block.*Figure > blocks_.back().*Figure))) return;
    std::size_t at = count_ < blocks_.size() ? count_++ : count_ - 1;
    for (; at > 0 && block.*Figure > blocks_[at - 1].*Figure; --at) blocks_[at] = blocks_[at - 1];
    blocks_[at] = block;
  }

  std::vector<Block> list() const { return {blocks_.begin(), blocks_.begin() + static_cast<std::ptrdiff_t>(count_)}; }
  /// With a block that has not ended yet.
  std::vector<Block> with(const Block& block) const {
    WorstBlocks all = *this;
    all.offer(block);
    return all.list();
  }

 private:
  std::array<Block, 10> blocks_{};
  std::size_t count_ = 0;
};

}  // namespace leadscrew::report
