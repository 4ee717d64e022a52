#pragma once
// Open files, and what the system says when it fails.

#include <fcntl.h>
#include <unistd.h>

#include <leadscrew/base/result.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace leadscrew::files {

/// Owns an open file; -1 is none.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }

  int number() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_ = -1;
};

/// `part.ngc: error: cannot open: No such file or directory [io-open]`; `error` is errno.
base::Diagnostic system_failure(std::string_view code, std::string_view what, const std::string& file, int error);

/// open(2). A pipe that nobody reads from yet is waited for. Errors: `io-open`, interruption.
base::Result<Descriptor> open_descriptor(const std::string& path, int flags, std::string_view what);

/// Writes all of the bytes. Errors: `io-write`, `io-pipe` (nobody reads on), interruption.
base::Result<void> write_all(int descriptor, std::string_view bytes, const std::string& file);

/// read(2); 0 at the end. Errors: `io-read`, interruption.
base::Result<std::size_t> read_some(int descriptor, std::span<char> buffer, const std::string& file);

}  // namespace leadscrew::files
