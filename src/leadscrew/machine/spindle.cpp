#include <algorithm>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/machine/fields.hpp>
#include <leadscrew/machine/spindle.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <string>

namespace leadscrew::machine {

double tap_acceleration(const Spindle& spindle, const Derivatives& limits, double lead, double tolerance,
                        base::Period period) {
  constexpr double seconds_per_minute = 60;
  const double t = period.seconds(), gain = std::min(limits.jerk / limits.acceleration, 0.1 / t);
  // Not half of the tolerance for each of both terms; the axis' acceleration is shared with what makes good errors.
  const double share = 0.45 * tolerance;
  const double by_estimate = share / (1.2 * t / gain + 6 * t * t);
  const double by_jerk = numeric::cbrt(share / 2.4 * limits.jerk * limits.jerk);
  const double change = std::min({by_estimate, by_jerk, limits.acceleration / 2}) / 2;
  // By the clock a spindle that is fast by its wander takes up speed faster by the square of that.
  const double faster = 1 + spindle.wander;
  return std::min(spindle.acceleration / seconds_per_minute, change / lead / (faster * faster));
}

void check_spindle(const Spindle& spindle, std::vector<base::Diagnostic>& problems) {
  // Of NaN nothing is true.
  const auto check = [&](const char* what, double value, double least, double most, std::string_view field) {
    if (least <= value && value <= most) return;
    problems.push_back(base::problem("machine-spindle", std::string(what) + " is " + base::text(value),
                                     base::text(least) + " to " + base::text(most), {.field = field}));
  };
  check("the spindle's acceleration", spindle.acceleration, 1, 1e9, field::spindle_acceleration);
  check("the noise of the spindle's speed", spindle.wander, 0, 0.2, field::spindle_noise);
  check("the period of the spindle's noise", spindle.wander_period, 0.1, 1000, field::spindle_noise_period);
}

}  // namespace leadscrew::machine
