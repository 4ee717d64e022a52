#pragma once
// Bytes of a source, as lines or as runs of known length, through one buffer of fixed size.

#include <cstddef>
#include <leadscrew/base/result.hpp>
#include <leadscrew/base/sink.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace leadscrew::trace {

class Input {
 public:
  /// Also the length of the longest line.
  static constexpr std::size_t capacity = 64 * 1024;

  explicit Input(base::ByteSource source) : source_(std::move(source)), buffer_(capacity) {}

  /// The next `wanted` ≤ capacity bytes, or what is left of them before the end. Valid until the next call that reads.
  base::Result<std::string_view> peek(std::size_t wanted);
  void skip(std::size_t bytes) { begin_ += bytes; }

  struct TextLine {
    std::string_view text;  ///< without the line end
    bool complete = true;   ///< false when the line is longer than the buffer
  };
  /// The next line and steps over it; nullopt at the end.
  base::Result<std::optional<TextLine>> line();

 private:
  base::Result<bool> fill();
  std::string_view unread() const { return {buffer_.data() + begin_, end_ - begin_}; }

  base::ByteSource source_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  bool ended_ = false;
};

}  // namespace leadscrew::trace
