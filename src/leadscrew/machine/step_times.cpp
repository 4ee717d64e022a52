#include <leadscrew/base/number_text.hpp>
#include <leadscrew/machine/step_times.hpp>
#include <string>

namespace leadscrew::machine {

void check_step_times(base::Axis axis, const StepTimes& times, std::vector<base::Diagnostic>& problems) {
  const auto microseconds = [](std::int64_t ns) { return base::text(static_cast<double>(ns) / 1e3); };
  for (const StepTime& each : all_step_times) {
    const std::int64_t value = times.*each.value;
    if (each.least <= value && value <= longest_step_time) continue;
    problems.push_back(base::problem("step-time",
                                     std::string("axis ") + base::letter(axis) + ": " + std::string(each.name) +
                                         " is " + microseconds(value) + " us",
                                     each.least > 0 ? "above 0, and up to 1000000 us" : "from 0 to 1000000 us",
                                     {.axis = axis, .field = each.name}));
  }
}

}  // namespace leadscrew::machine
