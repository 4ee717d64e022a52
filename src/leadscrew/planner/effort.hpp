#pragma once
// How much work planning may be. It is counted, not timed, so that a program is planned the same on every computer.
//
//   balance ^ .-.      .--.
//           |/   \    /    \          windows are paid for, committed motion earns
//           |     \  /      \  /
//           +------\/--------\/----▶ t   below 0: the rest of the section is planned with lower limits
//
// A unit is about a quarter of a microsecond of one processor: a sample of the path for knots, an
// interval in a step of Newton's method, four samples of the proof. The examples take 2'000 to 50'000 units a second of
// motion, and so does a circle at F2.5.

#include <cstdint>
#include <functional>

namespace leadscrew::planner {

class Effort {
 public:
  /// What windows may take, units: ten times what a second of ordinary motion takes, something for each section, and
  /// this much (some seconds of a processor) before that has come together.
  static constexpr double units_per_second = 5e5, units_per_section = 5e4, greatest_balance = 4e7;
  /// No single window takes more: several times that of 600 intervals that is repaired as often as can be.
  static constexpr double most_of_a_window = 2e6;

  /// Planning ends at once, for good, when this says true. Asked every 4096 units or so. Absent: never.
  std::function<bool()> should_stop;

  /// A window begins, with all that it may take.
  void begin_window() {
    total_ += of_window_;
    of_window_ = 0;
  }
  /// False when the window must be given up: it has taken too much, or everything is to stop.
  bool spend(double units);
  /// What the window has taken so far, units.
  double of_window() const { return of_window_; }
  bool goes_on() const { return !stopped_ && of_window_ <= most_of_a_window; }

  /// The window that was planned last is paid for.
  void pay() { balance_ -= of_window_; }
  /// It was refused: what is planned in its place is not work of the motion's.
  void give_back() { balance_ += of_window_; }
  /// So much motion has been committed, s ≥ 0.
  void earn(double seconds);
  /// A section begins: windows from rest cost something, however short it is.
  void earn_section();
  /// Units; below 0, planning has taken more than motion has earned.
  double balance() const { return balance_; }

  bool is_stopped() const { return stopped_; }
  /// Units so far, whether paid for or not.
  double total() const { return total_ + of_window_; }

 private:
  double balance_ = greatest_balance;
  double of_window_ = 0, total_ = 0, asked_at_ = 0;
  bool stopped_ = false;
};

}  // namespace leadscrew::planner
