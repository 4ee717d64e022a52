#include <leadscrew/hardware/motion_model.hpp>

// For a build without Verilator's model.

namespace leadscrew::hardware {

std::unique_ptr<MotionModel> make_motion_model(const std::optional<std::string>&) {
  return nullptr;
}

bool has_motion_model() {
  return false;
}

}  // namespace leadscrew::hardware
