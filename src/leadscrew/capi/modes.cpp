// The call of leadscrew.h for the modes that a program has in force: the reader's, block by block.

#include <array>
#include <cstddef>
#include <cstring>
#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/modal_state.hpp>
#include <leadscrew/pipeline/lost_time.hpp>
#include <string>

#include "program_readings.hpp"

using namespace leadscrew;
using namespace leadscrew::capi;
using gcode::Code;

namespace {

constexpr std::int64_t blocks_between_questions = 4096;

Code code_of(gcode::FeedMode mode) {
  switch (mode) {
    case gcode::FeedMode::inverse_time:
      return Code::G93;
    case gcode::FeedMode::per_revolution:
      return Code::G95;
    case gcode::FeedMode::per_minute:
      break;
  }
  return Code::G94;
}

Code code_of(gcode::PathMode mode) {
  switch (mode) {
    case gcode::PathMode::exact_path:
      return Code::G61;
    case gcode::PathMode::exact_stop:
      return Code::G61_1;
    case gcode::PathMode::blend:
      break;
  }
  return Code::G64;
}

Code code_of(gcode::Plane plane) {
  constexpr std::array codes = {Code::G17, Code::G18, Code::G19, Code::G17_1, Code::G18_1, Code::G19_1};
  return codes[static_cast<std::size_t>(plane)];
}

Code tool_length_of(const gcode::Frame& frame) {
  if (frame.tip_control() != nullptr) return frame.takes_vectors() ? Code::G43_5 : Code::G43_4;
  return frame.tool() == base::AxisVector{} ? Code::G49 : Code::G43;
}

std::string coolant_of(const gcode::ModalState& modal) {
  if (!modal.mist && !modal.flood) return "M9";
  return modal.mist && modal.flood ? "M7 M8" : modal.mist ? "M7" : "M8";
}

/// 1 … 9 of G54 … G59.3, 10 … of G54.1.
std::string system_of(int system) {
  if (system <= 6) return "G" + std::to_string(53 + system);
  return system <= 9 ? "G59." + std::to_string(system - 6) : "G54.1 P" + std::to_string(system - 9);
}

double feed_of(const gcode::ModalState& modal) {
  if (!modal.feed_known || modal.feed_mode == gcode::FeedMode::inverse_time) return 0;
  const bool per_revolution = modal.feed_mode == gcode::FeedMode::per_revolution;  // kept for one in a minute
  return per_revolution ? modal.linear_feed * gcode::seconds_per_minute : modal.linear_feed;
}

leadscrew_modes modes_of(const gcode::Reader& reader) {
  const gcode::ModalState& modal = reader.modal();
  const gcode::Frame& frame = reader.frame();
  leadscrew_modes modes{};
  modes.size = sizeof modes;
  copy_text(modes.motion, name(modal.motion));
  copy_text(modes.plane, name(code_of(modal.plane)));
  copy_text(modes.units, frame.length_unit == 1 ? "G21" : "G20");
  copy_text(modes.distance, modal.distance == gcode::Distance::absolute ? "G90" : "G91");
  copy_text(modes.arc_distance, modal.arc_distance == gcode::Distance::absolute ? "G90.1" : "G91.1");
  copy_text(modes.feed_mode, name(code_of(modal.feed_mode)));
  copy_text(modes.path_mode, name(code_of(modal.effective_mode)));
  copy_text(modes.retract, modal.retract == gcode::Retract::initial_level ? "G98" : "G99");
  copy_text(modes.compensation, name(modal.cutter_side));
  copy_text(modes.tool_length, name(tool_length_of(frame)));
  copy_text(modes.spindle, name(modal.spindle));
  copy_text(modes.coolant, coolant_of(modal));
  copy_text(modes.system, system_of(reader.system()));
  if (modal.effective_mode == gcode::PathMode::blend) {
    modes.tolerance = modal.effective_tolerance;
    modes.naive_cam = modal.effective_naive_cam_tolerance;
  }
  modes.feed = feed_of(modal);
  modes.spindle_speed = modal.spindle_speed;
  for (std::size_t i = 0; i < base::axis_count; ++i) modes.offset[i] = frame.system().origin[i] + frame.shift()[i];
  modes.tool = modal.loaded_tool;
  modes.selected_tool = modal.selected_tool.value_or(-1);
  return modes;
}

/// But for where they begin.
bool is_same(const leadscrew_modes& a, const leadscrew_modes& b) {
  constexpr std::size_t begin = offsetof(leadscrew_modes, motion);
  return std::memcmp(reinterpret_cast<const char*>(&a) + begin, reinterpret_cast<const char*>(&b) + begin,
                     sizeof a - begin) == 0;
}

int tell_modes(ProgramReadings& readings, leadscrew_modes_function on_modes, void* user, leadscrew_error* error) {
  gcode::Reader reader = readings.open();
  leadscrew_modes last{};
  gcode::Move move;
  for (std::int64_t block = 0; !readings.error() && reader.next(move);) {
    if (!pipeline::block_length(move)) continue;
    leadscrew_modes modes = modes_of(reader);
    if (block == 0 || !is_same(modes, last)) {
      modes.line = base::number(move.line);
      modes.file = base::file(move.line);
      modes.visit = base::visit(move.line);
      modes.block = block;
      on_modes(&modes, user);
      last = modes;
    }
    if (++block % blocks_between_questions == 0 && readings.is_ended()) break;
  }
  readings.take(reader);
  return readings.error() ? rejected(error, *readings.error()) : static_cast<int>(LEADSCREW_OK);
}

}  // namespace

int leadscrew_program_modes(const leadscrew_machine* machine, const char* text, size_t length,
                            const leadscrew_options* options, leadscrew_modes_function on_modes, void* user,
                            leadscrew_error* error) {
  if (machine == nullptr || !is_text(text, length) || on_modes == nullptr)
    return misuse(error, "the machine, the text or the function is NULL, or the length is none that memory holds");
  return with_readings(*machine, text, length, options, error,
                       [&](ProgramReadings& readings) { return tell_modes(readings, on_modes, user, error); });
}
