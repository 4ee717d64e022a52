#include <fast_float/fast_float.h>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/gcode/number.hpp>

namespace leadscrew::gcode {

double long_decimal(const char* first, const char* last) {
  double value = 0;
  fast_float::from_chars(first, last, value, fast_float::chars_format::fixed);
  return value;
}

std::string text(double value) {
  return value == 0 ? "0" : base::text(value, 9);
}

}  // namespace leadscrew::gcode
