#pragma once
// Lines of a text that arrives in chunks of any size, in constant memory.

#include <cstdint>
#include <leadscrew/gcode/reader.hpp>
#include <optional>
#include <vector>

namespace leadscrew::gcode {

/// One line, without its line feed. `*end` is a line feed, so that a scan needs no other bound. Valid until the next
/// line.
struct TextLine {
  const char* begin = nullptr;
  const char* end = nullptr;
  const char* text = nullptr;  ///< where words may begin: behind a byte order mark
  std::int64_t number = 0;     ///< from 1
  bool too_long = false;       ///< longer than longest_line; what is here is its beginning
};

inline constexpr std::size_t longest_line = 64 * 1024;  ///< bytes

class LineSource {
 public:
  explicit LineSource(ByteSource source);

  /// The next line; false at the end of the text, or when the source has failed.
  bool next(TextLine& line);

  std::int64_t lines() const { return lines_; }
  const std::optional<base::Diagnostic>& failure() const { return failure_; }

 private:
  bool refill();
  bool skip_to_line_feed();

  ByteSource source_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;   // of what has not been given out
  std::size_t filled_ = 0;  // bytes of the buffer in use
  std::int64_t lines_ = 0;
  bool skipping_ = false;  // the rest of a line that was too long
  bool exhausted_ = false;
  std::optional<base::Diagnostic> failure_;
};

}  // namespace leadscrew::gcode
