#pragma once
// Where words bring the tool: its tip in the workpiece and its direction, for whoever shows or writes them.

#include <leadscrew/kinematics/pose.hpp>
#include <optional>

namespace leadscrew::kinematics {

/// Of a tool, seen from the workpiece as it lies with all rotary axes at 0.
struct ToolPose {
  base::AxisVector tip{};  ///< X, Y and Z of the tip, mm; all other axes as they are
  Vector direction{};      ///< a unit vector from the tip to the spindle
};

class WordPoses {
 public:
  /// Poses of a machine that has a chain of rotary axes; none of others.
  explicit WordPoses(const machine::Machine& machine) {
    if (machine.rotary_chain) chain_.emplace(chain_of(machine));
  }

  /// From now on that is the tool's offset, mm; none before.
  void hold(const Vector& tool) { tool_ = tool; }
  /// While the axes are there, mm and degrees.
  std::optional<ToolPose> of(const base::AxisVector& axes) const {
    if (!chain_) return std::nullopt;
    return ToolPose{pose_of(*chain_, axes, tool_), direction_of(*chain_, angles_of(*chain_, axes))};
  }
  /// The direction alone, which rotary axes tell, be X, Y and Z the axes' or the tip's.
  std::optional<Vector> direction_at(const base::AxisVector& axes) const {
    if (!chain_) return std::nullopt;
    return direction_of(*chain_, angles_of(*chain_, axes));
  }

 private:
  std::optional<Chain> chain_;
  Vector tool_{};
};

}  // namespace leadscrew::kinematics
