#include <cmath>
#include <leadscrew/gcode/surface_words.hpp>
#include <leadscrew/kinematics/pose.hpp>
#include <leadscrew/kinematics/transformation.hpp>
#include <numbers>

namespace leadscrew::gcode {

namespace {

constexpr double least_curve_tolerance = 1e-10, greatest_curve_tolerance = 0.1;  // mm
constexpr double range_rounding = 1e-9;  // of the whole range, by which a word may be beyond its end

}  // namespace

int SurfaceWords::choice_of(const Block& block, char letter, int otherwise, int most) {
  const std::optional<int> choice = as_integer(block.value_or(letter, otherwise));
  if (choice && 1 <= *choice && *choice <= most) return *choice;
  error("bad-value", block.column_of(letter), std::string(1, letter) + " is " + text(block[letter]),
        "an integer from 1 to " + std::to_string(most));
  return otherwise;
}

bool SurfaceWords::read_surface(const Block& block, Machined& machined) {
  if (!block.has('D')) return reporter_.fail();
  const std::optional<int> number = as_integer(block['D']);
  if (number && surfaces_.is_spoiled(*number)) return reporter_.fail();
  const auto form = number ? surfaces_.find(*number) : nullptr;
  if (!form) {
    return error("surface-unknown", block.column_of('D'), "there is no surface " + text(block['D']),
                 "G6.4 D" + text(block['D']) + " before it, and its points");
  }
  machined.number = *number;
  return place(*form, machined.machining);
}

/// Points to where the frame has them, which takes planes to planes: a B-spline stays what it is. A mirrored one has its other side
/// where Su × Sv points.
bool SurfaceWords::place(const surfaces::SurfaceForm& form, surfaces::Machining& machining) {
  surfaces::SurfaceForm placed = form;
  for (surfaces::NetPoint& point : placed.net) {
    base::AxisVector place{};
    for (std::size_t i = 0; i < 3; ++i) place[i] = point.position[i];
    place = frame_.to_machine(place);
    for (std::size_t i = 0; i < 3; ++i) point.position[i] = place[i];
  }
  std::array<base::AxisVector, 3> units{};
  for (std::size_t i = 0; i < 3; ++i) {
    units[i][i] = 1;
    units[i] = frame_.direction_to_machine(units[i]);
  }
  const auto& [x, y, z] = units;
  const double turned =
      x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) + x[2] * (y[0] * z[1] - y[1] * z[0]);
  if (turned < 0) machining.side = -machining.side;
  machining.surface = std::make_shared<const surfaces::Surface>(std::move(placed));
  return true;
}

bool SurfaceWords::read_tool(const Block& block, Machined& machined) {
  const std::uint32_t column = block.has('T') ? block.column_of('T') : block.column_of(Group::nonmodal);
  const std::optional<int> number = block.has('T') ? as_integer(block['T']) : modal_.loaded_tool;
  if (!number || *number < 1) {
    return error(block.has('T') ? "bad-value" : "missing-word", column,
                 block.has('T') ? "the tool number is " + text(block['T']) : "no tool is in the spindle, nor said by T",
                 "T3: the tool whose shape it is, an integer above 0");
  }
  const std::string tool = "tool " + std::to_string(*number);
  if (modal_.loaded_tool != 0 && modal_.loaded_tool != *number) {
    return error("surface-tool", column,
                 tool + " is to machine, and in the spindle is " + std::to_string(modal_.loaded_tool),
                 "change it before: T" + std::to_string(*number) + " M6");
  }
  const machine::Tool* const found = tools_.find(*number);
  if (!found)
    return error("unknown-tool", column, tool + " is not in the tool table", "give a tool table that holds it");
  const double radius = found->diameter / 2;
  if (!found->corner_radius || !(radius > 0) || *found->corner_radius > radius) {
    return error("surface-tool", column, tool + " has no shape in the tool table",
                 "its diameter D and the radius R of its edge: D10 R5 is a ball, D10 R1 a bull nose, D10 R0 flat");
  }
  machined.tool = *found;
  machined.machining.cutter = {radius, *found->corner_radius};
  return true;
}

bool SurfaceWords::read_steps(const Block& block, surfaces::Machining& machining) {
  if (block.has('H') == block.has('Q')) {
    return error(block.has('H') ? "ambiguous-word" : "missing-word", block.column_of(Group::nonmodal),
                 block.has('H') ? "G6.5 has a height of ridges and a step" : "G6.5 has neither H nor Q",
                 "H0.01: the height of ridges between passes, or Q0.5: the distance between passes");
  }
  const char letter = block.has('H') ? 'H' : 'Q';
  const double value = block[letter] * frame_.length_unit;
  if (!(value > 0)) {
    return error("bad-value", block.column_of(letter), std::string(1, letter) + " is " + text(block[letter]),
                 std::string(1, letter) + " must be above 0");
  }
  (letter == 'H' ? machining.scallop : machining.step) = value;
  return true;
}

