#include <gtest/gtest.h>

#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/circular_search.hpp>
#include <leadscrew/pulse/linear.hpp>
#include <string>
#include <vector>

// Registers of 16 and of 32 bits: the same steps at the same clocks as with 64.

namespace leadscrew::pulse {
namespace test_registers {

template <typename Register>
BasicPoint<Register> narrowed(Point at) {
  return {static_cast<Register>(at.x), static_cast<Register>(at.y)};
}
template <typename Register>
BasicArc<Register> narrowed(const Arc& arc) {
  return {narrowed<Register>(arc.start), narrowed<Register>(arc.end), arc.direction};
}

/// Clocks until either is done, or differs; −1 where they differ.
template <typename Wide, typename Narrow>
std::int64_t same_clocks(Wide wide, Narrow narrow) {
  std::int64_t clocks = 0;
  for (; !wide.done(); ++clocks) {
    if (narrow.done() || narrow.step() != wide.step()) return -1;
  }
  return narrow.done() ? clocks : -1;
}

template <typename Register>
struct Circles {
  template <Search method, OnCircle on_circle = OnCircle::outward>
  static std::int64_t search(const Arc& arc) {
    return same_clocks(CircularSearch<method, on_circle>(arc),
                       CircularSearch<method, on_circle, Register>(narrowed<Register>(arc)));
  }
  static std::int64_t dda(const Arc& arc, Order order, Preload preload) {
    return same_clocks(CircularDda(arc, {order, preload}),
                       BasicCircularDda<Register>(narrowed<Register>(arc), {order, preload}));
  }
  static void expect_same(const Arc& arc) {
    const std::string what = std::to_string(arc.start.x) + ' ' + std::to_string(arc.start.y) + " to " +
                             std::to_string(arc.end.x) + ' ' + std::to_string(arc.end.y);
    EXPECT_GT(search<Search::point_comparison>(arc), 0) << what;
    EXPECT_GT((search<Search::point_comparison, OnCircle::inward>(arc)), 0) << what;
    EXPECT_GT(search<Search::least_error>(arc), 0) << what;
    EXPECT_GT(search<Search::improved_least_error>(arc), 0) << what;
    for (const Order order : {Order::parallel, Order::x_first, Order::shrinking_first, Order::growing_first}) {
      for (const Preload preload : {Preload::none, Preload::half, Preload::half_lagging, Preload::full})
        EXPECT_GT(dda(arc, order, preload), 0) << what;
    }
  }
};

/// Circles of eight radii up to the greatest, and arcs through all quadrants.
template <typename Register>
void expect_same_circles(std::int64_t greatest) {
  for (std::int64_t radius = greatest; radius > 0; radius -= (greatest + 7) / 8) {
    for (const Direction direction : {Direction::clockwise, Direction::counterclockwise}) {
      Circles<Register>::expect_same({{radius, 0}, {radius, 0}, direction});
      Circles<Register>::expect_same({{0, -radius}, {radius * 3 / 5, radius * 4 / 5}, direction});
    }
  }
}

TEST(RegistersOf16Bits, TakeTheSameCirclesUpToTheGreatestRadius) {
  EXPECT_EQ(greatest_coordinate_of<std::int16_t>, 4096);
  expect_same_circles<std::int16_t>(4096);
}

TEST(RegistersOf32Bits, TakeTheSameCircles) {
  expect_same_circles<std::int32_t>(7000);
}

/// What the comment of greatest_coordinate_of promises, where a circle is too long to be walked round: its beginning.
TEST(RegistersOf32Bits, BeginTheSameCircleAtTheGreatestRadius) {
  constexpr std::int64_t greatest = greatest_coordinate_of<std::int32_t>;
  const Arc arc{{greatest, 0}, {0, greatest}, Direction::counterclockwise};
  CircularSearch<Search::least_error> wide(arc);
  CircularSearch<Search::least_error, OnCircle::outward, std::int32_t> narrow(narrowed<std::int32_t>(arc));
  for (int clock = 0; clock < 100000; ++clock) ASSERT_EQ(wide.step(), narrow.step()) << clock;
}

/// A fan of lines, and those to the greatest coordinates.
template <typename Register>
void expect_same_lines(std::int64_t greatest) {
  for (std::int64_t a = -greatest; a <= greatest; a += greatest / 8) {
    for (const std::int64_t b : {-greatest, -greatest / 3, std::int64_t{-1}, std::int64_t{0}, greatest / 2, greatest}) {
      if (a == 0 && b == 0) continue;
      const std::array<std::int64_t, 2> delta{a, b};
      const std::array<Register, 2> narrow{static_cast<Register>(a), static_cast<Register>(b)};
      const std::int64_t longest = std::max(absolute(a), absolute(b));
      EXPECT_EQ(same_clocks(LinearBresenham({a, b}), BasicLinearBresenham<Register>({narrow[0], narrow[1]})), longest);
      EXPECT_EQ(same_clocks(LinearPointComparison<2>(delta), LinearPointComparison<2, Register>(narrow)),
                absolute(a) + absolute(b));
      EXPECT_GE(same_clocks(LinearDda<2>(delta, longest, Preload::half),
                            LinearDda<2, Register>(narrow, static_cast<Register>(longest), Preload::half)),
                longest);
    }
  }
}

TEST(RegistersOf16Bits, TakeTheSameLines) {
  expect_same_lines<std::int16_t>(4096);
}
TEST(RegistersOf32Bits, TakeTheSameLines) {
  expect_same_lines<std::int32_t>(30000);
}

}  // namespace test_registers
}  // namespace leadscrew::pulse
