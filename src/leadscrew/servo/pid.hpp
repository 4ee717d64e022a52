#pragma once
// The PID controller of a position loop, with feed-forward of velocity and acceleration.
//
//   e = reference − reading
//   u = P·e + I·T·Σe + D·(e − e₋₁) + Fv·v + Fa·a        published form
//   u = P·e + I·T·Σe + D·(e − e₋₁)/T + Fv·v + Fa·a      standard form
//
// Σe holds the present error as well; before the first period e₋₁ is 0, as a cleared register says. With the published
// form Lin and Koren's gains (P, I, D) = (2, 2, 15) and (6, 50, 25) at T = 10 ms make sense: what they call D counts
// differences of the error, not its slope (R.-S. Lin, Y. Koren, "Real-time interpolators for multi-axis CNC machine
// tools").
//
// Saturation and windup: u is cut off at ±limit, for the amplifier gives no more. An integral that went on summing
// meanwhile would have to be emptied by an overshoot. So, unless it is told otherwise, an error that would drive a
// command further past the limit is not added to Σe. This conditional integration has no constant to be tuned, where
// back-calculation needs a time constant of its own, and below the limit it changes no bit of the command.

#include <algorithm>
#include <cmath>
#include <leadscrew/base/result.hpp>
#include <leadscrew/servo/setpoint.hpp>
#include <limits>

namespace leadscrew::servo {

enum class PidForm { published, standard };

enum class AntiWindup { conditional, none };

/// u in units of command, lengths in mm; all ≥ 0.
struct PidGains {
  double proportional = 0;  ///< P, units/mm
  double integral = 0;      ///< I, units/(mm·s)
  double derivative = 0;    ///< D, units/mm in the published form, units·s/mm in the standard one
};

struct PidOptions {
  PidGains gains;
  PidForm form = PidForm::published;
  double velocity_forward = 0;      ///< Fv, units/(mm/s); 1/K makes good what a drive of gain K lags behind; ≥ 0
  double acceleration_forward = 0;  ///< Fa, units/(mm/s²); τ/K; ≥ 0
  double limit = std::numeric_limits<double>::infinity();  ///< of |u|; > 0
  AntiWindup anti_windup = AntiWindup::conditional;
};

class Pid {
 public:
  /// period: T, seconds. Code: `servo-controller`.
  static base::Result<Pid> create(const PidOptions& options, double period);

  /// The command for the period that begins. Once a period.
  double command(const Setpoint& setpoint, double reading) {
    const double error = setpoint.position - reading;
    const double others = gains_.proportional * error + gains_.derivative * (error - last_error_) +
                          velocity_forward_ * setpoint.velocity + acceleration_forward_ * setpoint.acceleration;
    last_error_ = error;
    const double wanted = others + gains_.integral * (sum_ + error);
    const bool winds_up = std::fabs(wanted) > limit_ && (wanted > 0) == (error > 0);
    if (!(winds_up && anti_windup_ == AntiWindup::conditional)) sum_ += error;
    return std::clamp(others + gains_.integral * sum_, -limit_, limit_);
  }

  /// Σe, mm.
  double sum() const { return sum_; }

 private:
  Pid() = default;

  PidGains gains_;  // of e, Σe and e − e₋₁
  double velocity_forward_ = 0, acceleration_forward_ = 0, limit_ = 0;
  AntiWindup anti_windup_ = AntiWindup::conditional;
  double sum_ = 0, last_error_ = 0;
};

}  // namespace leadscrew::servo
