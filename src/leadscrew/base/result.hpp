#pragma once
// Failure is a value: every function that can fail returns a Result.

#include <leadscrew/base/diagnostic.hpp>
#include <tl/expected.hpp>
#include <utility>

namespace leadscrew::base {

/// A value, or why there is none.
template <class T>
using Result = tl::expected<T, Diagnostic>;

/// A failed Result of any type, from its diagnostic.
inline tl::unexpected<Diagnostic> failure(Diagnostic diagnostic) {
  return tl::unexpected<Diagnostic>(std::move(diagnostic));
}

}  // namespace leadscrew::base
