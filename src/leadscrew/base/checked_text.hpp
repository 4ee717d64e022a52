#pragma once
// A text that is read more than once, and must be the same each time: what was checked is what is carried out.
//
//   first reading   bytes ─▶ pieces of 64 KiB ─▶ the hash of each is kept
//   each later one  bytes ─▶ pieces of 64 KiB ─▶ compared with its hash before a byte of it is handed on
//
// So nothing of a file that is written over between two readings is ever interpreted, whenever that happens, and
// nothing but 8 bytes a piece is kept. A text that has shrunk or grown ends in another piece, and is another one.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/hash.hpp>
#include <leadscrew/base/result.hpp>
#include <leadscrew/base/sink.hpp>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace leadscrew::base {

class CheckedText {
 public:
  static constexpr std::size_t piece_size = 64 * 1024;  ///< bytes

  /// `changed`: the error of a reading that differs from the first.
  explicit CheckedText(Diagnostic changed) : changed_(std::move(changed)) {}

  /// The same bytes as those of `source`, which reads the text from its beginning. A piece that no reading has come to
  /// yet is taken as it is. Errors: those of the source, and `changed`; after an error there is nothing more to read.
  /// This must outlive the source and stay where it is; sources of one text are not for two threads at a time.
  ByteSource source(ByteSource source) {
    return [this, reading = Reading(std::move(source))](std::span<char> buffer) mutable {
      return reading.read(*this, buffer);
    };
  }

  /// The same from a byte on; `open` reads the text from there. Errors of the source: also those of reading what no
  /// reading has come to yet, before the byte.
  template <class Open>
  ByteSource source_at(std::int64_t offset, Open&& open) {
    const auto piece = std::min(static_cast<std::size_t>(offset) / piece_size, hashes_.size());
    Reading reading(open(static_cast<std::int64_t>(piece * piece_size)), piece);
    return [this, reading = std::move(reading), skip = static_cast<std::size_t>(offset) - piece * piece_size](
               std::span<char> buffer) mutable { return reading.read(*this, buffer, std::exchange(skip, 0)); };
  }

 private:
  class Reading {
   public:
    explicit Reading(ByteSource source, std::size_t first = 0) : source_(std::move(source)), number_(first) {}

    /// Behind so many bytes that are left out.
    Result<std::size_t> read(CheckedText& text, std::span<char> buffer, std::size_t left_out = 0) {
      while (left_out > 0) {
        if (begin_ == end_ && is_last_) break;
        if (begin_ == end_) {
          if (auto filled = next_piece(text); !filled) return failure(filled.error());
        }
        const std::size_t count = std::min(left_out, end_ - begin_);
        begin_ += count;
        left_out -= count;
      }
      if (begin_ == end_ && !is_last_) {
        if (auto filled = next_piece(text); !filled) return failure(filled.error());
      }
      const std::size_t count = std::min(buffer.size(), end_ - begin_);
      if (count > 0) std::memcpy(buffer.data(), piece_.data() + begin_, count);
      begin_ += count;
      return count;
    }

   private:
    /// A piece that is not full is the text's last, be it empty.
    Result<void> next_piece(CheckedText& text) {
      piece_.resize(piece_size);
      begin_ = end_ = 0;
      is_last_ = true;  // behind an error too
      std::size_t filled = 0;
      while (filled < piece_.size()) {
        const auto got = source_(std::span(piece_).subspan(filled));
        if (!got) return failure(got.error());
        if (*got == 0) break;
        filled += *got;
      }
      Hash hash;
      hash.add({piece_.data(), filled});
      if (!text.is_known(number_++, hash.value())) return failure(text.changed_);
      end_ = filled;
      is_last_ = filled < piece_.size();
      return {};
    }

    ByteSource source_;
    std::vector<char> piece_;
    std::size_t begin_ = 0, end_ = 0;  // of the piece: what has not been handed on
    std::size_t number_ = 0;           // of the next piece
    bool is_last_ = false;
  };

  /// Is this the piece of the first reading, or is it the first reading's?
  bool is_known(std::size_t number, std::uint64_t hash) {
    if (number == hashes_.size()) hashes_.push_back(hash);
    return hashes_[number] == hash;
  }

  Diagnostic changed_;
  std::vector<std::uint64_t> hashes_;  // of pieces, in their order
};

}  // namespace leadscrew::base
