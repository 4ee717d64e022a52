#include "own_process.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <leadscrew/files/descriptor.hpp>
#include <mutex>
#include <stdexcept>
#include <system_error>

namespace leadscrew::python {

namespace {

constexpr int between_looks = 20;         // ms
constexpr char done = '+', failed = '-';  // before the text, or before what an exception says

/// A process that writes a text; ended with this.
class Writer {
 public:
  explicit Writer(const std::function<std::string()>& work) {
    // Another thread's process would have this one's end of the pipe, which then ends with both.
    static std::mutex one_at_a_time;
    const std::scoped_lock lock(one_at_a_time);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "a process");
    output_ = files::Descriptor(ends[0]);
    const files::Descriptor input(ends[1]);
    id_ = ::fork();
    if (id_ < 0) throw std::system_error(errno, std::generic_category(), "a process");
    if (id_ == 0) write(work, input.number());
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() {
    if (id_ > 0) ::kill(id_, SIGKILL);
    end();
  }

  /// What it has written since, waited for no longer than between two looks; false once it writes no more.
  bool read(std::string& text) {
    pollfd waited{output_.number(), POLLIN, 0};
    if (::poll(&waited, 1, between_looks) <= 0) return true;
    std::array<char, 1 << 16> buffer;
    const ssize_t got = ::read(output_.number(), buffer.data(), buffer.size());
    if (got > 0) text.append(buffer.data(), static_cast<std::size_t>(got));
    return got > 0 || (got < 0 && errno == EINTR);
  }
  /// Waits for its end.
  void end() {
    while (id_ > 0 && ::waitpid(id_, nullptr, 0) < 0 && errno == EINTR) continue;
    id_ = 0;
  }

 private:
  /// ^C at a terminal is for the process that was called, which ends this one; and so is that process's own end.
  [[noreturn]] static void write(const std::function<std::string()>& work, int to) noexcept {
    ::signal(SIGINT, SIG_IGN);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::string text;
    try {
      text = done + work();
    } catch (const std::exception& error) {
      text = failed + std::string(error.what());
    }
    ::_exit(files::write_all(to, text, "a process") ? 0 : 1);
  }

  files::Descriptor output_;
  ::pid_t id_ = 0;
};

}  // namespace

std::string in_own_process(Watch& watch, const std::function<std::string()>& work) {
  Writer writer(work);
  std::string text;
  while (writer.read(text))
    if (!watch.goes_on()) return {};
  writer.end();
  if (text.empty())
    throw std::runtime_error("expected a text of the process that was started, and it ended without one");
  const bool has_failed = text[0] == failed;
  text.erase(0, 1);
  if (has_failed) throw std::runtime_error(text);
  return text;
}

}  // namespace leadscrew::python
