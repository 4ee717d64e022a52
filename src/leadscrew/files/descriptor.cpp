#include <cerrno>
#include <leadscrew/files/descriptor.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <system_error>

namespace leadscrew::files {

base::Diagnostic system_failure(std::string_view code, std::string_view what, const std::string& file, int error) {
  return {base::Severity::error,     code, std::string(what) + ": " + std::generic_category().message(error), {},
          base::Place{.file = file}, {}};
}

base::Result<Descriptor> open_descriptor(const std::string& path, int flags, std::string_view what) {
  while (true) {
    const int number = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
    if (number >= 0) return Descriptor(number);
    if (interrupted()) return base::failure(interruption());
    if (errno != EINTR) return base::failure(system_failure("io-open", what, path, errno));
  }
}

base::Result<void> write_all(int descriptor, std::string_view bytes, const std::string& file) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (interrupted()) {
      return base::failure(interruption());
    } else if (errno != EINTR) {
      return base::failure(system_failure(errno == EPIPE ? "io-pipe" : "io-write", "cannot write", file, errno));
    }
  }
  return {};
}

base::Result<std::size_t> read_some(int descriptor, std::span<char> buffer, const std::string& file) {
  while (true) {
    if (interrupted()) return base::failure(interruption());
    const ssize_t got = ::read(descriptor, buffer.data(), buffer.size());
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR) return base::failure(system_failure("io-read", "cannot read", file, errno));
  }
}

}  // namespace leadscrew::files
