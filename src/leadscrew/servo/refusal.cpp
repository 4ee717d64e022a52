#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/servo/refusal.hpp>
#include <utility>

namespace leadscrew::servo {

using base::text;

void Refusal::unless_positive(std::string_view what, double value) {
  if (!(value > 0 && std::isfinite(value))) refuse(what, value, "above 0");
}

void Refusal::unless_not_negative(std::string_view what, double value) {
  if (!(value >= 0 && std::isfinite(value))) refuse(what, value, "0 or more");
}

void Refusal::unless_limit(std::string_view what, double value) {
  if (!(value > 0)) refuse(what, value, "above 0; infinite for none");
}

void Refusal::unless_within(std::string_view what, double value, double low, double high) {
  if (!(low <= value && value <= high)) refuse(what, value, "between " + text(low) + " and " + text(high));
}

void Refusal::refuse(std::string_view what, double value, std::string hint) {
  if (found_) return;
  std::string message = std::string(what) + " is " + text(value);
  found_ = base::Diagnostic{base::Severity::error, code_, std::move(message), std::move(hint), {}, {}, {.field = what}};
}

}  // namespace leadscrew::servo
