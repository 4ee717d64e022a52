#include <poll.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <leadscrew/files/descriptor.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <system_error>

namespace leadscrew::files {

base::Diagnostic system_failure(std::string_view code, std::string_view what, const std::string& file, int error) {
  return {base::Severity::error,     code, std::string(what) + ": " + std::generic_category().message(error), {},
          base::Place{.file = file}, {}};
}

namespace {

constexpr int longest_wait = 100;          // ms between two looks for an interruption
constexpr std::size_t least_free = 4096;   // bytes that a pipe takes at once when it says that it is ready: PIPE_BUF
constexpr timespec nap = {0, 10'000'000};  // between two looks for a reader of a pipe

bool is_regular(int descriptor) {
  struct stat status = {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

/// A signal may have been handled by another thread, or just before a call that waits: so no call waits for long.
base::Result<void> await(int descriptor, short event) {
  pollfd ready = {descriptor, event, 0};
  while (::poll(&ready, 1, longest_wait) <= 0) {
    if (interrupted()) return base::failure(interruption());
  }
  return {};
}

bool has_no_reader(const std::string& path, int error) {
  struct stat status = {};
  return error == ENXIO && ::stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode);
}

}  // namespace

base::Result<Descriptor> open_descriptor(const std::string& path, int flags, std::string_view what) {
  while (true) {
    Descriptor descriptor(::open(path.c_str(), flags | O_CLOEXEC | O_NONBLOCK, 0666));
    const int error = errno;
    if (descriptor) {
      ::fcntl(descriptor.number(), F_SETFL, ::fcntl(descriptor.number(), F_GETFL) & ~O_NONBLOCK);
      return descriptor;
    }
    if (interrupted()) return base::failure(interruption());
    if (has_no_reader(path, error)) {
      ::nanosleep(&nap, nullptr);
    } else if (error != EINTR) {
      return base::failure(system_failure("io-open", what, path, error));
    }
  }
}

base::Result<void> write_all(int descriptor, std::string_view bytes, const std::string& file) {
  const bool waits = !is_regular(descriptor);
  while (!bytes.empty()) {
    if (waits) {
      if (auto ready = await(descriptor, POLLOUT); !ready) return ready;
    }
    const std::size_t size = waits ? std::min(bytes.size(), least_free) : bytes.size();
    const ssize_t written = ::write(descriptor, bytes.data(), size);
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (interrupted()) {
      return base::failure(interruption());
    } else if (errno != EINTR && errno != EAGAIN) {
      return base::failure(system_failure(errno == EPIPE ? "io-pipe" : "io-write", "cannot write", file, errno));
    }
  }
  return {};
}

base::Result<std::size_t> read_some(int descriptor, std::span<char> buffer, const std::string& file) {
  while (true) {
    if (interrupted()) return base::failure(interruption());
    if (auto ready = await(descriptor, POLLIN); !ready) return base::failure(ready.error());
    const ssize_t got = ::read(descriptor, buffer.data(), buffer.size());
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR && errno != EAGAIN) return base::failure(system_failure("io-read", "cannot read", file, errno));
  }
}

}  // namespace leadscrew::files
