#include "arrays.hpp"

#include <algorithm>

namespace leadscrew::python {

py::dtype dtype_of(const std::vector<Field>& fields, std::size_t size) {
  py::list names, formats, offsets;
  for (const Field& field : fields) {
    names.append(field.name);
    formats.append(field.format);
    offsets.append(field.offset);
  }
  return {names, formats, offsets, static_cast<py::ssize_t>(size)};
}

base::AxisVector axes_of(const Numbers& nine) {
  if (nine.size() != static_cast<py::ssize_t>(base::axis_count)) throw py::value_error("nine numbers, one an axis");
  base::AxisVector axes;
  std::copy_n(nine.data(), axes.size(), axes.begin());
  return axes;
}

Numbers array_of(const base::AxisVector& axes) {
  Numbers array(static_cast<py::ssize_t>(axes.size()));
  std::copy(axes.begin(), axes.end(), array.mutable_data());
  return array;
}

}  // namespace leadscrew::python
