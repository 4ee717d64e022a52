#include "watch.hpp"

#include <leadscrew/host/program_reading.hpp>

#include "problems.hpp"

namespace leadscrew::python {

namespace py = pybind11;

bool Watch::goes_on() {
  if (ended_) return false;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < between_questions) return true;
  last_ = now;
  ended_ = !ask();
  return !ended_;
}

bool Watch::ask() {
  const py::gil_scoped_acquire lock;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return progress_.is_none() || !progress_(share_).is(py::bool_(false));
  } catch (py::error_already_set& error) {
    error_.emplace(std::move(error));
    return false;
  }
}

void Watch::raise_what_ended() {
  if (error_) {
    py::error_already_set error = std::move(*error_);
    error_.reset();
    throw error;
  }
  if (ended_) raise({host::interruption()});
}

}  // namespace leadscrew::python
