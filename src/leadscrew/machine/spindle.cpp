#include <leadscrew/base/number_text.hpp>
#include <leadscrew/machine/fields.hpp>
#include <leadscrew/machine/spindle.hpp>
#include <string>

namespace leadscrew::machine {

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
