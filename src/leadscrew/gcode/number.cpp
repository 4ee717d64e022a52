#include <fast_float/fast_float.h>
#include <charconv>
#include <leadscrew/gcode/number.hpp>

namespace leadscrew::gcode {

double long_decimal(const char* first, const char* last) {
  double value = 0;
  fast_float::from_chars(first, last, value, fast_float::chars_format::fixed);
  return value;
}

std::string text(double value) {
  if (value == 0) return "0";
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 9);
  return {buffer, end.ptr};
}

}  // namespace leadscrew::gcode
