#pragma once
// The threading cycle (LinuxCNC manual, G Codes, "G76"), one step at a time. Pass n cuts J·n^(1/R) below the crest, until
// it is K; then come the spring passes.
//
//      start ◀──────────── back ──────────────          drive line, at which the tool returns
//        │ in                             ▲
//        ▼ \ entry taper      exit taper /   out
//           ──────────────────────────▶           in step with the spindle

#include <cstdint>

namespace leadscrew::gcode {

class ThreadCycle {
 public:
  /// Lengths in the program's units, its X a radius.
  struct Plan {
    double drive_x = 0;      ///< where the tool stands
    double start_z = 0;      ///< likewise
    double end_z = 0;        ///< where the drive line ends
    double crest = 0;        ///< I: from the drive line; negative outside; ≠ 0
    double first_depth = 0;  ///< J > 0
    double full_depth = 0;   ///< K > J
    double degression = 1;   ///< R ≥ 1
    double slide_angle = 0;  ///< Q, degrees
    double pitch = 0;        ///< P > 0: along Z in a revolution
    double taper = 0;        ///< E ≥ 0: length along Z
    bool tapers_entry = false;
    bool tapers_exit = false;
    int spring_passes = 0;  ///< H ≥ 0
  };

  struct Step {
    enum class Kind : std::uint8_t {
      rapid,
      thread,  ///< in step with the spindle
      lead,    ///< what follows goes so far in a revolution
      free,    ///< no longer in step
    };
    Kind kind = Kind::rapid;
    double x = 0, z = 0;  ///< where a rapid or a thread leads
    double lead = 0;
  };

  ThreadCycle() = default;
  explicit ThreadCycle(const Plan& plan);

  bool active() const { return phase_ != Phase::done; }
  /// The next step; call only while active. The last but the program's own move to the end of the drive line.
  Step next();

  /// How many passes the plan makes, the spring passes included; infinite where that is beyond counting.
  static double passes(const Plan& plan);
  const Plan& plan() const { return plan_; }

 private:
  enum class Phase : std::uint8_t {
    back,
    set_entry_lead,
    to_crest,
    taper_in,
    in,
    set_lead,
    cut,
    set_exit_lead,
    taper_out,
    release,
    out,
    done
  };

  void begin_pass();
  void end_pass();
  Phase behind_cut() const { return plan_.tapers_exit ? Phase::set_exit_lead : Phase::release; }
  Step at(Step::Kind kind, double x, double z) const { return {kind, x, z, 0}; }

  Plan plan_;
  Phase phase_ = Phase::done;
  double side_ = -1;                          // 1: internal
  double direction_ = -1;                     // along Z
  double slide_ = 0;                          // by which a pass is shifted, for its depth
  double taper_lead_ = 0;                     // along a taper, so that Z advances by the pitch
  double depth_ = 0;                          // of the pass, below the crest
  int pass_ = 0;                              // from 1
  int springs_ = 0;                           // passes at full depth so far
  double x_ = 0, crest_x_ = 0, clear_x_ = 0;  // of the pass
  double start_z_ = 0, end_z_ = 0;            // likewise
};

}  // namespace leadscrew::gcode
