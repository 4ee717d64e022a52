#pragma once
// A file that is read more than once, in constant memory: a program or a trace.
//
// It is opened once and held open; every source reads it from the beginning at an offset of its own. So a file that is
// renamed or removed meanwhile is still read to its end. What is read again is what was read first: a piece of it that
// was changed meanwhile is an error before a byte of it is handed on (base/checked_text.hpp). What cannot be read twice
// (a pipe, a terminal, a device) is first copied to a temporary file without a name, up to 1 GiB.

#include <sys/stat.h>

#include <cstdint>
#include <leadscrew/base/checked_text.hpp>
#include <leadscrew/base/sink.hpp>
#include <leadscrew/files/descriptor.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace leadscrew::files {

/// Bytes of what is copied.
inline constexpr std::int64_t largest_copy = std::int64_t{1} << 30;

class InputFile {
 public:
  /// "-" is standard input. Errors: `io-open`, `io-read`, `io-write` (of the copy), `input-too-large` where there is
  /// more to copy than `largest` bytes, interruption. changed: the code of the error when it is another file when it is
  /// read again.
  static base::Result<InputFile> open(const std::string& path, std::string_view changed = "program-changed",
                                      std::int64_t largest = largest_copy);

  /// A file that nobody else knows, which holds this. Errors: `io-open`, `io-write`, interruption.
  static base::Result<InputFile> of_text(std::string_view text, const std::string& name);

  const std::string& name() const { return name_; }  ///< for people: the path, or <stdin>
  std::int64_t size() const { return size_; }        ///< bytes

  /// Reads from the beginning; `position`, if given, is kept at the number of bytes read. The file must outlive the
  /// source and stay where it is; one thread at a time reads it. Errors: `io-read`, interruption, and `changed`
  /// where it differs from what an earlier source has read.
  base::ByteSource source(std::int64_t* position = nullptr) const;

  /// The same, from a byte on that an earlier source has come to.
  base::ByteSource source_at(std::int64_t offset) const;

  /// Opens this text anew, and those of its subprograms: `NAME.ngc`, `NAME.nc` and other endings of part programs, for a
  /// number also `O1000.nc` and `O0100.nc`, in the folder of this file and then in `folders`. They stay open, and are
  /// what they were. Both must outlive it, and it is for one thread at a time.
  base::TextOpener opener(std::vector<std::string> folders = {}) const;

  /// Those that have been opened, in the order of their names.
  std::vector<const InputFile*> subprograms() const;

  /// The one that lines with this base::file() are of, once its program has been read: this, or a subprogram of it. Null
  /// where there is none.
  const InputFile* text_of(int file) const;

  /// Has it been written to since it was opened, read already or not, or a subprogram of it? Error: `changed`.
  base::Result<void> unchanged() const;

  /// Is this path the same file?
  bool is_same(const std::string& path) const;

 private:
  InputFile(std::string name, std::string_view changed);
  base::Result<void> take(Descriptor descriptor, std::int64_t largest);
  base::Result<const InputFile*> subprogram(const std::string& name, const std::vector<std::string>& folders) const;
  base::ByteSource reading(std::int64_t offset, std::int64_t* position) const;
  base::Result<std::size_t> read_at(std::int64_t offset, std::span<char> buffer) const;

  Descriptor descriptor_;
  std::string name_;
  std::int64_t size_ = 0;
  struct stat opened_ = {};
  base::Diagnostic changed_;
  mutable base::CheckedText text_;                                         ///< what any source has read so far
  mutable std::map<std::string, std::unique_ptr<InputFile>> subprograms_;  ///< by their names
  mutable std::vector<const InputFile*> in_order_;                         ///< of these, in the order of their opening
};

/// The whole of a small file, such as a machine file. Errors as above; `input-too-large` of a file of any kind.
base::Result<std::string> read_whole(const std::string& path, std::int64_t largest);

/// So many bytes of the source of a file with this name. Errors: those of the source; `io-read` where it ends before.
base::Result<std::string> all_of(const base::ByteSource& source, std::int64_t size, const std::string& name);

}  // namespace leadscrew::files
