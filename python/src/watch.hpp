#pragma once
// Long work without the interpreter's lock, and whether to go on with it: ^C, and the caller's own function.

#include <pybind11/pybind11.h>

#include <chrono>
#include <optional>

namespace leadscrew::python {

/// Made, asked and ended by the thread that called from Python.
class Watch {
 public:
  /// progress: None, or called with the share of the work that is done, 0 … 1, some twenty times a second; an exception of
  /// its own ends the work, and so does False.
  explicit Watch(pybind11::object progress) : progress_(std::move(progress)) {}

  /// Asked often, without the lock: looks at a clock, and twenty times a second for signals. False once the work is to end.
  bool goes_on();
  /// The same, and from now on so much of the work is done, 0 … 1.
  bool goes_on(double share) {
    share_ = share;
    return goes_on();
  }
  /// With the lock, after the work: raises what ended it.
  void raise_what_ended();

 private:
  bool ask();

  static constexpr std::chrono::milliseconds between_questions{50};

  pybind11::object progress_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  double share_ = 0;
  bool ended_ = false;
  std::optional<pybind11::error_already_set> error_;
};

/// What `work` returns, which runs without the lock; raises what ended it.
template <class Work>
auto without_lock(Watch& watch, const Work& work) {
  auto result = [&] {
    const pybind11::gil_scoped_release release;
    return work();
  }();
  watch.raise_what_ended();
  return result;
}

}  // namespace leadscrew::python
