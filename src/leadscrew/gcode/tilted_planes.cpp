#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/offsets.hpp>
#include <leadscrew/gcode/tilted_planes.hpp>
#include <leadscrew/kinematics/solutions.hpp>

namespace leadscrew::gcode {

namespace {

constexpr int by_euler = 0, by_roll_pitch_yaw = 1, by_points = 2, by_vectors = 3, by_projections = 4;  // P of G68.2
constexpr std::uint32_t letters_of_xyz = letter_bit('X') | letter_bit('Y') | letter_bit('Z');
constexpr std::uint32_t letters_of_abc = letter_bit('A') | letter_bit('B') | letter_bit('C');

// Words that are missing are 0.
TiltedPlane::Vector words_of(const Block& block, const char* letters, double unit) {
  TiltedPlane::Vector result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = block.value_or(letters[i], 0) * unit;
  return result;
}

// An angle that is one of nine decimals but for rounding is that.
double without_rounding(double degrees) {
  constexpr double decimals = 1e9, rounding = 1e-12;
  const double rounded = std::round(degrees * decimals) / decimals;
  return std::fabs(rounded - degrees) < rounding ? rounded : degrees;
}

bool defines_plane(const Block& block) {
  return block.is(Code::G68_2) || block.is(Code::G68_4) || block.is(Code::G268);
}

}  // namespace

bool TiltedPlanes::problem(std::uint32_t column, std::string message, std::string hint) {
  is_refused_ = true;
  draft_ = {};
  return error("bad-tilted-plane", column, std::move(message), std::move(hint));
}

void TiltedPlanes::set(const Block& block) {
  constexpr std::uint32_t number = letter_bit('N');
  if (draft_.is_open && !defines_plane(block) && (block.groups || (block.words & ~number))) {
    problem(block.first_column,
            "the blocks of " + name(draft_.code) + " P" + std::to_string(draft_.kind) + " end before the plane is told",
            draft_.kind == by_points ? "Q1, Q2 and Q3, the three points" : "Q1, the origin and X, and Q2, the normal");
  }
  if (block.is(Code::G69) || block.is(Code::G269)) {
    is_refused_ = false;
    if (frame_.is_tilted()) frame_.end_tilted_plane();
  }
  if (defines_plane(block) && can_begin(block)) begin(block);
}

bool TiltedPlanes::can_begin(const Block& block) {
  const std::uint32_t column = block.column_of(Group::rotation);
  const std::string code = name(block.code(Group::rotation));
  if (!machine_.rotary_chain) {
    return problem(column, code + " on a machine whose rotary axes have no kinematics",
                   "kinematics = \"table-table-ac\" in the machine file, or another of its names");
  }
  const bool adds = block.is(Code::G68_4);
  if (adds && !frame_.is_tilted())
    return problem(column, "G68.4 without a tilted plane", "G68.2 before it, or in its place");
  if (frame_.is_tilted() && !adds)
    return problem(column, code + " while a plane is tilted",
                   "G69 before it, or G68.4, which tells a plane in that one");
  const ProgramTransform& q = frame_.transform();
  const bool transforms =
      q.angle != 0 || q.scale != ProgramTransform{}.scale || q.mirrored != ProgramTransform{}.mirrored;
  if (!transforms) return true;
  return problem(column, code + " while coordinates are mirrored, scaled or turned", "G50.1, G50 and G69 before it");
}

void TiltedPlanes::begin(const Block& block) {
  const std::optional<int> kind = block.is(Code::G268) ? by_roll_pitch_yaw : as_integer(block.value_or('P', by_euler));
  const std::string code = name(block.code(Group::rotation));
  if (kind == by_projections) {
    problem(block.column_of('P'), code + " P4, which tells angles of projection, is known and not done",
            "P1 with turns about X, Y and Z, or P2 with three points of the plane");
    return;
  }
  if (!kind || *kind < by_euler || *kind > by_vectors) {
    problem(block.column_of('P'), code + " has P" + text(block['P']),
            "0 Euler angles, 1 angles about X, Y and Z, 2 three points, 3 two vectors");
    return;
  }
  if (draft_.is_open && (draft_.kind != *kind || !block.is(draft_.code))) {
    problem(block.column_of(Group::rotation),
            code + " P" + std::to_string(*kind) + " in the midst of " + name(draft_.code) + " P" +
                std::to_string(draft_.kind),
            "all blocks of one plane have the same code and P");
    return;
  }
  if (*kind == by_euler || *kind == by_roll_pitch_yaw) return begin_by_angles(block, *kind);
  add(block, *kind);
}

// Of P1: Q names the axes in the order of their turns. By default X, Y, Z.
std::optional<std::array<int, 3>> TiltedPlanes::order_of(const Block& block) {
  const std::optional<int> word = as_integer(block.value_or('Q', 123));
  const int digits = word.value_or(0);
  const std::array<int, 3> order = {digits / 100, digits / 10 % 10, digits % 10};
  std::array<int, 3> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  if (sorted == std::array<int, 3>{1, 2, 3}) return order;
  problem(block.column_of('Q'), "the order of turns is Q" + text(block['Q']), "123, 132, 213, 231, 312 or 321");
  return std::nullopt;
}

void TiltedPlanes::begin_by_angles(const Block& block, int kind) {
  TiltedPlane plane;
  plane.origin = words_of(block, "XYZ", frame_.length_unit);
  const TiltedPlane::Vector degrees = words_of(block, "IJK", 1);
  if (kind == by_euler) {
    if (block.has('Q')) {
      problem(block.column_of('Q'), "Q beside Euler angles", "G68.2 P1 takes an order of turns");
      return;
    }
    plane.turn = TiltedPlane::by_euler(degrees);
  } else {
    const auto order = order_of(block);
    if (!order) return;
    plane.turn = TiltedPlane::by_fixed_axes(*order, degrees);
  }
  put(block, plane);
}

void TiltedPlanes::put(const Block& block, const TiltedPlane& plane) {
  frame_.begin_tilted_plane(block.is(Code::G68_4) ? plane.in(frame_.tilted_plane()->plane) : plane, machine_);
}

// One block of P2 or P3. The last makes the plane: its origin is the first point.
void TiltedPlanes::add(const Block& block, int kind) {
  const int count = kind == by_points ? 3 : 2;
  const std::optional<int> which = as_integer(block.value_or('Q', 0));
  const std::uint32_t column = block.has('Q') ? block.column_of('Q') : block.column_of(Group::rotation);
  if (!which || *which < 1 || *which > count) {
    problem(column,
            name(block.code(Group::rotation)) + " P" + std::to_string(kind) + " has Q" + text(block.value_or('Q', 0)),
            kind == by_points ? "Q1, Q2 and Q3, the three points" : "Q1, the origin and X, and Q2, the normal");
    return;
  }
  const auto i = static_cast<std::size_t>(*which - 1);
  if (draft_.points[i] || draft_.vectors[i]) {
    problem(column, "Q" + std::to_string(*which) + " of this plane has been given already", "each once");
    return;
  }
  draft_.is_open = true;
  draft_.kind = kind;
  draft_.code = block.code(Group::rotation);
  draft_.points[i] = words_of(block, "XYZ", frame_.length_unit);
  draft_.vectors[i] = words_of(block, "IJK", 1);
  modal_.is_plain = false;  // the next block is looked at
  for (int k = 0; k < count; ++k) {
    if (!draft_.points[static_cast<std::size_t>(k)]) return;
  }
  const auto turn = kind == by_points ? TiltedPlane::by_points(*draft_.points[0], *draft_.points[1], *draft_.points[2])
                                      : TiltedPlane::by_vectors(*draft_.vectors[0], *draft_.vectors[1]);
  if (!turn) {
    problem(block.column_of(Group::rotation),
            kind == by_points ? "the three points lie on one line" : "the two vectors are not square to one another",
            kind == by_points ? "three corners of a triangle"
                              : "X and the normal, within 5 degrees of square, none of them 0");
    return;
  }
  const TiltedPlane plane{*draft_.points[0], *turn};
  draft_ = {};
  put(block, plane);
}

// Where whole turns take an angle that is inside travel, and nearest to where the axis is.
std::optional<double> TiltedPlanes::inside(std::size_t turn, double degrees) const {
  const std::size_t axis = base::index(frame_.tilted_plane()->chain.turns()[turn].axis);
  const double least = std::ceil((travel_.low()[axis] - degrees) / 360);
  const double most = std::floor((travel_.high()[axis] - degrees) / 360);
  if (!(least <= most)) return std::nullopt;
  return degrees + 360 * std::clamp(std::floor((frame_.position[axis] - degrees) / 360 + 0.5), least, most);
}

// Of all angles that hold the tool along the normal those that are reached soonest. `side`: P, 1 for the greater tilt, 2
// for the lesser.
std::optional<kinematics::Angles<double>> TiltedPlanes::nearest(const Block& block, std::size_t side) {
  const kinematics::Chain& chain = frame_.tilted_plane()->chain;
  const auto before = kinematics::angles_of(chain, frame_.position);
  const auto found = kinematics::solutions(chain, frame_.plane_normal());
  const std::uint32_t column = block.column_of(Group::nonmodal);
  if (found.count == 0) {
    error("pose-out-of-reach", column, "no angles of the rotary axes hold the tool along the plane's normal",
          "it is " + text(found.miss) + " degrees beyond what they reach");
    return std::nullopt;
  }
  std::optional<kinematics::Angles<double>> best;
  double least = 0;
  for (std::size_t k = 0; k < found.count; ++k) {
    kinematics::Angles<double> angles = found.angles[k];
    if (found.is_pole) angles[0] = before[0];
    for (double& each : angles) each = without_rounding(each);
    const double other = found.angles[found.count - 1 - k][1];
    if ((side == 1 && angles[1] < other) || (side == 2 && angles[1] > other)) continue;
    double cost = 0;
    bool fits = true;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto placed = inside(i, angles[i]);
      fits = fits && placed;
      angles[i] = placed.value_or(0);
      cost += std::pow((angles[i] - before[i]) / machine_.limits(chain.turns()[i].axis).velocity, 2);
    }
    // Of two that are as near the one whose tilt is above 0.
    constexpr double rounding = 1e-9;
    const bool is_as_near = best && std::fabs(cost - least) <= rounding * least;
    if (!fits || (best && (is_as_near ? angles[1] < (*best)[1] : least < cost))) continue;
    best = angles;
    least = cost;
  }
  if (!best) {
    error("rotary-travel", column, "no angles that hold the tool along the plane's normal are inside travel",
          side == 0 ? "clamp the part otherwise" : "the other side, or P0");
  }
  return best;
}

