#pragma once
// The canned cycles G81, G82, G83 and G85 (NIST IR 6556, 3.5.16), one step at a time, so that a cycle repeated many
// times needs no memory.
//
//     ──┐ lift to R where the tool is below it
//       └──▶ approach at the old level ──▶ down to R ──▶ drill to Z ──▶ back to R or the clear level ──▶ next hole

#include <leadscrew/base/axes.hpp>
#include <leadscrew/gcode/codes.hpp>

namespace leadscrew::gcode {

class DrillCycle {
 public:
  /// Machine coordinates, mm and degrees.
  struct Plan {
    Code code = Code::G81;
    base::Axis drill = base::Axis::Z;  ///< the axis of the hole
    base::AxisVector start{};          ///< where the tool stands
    base::AxisVector first_hole{};     ///< above it; its drill coordinate is unused
    base::AxisVector increment{};      ///< from hole to hole
    double r_level = 0;                ///< ≥ bottom
    double clear_level = 0;            ///< ≥ r_level; where the tool waits between holes
    double bottom = 0;
    double peck = 0;           ///< G83: mm, > 0
    double dwell_seconds = 0;  ///< G82: ≥ 0
    int repeats = 1;           ///< ≥ 1
  };

  struct Step {
    enum class Kind { rapid, feed, dwell } kind = Kind::rapid;
    base::AxisVector target{};
  };

  /// How far from the bottom of the hole a peck goes back to cutting feed (LinuxCNC: 0.010 inch).
  static constexpr double peck_clearance = 0.254;  // mm
  /// What is left to the bottom is no peck of its own below this: it is rounding.
  static constexpr double least_peck = 1e-6;  // mm

  DrillCycle() = default;
  explicit DrillCycle(const Plan& plan);

  bool active() const { return phase_ != Phase::done; }
  /// The next step; call only while active.
  Step next();
  /// Where the tool stands after the last step.
  base::AxisVector end() const;
  const Plan& plan() const { return plan_; }

 private:
  enum class Phase { lift, approach, to_r_level, cut, peck_out, peck_in, bottom, dwell, retract, clear, done };

  Step at_level(Step::Kind kind, double level);
  base::AxisVector hole(int number) const;
  double peck_depth(int peck) const { return plan_.r_level - peck * plan_.peck; }

  Plan plan_;
  Phase phase_ = Phase::done;
  base::AxisVector position_{};
  int hole_ = 0;
  int peck_ = 1;
};

}  // namespace leadscrew::gcode
