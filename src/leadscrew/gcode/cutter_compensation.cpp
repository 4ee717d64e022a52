// What switches compensation on and off, and what cannot stand between; the moves are in compensated_moves.cpp.

#include <cmath>
#include <leadscrew/gcode/block_check.hpp>
#include <leadscrew/gcode/cutter_compensation.hpp>

namespace leadscrew::gcode {

bool CutterCompensation::refuse(Code code, std::uint32_t column) {
  const bool is_roughing = Code::G71_profile <= code && code <= Code::G73_profile;
  return error("cutter-compensation", column, name(code) + " while cutter compensation is on",
               is_roughing ? "G40 in a block before it; G42 in the first block of the contour holds for G70"
                           : "G40 in a block before it");
}

// LinuxCNC's list, 2.9; but outside its dialect, what moves carry along is changed at their place.
bool CutterCompensation::allows_groups(const Block& block) {
  if (block.is(Code::G40) && options_.dialect != Dialect::linuxcnc) return true;  // what else it says holds behind that
  const std::uint32_t groups = block.is(Code::G40) ? groups_before_end(block) : groups_within(block);
  for (std::size_t i = 0; i < index(Group::count); ++i) {
    const Group group = static_cast<Group>(i);
    if ((groups & bit(group)) && block.has(group)) return refuse(block.code(group), block.column_of(group));
  }
  return true;
}

// What LinuxCNC does before G40 of the same block.
std::uint32_t CutterCompensation::groups_before_end(const Block& block) const {
  std::uint32_t groups = bit(Group::tool) | bit(Group::overrides) | bit(Group::output);
  if (plane_after(block, modal_) != modal_.plane) groups |= bit(Group::plane);
  return groups;
}

std::uint32_t CutterCompensation::groups_within(const Block& block) const {
  std::uint32_t groups = bit(Group::system) | bit(Group::tool_length) | bit(Group::tool) | bit(Group::scaling) |
                         bit(Group::rotation) | bit(Group::mirror);
  if (options_.dialect == Dialect::linuxcnc)
    groups |= bit(Group::path) | bit(Group::retract) | bit(Group::overrides) | bit(Group::output);
  if (block.is(Code::M66)) groups |= bit(Group::output);
  if (block.is(Code::M428) || block.is(Code::M429)) groups |= bit(Group::user);
  if (plane_after(block, modal_) != modal_.plane) groups |= bit(Group::plane);
  if (!allows_nonmodal(block)) groups |= bit(Group::nonmodal);
  return groups | bit(Group::cutter_radius);
}

bool CutterCompensation::allows_nonmodal(const Block& block) const {
  switch (block.code(Group::nonmodal)) {
    case Code::none:
    case Code::G4:
    case Code::G9:
    case Code::G70_profile:
    case Code::G103:
    case Code::G187:
    case Code::G5_high_speed:
    case Code::G5_1_high_speed:
    case Code::G8_high_speed:
      return true;
    case Code::G10: {
      const double kind = block.value_or('L', 0);
      const double number =
          block.value_or('P', 0) + (is_further_system(kind, options_.dialect) ? Parameters::numbered_systems : 0);
      return (kind != 2 && kind != 20) || (number != 0 && number != modal_.system);
    }
    default:
      return false;
  }
}

void CutterCompensation::check(const Block& block) {
  column_ = motion_column(block);
  if (!is_on()) return;
  if (!allows_groups(block) || block.is(Code::G40)) return;
  if (block.has('T') && options_.dialect == Dialect::fanuc_lathe) {  // another offset
    error("cutter-compensation", block.column_of('T'), "T while cutter compensation is on", "G40 in a block before it");
    return;
  }
  const Code motion = modal_.to_do;
  if (motion != Code::none && !is_line(motion) && !is_arc(motion)) refuse(motion, motion_column(block));
}

void CutterCompensation::set(const Block& block) {
  if (is_on()) return;  // has been refused
  column_ = motion_column(block);
  const std::optional<Cutter> cutter = radius_.of_compensation(block);
  if (!cutter || begin(block, *cutter)) return;
  phase_ = Phase::passing;
}

// Which side is left of a mirrored program is that of the program.
bool CutterCompensation::begin(const Block& block, const Cutter& cutter) {
  const double radius = cutter.radius;
  const std::uint32_t column = block.column_of(Group::cutter_radius);
  if (is_secondary(modal_.plane)) {
    return error("cutter-compensation", column, "cutter compensation in a plane of U, V and W",
                 "give G17, G18 or G19 before");
  }
  const base::Axis first = first_axis(modal_.plane), second = second_axis(modal_.plane);
  const double scale = frame_.circle_scale(first, second);
  if (frame_.is_tilted() || frame_.tip_control() || frame_.takes_vectors() || scale == 0) {
    return error("cutter-compensation", column,
                 "cutter compensation where the program's plane is none of the machine's",
                 "no tilted plane, tool centre point control or scales that differ");
  }
  if (modal_.plane == Plane::YZ && options_.dialect == Dialect::linuxcnc) {
    return error("cutter-compensation", column, "cutter compensation in plane YZ",
                 "LinuxCNC compensates in G17 and G18 alone");
  }
  if (!set_origin(block, cutter)) return false;
  const bool is_left = block.is(Code::G41) || block.is(Code::G41_1);
  aside_ = (is_left == (scale > 0)) ? radius : -radius;
  modal_.cutter_side = is_left == (radius >= 0) ? Code::G41 : Code::G42;
  modal_.is_plain = false;
  plane_ = modal_.plane;
  at_ = in_plane(frame_.position, plane_);
  phase_ = radius != 0 ? Phase::entering : Phase::passing;
  if (radius != 0) travel_.release(first, second);
  return true;
}

// LinuxCNC manual, "Lathe tool orientation": 1 to 4 are the corners, 5 to 8 the sides, 0 and 9 the middle.
bool CutterCompensation::set_origin(const Block& block, const Cutter& cutter) {
  const bool is_given = block.has('L');
  const bool is_in_middle = cutter.orientation == 0 || cutter.orientation == 9;
  origin_ = {};
  if (modal_.plane != Plane::ZX && (is_given || !is_in_middle)) {
    return error("cutter-compensation", is_given ? block.column_of('L') : block.column_of(Group::cutter_radius),
                 "the orientation of a lathe tool outside of plane ZX",
                 is_given ? "G18 before it, or no L" : "G18 before it, or a tool without Q in its table");
  }
  constexpr int along_x[] = {0, -1, -1, 1, 1, 0, -1, 0, 1, 0};
  constexpr int along_z[] = {0, 1, -1, -1, 1, 1, 0, -1, 0, 0};
  const double radius = std::fabs(cutter.radius);
  origin_ = {along_z[cutter.orientation] * radius, along_x[cutter.orientation] * radius};
  return true;
}

void CutterCompensation::end() {
  modal_.cutter_side = Code::G40;
  if (!is_on()) return;
  settle();
  end_search();
  const PlanePoint programmed = in_plane(frame_.position, plane_);
  if (phase_ == Phase::on && (at_.first != programmed.first || at_.second != programmed.second)) {
    tool_ = frame_.position;
    set_in_plane(*tool_, at_);
    is_aside_ = true;
  }
  phase_ = Phase::off;
  modal_.tool_is_aside = is_aside_;
  travel_.restore();
  contour_.reset();
}

// LinuxCNC executes what differs as a block, G40 in it behind the plane, and G41 with the tool's radius.
bool CutterCompensation::bring_back(const ModalState& before, const base::AxisVector& tool_length, bool shifts_alike,
                                    std::uint32_t column) {
  const bool was_on = before.cutter_side != Code::G40, has_plane = before.plane == modal_.plane;
  if (was_on && !is_on()) {
    return error("cutter-compensation", column,
                 "modes that were kept while cutter compensation was on come back without it",
                 "keep them before it, or G40 behind them");
  }
  const bool is_alike = before.cutter_side == modal_.cutter_side && has_plane && before.system == modal_.system &&
                        shifts_alike && tool_length == frame_.tool();
  const bool has_place = has_plane || !is_on() || options_.dialect != Dialect::linuxcnc;
  if (was_on ? !is_alike : !has_place) {
    return error("cutter-compensation", column,
                 "another plane, offset or side comes back while cutter compensation is on", "G40 before it");
  }
  if (!was_on) end();
  return true;
}

void CutterCompensation::forget_tool() {
  tool_.reset();
  is_aside_ = modal_.tool_is_aside = false;
}

// What is kept back goes its way; what follows an error is read for its own errors alone.
void CutterCompensation::abandon() {
  settle();
  search_.forget();
  if (is_on()) phase_ = Phase::passing;
  forget_tool();
}

}  // namespace leadscrew::gcode