void TiltedPlanes::orient(const Block& block) {
  const std::uint32_t column = block.column_of(Group::nonmodal);
  const std::string code = name(block.code(Group::nonmodal));
  if (!frame_.is_tilted()) {
    if (!is_refused_) problem(column, code + " without a tilted plane", "G68.2 before it");
    reporter_.fail();
    return;
  }
  if (frame_.tip_control()) {
    error("tip-control", column, code + " while tool centre point control is on", "G49 before it");
    return;
  }
  if (fails_beside_contour(column, code)) return;
  const std::optional<int> side = as_integer(block.value_or('P', 0));
  if (!side || *side < 0 || *side > 2) {
    error("bad-value", block.column_of('P'), code + " has P" + text(block['P']),
          "0 for the nearest angles, 1 or 2 for the greater or the lesser tilt");
    return;
  }
  const auto angles = nearest(block, static_cast<std::size_t>(*side));
  if (!angles) return;
  base::AxisVector target = frame_.position;
  for (std::size_t i = 0; i < 2; ++i) target[base::index(frame_.tilted_plane()->chain.turns()[i].axis)] = (*angles)[i];
  if (!travel_.inside_travel(block, target) || target == frame_.position) return;
  // Nothing is rounded into it: what comes behind is told in other coordinates of the axes.
  Move& line = outbox_.emit(Move::Kind::line);
  line.path_mode = PathMode::exact_stop;
  line.tolerance = line.naive_cam_tolerance = 0;
  line.end = target;
  frame_.position = target;
  frame_.follow_rotary_axes();
}

