#pragma once
// Between the poses that LinuxCNC plans in and the axes of a machine with two rotary axes: its own kinematics, of which a machine
// file tells, beside those of the kinematics module that motmod calls for the joints. Without a file both are the same.
//
// A pose is that of the tool's tip, the tool's length added in Z, as LinuxCNC has it: tip = pose - tool.

#include <array>
#include <leadscrew/machine.hpp>
#include <leadscrew/motion_source.hpp>
#include <optional>

#include "link.hpp"

namespace leadscrew::linuxcnc {

class Kinematics {
 public:
  /// Poses are the axes.
  Kinematics() = default;
  /// Of a sound machine with a chain of rotary axes.
  explicit Kinematics(machine::Machine machine)
      : machine_(std::move(machine)), chain_(kinematics::chain_of(*machine_)) {}

  /// Whose limits hold for the axes; none where poses are the axes.
  const std::optional<machine::Machine>& machine() const { return machine_; }
  /// mm or degrees; `tool`: its length, mm.
  Position tip_of(const Position& pose, double tool) const {
    Position tip = pose;
    if (chain_) tip[2] -= tool;
    return tip;
  }
  Position axes_of(const Position& pose, double tool) const {
    return chain_ ? kinematics::machine_of(*chain_, tip_of(pose, tool), {0, 0, tool}) : pose;
  }
  Position pose_of(const Position& axes, double tool) const {
    if (!chain_) return axes;
    Position pose = kinematics::pose_of(*chain_, axes, {0, 0, tool});
    pose[2] += tool;
    return pose;
  }

 private:
  std::optional<machine::Machine> machine_;
  std::optional<kinematics::Chain> chain_;
};

}  // namespace leadscrew::linuxcnc
