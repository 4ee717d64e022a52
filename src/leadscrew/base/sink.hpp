#pragma once
// Where bytes go to and come from: writers and readers know nothing of files.

#include <cstddef>
#include <functional>
#include <leadscrew/base/result.hpp>
#include <span>
#include <string_view>

namespace leadscrew::base {

/// Takes all of the bytes, or says why it could not.
using ByteSink = std::function<base::Result<void>(std::string_view)>;

/// Fills the buffer with the next bytes and returns how many; 0 at the end.
using ByteSource = std::function<base::Result<std::size_t>(std::span<char>)>;

}  // namespace leadscrew::base
