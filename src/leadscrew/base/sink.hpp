#pragma once
// Where bytes go to and come from: writers and readers know nothing of files.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <leadscrew/base/result.hpp>
#include <span>
#include <string>
#include <string_view>

namespace leadscrew::base {

/// Takes all of the bytes, or says why it could not.
using ByteSink = std::function<base::Result<void>(std::string_view)>;

/// Fills the buffer with the next bytes and returns how many; 0 at the end.
using ByteSource = std::function<base::Result<std::size_t>(std::span<char>)>;

/// A text of several, from a place in it.
struct OpenedText {
  ByteSource source;  ///< of its bytes from that place on
  std::string name;   ///< for diagnostics
};

/// Opens a text at a byte of it, which is not beyond what has been read of it: of a program its own where the name is
/// empty, else that of a subprogram: the name in `o<name> call`, in small letters, or the number in `M98 P` and
/// `o100 call`. Errors: `missing-sub`; those of files.
using TextOpener = std::function<Result<OpenedText>(const std::string& name, std::int64_t offset)>;

}  // namespace leadscrew::base
