#pragma once
// From words to a swept tool: straight from one word to the next, or, where that would be off by more than a nanometre, in parts
// of the cubic through four words (Catmull and Rom, "A class of local interpolating splines", 1974).

#include <array>
#include <cstdint>
#include <functional>
#include <leadscrew/measuring/swept_tool.hpp>

namespace leadscrew::measuring {

/// Which word of a trace.
struct WordPlace {
  std::int64_t number = -1;  ///< from 0; −1: none
  double t = 0;              ///< s
  std::int64_t line = 0;     ///< of its block; 0 where the trace does not tell it
};

/// A part of the way between two words.
struct WordStep {
  SweptTool tool;
  WordPlace word;    ///< the former
  double chord = 0;  ///< mm: how far the straight way is off a smooth one
};

class WordPath {
 public:
  using Sink = std::function<void(const WordStep&)>;

  /// The next word's tool. `joined`: it has come from the word before, which had the same body.
  void add(const ToolPose& pose, const ToolBody& body, const WordPlace& word, bool joined, const Sink& sink);
  /// There is no word after the last.
  void end(const Sink& sink);

 private:
  void tell(std::size_t from, const Sink& sink);

  std::array<WordPlace, 4> places_{};
  std::array<ToolPose, 4> poses_{};  // the last ones
  std::size_t count_ = 0;            // of them, 0 … 4
  ToolBody body_;
};

}  // namespace leadscrew::measuring
