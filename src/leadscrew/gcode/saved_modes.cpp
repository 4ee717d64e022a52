#include <algorithm>
#include <leadscrew/gcode/saved_modes.hpp>

namespace leadscrew::gcode {

bool SavedModes::execute(const Block& block) {
  const Code code = block.code(Group::modes);
  if (code == Code::M70 || code == Code::M73) {
    keep(code == Code::M73);
    return false;
  }
  const bool has_any = !kept_.empty() && kept_.back().calls == modal_.calls;
  if (code == Code::M71) {
    if (has_any) kept_.pop_back();
    return false;
  }
  if (!has_any) return error("missing-modes", block.column_of(Group::modes), "no modes are kept", "give M70 before");
  return bring_back(kept_.back(), block.column_of(Group::modes));
}

bool SavedModes::ends_compensation(const Block& block) const {
  return block.is(Code::M72) && !kept_.empty() && kept_.back().modal.cutter_side == Code::G40;
}

bool SavedModes::leaving_brings_back() const {
  return std::any_of(kept_.begin(), kept_.end(),
                     [&](const Kept& kept) { return kept.calls > modal_.fewest_calls && kept.comes_back; });
}

bool SavedModes::leaving_ends_compensation() const {
  return std::any_of(kept_.begin(), kept_.end(), [&](const Kept& kept) {
    return kept.calls > modal_.fewest_calls && kept.comes_back && kept.modal.cutter_side == Code::G40;
  });
}

void SavedModes::keep(bool comes_back) {
  if (kept_.empty() || kept_.back().calls < modal_.calls) kept_.emplace_back();
  comes_back |= kept_.back().comes_back;  // M70 behind M73 keeps others, and they come back by themselves
  const bool has_tip_control = frame_.tip_control() && !modal_.tip_by_m;
  kept_.back() = {modal_.calls,
                  comes_back,
                  modal_,
                  frame_.length_unit,
                  frame_.tool(),
                  has_tip_control,
                  frame_.takes_vectors(),
                  offsets_.are_shifted()};
  modal_.fewest_calls = modal_.calls;
  modal_.is_plain = false;
}

bool SavedModes::leave_calls() {
  bool any = false;
  for (; !kept_.empty() && kept_.back().calls > modal_.fewest_calls; kept_.pop_back()) {
    if (kept_.back().comes_back && bring_back(kept_.back(), 1)) any = true;
  }
  modal_.fewest_calls = modal_.calls;
  return any;
}

bool SavedModes::bring_back(const Kept& kept, std::uint32_t column) {
  const ModalState& before = kept.modal;
  if (frame_.is_tilted() && before.system != modal_.system) {
    return error("tilted-plane", column, "another coordinate system comes back while a plane is tilted",
                 "G69 before it");
  }
  const bool shifts_alike = kept.is_shifted == offsets_.are_shifted();
  if (!compensation_.bring_back(before, kept.tool_length, shifts_alike, column)) return false;
  if (kept.has_tip_control && fails_beside_contour(column, "tool centre point control that comes back")) return false;
  frame_.length_unit = kept.length_unit;
  modal_.plane = before.plane;
  modal_.distance = before.distance;
  modal_.arc_distance = before.arc_distance;
  modal_.retract = before.retract;
  modal_.diameters = before.diameters;
  modal_.path_mode = before.path_mode;
  modal_.tolerance = before.tolerance;
  modal_.naive_cam_tolerance = before.naive_cam_tolerance;
  modal_.orientation_tolerance = before.orientation_tolerance;
  modal_.feed_mode = before.feed_mode;
  modal_.feed_known = before.feed_known;
  modal_.feed_word = before.feed_word;
  modal_.linear_feed = before.linear_feed;
  modal_.angular_feed = before.angular_feed;
  if (modal_.system != before.system) offsets_.select_system(before.system);
  if (!shifts_alike) offsets_.put_shift_in_force(kept.is_shifted);
  bring_back_tool(kept);
  bring_back_machine(before);
  return true;
}

// M428 and M429 are none of the modes that are kept.
void SavedModes::bring_back_tool(const Kept& kept) {
  if (frame_.tip_control()) frame_.end_tip_control();
  frame_.set_tool(kept.tool_length);
  if (kept.takes_vectors) frame_.take_vectors();
  if (kept.has_tip_control) modal_.tip_by_m = false;
  if (kept.has_tip_control || modal_.tip_by_m) frame_.begin_tip_control(machine_);
}

void SavedModes::bring_back_machine(const ModalState& before) {
  using Kind = base::Event::Kind;
  modal_.constant_surface_speed = before.constant_surface_speed;
  modal_.surface_speed = before.surface_speed;
  modal_.surface_speed_word = before.surface_speed_word;
  modal_.surface_speed_line = before.surface_speed_line;
  modal_.most_spindle_speed = before.most_spindle_speed;
  if (modal_.spindle_speed != before.spindle_speed) outbox_.emit_event(Kind::spindle_speed, before.spindle_speed);
  modal_.spindle_speed = before.spindle_speed;
  if (modal_.spindle != before.spindle) {
    modal_.spindle = before.spindle;
    outbox_.emit_event(before.spindle == Code::M3   ? Kind::spindle_clockwise
                       : before.spindle == Code::M4 ? Kind::spindle_counterclockwise
                                                    : Kind::spindle_stop,
                       before.spindle == Code::M5 ? 0 : before.spindle_speed);
  }
  const bool off = (modal_.mist && !before.mist) || (modal_.flood && !before.flood);
  if (off) outbox_.emit_event(Kind::coolant_off);
  if (before.mist && (off || !modal_.mist)) outbox_.emit_event(Kind::coolant_mist);
  if (before.flood && (off || !modal_.flood)) outbox_.emit_event(Kind::coolant_flood);
  modal_.mist = before.mist;
  modal_.flood = before.flood;
  bring_back_overrides(before);
}

void SavedModes::bring_back_overrides(const ModalState& before) {
  using Kind = base::Event::Kind;
  const auto bring_back = [&](bool ModalState::* mode, Kind kind) {
    if (modal_.*mode != before.*mode) outbox_.emit_event(kind, before.*mode);
    modal_.*mode = before.*mode;
  };
  bring_back(&ModalState::feed_override, Kind::feed_override);
  bring_back(&ModalState::speed_override, Kind::spindle_override);
  bring_back(&ModalState::adaptive_feed, Kind::adaptive_feed);
  bring_back(&ModalState::feed_hold, Kind::feed_hold);
}

}  // namespace leadscrew::gcode
