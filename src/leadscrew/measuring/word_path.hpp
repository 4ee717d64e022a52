#pragma once
// From words to a swept tool: straight from one word to the next, or, where that would be off by more than a nanometre, in parts
// of the cubic through four words (Catmull and Rom, "A class of local interpolating splines", 1974).

#include <array>
#include <cstdint>
#include <functional>
#include <leadscrew/measuring/swept_tool.hpp>

namespace leadscrew::measuring {

/// A part of the way between two words.
struct WordStep {
  SweptTool tool;
  std::int64_t word = 0;  ///< the former
  double chord = 0;       ///< mm: how far the straight way is off a smooth one
};

class WordPath {
 public:
  using Sink = std::function<void(const WordStep&)>;

  /// The next word's tool. `joined`: it has come from the word before, which had the same body.
  void add(const ToolPose& pose, const ToolBody& body, std::int64_t word, bool joined, const Sink& sink);
  /// There is no word after the last.
  void end(const Sink& sink);

 private:
  void tell(std::size_t from, const Sink& sink);

  std::array<ToolPose, 4> poses_{};  // the last ones
  std::size_t count_ = 0;            // of them, 0 … 4
  ToolBody body_;
  std::int64_t word_ = 0;  // of the last
};

}  // namespace leadscrew::measuring
