#pragma once
// Helpers for tests that make words of a plan.

#include <leadscrew/interpolator/interpolator.hpp>
#include <planned.hpp>
#include <vector>

namespace leadscrew::testing_support {

inline std::vector<base::Word> words(const std::vector<planner::Chunk>& chunks, base::Period period) {
  interpolator::Interpolator interpolator(period, {});
  std::vector<base::Word> words;
  auto chunk = chunks.begin();
  while (true) {
    while (interpolator.wants_chunk() && chunk != chunks.end()) interpolator.load(*chunk++);
    const bool last = interpolator.wants_chunk();
    words.push_back(interpolator.next());
    if (last) return words;
  }
}

}  // namespace leadscrew::testing_support
