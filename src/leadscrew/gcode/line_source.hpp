#pragma once
// Lines of a text that arrives in chunks of any size, in constant memory: a window of 128 KiB goes along the text. What
// the window holds can be read again.

#include <cstdint>
#include <leadscrew/base/line.hpp>
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
  std::int64_t offset = 0;     ///< bytes of the text before it
  base::Line id{};             ///< its number, its file and its visit
  bool too_long = false;       ///< longer than longest_line; what is here is its beginning
};

inline constexpr std::size_t longest_line = 64 * 1024;  ///< bytes

class LineSource {
 public:
  /// Of file number `file`, from its beginning.
  explicit LineSource(ByteSource source, int file = 0);

  /// Goes on with this text, whose first line begins at `offset` and has this number.
  void restart(ByteSource source, int file, std::int64_t offset, std::int64_t line);
  /// Goes back or forth to a line that the window holds; false where it does not.
  bool seek(int file, std::int64_t offset, std::int64_t line);
  /// The visit that lines have from now on.
  void set_visit(std::int64_t visit) { stamp_ = base::line_at(0, file_, visit); }

  /// The next line; false at the end of the text, or when the source has failed.
  bool next(TextLine& line);

  /// Has all of it come already?
  bool has_line() const;

  int file() const { return file_; }
  std::int64_t lines() const { return lines_; }                   ///< number of the last line
  std::int64_t offset() const { return base_ + as_int(begin_); }  ///< where the next line begins
  /// What the window holds from there on. The offset is that of a line in it.
  std::string_view text_from(std::int64_t offset) const;
  const std::optional<base::Diagnostic>& failure() const { return failure_; }

 private:
  static std::int64_t as_int(std::size_t size) { return static_cast<std::int64_t>(size); }
  bool refill();
  bool skip_to_line_feed();

  ByteSource source_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;   // of what has not been given out
  std::size_t filled_ = 0;  // bytes of the buffer in use
  std::int64_t base_ = 0;   // where the buffer begins in the text
  std::int64_t lines_ = 0;
  base::Line stamp_{};  // file and visit
  int file_ = 0;
  bool skipping_ = false;  // the rest of a line that was too long
  bool exhausted_ = false;
  std::optional<base::Diagnostic> failure_;
};

}  // namespace leadscrew::gcode
