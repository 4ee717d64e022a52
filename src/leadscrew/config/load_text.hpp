#pragma once
// Small files as text.

#include <cstddef>
#include <leadscrew/base/result.hpp>
#include <string>

namespace leadscrew::config {

/// The first `most` bytes of the file at `path`, or all there are. Codes: `io-open`, `io-read`.
base::Result<std::string> load_text(const std::string& path, std::size_t most);

}  // namespace leadscrew::config
