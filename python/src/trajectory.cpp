// Trajectory: a motion planned to its end, asked at any times, and its words.

#include <cmath>
#include <leadscrew/pipeline/trajectory.hpp>

#include "bindings.hpp"
#include "rows.hpp"

namespace leadscrew::python {

namespace {

using pipeline::Trajectory;

py::array states_at(const Trajectory& trajectory, const Numbers& times) {
  std::vector<pipeline::TrajectoryState> states;
  const double* const first = times.data();
  const auto count = static_cast<std::size_t>(times.size());
  {
    const py::gil_scoped_release release;
    states.reserve(count);
    for (std::size_t i = 0; i < count; ++i) states.push_back(trajectory.at(first[i]));
  }
  return array_of(std::move(states), state_fields());
}

py::array words_of(const Trajectory& trajectory) {
  Words words;
  {
    const py::gil_scoped_release release;
    const std::int64_t last = base::count(trajectory.last_tick());
    words.reserve(static_cast<std::size_t>(last) + 1);
    for (std::int64_t i = 0; i <= last; ++i) words.push_back(trajectory.word(base::Tick{i}));
  }
  return array_of(std::move(words), word_fields());
}

}  // namespace

void bind_trajectory(py::module_& module) {
  py::class_<Trajectory>(module, "Trajectory")
      .def_property_readonly("duration", &Trajectory::duration)
      .def_property_readonly("length", &Trajectory::length)
      .def("at", &states_at, py::arg("times"))
      .def("words", &words_of);
}

}  // namespace leadscrew::python
