// The modes of a block, and those that come back.

#include <leadscrew/gcode/interpreter.hpp>

namespace leadscrew::gcode {

void Interpreter::set_modes(const Block& block) {
  const bool had_tip_control = frame_.tip_control() != nullptr;
  if (block.is(Code::G40)) compensation_.end();
  modal_.plane = plane_after(block, modal_);
  if (block.has(Group::units)) frame_.length_unit = block.is(Code::G20) ? 25.4 : 1;
  if (block.has(Group::user)) offsets_.switch_tip_control(block);
  offsets_.set_tool_length(block);
  if (block.is(Code::G43_5)) vectors_.begin(block);
  if (had_tip_control != (frame_.tip_control() != nullptr))
    cycles_.end_series();  // its level is of the axes, or of the tip
  if (block.has(Group::system)) {
    offsets_.select_system(block);
  }
  if (block.has(Group::rotation) || tilted_planes_.is_unfinished()) {
    const bool was_tilted = frame_.is_tilted();
    tilted_planes_.set(block);
    if (was_tilted || frame_.is_tilted()) cycles_.end_series();  // its level is of the plane
  }
  transforms_.set(block);
  if (block.has(Group::path)) set_path_control(block);
  if (block.is(Code::G187)) set_smoothness(block);
  if (block.is(Code::G9)) modal_.effective_mode = PathMode::exact_stop;
  if (block.has(Group::cutter_radius) && !block.is(Code::G40)) compensation_.set(block);
  modal_.distance = distance_after(block, modal_);
  if (block.has(Group::arc_distance)) {
    modal_.arc_distance = block.is(Code::G90_1) ? Distance::absolute : Distance::incremental;
  }
  if (block.has(Group::retract)) {
    modal_.retract = block.is(Code::G98) ? Retract::initial_level : Retract::r_level;
  }
}

void Interpreter::set_path_control(const Block& block) {
  switch (block.code(Group::path)) {
    case Code::G61:
      // LinuxCNC stops nowhere for it, Fanuc's and Haas' controllers do.
      modal_.path_mode = is_of_fanuc_family(options_.dialect) ? PathMode::exact_stop : PathMode::exact_path;
      break;
    case Code::G62:
    case Code::G63:
      modal_.path_mode = PathMode::blend;
      break;
    case Code::G61_1:
      modal_.path_mode = PathMode::exact_stop;
      break;
    case Code::G64:
      modal_.path_mode = PathMode::blend;
      for (const char letter : {'P', 'Q', 'E'}) {
        if (block.value_or(letter, 0) < 0) {
          error("bad-value", block.column_of(letter), "the tolerance is " + text(block[letter]),
                std::string(1, letter) + " must be 0 or more");
          return;
        }
      }
      modal_.tolerance = block.has('P') ? block['P'] * frame_.length_unit : machine_.tolerance;
      modal_.orientation_tolerance = machine_.rotary_chain ? machine_.rotary_chain->orientation_tolerance : 0;
      if (block.has('E') && !block.is(Code::M67) && !block.is(Code::M68)) modal_.orientation_tolerance = block['E'];
      modal_.naive_cam_tolerance.reset();
      if (block.has('Q')) modal_.naive_cam_tolerance = block['Q'] * frame_.length_unit;
      break;
    default:
      break;
  }
  modal_.effective_mode = options_.path_mode.value_or(modal_.path_mode);
  const bool blends = modal_.effective_mode == PathMode::blend;
  modal_.effective_tolerance = blends ? options_.tolerance.value_or(modal_.tolerance) : 0;
  modal_.effective_naive_cam_tolerance = blends ? modal_.naive_cam_tolerance.value_or(modal_.effective_tolerance) : 0;
}

/// Haas: E of G187 is how far corners may be rounded; without it they are rounded as the machine does.
void Interpreter::set_smoothness(const Block& block) {
  const double rounding = block.value_or('E', 0) * frame_.length_unit;
  if (rounding < 0) {
    error("bad-value", block.column_of('E'), "corners are to be rounded by " + text(block['E']), "E must be 0 or more");
    return;
  }
  modal_.tolerance = block.has('E') ? rounding : machine_.tolerance;
  modal_.naive_cam_tolerance.reset();
  set_path_control({});
}

// What depends on modes that have come back.
void Interpreter::follow_modes(bool had_tip_control) {
  set_path_control({});
  vectors_.forget_direction();
  if (had_tip_control != (frame_.tip_control() != nullptr)) cycles_.end_series();
}

void Interpreter::leave_calls() {
  if (curves_.open() && saved_modes_.leaving_brings_back()) curves_.refuse_modes();
  const bool had_tip_control = frame_.tip_control() != nullptr;
  if (saved_modes_.leave_calls()) follow_modes(had_tip_control);
  if (reporter_.failed()) abandon();
  modal_.is_plain = is_plain();
}

}  // namespace leadscrew::gcode
