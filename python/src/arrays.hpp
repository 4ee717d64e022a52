#pragma once
// Rows of structures as NumPy arrays that share their memory, and arrays as vectors of axes.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <initializer_list>
#include <leadscrew/base/axes.hpp>
#include <memory>
#include <utility>
#include <vector>

namespace leadscrew::python {

namespace py = pybind11;

/// One field of a structured array.
struct Field {
  const char* name;
  const char* format;  ///< as NumPy has it: "<f8", "(9,)<f8"
  std::size_t offset;  ///< bytes
};
py::dtype dtype_of(const std::vector<Field>& fields, std::size_t size);

/// The array looks into the rows and keeps them alive: nothing is copied.
template <class Row>
py::array array_of(std::vector<Row> rows, const std::vector<Field>& fields) {
  auto kept = std::make_unique<std::vector<Row>>(std::move(rows));
  const auto count = static_cast<py::ssize_t>(kept->size());
  Row* const data = kept->data();
  const py::capsule owner(kept.release(), [](void* all) { delete static_cast<std::vector<Row>*>(all); });
  return py::array(dtype_of(fields, sizeof(Row)), {count}, {static_cast<py::ssize_t>(sizeof(Row))}, data, owner);
}

/// Numbers in rows of so many.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// n rows of nine, as the package hands them on.
base::AxisVector axes_of(const Numbers& nine);
Numbers array_of(const base::AxisVector& axes);

/// A new array of these rows and columns, not set.
inline Numbers new_numbers(std::size_t rows, std::size_t columns) {
  return Numbers({static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(columns)});
}

}  // namespace leadscrew::python
