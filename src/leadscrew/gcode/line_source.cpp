#include <algorithm>
#include <cstring>
#include <leadscrew/gcode/line_source.hpp>
#include <string_view>
#include <utility>

namespace leadscrew::gcode {

namespace {
constexpr std::size_t chunk = 65536;
}

// Space for the longest line, one chunk behind it, and a line feed behind the last byte of the text.
LineSource::LineSource(ByteSource source, int file)
    : source_(std::move(source)), buffer_(longest_line + chunk + 2), stamp_(base::line_at(0, file)), file_(file) {}

void LineSource::restart(ByteSource source, int file, std::int64_t offset, std::int64_t line) {
  source_ = std::move(source);
  begin_ = filled_ = 0;
  base_ = offset;
  lines_ = line - 1;
  file_ = file;
  skipping_ = exhausted_ = false;
  failure_.reset();
}

bool LineSource::seek(int file, std::int64_t offset, std::int64_t line) {
  const bool is_here = file == file_ && offset >= base_ && offset < base_ + as_int(filled_) && !failure_;
  if (!is_here) return false;
  begin_ = static_cast<std::size_t>(offset - base_);
  lines_ = line - 1;
  skipping_ = false;
  return true;
}

std::string_view LineSource::text_from(std::int64_t offset) const {
  const auto from = static_cast<std::size_t>(offset - base_);
  return {buffer_.data() + from, filled_ - from};
}

bool LineSource::refill() {
  if (exhausted_) return false;
  if (buffer_.size() - 1 - filled_ < chunk) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, filled_ - begin_);
    filled_ -= begin_;
    base_ += as_int(begin_);
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

bool LineSource::has_line() const {
  return filled_ > begin_ && std::memchr(buffer_.data() + begin_, '\n', filled_ - begin_) != nullptr;
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
    line.offset = base_ + (from - buffer_.data());
    length = std::min(length, longest_line);
    from[length] = '\n';
    line.begin = line.text = from;
    line.end = from + length;
    line.number = ++lines_;
    line.id = base::Line{static_cast<std::int64_t>(stamp_) | std::min(line.number, base::last_line)};
    return true;
  }
}

}  // namespace leadscrew::gcode
