#include <cmath>
#include <leadscrew/gcode/transforms.hpp>

namespace leadscrew::gcode {

namespace {

constexpr base::Axis linear_axes[] = {base::Axis::X, base::Axis::Y, base::Axis::Z};
constexpr double least_scale = 1e-6;
constexpr double greatest_scale = 1e6;

}  // namespace

void Transforms::set(const Block& block) {
  constexpr std::uint32_t groups = bit(Group::mirror) | bit(Group::scaling) | bit(Group::rotation) | bit(Group::polar);
  if (!(block.groups & groups)) return;
  if (block.has(Group::polar)) {
    modal_.polar = block.is(Code::G16);
    modal_.polar_radius = modal_.polar_angle = 0;
  }
  ProgramTransform transform = frame_.transform();
  if (block.has(Group::mirror)) set_mirror(block, transform);
  if (block.is(Code::G50) && !block.has('S')) transform.scale = {1, 1, 1};
  if (block.is(Code::G51) && !set_scale(block, transform)) return;
  if (block.is(Code::G69)) transform.angle = 0;
  if (block.is(Code::G68) && !set_turn(block, transform)) return;
  frame_.set_transform(transform);
}

// Where the axis words say; where they do not, where the tool stands, in coordinates that are scaled and turned.
std::array<double, 3> Transforms::center_of(const Block& block) const {
  const base::AxisVector stands = frame_.transformed(frame_.to_program(frame_.position));
  std::array<double, 3> center{};
  for (const base::Axis axis : linear_axes) {
    const std::size_t i = base::index(axis);
    const char letter = base::letter(axis);
    center[i] = block.has(letter) ? block[letter] * frame_.length_unit : stands[i];
  }
  return center;
}

void Transforms::set_mirror(const Block& block, ProgramTransform& transform) const {
  const bool all = !(block.words & axis_letter_bits);
  for (const base::Axis axis : linear_axes) {
    const std::size_t i = base::index(axis);
    const char letter = base::letter(axis);
    if ((block.is(Code::G50_1) || block.is(Code::G100)) && (all || block.has(letter))) transform.mirrored[i] = false;
    if ((block.is(Code::G51_1) || block.is(Code::G101)) && block.has(letter)) {
      transform.mirrored[i] = true;
      transform.mirror_at[i] = block.is(Code::G101) ? 0 : block[letter] * frame_.length_unit;
    }
  }
}

// P scales all, I, J and K scale X, Y and Z; Mach3's axis words are the scales themselves.
bool Transforms::set_scale(const Block& block, ProgramTransform& transform) {
  const bool by_axes = options_.dialect == Dialect::mach3;
  transform.scale_about = by_axes ? std::array<double, 3>{} : center_of(block);
  bool any = false;
  for (const base::Axis axis : linear_axes) {
    const std::size_t i = base::index(axis);
    const char letter = by_axes ? base::letter(axis) : static_cast<char>('I' + i);
    const char used = block.has(letter) ? letter : 'P';
    any |= block.has(used);
    transform.scale[i] = block.value_or(used, 1);
    const double size = std::fabs(transform.scale[i]);
    if (least_scale <= size && size <= greatest_scale) continue;
    return error("bad-value", block.column_of(used), "the scale is " + text(transform.scale[i]),
                 "from 1e-6 to 1e6 in magnitude");
  }
  if (any) return true;
  return error("missing-word", block.column_of(Group::scaling), "G51 does not say how much",
               by_axes ? "G51 X2 Y2" : "G51 X0 Y0 P2.");
}

bool Transforms::set_turn(const Block& block, ProgramTransform& transform) {
  if (!block.has('R')) return false;
  transform.angle = block['R'];
  transform.first = base::index(first_axis(modal_.plane));
  transform.second = base::index(second_axis(modal_.plane));
  // Words are coordinates of the program, which are scaled; without one the tool's place is the centre, as it is.
  transform.turn_about = center_of(block);
  const base::AxisVector stands = frame_.to_program(frame_.position);
  for (const base::Axis axis : linear_axes) {
    if (!block.has(base::letter(axis))) transform.turn_about[base::index(axis)] = stands[base::index(axis)];
  }
  return true;
}

}  // namespace leadscrew::gcode
