#pragma once
// Arcs about the origin, by quadrants: in each of them neither axis turns back.
//
//   ccw          y          A start on an axis belongs to the quadrant that the arc enters there, an end on one to the
//            1   |   0      quadrant that it closes. An arc whose end is where it starts is a full circle.
//        --------+-------- x
//            2   |   3

#include <leadscrew/pulse/pulse.hpp>

namespace leadscrew::pulse {

/// |coordinates| ≤ greatest_coordinate_of<Register>; neither start nor end at the origin. The end may be off the circle through the
/// start by up to half a BLU: it is reached all the same.
template <typename Register>
struct BasicArc {
  BasicPoint<Register> start, end;
  Direction direction = Direction::counterclockwise;

  constexpr Square<Register> squared_radius() const {
    const Square<Register> x = start.x, y = start.y;
    return x * x + y * y;
  }
  constexpr bool is_counterclockwise() const { return direction == Direction::counterclockwise; }

  friend constexpr bool operator==(const BasicArc&, const BasicArc&) = default;
};
using Arc = BasicArc<std::int64_t>;

/// The quadrant in which a motion from this place goes on: 0 … 3.
template <typename Register>
constexpr int quadrant(BasicPoint<Register> at, Direction direction) {
  const auto [x, y] = at;
  if (direction == Direction::counterclockwise) {
    if (x > 0 && y >= 0) return 0;
    if (x <= 0 && y > 0) return 1;
    return x < 0 && y <= 0 ? 2 : 3;
  }
  if (x >= 0 && y > 0) return 0;
  if (x < 0 && y >= 0) return 1;
  return x <= 0 && y < 0 ? 2 : 3;
}

/// Signs of the steps in a quadrant: those of the tangent.
constexpr Pulse<2> tangent(int quadrant, Direction direction) {
  const bool up = quadrant == 0 || quadrant == 3, right = quadrant == 2 || quadrant == 3;  // counterclockwise
  const auto sense = static_cast<std::int8_t>(direction);
  return {{static_cast<std::int8_t>(right ? sense : -sense), static_cast<std::int8_t>(up ? sense : -sense)}};
}

/// The next one.
constexpr int after(int quadrant, Direction direction) {
  return (quadrant + static_cast<int>(direction)) & 3;
}

/// How many borders of quadrants the arc passes: 0 … 4.
template <typename Register>
constexpr int borders(const BasicArc<Register>& arc) {
  const int sense = static_cast<int>(arc.direction);
  const int from = quadrant(arc.start, arc.direction), to = quadrant(arc.end, static_cast<Direction>(-sense));
  const int passed = (sense * (to - from)) & 3;
  const Square<Register> x = arc.start.x, y = arc.start.y;
  const Square<Register> cross = x * arc.end.y - y * arc.end.x, dot = x * arc.end.x + y * arc.end.y;
  const bool goes_round = sense * cross < 0 || (cross == 0 && dot > 0);
  return passed == 0 && goes_round ? 4 : passed;
}

/// Where the circle leaves a quadrant: the lattice point of the axis nearest to it.
template <typename Register>
constexpr BasicPoint<Register> border(int quadrant, Direction direction, Register radius) {
  // Counterclockwise the first quadrant is left at +Y; clockwise the second.
  switch (direction == Direction::counterclockwise ? quadrant : (quadrant + 3) & 3) {
    case 0:
      return {0, radius};
    case 1:
      return {static_cast<Register>(-radius), 0};
    case 2:
      return {0, static_cast<Register>(-radius)};
    default:
      return {radius, 0};
  }
}

}  // namespace leadscrew::pulse
