#pragma once
// What is left on a grid of places of a surface, lowered by tools that pass by.
//
// The grid lies in blocks of a few places, and four blocks in one of the level above, up to one of all. Each knows how far its
// places lie beside and along the mean of their normals, and the greatest height in it. A tool that cannot come below that,
// by the tangent of its distance at the block's centre (it is convex), is passed over with all the places in it.

#include <cstddef>
#include <cstdint>
#include <leadscrew/measuring/swept_tool.hpp>
#include <vector>

namespace leadscrew::measuring {

/// One of the grid, and what is left above it.
struct GridPlace {
  Vector s{}, n{};    ///< mm; unit, 0 where there is no normal
  double height = 0;  ///< mm along n, negative where it is cut into
};

/// The height in a block where there is no place of the grid, or none with a normal: nothing lowers it.
inline constexpr double no_place = -std::numeric_limits<double>::infinity();

/// So deep a cut of a tool is sought: what is deeper counts as this deep, mm, negative.
inline double deepest_of(const ToolBody& body) {
  return -4 * body.radius;
}

class PlaceTree {
 public:
  /// Of a block, in places.
  struct Block {
    std::size_t columns = 4, rows = 4;
  };

  /// columns × rows places, each ≥ 1. Blocks had better be as wide as they are high on the surface.
  PlaceTree(std::size_t columns, std::size_t rows, Block block);

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  GridPlace& at(std::size_t i, std::size_t j) { return places_[index(i, j)]; }
  const GridPlace& at(std::size_t i, std::size_t j) const { return places_[index(i, j)]; }

  /// Once all places are set: nothing nearer than `reach`, mm, is left anywhere.
  void begin(double reach);
  /// Sets what is still as high as `from` to `to`, the greater. False where nothing is.
  bool raise(double from, double to);
  /// Lowers what is left by a tool. True where it has lowered any.
  bool lower(const SweptTool& tool);
  /// May it lower any, as far as the root can tell?
  bool may_lower(const SweptTool& tool) const { return may_reach(levels_.back().nodes.front(), tool); }

 private:
  /// A block, or four of the level below.
  struct Node {
    Vector centre{}, normal{};
    double aside = 0;    ///< of its places from the centre, across the normal, at most
    double along = 0;    ///< along the normal
    double spread = 0;   ///< |n − normal|
    double highest = 0;  ///< height
  };
  struct Level {
    std::size_t columns = 0, rows = 0;
    std::vector<Node> nodes;
  };

  std::size_t index(std::size_t i, std::size_t j) const {
    const std::size_t number = (j / block_.rows) * levels_.front().columns + i / block_.columns;
    return number * block_.columns * block_.rows + (j % block_.rows) * block_.columns + i % block_.columns;
  }
  static bool may_reach(const Node& node, const SweptTool& tool);
  static void enclose(Node& node, const std::vector<const GridPlace*>& places);
  void build(std::size_t level, std::size_t i, std::size_t j);
  void visit(std::size_t level, std::size_t i, std::size_t j, const SweptTool& tool);
  void visit_block(Node& node, std::size_t block, const SweptTool& tool);

  std::size_t columns_, rows_;
  Block block_;
  std::vector<Level> levels_;  // of blocks first
  std::vector<GridPlace> places_;
  bool lowered_ = false;
};

}  // namespace leadscrew::measuring
