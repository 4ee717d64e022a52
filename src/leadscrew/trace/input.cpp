#include <leadscrew/trace/input.hpp>

#include <cassert>
#include <cstring>

namespace leadscrew::trace {

/// Puts more bytes behind the unread ones; false when the source is at its end or the buffer is full.
base::Result<bool> Input::fill() {
  if (ended_) return false;
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ == capacity) return false;
  const base::Result<std::size_t> count = source_(std::span(buffer_).subspan(end_));
  if (!count) return base::failure(count.error());
  assert(*count <= capacity - end_);
  end_ += *count;
  ended_ = *count == 0;
  return !ended_;
}

base::Result<std::string_view> Input::peek(std::size_t wanted) {
  assert(wanted <= capacity);
  while (end_ - begin_ < wanted) {
    const base::Result<bool> more = fill();
    if (!more) return base::failure(more.error());
    if (!*more) break;
  }
  return unread().substr(0, wanted);
}

base::Result<std::optional<Input::TextLine>> Input::line() {
  std::size_t searched = 0;
  while (true) {
    const std::size_t end = unread().find('\n', searched);
    if (end != std::string_view::npos) {
      std::string_view text = unread().substr(0, end);
      if (text.ends_with('\r')) text.remove_suffix(1);
      skip(end + 1);
      return TextLine{text, true};
    }
    searched = unread().size();
    const base::Result<bool> more = fill();
    if (!more) return base::failure(more.error());
    if (*more) continue;
    if (searched == 0) return std::nullopt;
    std::string_view text = unread();
    if (text.ends_with('\r')) text.remove_suffix(1);
    const bool complete = ended_;
    skip(searched);
    return TextLine{text, complete};
  }
}

}  // namespace leadscrew::trace
