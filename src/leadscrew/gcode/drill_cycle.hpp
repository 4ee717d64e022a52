#pragma once
// The canned cycles (NIST IR 6556, 3.5.16; LinuxCNC manual, G Codes; Fanuc's G76), one step at a time, so that a cycle
// repeated many times needs no memory.
//
//     ──┐ lift to R where the tool is below it
//       └──▶ approach at the old level ──▶ down to R ──▶ what the cycle does there ──▶ clear level ──▶ next hole

#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/gcode/codes.hpp>
#include <span>

namespace leadscrew::gcode {

class DrillCycle {
 public:
  /// Where the holes are: in a row from the first, or on a circle about it (Haas: G70, G71).
  struct Pattern {
    base::AxisVector increment{};  ///< of a row: from hole to hole
    double radius = 0;             ///< mm; of a circle; 0 for a row
    double start_angle = 0;        ///< degrees, counterclockwise from the first axis of the plane
    double step_angle = 0;         ///< degrees from hole to hole
    base::Axis first = base::Axis::X, second = base::Axis::Y;  ///< of the plane
  };

  /// Machine coordinates, mm and degrees.
  struct Plan {
    Code code = Code::G81;
    base::Axis drill = base::Axis::Z;  ///< the axis of the hole
    base::AxisVector start{};          ///< where the tool stands
    base::AxisVector first_hole{};     ///< above it; its drill coordinate is unused
    Pattern pattern;
    double r_level = 0;      ///< ≥ bottom
    double clear_level = 0;  ///< ≥ r_level; where the tool waits between holes
    double out_level = 0;    ///< ≥ r_level; to which a cycle that goes out at feed does so
    double bottom = 0;
    double peck = 0;           ///< G73, G83: mm, > 0: the first. G74, G84: of each, the tool out to R between; 0: none
    double peck_step = 0;      ///< mm, ≥ 0: by which each is less than the one before
    double least_peck = 0;     ///< mm, > 0 where peck_step is
    double dwell_seconds = 0;  ///< ≥ 0; no dwell where 0 and the cycle may do without
    double level = 0;          ///< G87: to which it bores upwards
    base::AxisVector aside{};  ///< G76, G87: from the hole to where the tool clears its wall
    int repeats = 1;           ///< ≥ 1
    bool spindle_turned = true;  ///< before the cycle; a tapping cycle then need not turn it
    bool dwells = false;         ///< P was given
    double out_factor = 1;       ///< G74, G84: so many times as fast out as in, spindle and feed alike; ≥ 1
    bool follows = false;        ///< of a tapping cycle: the machine follows a spindle that it simulates
  };

  struct Step {
    enum class Kind {
      rapid,
      feed,
      dwell,
      spindle_start,
      spindle_reverse,
      spindle_stop,
      spindle_orient,
      overrides_off,
      overrides_on,
      in_step,
      out_of_step,
      spindle_turn,  ///< the way a tap is cut, where it stands before the cycle
      pause
    };
    Kind kind = Kind::rapid;
    base::AxisVector target{};
    bool is_fast = false;  ///< of a tap's way out: times Plan::out_factor
  };

  /// What a cycle may do from R on.
  enum class Action : std::uint8_t {
    peck,             ///< down in pecks, each followed by its way out and back in
    down,             ///< to the bottom at feed
    plunge,           ///< to the bottom at rapid
    out,              ///< up at feed, to Plan::out_level
    bore_back,        ///< at feed to Plan::level
    clear,            ///< up at rapid, to Plan::clear_level
    dwell,            ///< where the plan dwells
    aside,            ///< by Plan::aside, off the wall
    back,             ///< over the hole again
    orient,           ///< the spindle, which stands, turns to its angle
    stop,             ///< the spindle stops
    reverse,          ///< the spindle turns the other way
    start,            ///< the spindle turns as before
    turn,             ///< the spindle turns the way a tap is cut, if it stood before the cycle
    no_overrides,     ///< the operator's are not obeyed
    overrides_again,  ///< they are, as before
    in_step,          ///< motion goes in step with the spindle
    out_of_step,      ///< no longer
    pause,            ///< waits for the operator
  };

  /// How far from the bottom of the hole a peck goes back to cutting feed (LinuxCNC: 0.010 inch).
  static constexpr double peck_clearance = 0.254;  // mm
  /// What is left of a hole and less than this goes with the last peck (LinuxCNC: 1e-6 of a unit).
  static constexpr double least_rest = 1e-6;  // mm

  DrillCycle() = default;
  explicit DrillCycle(const Plan& plan);

  bool active() const { return phase_ != Phase::done; }
  /// The next step; call only while active.
  Step next();
  /// Above a hole, from 0 to repeats − 1.
  base::AxisVector hole(int number) const;
  /// Where the tool stands after the last step.
  base::AxisVector end() const;
  const Plan& plan() const { return plan_; }

 private:
  enum class Phase { lift, approach, to_r_level, in_hole, peck_out, peck_in, done };

  Step at_level(Step::Kind kind, double level);
  Step in_hole();
  Step peck();
  double tap_level();
  bool taps_deeper() const { return plan_.peck > 0 && pecks_ > 0 && peck_level_ > plan_.bottom; }
  Step move_aside(double sign);

  Plan plan_;
  Phase phase_ = Phase::done;
  base::AxisVector position_{};
  int hole_ = 0;
  std::span<const Action> actions_;  // of the hole, those still to come
  double peck_level_ = 0;            // to which the pecks so far have gone
  int pecks_ = 0;                    // of the hole, so far
};

}  // namespace leadscrew::gcode
