#include <leadscrew/hardware/block_moves.hpp>
#include <leadscrew/hardware/model_program.hpp>
#include <string>
#include <utility>

namespace leadscrew::hardware {

namespace {

base::Diagnostic refusal(const nc::Block& block, std::string_view code, std::string message, std::string hint) {
  base::Diagnostic found = base::problem(code, std::move(message), std::move(hint), {.field = nc::pulses_field});
  found.place.line = base::number(block.line);
  return found;
}

std::optional<base::Diagnostic> hardware_problem(const nc::Block& block, const Lanes& lanes) {
  const BlockMove made = move_of(block, lanes);
  const std::string letter(1, base::letter(base::all_axes[made.axis]));
  switch (made.problem) {
    case BlockMove::Problem::none:
      break;
    case BlockMove::Problem::helix:
      return refusal(block, "hardware-helix", "the hardware: an arc along which " + letter + " moves too",
                     "write it as lines, or leave --hardware-model out");
    case BlockMove::Problem::axis:
      return refusal(block, "hardware-axes",
                     "the hardware: " + letter + ", where its " + std::to_string(MotionModel::axes) +
                         " axes are those that the machine has before it",
                     "give a machine of fewer axes, or leave --hardware-model out");
    case BlockMove::Problem::too_long:
      return refusal(block, "hardware-register",
                     "the hardware: more steps of " + letter + " than its counters of " + std::to_string(model_width) +
                         " bits hold",
                     "lines of up to 16777215 steps, arcs of radii up to 8388606: write shorter ones, or leave "
                     "--hardware-model out");
  }
  return std::nullopt;
}

}  // namespace

std::optional<base::Diagnostic> missing_model() {
  if (has_motion_model()) return std::nullopt;
  return base::problem("hardware-model", "--hardware-model: this leadscrew was built without the model of the hardware",
                       "install verilator and build with cmake --preset release -DLEADSCREW_HARDWARE=ON");
}

nc::BlockCheck model_check(const machine::Machine& machine) {
  return [lanes = Lanes(machine)](const nc::Block& block) { return hardware_problem(block, lanes); };
}

}  // namespace leadscrew::hardware
