#include <bit>
#include <cmath>
#include <leadscrew/gcode/polar.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <numbers>

namespace leadscrew::gcode {

namespace {
constexpr std::uint32_t distance_bit = letter_bit('Z') << 1;
constexpr std::uint32_t angle_bit = letter_bit('Z') << 2;
constexpr double radians_to_degrees = 180 / std::numbers::pi;
}  // namespace

void Polar::announce(Block& block) {
  const std::uint32_t column = column_of(block);
  // LinuxCNC looks at the plane when it reads the block, before its own G17, G18 or G19 holds.
  if (modal_.plane != Plane::XY) {
    error("bad-polar", column, "polar words stand outside of G17", "give G17 in a block before, or X and Y");
  }
  for (const char letter : {'X', 'Y'}) {
    if (!block.has(letter)) continue;
    error("bad-polar", block.column_of(letter), std::string("@ or ^ and ") + letter + " stand in one block",
          "give the point either way");
  }
  if (block.is(Code::G53)) {
    error("bad-polar", column, "G53 takes no polar words", "they are seen from the program's origin: give X and Y");
  }
  for (std::uint32_t rest = block.groups & ~bit(Group::motion); rest != 0; rest &= rest - 1) {
    const Code code = block.codes[static_cast<std::size_t>(std::countr_zero(rest))];
    if (!row(code).takes_axes) continue;
    error("bad-polar", column, name(code) + " takes no polar words", "they belong to motions: give X and Y");
  }
  block.words |= letter_bit('X') | letter_bit('Y');
  for (const char letter : {'X', 'Y'}) {
    const auto i = static_cast<std::size_t>(letter - 'A');
    block.value[i] = 0;
    block.column[i] = column;
  }
}

bool Polar::applies(const Block& block) const {
  if (block.is(Code::G15) || block.is(Code::G53)) return false;
  for (std::uint32_t rest = block.groups & ~bit(Group::motion); rest != 0; rest &= rest - 1) {
    if (row(block.codes[static_cast<std::size_t>(std::countr_zero(rest))]).takes_axes) return false;
  }
  return block.has(base::letter(first_axis(modal_.plane))) || block.has(base::letter(second_axis(modal_.plane)));
}

// The first axis of the plane is the radius from the program's zero, the second the angle from the first axis. A word
// that is missing keeps its value; in G91 words add to what was.
Block Polar::in_axes(const Block& block) {
  Block result = block;
  const char letters[] = {base::letter(first_axis(modal_.plane)), base::letter(second_axis(modal_.plane))};
  const bool incremental = block.is(Code::G91) || (modal_.distance == Distance::incremental && !block.is(Code::G90));
  if (block.has(letters[0])) modal_.polar_radius = block[letters[0]] + (incremental ? modal_.polar_radius : 0);
  if (block.has(letters[1])) modal_.polar_angle = block[letters[1]] + (incremental ? modal_.polar_angle : 0);
  const base::AxisVector program = frame_.to_program(frame_.position);
  const double values[] = {modal_.polar_radius * cosine_of_degrees(modal_.polar_angle),
                           modal_.polar_radius * sine_of_degrees(modal_.polar_angle)};
  const std::uint32_t column = block.column_of(block.has(letters[0]) ? letters[0] : letters[1]);
  for (int i = 0; i < 2; ++i) {
    const auto word = static_cast<std::size_t>(letters[i] - 'A');
    const base::Axis axis = axis_of_letter(static_cast<unsigned>(word));
    const double stands = program[base::index(axis)] / frame_.unit(axis);
    result.words |= letter_bit(letters[i]);
    if (!block.has(letters[i])) result.column[word] = column;
    result.value[word] = values[i] - (incremental ? stands : 0);
  }
  return result;
}

void Polar::resolve(Block& block) {
  const base::AxisVector program = frame_.to_program(frame_.position);
  const double x = program[base::index(base::Axis::X)] / frame_.length_unit;
  const double y = program[base::index(base::Axis::Y)] / frame_.length_unit;
  const bool incremental = modal_.distance == Distance::incremental;
  if (incremental && x == 0 && y == 0) {
    error("bad-polar", column_of(block), "an increment of polar words begins at the origin, which has no angle",
          "give G90, or move away from the origin before");
    return;
  }
  if (x == 0 && y == 0 && !(block.words & angle_bit)) {
    error("bad-polar", column_of(block), "@ stands alone at the origin, which has no angle", "give ^ as well");
    return;
  }
  double distance = numeric::hypot(x, y);
  double angle = numeric::atan2(y, x) * radians_to_degrees;
  if (block.words & distance_bit) distance = block.value[polar_distance] + (incremental ? distance : 0);
  if (block.words & angle_bit) angle = block.value[polar_angle] + (incremental ? angle : 0);
  block.value['X' - 'A'] = distance * cosine_of_degrees(angle) - (incremental ? x : 0);
  block.value['Y' - 'A'] = distance * sine_of_degrees(angle) - (incremental ? y : 0);
}

}  // namespace leadscrew::gcode
