#pragma once
// The module leadscrew._core: what Python calls of the rooms, file by file. The package around it checks what it is given and
// says what was expected; here numbers are what they have to be.

#include <pybind11/pybind11.h>

namespace leadscrew::python {

namespace py = pybind11;

void bind_machine(py::module_& module);     ///< Machine, and where its tool is while axes are somewhere
void bind_work(py::module_& module);        ///< programs and moves, run, planned, judged, simulated
void bind_trajectory(py::module_& module);  ///< Trajectory
void bind_surfaces(py::module_& module);    ///< Surface and its passes
void bind_pulses(py::module_& module);      ///< interpolators of reference pulses
void bind_studies(py::module_& module);     ///< published experiments made again

}  // namespace leadscrew::python
