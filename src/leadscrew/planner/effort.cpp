#include <algorithm>
#include <leadscrew/planner/effort.hpp>

namespace leadscrew::planner {

bool Effort::spend(double units) {
  constexpr double between_questions = 4096;
  of_window_ += units;
  if (should_stop && !stopped_ && total() >= asked_at_) {
    asked_at_ = total() + between_questions;
    stopped_ = should_stop();
  }
  return goes_on();
}

void Effort::earn(double seconds) {
  balance_ = std::min(greatest_balance, balance_ + units_per_second * seconds);
}

void Effort::earn_section() {
  balance_ = std::min(greatest_balance, balance_ + units_per_section);
}

}  // namespace leadscrew::planner
