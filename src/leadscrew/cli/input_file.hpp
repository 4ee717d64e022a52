#pragma once
// A file that is read more than once, in constant memory: a program or a trace.
//
// It is opened once and held open; every source reads it from the beginning at an offset of its own. So a file that is
// renamed or removed meanwhile is still read to its end, and one that shrinks or is changed is noticed. What cannot be
// read twice (a pipe, a terminal, a device) is first copied to a temporary file without a name, up to 1 GiB.

#include <sys/stat.h>

#include <cstdint>
#include <leadscrew/cli/descriptor.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <string>

namespace leadscrew::cli {

/// Bytes of what is copied.
inline constexpr std::int64_t largest_copy = std::int64_t{1} << 30;

class InputFile {
 public:
  /// "-" is standard input, curve:NAME a curve of the studies (curve_program.hpp). Errors: `usage` of the latter,
  /// `io-open`, `io-read`, `io-write` (of the copy), `input-too-large` where there is more to copy than so many bytes,
  /// interruption.
  static base::Result<InputFile> open(const std::string& path, std::int64_t largest = largest_copy);

  const std::string& name() const { return name_; }  ///< for people: the path, curve:NAME, or <stdin>
  std::int64_t size() const { return size_; }        ///< bytes

  /// Reads from the beginning; `position`, if given, is kept at the number of bytes read. The file must outlive the
  /// source.
  gcode::ByteSource source(std::int64_t* position = nullptr) const;

  /// Fails if the file has been changed since it was opened.
  base::Result<void> unchanged() const;

  /// Is this path the same file?
  bool is_same(const std::string& path) const;

 private:
  base::Result<std::size_t> read_at(std::int64_t offset, std::span<char> buffer) const;

  Descriptor descriptor_;
  std::string name_;
  std::int64_t size_ = 0;
  struct stat opened_ = {};
};

/// The whole of a small file, such as a machine file. Errors as above; `input-too-large` of a file of any kind.
base::Result<std::string> read_whole(const std::string& path, std::int64_t largest);

}  // namespace leadscrew::cli
