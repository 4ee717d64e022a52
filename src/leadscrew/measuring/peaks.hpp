#pragma once
// The tallest ridges and the deepest cuts, between the places of a grid.
//
// The grid sees a ridge as a place that is higher than its neighbours. Its crest is where what one pass leaves meets what the
// other leaves, and each of these is smooth:
//
//              ∗           ∗ crest: where the parabolas through three places on either side meet
//           ● ╱ ╲ ●
//         ●         ●      the mean over all crossings is taken of these; about the tallest of them the tools that are near
//       ●             ●    are kept, and what they leave is evaluated on ever finer grids

#include <cstddef>
#include <cstdint>
#include <leadscrew/measuring/net.hpp>
#include <leadscrew/measuring/place_tree.hpp>
#include <leadscrew/measuring/target.hpp>
#include <leadscrew/measuring/word_path.hpp>
#include <vector>

namespace leadscrew::measuring {

/// A place that stands out.
struct Peak {
  double height = 0;    ///< mm along n
  double u = 0, v = 0;  ///< where
  Vector place{};       ///< mm
  WordPlace word;       ///< whose tool leaves it so

  /// Has any been found?
  bool exists() const { return word.number >= 0; }
};

/// Where a line of the grid crosses a ridge: heights by the number of the place, `at` between two of them.
struct Crossing {
  std::size_t place = 0;  ///< of the highest place
  double height = 0;      ///< of the crest, mm
};
/// Of heights at even spacing; those from `reach` on count as not reached. In ascending order.
std::vector<Crossing> crossings_of(const std::vector<double>& heights, double reach);

class Peaks {
 public:
  /// Of a finished map. What it gets must not change before refine().
  void choose(const PlaceTree& map, const GridLines& lines, const Target& target);
  /// Keeps the tool where it may leave least of one of them.
  void see(const SweptTool& tool, const WordPlace& word);
  /// Seeks them, of the tools seen. `net`: of the target.
  void refine(const Net& net);

  const Peak& ridge() const { return ridge_; }
  const Peak& cut() const { return cut_; }
  double mean_ridge() const { return ridges_ > 0 ? sum_ / static_cast<double>(ridges_) : 0; }
  std::int64_t ridges() const { return ridges_; }

 private:
  struct Kept {
    SweptTool tool;
    WordPlace word;
  };
  struct Cell {
    surfaces::Range u, v;
    bool is_cut = false;
    PlaceTree around;  // nine places
    std::vector<Kept> tools;
  };
  struct Candidate {
    std::size_t i = 0, j = 0;
    double height = 0;
  };
  void cross(const PlaceTree& map, bool along_columns, double reach);
  void find_cuts(const PlaceTree& map);
  void make_cells(std::vector<Candidate>& candidates, const PlaceTree& map, const GridLines& lines, bool is_cut);
  void enclose_cells();
  Peak refined(Cell& cell, const Net& net) const;
  Peak height_at(std::vector<Kept>& tools, const Net& net, double u, double v) const;
  void keep_near(std::vector<Kept>& tools, const Net& net, const surfaces::Range& u, const surfaces::Range& v,
                 double highest) const;

  std::vector<Candidate> ridge_candidates_, cut_candidates_;
  std::vector<Cell> cells_;
  // All cells, up to the reach, are in a ball: what does not come into it is near none of them.
  Vector middle_{};
  double far_ = 0;  // its radius, mm
  double reach_ = 0, sum_ = 0;
  std::int64_t ridges_ = 0;
  Peak ridge_, cut_;
};

}  // namespace leadscrew::measuring
