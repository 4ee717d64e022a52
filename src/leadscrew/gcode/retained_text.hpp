#pragma once
// A text that comes but once, and what has been read of it since a place, so that it can be read again from there.

#include <cstdint>
#include <leadscrew/base/sink.hpp>
#include <string_view>
#include <utility>
#include <vector>

namespace leadscrew::gcode {

class RetainedText {
 public:
  static constexpr std::size_t most = std::size_t{16} << 20;  ///< bytes that are kept

  explicit RetainedText(base::ByteSource live) : live_(std::move(live)) {}

  /// Keeps what is read from now on, and what has just been read, the bytes before.
  void keep(std::string_view read);
  /// Whether the text can be read from there. Error: `text-not-kept`.
  base::Result<void> check(std::int64_t offset) const;
  /// Is it kept, or was more than `most` to keep?
  bool is_asked_for() const { return is_asked_for_; }

  /// Reads from `offset`, which is held or where the text has come to, and moves it on. Errors: those of the source,
  /// and `text-not-kept` where more than `most` has been read since.
  base::Result<std::size_t> read(std::int64_t& offset, std::span<char> buffer);

 private:
  bool holds(std::int64_t offset) const { return is_kept_ && offset >= from_; }

  base::ByteSource live_;
  std::vector<char> kept_;
  std::int64_t from_ = 0;     // where what is kept begins
  std::int64_t arrived_ = 0;  // bytes that the source has given
  bool is_asked_for_ = false;
  bool is_kept_ = false;
};

}  // namespace leadscrew::gcode
