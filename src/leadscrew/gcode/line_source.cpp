#include <algorithm>
#include <cstring>
#include <leadscrew/gcode/line_source.hpp>
#include <utility>

namespace leadscrew::gcode {

namespace {
constexpr std::size_t chunk = 65536;
}

// Space for the longest line, one chunk behind it, and a line feed behind the last byte of the text.
LineSource::LineSource(ByteSource source) : source_(std::move(source)), buffer_(longest_line + chunk + 2) {}

bool LineSource::refill() {
  if (exhausted_) return false;
  if (buffer_.size() - 1 - filled_ < chunk) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, filled_ - begin_);
    filled_ -= begin_;
    begin_ = 0;
  }
  auto count = source_(std::span<char>(buffer_.data() + filled_, chunk));
  if (!count) failure_ = std::move(count.error());
  if (!count || *count == 0) {
    exhausted_ = true;
    return false;
  }
  filled_ += std::min(*count, chunk);
  return true;
}

bool LineSource::skip_to_line_feed() {
  do {
    const char* const from = buffer_.data() + begin_;
    const void* const line_feed = std::memchr(from, '\n', filled_ - begin_);
    if (line_feed) {
      begin_ += static_cast<std::size_t>(static_cast<const char*>(line_feed) - from) + 1;
      skipping_ = false;
      return true;
    }
    begin_ = filled_;
  } while (refill());
  return false;
}

bool LineSource::next(TextLine& line) {
  if (skipping_ && !skip_to_line_feed()) return false;
  std::size_t scanned = 0;
  for (;;) {
    char* const from = buffer_.data() + begin_;
    const std::size_t available = filled_ - begin_;
    char* end = static_cast<char*>(std::memchr(from + scanned, '\n', available - scanned));
    std::size_t length = end ? static_cast<std::size_t>(end - from) : available;
    line.too_long = length > longest_line;
    if (!end && !line.too_long) {
      scanned = available;
      if (refill()) continue;
      if (failure_ || available == 0) return false;
      end = from + available;
    }
    if (end) {
      begin_ = std::min(filled_, begin_ + length + 1);
    } else {
      begin_ = filled_;
      skipping_ = true;
    }
    length = std::min(length, longest_line);
    from[length] = '\n';
    line.begin = line.text = from;
    line.end = from + length;
    line.number = ++lines_;
    return true;
  }
}

}  // namespace leadscrew::gcode
