#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <leadscrew/drive/live_program.hpp>
#include <leadscrew/files/descriptor.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <utility>

namespace leadscrew::drive {

namespace {

constexpr std::size_t most_moves_waiting = 10'000;  // so that memory is bounded: the writer is held back
constexpr std::int64_t pause = 2'000'000;           // ns
constexpr int longest_wait = 50;                    // ms, of a poll
constexpr std::int64_t longest_kept = 500'000'000;  // ns, that lines wait for those that follow

/// Half of a line is another line, of a writer that died: X1 of X10.
base::Diagnostic unfinished_line() {
  return base::problem("unfinished-line", "the program ends inside a line, which was not executed",
                       "end every line with a line feed, the last, too");
}

}  // namespace

LiveProgram::LiveProgram(const Setup& setup, std::string name)
    : setup_(setup), name_(std::move(name)), moves_(setup.machine, setup.reading.start), thread_([this] { read(); }) {}

void LiveProgram::end() {
  is_unwanted_.store(true, std::memory_order_relaxed);
  if (thread_.joinable()) thread_.join();
}

/// Moves behind an error may begin where no motion leads.
void LiveProgram::read() {
  gcode::ReaderOptions options = setup_.speaking(setup_.reader_options(name_));
  options.is_dry = [this] { return is_dry(); };
  gcode::Reader reader(source(), setup_.machine, setup_.tools, std::move(options),
                       [this](const base::Diagnostic& problem) {
                         if (problem.severity == base::Severity::error) fail(problem);
                       });
  gcode::Move move;
  while (reader.next(move) && !has_failed()) {
    moves_.append(std::move(move));
    blocks_.store(reader.blocks(), std::memory_order_relaxed);
    while (moves_.waiting() >= most_moves_waiting && !is_unwanted_.load(std::memory_order_relaxed))
      realtime::sleep_until(realtime::now() + pause);
  }
  if (reader.source_failure()) fail(*reader.source_failure());
  blocks_.store(reader.blocks(), std::memory_order_relaxed);
  moves_.finish();
}

void LiveProgram::fail(const base::Diagnostic& problem) {
  if (!failure_) failure_ = problem;
  has_failed_.store(true, std::memory_order_release);
}

/// What has been written by now; waits for more, but never for longer than somebody wants it.
gcode::ByteSource LiveProgram::source() {
  const std::string& path = setup_.live_program;
  auto opened = path == "-" ? base::Result<files::Descriptor>(files::Descriptor(::dup(STDIN_FILENO)))
                            : files::open_descriptor(path, O_RDONLY, "cannot open");
  if (!opened) {
    return [problem = opened.error()](std::span<char>) -> base::Result<std::size_t> { return base::failure(problem); };
  }
  input_ = std::move(*opened);
  return [this](std::span<char> buffer) -> base::Result<std::size_t> {
    for (pollfd waits{input_.number(), POLLIN, 0}; !is_unwanted_.load(std::memory_order_relaxed);) {
      if (::poll(&waits, 1, longest_wait) == 0) continue;
      auto count = files::read_some(input_.number(), buffer, name_);
      if (count && *count == 0 && is_inside_line_) return base::failure(unfinished_line());
      if (count && *count > 0) is_inside_line_ = buffer[*count - 1] != '\n';
      return count;
    }
    return 0;
  };
}

/// Nothing comes for a moment, or a line now and then, and whoever sends the next may wait for motion.
bool LiveProgram::is_dry() {
  const std::int64_t now = realtime::now();
  if (kept_since_ < 0) kept_since_ = now;
  pollfd waits{input_.number(), POLLIN, 0};
  const bool is_dry = now - kept_since_ > longest_kept || ::poll(&waits, 1, longest_wait) == 0;
  if (is_dry) kept_since_ = -1;
  return is_dry;
}

}  // namespace leadscrew::drive
