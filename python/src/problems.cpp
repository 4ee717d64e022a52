#include "problems.hpp"

#include <leadscrew/base/axes.hpp>
#include <string>

namespace leadscrew::python {

namespace py = pybind11;

namespace {

std::string field_of(const base::Subject& subject) {
  std::string field(subject.field);
  if (subject.axis) field += std::string(field.empty() ? "" : ".") + base::letter(*subject.axis);
  return field;
}

/// Bytes of a program need not be UTF-8.
py::object text_of(const std::string& bytes) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "replace"));
}

}  // namespace

py::list list_of(const Diagnostics& diagnostics) {
  py::list all;
  const py::object diagnostic = py::module_::import("leadscrew.problems").attr("Diagnostic");
  for (const base::Diagnostic& each : diagnostics) {
    all.append(diagnostic(std::string(base::name(each.severity)), std::string(each.code), text_of(each.message),
                          text_of(each.hint), text_of(each.place.file), each.place.line, each.place.column,
                          text_of(each.source), field_of(each.subject)));
  }
  return all;
}

void raise(const Diagnostics& diagnostics) {
  const py::object type = py::module_::import("leadscrew.problems").attr("ProblemError");
  const py::object error = type(list_of(diagnostics));
  PyErr_SetObject(type.ptr(), error.ptr());
  throw py::error_already_set();
}

}  // namespace leadscrew::python
