#pragma once
// Where words bring the tool: its tip in the workpiece and its direction, for whoever shows or writes them. Which tool that
// is, the plan tells with the word at which it becomes another (toolpath::Builder::tell_tool).

#include <array>
#include <cmath>
#include <deque>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/kinematics/pose.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <optional>

namespace leadscrew::kinematics {

/// Of a tool, seen from the workpiece as it lies with all rotary axes at 0.
struct ToolPose {
  base::AxisVector tip{};  ///< X, Y and Z of the tip, mm; all other axes as they are
  Vector direction{};      ///< a unit vector from the tip to the spindle

  /// X, Y and Z of the tip and of the direction, as rows of words have them.
  std::array<double, 6> numbers() const { return {tip[0], tip[1], tip[2], direction[0], direction[1], direction[2]}; }
};

class WordPoses {
 public:
  /// Poses of a machine that has a chain of rotary axes; none of others.
  explicit WordPoses(const machine::Machine& machine) {
    if (machine.rotary_chain) chain_.emplace(chain_of(machine));
  }

  /// From now on that is the tool's offset, mm; none before.
  void hold(const Vector& tool) { tool_ = tool; }
  const Vector& tool() const { return tool_; }
  /// Of a word that has not been asked for: events of the tool count from there on, all others are passed over.
  void observe(const base::PassedEvent& event) {
    using Kind = base::Event::Kind;
    if (chain_ && (event.kind == Kind::tool_offset || event.kind == Kind::tip_control)) ahead_.push_back(event);
  }

  /// Of a word, in the order of time.
  std::optional<ToolPose> of(const base::Word& word) {
    advance(word.tick);
    return of(word.position);
  }
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

  /// The tool is that of the word of this tick, later than all before.
  void advance(base::Tick tick) {
    for (; !ahead_.empty() && ahead_.front().tick <= tick; ahead_.pop_front()) {
      const base::Event& event = ahead_.front();
      if (event.kind == base::Event::Kind::tip_control) {
        is_of_tip_ = event.value != 0;
      } else {
        tool_[static_cast<std::size_t>(event.output)] = event.value;
      }
    }
  }
  /// Of the tip in the workpiece, mm/s, while the axes are there and move so, mm/s and degrees/s; none where feed is not
  /// counted by the tip.
  std::optional<double> tip_speed(const base::AxisVector& axes, const base::AxisVector& velocity) const {
    if (!chain_ || !is_of_tip_) return std::nullopt;
    Coordinates<numeric::Jet<1>> moving;
    for (std::size_t i = 0; i < moving.size(); ++i) {
      moving[i] = axes[i];
      moving[i][1] = velocity[i];
    }
    const auto tip = pose_of(*chain_, moving, tool_);
    return numeric::hypot(tip[0][1], tip[1][1], tip[2][1]);
  }

 private:
  std::optional<Chain> chain_;
  Vector tool_{};
  bool is_of_tip_ = false;  ///< is feed counted by it?
  std::deque<base::PassedEvent> ahead_;
};

}  // namespace leadscrew::kinematics
