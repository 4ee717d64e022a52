#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/circular_pocket.hpp>

namespace leadscrew::gcode {

namespace {

constexpr double most_circles = 10'000;
constexpr int most_levels = 10'000;

}  // namespace

bool CircularPockets::can_mill(const Block& block) {
  const std::uint32_t column = block.column_of(Group::nonmodal);
  const std::string code = name(block.code(Group::nonmodal));
  if (!block.has('I')) return reporter_.fail();
  if (modal_.plane != Plane::XY)
    return error("bad-plane", column, code + " outside the plane of X and Y", "give G17 before");
  if (modal_.feed_mode == FeedMode::inverse_time) return error("bad-feed-mode", column, code + " in G93", "give G94");
  for (const base::Axis axis : base::all_axes) {
    const bool linear = axis == base::Axis::X || axis == base::Axis::Y || axis == base::Axis::Z;
    if (linear || !block.has(base::letter(axis))) continue;
    return error("unused-word", block.column_of(base::letter(axis)), code + " does not move axis " + base::letter(axis),
                 "move it in a block before");
  }
  return true;
}

bool CircularPockets::plan(const Block& block, Radii& radii) {
  const std::optional<double> cutter = cutter_.of(block);
  if (!cutter) return false;
  const std::string code = name(block.code(Group::nonmodal));
  const double unit = frame_.length_unit;
  radii.first = block['I'] * unit - *cutter;
  radii.last = block.has('K') ? block['K'] * unit - *cutter : radii.first;
  radii.step = block.value_or('Q', 0) * unit;
  if (!(radii.first > 0)) {
    const double scale = cutter_.scale();
    const std::string scaled = scale == 1 ? "" : ", which G51 scales by " + text(scale) + ",";
    return error(
        "bad-value", block.column_of('I'),
        code + " has I" + text(block['I']) + scaled + " with a tool of radius " + text(*cutter * scale) + " mm",
        "I, the radius of the first circle, must be above that of the tool");
  }
  if (radii.last < radii.first) {
    return error("bad-value", block.column_of('K'), code + " has K" + text(block['K']) + " and I" + text(block['I']),
                 "K, the radius of the pocket, is not below I");
  }
  if (block.has('K') != block.has('Q')) {
    return error("missing-word", block.column_of(Group::nonmodal), code + " has one of K and Q",
                 "K the radius of the pocket, Q how much greater each circle is");
  }
  const bool is_one = radii.last == radii.first;
  if (is_one || (radii.step > 0 && (radii.last - radii.first) / radii.step <= most_circles)) return true;
  return error("bad-value", block.column_of('Q'), code + " has Q" + text(block['Q']),
               "above 0, and at most 10000 circles to K");
}

// From the middle and back to it. The tool crosses to the other side between two circles.
void CircularPockets::mill_level(const Radii& radii, PlanePoint middle, int turn, const Feed& feed) {
  double at = 0;  // along X from the middle
  const auto to = [&](double next) {
    cycle_.arc({middle.first + next, middle.second}, {middle.first + (at + next) / 2, middle.second}, turn, feed);
    at = next;
  };
  const auto round = [&] { cycle_.arc(cycle_.place(), middle, turn, feed); };
  double radius = radii.first, side = 1;
  for (int circle = 1; !cycle_.failed(); ++circle) {
    to(side * radius);
    round();
    if (radius == radii.last) break;
    radius = std::min(radii.first + circle * radii.step, radii.last);
    side = -side;
  }
  to(0);
}

// Mach3: out along X, round, and back.
void CircularPockets::mill_circle(const Block& block, int turn, const Feed& feed) {
  const double radius = block['I'] * frame_.length_unit;
  for (const char letter : {'Z', 'K', 'Q', 'L', 'D'}) {
    if (!block.has(letter)) continue;
    error("unused-word", block.column_of(letter), "nothing in this block takes " + std::string(1, letter),
          "G12 and G13 of Mach3 take I alone");
    return;
  }
  if (!(radius > 0)) {
    error("bad-value", block.column_of('I'), "the radius of the circle is " + text(block['I']), "I must be above 0");
    return;
  }
  const PlanePoint middle = cycle_.place();
  cycle_.line(PlanePoint{middle.first + radius, middle.second}, feed);
  cycle_.arc(cycle_.place(), middle, turn, feed);
  cycle_.line(middle, feed);
}

void CircularPockets::mill(const Block& block) {
  if (!can_mill(block)) return;
  Feed feed;
  motion_.feed_of(block, true, block.has('F'), feed);
  const int turn = block.is(Code::G13) ? 1 : -1;
  cycle_.begin(block);
  const base::AxisVector target = frame_.to_program(motion_.target_of(block));
  // To the middle as canned cycles go to a hole.
  cycle_.line(PlanePoint{target[0], target[1]}, Feed{});
  if (options_.dialect == Dialect::mach3) return mill_circle(block, turn, feed);
  Radii radii;
  if (!plan(block, radii)) return;
  const std::optional<int> levels = as_integer(block.value_or('L', 1));
  if (!levels || *levels < 1 || *levels > most_levels) {
    error("bad-value", block.column_of('L'), name(block.code(Group::nonmodal)) + " has L" + text(block['L']),
          "an integer from 1 to 10000");
    return;
  }
  const PlanePoint middle = cycle_.place();
  const double down = target[2] - cycle_.position()[2];
  // Only G91 goes deeper with each level.
  const int times = modal_.distance == Distance::incremental ? *levels : 1;
  const double top = cycle_.position()[2];
  for (int level = 1; level <= times && !cycle_.failed(); ++level) {
    cycle_.level(level == 1 ? target[2] : top + level * down, feed);
    mill_level(radii, middle, turn, feed);
  }
}

}  // namespace leadscrew::gcode