bool SurfaceWords::read_pattern(const Block& block, surfaces::Machining& machining) {
  machining.along = static_cast<surfaces::Direction>(choice_of(block, 'L', 1, 2) - 1);
  machining.pattern = static_cast<surfaces::Pattern>(choice_of(block, 'S', 2, 5) - 1);
  machining.start_corner = choice_of(block, 'P', 1, 4);
  const double side = block.value_or('R', 1);
  if (side != 1 && side != -1)
    error("bad-value", block.column_of('R'), "R is " + text(side), "1 or -1: the side that the tool is on");
  machining.side = side < 0 ? -1 : 1;
  const double tolerance = block.value_or('C', 0) * frame_.length_unit;
  if (!block.has('C')) return true;
  machining.tolerance = tolerance;
  if (least_curve_tolerance <= tolerance && tolerance <= greatest_curve_tolerance) return true;
  return error("bad-value", block.column_of('C'), "C is " + text(block['C']), "from 0.0000000001 to 0.1 mm");
}

bool SurfaceWords::read_range(const Block& block, surfaces::Machining& machining) {
  constexpr char letters[2][2] = {{'U', 'V'}, {'I', 'J'}};
  for (std::size_t d = 0; d < 2; ++d) {
    const surfaces::Range whole = machining.surface->range(static_cast<surfaces::Direction>(d));
    const double rounding = range_rounding * (whole.to - whole.from);
    surfaces::Range range{block.value_or(letters[d][0], whole.from), block.value_or(letters[d][1], whole.to)};
    const auto column = [&](std::size_t k) {
      return block.has(letters[d][k]) ? block.column_of(letters[d][k]) : block.column_of(Group::nonmodal);
    };
    const char* const name = d == 0 ? "u" : "v";
    const std::string hint =
        std::string(name) + " of the surface goes from " + text(whole.from) + " to " + text(whole.to);
    if (range.from < whole.from - rounding || range.to > whole.to + rounding) {
      const bool is_first = range.from < whole.from - rounding;
      return error("surface-range", column(is_first ? 0 : 1),
                   std::string(name) + " " + text(is_first ? range.from : range.to) + " is not of the surface", hint);
    }
    range = {std::max(range.from, whole.from), std::min(range.to, whole.to)};
    if (!(range.to - range.from > rounding)) {
      return error("surface-range", column(block.has(letters[d][1]) ? 1 : 0),
                   std::string("there is nothing between ") + name + " " + text(range.from) + " and " + text(range.to),
                   hint);
    }
    (d == 0 ? machining.u : machining.v) = range;
  }
  return true;
}

bool SurfaceWords::read_orientation(const Block& block, surfaces::Machining& machining) {
  surfaces::Orientation& orientation = machining.orientation;
  const kinematics::Transformation* const control = frame_.tip_control();
  if (!block.has('A') && !block.has('B')) {
    if (!machine_.rotary_chain) return true;
    const kinematics::Chain chain = kinematics::chain_of(machine_);
    const auto angles = kinematics::angles_of(chain, kinematics::Coordinates<double>(frame_.position));
    const auto direction = kinematics::direction_of(chain, angles);
    orientation.axis = control ? direction : kinematics::in_machine(chain, angles, direction);
    return true;
  }
  for (const char letter : {'A', 'B'}) {
    if (std::fabs(block.value_or(letter, 0)) < 90) continue;
    return error("bad-value", block.column_of(letter), std::string(1, letter) + " is " + text(block[letter]),
                 "the tool leans by less than 90 degrees");
  }
  if (!control) {
    return error("surface-needs-tip-control", block.column_of(block.has('A') ? 'A' : 'B'),
                 "the tool's direction is to follow the surface while tool centre point control is off",
                 "G43.4 before it, on a machine with two rotary axes; without A and B the tool keeps its direction");
  }
  constexpr double radians = std::numbers::pi / 180;
  const double lead = block.value_or('A', 0) * radians, tilt = block.value_or('B', 0) * radians;
  if (lead != 0 || tilt != 0) {
    orientation = surfaces::Orientation::leaning(lead, tilt);
  } else {
    orientation.rule = surfaces::Orientation::Rule::normal;
  }
  return true;
}

std::shared_ptr<const Machined> SurfaceWords::read(const Block& block) {
  auto machined = std::make_shared<Machined>();
  surfaces::Machining& machining = machined->machining;
  machined->line = modal_.line;
  machined->is_of_tip = frame_.tip_control() != nullptr;
  machining.allows_gouging = options_.allows_gouging;
  read_pattern(block, machining);
  read_steps(block, machining);
  read_tool(block, *machined);
  if (read_surface(block, *machined)) read_range(block, machining);
  read_orientation(block, machining);
  if (reporter_.failed()) return nullptr;
  return machined;
}

}  // namespace leadscrew::gcode
