#pragma once
// Text and rows, gathered into blocks of 64 KiB before they reach a sink.

#include <leadscrew/base/sink.hpp>
#include <string>
#include <utility>

namespace leadscrew::base {

/// Once the sink has failed, nothing more reaches it, and every later call returns the same diagnostic.
class BlockSink {
 public:
  static constexpr std::size_t block_bytes = 64 * 1024;

  /// `longest`: bytes that may be appended at once, so that the memory is taken now.
  explicit BlockSink(ByteSink sink, std::size_t longest = 0) : sink_(std::move(sink)) {
    text_.reserve(block_bytes + longest);
  }

  /// Is appended to.
  std::string& text() { return text_; }
  const Result<void>& state() const { return state_; }

  Result<void> flush_if_full() { return text_.size() < block_bytes ? state_ : flush(); }
  Result<void> flush() {
    if (state_ && !text_.empty()) state_ = sink_(text_);
    text_.clear();
    return state_;
  }

 private:
  ByteSink sink_;
  std::string text_;
  Result<void> state_;
};

}  // namespace leadscrew::base
