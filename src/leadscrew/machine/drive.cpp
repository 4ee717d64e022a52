#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/machine/drive.hpp>
#include <string>

namespace leadscrew::machine {

namespace {

bool is_sound(double value, DriveNumber::Range range) {
  switch (range) {
    case DriveNumber::Range::positive:
      return value > 0 && std::isfinite(value);
    case DriveNumber::Range::not_negative:
      return value >= 0 && std::isfinite(value);
    case DriveNumber::Range::share:
      return value >= 0 && value <= 1;
  }
  return false;
}

std::string hint_of(DriveNumber::Range range) {
  switch (range) {
    case DriveNumber::Range::positive:
      return "give a number above 0";
    case DriveNumber::Range::not_negative:
      return "0 or more";
    case DriveNumber::Range::share:
      return "between 0 and 1";
  }
  return {};
}

}  // namespace

void check_drive(base::Axis axis, const AxisDrive& drive, std::vector<base::Diagnostic>& problems) {
  for (const DriveNumber& number : drive_numbers) {
    const auto& value = drive.*number.value;
    if (!value || is_sound(*value, number.range)) continue;
    problems.push_back(base::problem("machine-drive",
                                     std::string("axis ") + base::letter(axis) +
                                         ": drive: " + std::string(number.name) + " is " + base::text(*value),
                                     hint_of(number.range), {.axis = axis, .field = number.name}));
  }
}

}  // namespace leadscrew::machine