// Whether the coordinate system that the block asks for is that in force.
bool TiltedPlanes::is_in_force(const Block& block) const {
  const Code code = block.code(Group::system);
  const bool is_numbered = Code::G54 <= code && code <= Code::G59_3;
  const double number = is_numbered ? static_cast<double>(index(code) - index(Code::G54)) + 1
                                    : Parameters::numbered_systems + block.value_or('P', 0);
  return number == modal_.system;
}

void TiltedPlanes::check(const Block& block) {
  const auto refuse = [&](std::uint32_t column, const std::string& what, const char* hint) {
    error("tilted-plane", column, what + " while a plane is tilted", hint);
  };
  const Code code = block.code(Group::nonmodal);
  const std::uint32_t column = block.has(Group::nonmodal) ? block.column_of(Group::nonmodal) : block.first_column;
  const double level = block.value_or('L', 0);
  const bool calls_position =
      code == Code::G92 || code == Code::G92_1 || code == Code::G92_2 || code == Code::G92_3 || code == Code::G52;
  const bool sets_g52 =
      code == Code::G10 && options_.dialect == Dialect::haas && sets_shift_of_all(block, options_.dialect);
  if (calls_position || sets_g52 || (code == Code::G10 && (level == 20 || level == 10 || level == 11)))
    refuse(column, name(code), "before G68.2, or behind G69");
  if (block.has(Group::system) && !is_in_force(block))
    refuse(block.column_of(Group::system), name(block.code(Group::system)), "G69 before it");
  if (code == Code::G53_1 || code == Code::G253) {
    if (modal_.to_do != Code::none) refuse(column, name(code) + " beside a motion", "in a block of its own");
    return;
  }
  const bool moves = modal_.to_do != Code::none || code == Code::G28 || code == Code::G30 || code == Code::G31;
  if (!moves || code == Code::G53 || frame_.tip_control() || !(block.words & letters_of_abc)) return;
  const bool is_line = modal_.to_do == Code::G0 || modal_.to_do == Code::G1 || modal_.to_do == Code::none;
  if (is_line && code != Code::G31 && !(block.words & letters_of_xyz)) return;
  refuse(motion_column(block), "rotary axes beside X, Y or Z",
         "turn them in a block of their own, or under tool centre point control");
}

}  // namespace leadscrew::gcode
