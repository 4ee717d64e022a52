#include <sys/stat.h>

#include <cerrno>
#include <leadscrew/cli/file_side.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <vector>

namespace leadscrew::cli {

namespace {

constexpr std::int64_t nap = 1'000'000;                   // ns between two looks for words, or for room
constexpr std::int64_t longest_for_none = 1'000'000'000;  // ns that a reader is waited for when nobody sends words

}  // namespace

FileSide::FileSide(DriveLink& link, const Job& job, const DriveState& begin)
    : WordSide(link, job, begin),
      path_(*job.arguments.drive.sink),
      writer_([this](std::string_view bytes) { return write(bytes); }, job.machine.axis_set(), job.machine.period),
      progress_(realtime::now()) {}

base::Result<void> FileSide::open(const Job&) {
  // A pipe without a reader cannot be opened so: ENXIO.
  constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC | O_NONBLOCK | O_CLOEXEC;
  while (true) {
    file_ = Descriptor(::open(path_.c_str(), flags, 0666));
    if (file_) break;
    if (errno != ENXIO && errno != EINTR) return base::failure(system_failure("io-open", "cannot write", path_, errno));
    if (!waits()) return {};
  }
  struct stat status = {};
  is_regular_ = ::fstat(file_.number(), &status) == 0 && S_ISREG(status.st_mode);
  return {};
}

base::Result<void> FileSide::run() {
  if (file_) took(writer_.finish());
  accepted_bytes_ = written_bytes_;
  link_.phase.store(DriveLink::Phase::ready, std::memory_order_release);
  for (DriveLink::Order wanted = DriveLink::Order::follow; wanted == DriveLink::Order::follow;) {
    realtime::sleep_until(realtime::now() + nap);
    link_.beats.fetch_add(1, std::memory_order_relaxed);
    wanted = gave_up_ || is_orphan() ? DriveLink::Order::abandon : order();
    if (wanted == DriveLink::Order::abandon) link_.words.leave();
    if (file_ && !failed_ && !gave_up_) take_words();
  }
  return conclude({});
}

/// What has come, as a whole or not at all.
void FileSide::take_words() {
  std::vector<base::Word> words;
  base::Result<void> written;
  for (base::Word word; written && link_.words.pop(word); words.push_back(word)) written = writer_.write(word);
  if (words.empty()) return;
  if (written) written = writer_.finish();
  if (!written) {
    // A row that was begun is no row.
    if (is_regular_) static_cast<void>(::ftruncate(file_.number(), accepted_bytes_));
    if (!gave_up_) took(written);
    return;
  }
  accepted_bytes_ = written_bytes_;
  last_ = words.back();
  link_.taken.fetch_add(static_cast<std::int64_t>(words.size()), std::memory_order_release);
  for (const base::Word& word : words) link_.feedback.push({.word = word, .actual = word.position});
  keeper_.observe(last_, {last_.position, last_.path_length});
}

base::Result<void> FileSide::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_.number(), bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
      written_bytes_ += written;
      progress_ = realtime::now();
      continue;
    }
    const int error = errno;
    if (error != EAGAIN && error != EINTR)
      return base::failure(system_failure(error == EPIPE ? "io-pipe" : "io-write", "cannot write", path_, error));
    if (!waits()) return base::failure(system_failure("io-pipe", "cannot write", path_, EAGAIN));
  }
  return {};
}

/// For a reader, a moment. False if nobody wants that any longer.
bool FileSide::waits() {
  realtime::sleep_until(realtime::now() + nap);
  link_.beats.fetch_add(1, std::memory_order_relaxed);
  const bool is_left = is_orphan() && realtime::now() - progress_ > longest_for_none;
  gave_up_ = is_left || order() == DriveLink::Order::abandon;
  return !gave_up_;
}

}  // namespace leadscrew::cli
