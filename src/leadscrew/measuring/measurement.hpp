#pragma once
// What a tool leaves of a surface, and where it has cut into it.
//
//            ╲       ╱╲       ╱╲       ╱      tools, swept from word to word
//             ╲  T  ╱  ╲     ╱  ╲     ╱
//          ────`-.-'────`-.-'────`-.-'──── S
//                   ↑ ridge: height above S along n
//
// At each place of a grid on the surface: how far along n the first of all tools is met. That is 0 where a tool touches, the
// height of the ridge between two passes, and negative where a tool has cut into the surface. The trace is read twice, or
// three times where places are left that no tool has come near:
//
//   1  all words against the grid (place_tree.hpp), many at a time, of these first few, far apart, then those between, so that
//      most find what they leave to be lower already
//   2  about the tallest ridges and the deepest cuts the tools that are near are kept, and what they leave is sought between the
//      places of the grid (peaks.hpp)
//
// Nothing here is shared with what makes passes: the surface is evaluated by formulas of its own (net.hpp).

#include <cstdint>
#include <leadscrew/measuring/peaks.hpp>
#include <leadscrew/measuring/place_tree.hpp>
#include <leadscrew/measuring/target.hpp>
#include <leadscrew/measuring/word_path.hpp>
#include <vector>

namespace leadscrew::measuring {

/// All that was found.
struct Findings {
  double area = 0;          ///< of the range, mm²
  double not_reached = 0;   ///< of it: where no tool came within the reach, mm²
  Peak cut;                 ///< the deepest; height 0 where there is none
  Peak ridge;               ///< the tallest that was reached
  double mean_ridge = 0;    ///< of all crossings of ridges by lines of the grid across the passes, mm; 0 without any
  std::int64_t ridges = 0;  ///< how many crossings
  double mean_height = 0;   ///< of what is left where it was reached, mm
  double chord = 0;         ///< mm: words are joined straight, and so far may a tool have been off that between two
};

class Measurement {
 public:
  /// Of a target that has no fault. Memory: by the places of its grid.
  explicit Measurement(Target target);
  Measurement(const Measurement&) = delete;
  Measurement& operator=(const Measurement&) = delete;

  /// The next word's tool: where it is, and what of it cuts. `joined`: it has come straight from the word before, as the same
  /// body, turning by less than a degree or so.
  void add(const ToolPose& pose, const ToolBody& body, const WordPlace& word, bool joined);
  /// After the last word. True: all words are to be given once more. Once it is false, words and readings change
  /// nothing any more.
  bool end_reading();

  /// After the last reading.
  const Findings& findings() const { return findings_; }
  const Target& target() const { return target_; }
  const PlaceTree& map() const { return tree_; }
  /// Parameters of the map's columns and rows.
  const GridLines& lines() const { return lines_; }

 private:
  void take(const WordStep& step);
  void lower_all();
  void survey();

  Target target_;
  Net net_;
  GridLines lines_;
  PlaceTree tree_;
  std::vector<float> area_;  // of each place of the grid, mm², row by row
  Peaks peaks_;
  WordPath words_;
  std::vector<WordStep> steps_;
  /// Of readings: what is near the surface, what else is within reach, and the peaks.
  enum class Stage : std::uint8_t { near, far, peaks, done } stage_ = Stage::near;
  Findings findings_;
};

}  // namespace leadscrew::measuring
