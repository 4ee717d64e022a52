#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/machine/fields.hpp>
#include <leadscrew/machine/screw_errors.hpp>

namespace leadscrew::machine {

namespace {

using base::text;
using Problems = std::vector<base::Diagnostic>;

bool is_finite(const PitchError& entry) {
  return std::isfinite(entry.position) && std::isfinite(entry.error);
}

void check_step(const std::string& name, const base::Subject& entry, const PitchError& before, const PitchError& now,
                Problems& problems) {
  const double distance = now.position - before.position, change = now.error - before.error;
  if (!(distance > 0)) {
    problems.push_back(base::problem(
        "pitch-order", name + " is at " + text(now.position) + ", the one before at " + text(before.position),
        "positions that rise from entry to entry", entry));
  } else if (std::fabs(change) > greatest_pitch_slope * distance) {
    problems.push_back(
        base::problem("pitch-slope", name + ": the error changes by " + text(change) + " along " + text(distance),
                      "at most a tenth of the distance; are errors in the same unit as positions?", entry));
  }
}

void check_table(const std::string& name, base::Subject subject, const std::vector<PitchError>& table,
                 Problems& problems) {
  for (std::size_t k = 0; k < table.size(); ++k) {
    const std::string entry = name + " " + std::to_string(k + 1);
    subject.entry = k;
    if (!is_finite(table[k])) {
      problems.push_back(base::problem("pitch-value",
                                       entry + " is " + text(table[k].position) + ", " + text(table[k].error),
                                       "finite numbers", subject));
    } else if (k > 0 && is_finite(table[k - 1])) {
      check_step(entry, subject, table[k - 1], table[k], problems);
    }
  }
}

}  // namespace

void check_screw(base::Axis axis, const ScrewErrors& errors, Problems& problems) {
  const std::string name = std::string("axis ") + base::letter(axis) + ": ";
  check_table(name + "pitch entry", {.axis = axis, .field = field::pitch_errors}, errors.table, problems);
  check_table(name + "backward pitch entry", {.axis = axis, .field = field::backward_pitch_errors},
              errors.backward_table, problems);
  if (!(errors.backlash >= 0 && std::isfinite(errors.backlash))) {
    problems.push_back(base::problem("backlash", name + "a backlash of " + text(errors.backlash), "0 or more",
                                     {.axis = axis, .field = field::backlash}));
  }
  if (!(errors.takeup_velocity >= 0 && std::isfinite(errors.takeup_velocity))) {
    problems.push_back(base::problem("backlash-takeup", name + "backlash taken up at " + text(errors.takeup_velocity),
                                     "0 or more, units a second; 0 is the axis' greatest velocity",
                                     {.axis = axis, .field = field::takeup_velocity}));
  }
}

}  // namespace leadscrew::machine
