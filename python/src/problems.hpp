#pragma once
// Diagnostics as Python has them: leadscrew.ProblemError, which holds all of them with their places.

#include <pybind11/pybind11.h>

#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/result.hpp>
#include <utility>
#include <vector>

namespace leadscrew::python {

using Diagnostics = std::vector<base::Diagnostic>;

/// As leadscrew.Diagnostic takes them.
pybind11::list list_of(const Diagnostics& diagnostics);
/// leadscrew.ProblemError of these, of which one at least is an error. With the interpreter's lock.
[[noreturn]] void raise(const Diagnostics& diagnostics);

template <class T>
T value_or_raise(base::Result<T> result) {
  if (!result) raise({result.error()});
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

}  // namespace leadscrew::python
