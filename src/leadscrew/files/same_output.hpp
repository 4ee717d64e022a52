#pragma once
// Whether two paths lead to one output.

#include <string>

namespace leadscrew::files {

/// Do both name one regular file, or one that is yet to be made?
bool is_same_output(const std::string& path, const std::string& other);

}  // namespace leadscrew::files
