#include <algorithm>
#include <cmath>
#include <leadscrew/measuring/place_tree.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::measuring {

using numeric::difference;
using numeric::dot;
using numeric::norm;

PlaceTree::PlaceTree(std::size_t columns, std::size_t rows, Block block)
    : columns_(columns), rows_(rows), block_(block) {
  std::size_t wide = (columns + block.columns - 1) / block.columns, high = (rows + block.rows - 1) / block.rows;
  places_.assign(wide * high * block.columns * block.rows, GridPlace{{}, {}, no_place});
  while (true) {
    levels_.push_back({wide, high, std::vector<Node>(wide * high)});
    if (wide == 1 && high == 1) break;
    wide = (wide + 1) / 2;
    high = (high + 1) / 2;
  }
}

void PlaceTree::begin(double reach) {
  for (std::size_t j = 0; j < rows_; ++j) {
    for (std::size_t i = 0; i < columns_; ++i) at(i, j).height = norm(at(i, j).n) > 0 ? reach : no_place;
  }
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    for (std::size_t j = 0; j < levels_[level].rows; ++j) {
      for (std::size_t i = 0; i < levels_[level].columns; ++i) {
        build(level, i, j);
        levels_[level].nodes[j * levels_[level].columns + i].highest = reach;
      }
    }
  }
}

bool PlaceTree::raise(double from, double to) {
  bool raised = false;
  for (GridPlace& place : places_) {
    if (place.height < from) continue;
    place.height = to;
    raised = true;
  }
  for (Level& level : levels_) {
    for (Node& node : level.nodes) {
      if (node.highest >= from) node.highest = to;
    }
  }
  return raised;
}

/// From the places in it. (Each place is looked at once a level.)
void PlaceTree::build(std::size_t level, std::size_t i, std::size_t j) {
  const std::size_t wide = block_.columns << level, high = block_.rows << level;
  std::vector<const GridPlace*> places;
  // Of the higher levels the blocks' borders and centres alone would not do: a surface may bulge anywhere.
  for (std::size_t row = j * high; row < std::min(rows_, (j + 1) * high); ++row) {
    for (std::size_t column = i * wide; column < std::min(columns_, (i + 1) * wide); ++column)
      places.push_back(&at(column, row));
  }
  enclose(levels_[level].nodes[j * levels_[level].columns + i], places);
}

void PlaceTree::enclose(Node& node, const std::vector<const GridPlace*>& places) {
  Vector least = places.front()->s, greatest = least, sum{};
  for (const GridPlace* place : places) {
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], place->s[k]);
      greatest[k] = std::max(greatest[k], place->s[k]);
      sum[k] += place->n[k];
    }
  }
  const double length = norm(sum);
  for (std::size_t k = 0; k < 3; ++k) {
    node.centre[k] = (least[k] + greatest[k]) / 2;
    node.normal[k] = length > 0 ? sum[k] / length : 0;
  }
  for (const GridPlace* place : places) {
    const Vector away = difference(place->s, node.centre);
    const double along = dot(away, node.normal);
    node.along = std::max(node.along, std::abs(along));
    node.aside = std::max(node.aside, norm(numeric::sum(away, -along, node.normal)));
    node.spread = std::max(node.spread, norm(difference(place->n, node.normal)));
  }
}

/// Is a point s + t n, 0 ≤ t ≤ highest, of any of its places perhaps in the tool?
bool PlaceTree::may_reach(const Node& node, const SweptTool& tool) {
  const Distance distance = tool.least_distance(node.centre);
  if (distance.value <= 0) return true;
  const double up = dot(distance.gradient, node.normal);
  const double across = std::sqrt(std::max(0.0, dot(distance.gradient, distance.gradient) - up * up));
  const double height = std::max(0.0, node.highest);
  const double nearer = across * node.aside + std::abs(up) * node.along + height * std::max(0.0, node.spread - up);
  return distance.value <= nearer;
}

bool PlaceTree::lower(const SweptTool& tool) {
  lowered_ = false;
  visit(levels_.size() - 1, 0, 0, tool);
  return lowered_;
}

/// No deeper than there are levels.
void PlaceTree::visit(std::size_t level, std::size_t i, std::size_t j, const SweptTool& tool) {
  Level& here = levels_[level];
  const std::size_t number = j * here.columns + i;
  Node& node = here.nodes[number];
  if (!may_reach(node, tool)) return;
  if (level == 0) return visit_block(node, number, tool);
  const Level& below = levels_[level - 1];
  double highest = no_place;
  for (std::size_t row = 2 * j; row < std::min(below.rows, 2 * j + 2); ++row) {
    for (std::size_t column = 2 * i; column < std::min(below.columns, 2 * i + 2); ++column) {
      visit(level - 1, column, row, tool);
      highest = std::max(highest, below.nodes[row * below.columns + column].highest);
    }
  }
  node.highest = highest;
}

void PlaceTree::visit_block(Node& node, std::size_t block, const SweptTool& tool) {
  const double below = deepest_of(tool.body());
  double highest = no_place;
  const std::size_t count = block_.columns * block_.rows;
  GridPlace* const places = &places_[block * count];
  for (std::size_t k = 0; k < count; ++k) {
    GridPlace& place = places[k];
    if (place.height == no_place) continue;
    if (tool.may_enter(place.s, place.n, place.height)) {
      const double height = tool.entry(place.s, place.n, below, place.height);
      if (height < place.height) {
        place.height = height;
        lowered_ = true;
      }
    }
    highest = std::max(highest, place.height);
  }
  node.highest = highest;
}

}  // namespace leadscrew::measuring
