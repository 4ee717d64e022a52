#pragma once
// Blocks on the lattice as moves of hdl/driver.

#include <array>
#include <cutter.hpp>
#include <leadscrew/hardware/motion_model.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/nc/block.hpp>
#include <optional>
#include <string_view>

namespace leadscrew::hardware {

/// Which of the core's axes an axis of the machine is: in order, those that the machine has.
class Lanes {
 public:
  explicit Lanes(const machine::Machine& machine);

  /// Nothing where the core has none left for it.
  std::optional<std::uint8_t> of(std::size_t axis) const;
  const std::array<base::Axis, MotionModel::axes>& axes() const { return axes_; }

 private:
  std::array<base::Axis, MotionModel::axes> axes_{};
  std::array<std::optional<std::uint8_t>, base::axis_count> lane_{};
};

/// A block's move at its programmed feed; or what the core cannot make of it, with that axis.
struct BlockMove {
  enum class Problem : std::uint8_t { none, helix, axis, too_long };
  Problem problem = Problem::none;
  std::size_t axis = 0;
  driver::Move move{};
};
BlockMove move_of(const nc::Block& block, const Lanes& lanes);

/// Of counts in the model's core, bits.
inline constexpr int model_width = 24;

}  // namespace leadscrew::hardware
