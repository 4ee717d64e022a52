#include "bindings.hpp"

PYBIND11_MODULE(_core, module) {
  module.doc() = "What the package leadscrew is made of: the rooms of the C++ library.";
  module.attr("version") = LEADSCREW_VERSION;
  leadscrew::python::bind_machine(module);
  leadscrew::python::bind_trajectory(module);
  leadscrew::python::bind_work(module);
  leadscrew::python::bind_surfaces(module);
  leadscrew::python::bind_pulses(module);
  leadscrew::python::bind_studies(module);
}
