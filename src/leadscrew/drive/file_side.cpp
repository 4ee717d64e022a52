#include <poll.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <leadscrew/drive/file_side.hpp>
#include <leadscrew/files/output_file.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <vector>

namespace leadscrew::drive {

namespace {

constexpr std::int64_t nap = 1'000'000;                // ns between two looks for words, or for space
constexpr std::int64_t sink_patience = 3'000'000'000;  // ns without progress, when motion is to end or nobody sends
constexpr std::size_t most_at_once = 4096;             // bytes, for which a pipe that is ready has space

}  // namespace

FileSide::FileSide(Link& link, const Setup& setup, const State& begin)
    : WordSide(link, setup, begin),
      path_(*setup.options.sink),
      writer_([this](std::string_view bytes) { return write(bytes); }, setup.machine.axis_set(), setup.machine.period,
              columns_of(setup.machine)),
      progress_(realtime::now()) {
  if (setup.machine.laser) laser_.emplace(*setup.machine.laser);
}

base::Result<void> FileSide::open(const Setup& setup) {
  if (auto opened = open_events(setup); !opened) return opened;
  if (auto made = files::make_folder_of(path_); !made) return made;
  // A pipe without a reader cannot be opened so: ENXIO.
  constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC | O_NONBLOCK | O_CLOEXEC;
  struct stat status = {};
  while (true) {
    file_ =
        files::Descriptor(files::is_standard_output(path_) ? ::dup(STDOUT_FILENO) : ::open(path_.c_str(), flags, 0666));
    if (file_) break;
    const int error = errno;
    const bool is_pipe = ::stat(path_.c_str(), &status) == 0 && S_ISFIFO(status.st_mode);
    if (error != EINTR && !(error == ENXIO && is_pipe))
      return base::failure(files::system_failure("io-open", "cannot write", path_, error));
    if (!waits()) return {};
  }
  is_regular_ = !files::is_standard_output(path_) && ::fstat(file_.number(), &status) == 0 && S_ISREG(status.st_mode);
  return {};
}

base::Result<void> FileSide::run() {
  if (file_) took(writer_.finish());
  accepted_bytes_ = written_bytes_;
  link_.phase.store(Link::Phase::ready, std::memory_order_release);
  for (Link::Order wanted = Link::Order::follow; wanted == Link::Order::follow;) {
    realtime::sleep_until(realtime::now() + nap);
    link_.beats.fetch_add(1, std::memory_order_relaxed);
    wanted = gave_up_ || is_orphan() ? Link::Order::abandon : order();
    if (wanted == Link::Order::abandon) link_.words.leave();
    if (file_ && !failed_ && !gave_up_) take_words();
  }
  return conclude({});
}

/// What has come, as a whole or not at all.
void FileSide::take_words() {
  std::vector<base::Word> words;
  base::Result<void> written;
  for (base::Word word; written && link_.words.pop(word); words.push_back(word)) {
    for (const base::PassedEvent& event : take_events(word)) {
      if (laser_) laser_->observe(event);
    }
    trace::BesideWord beside{.power = laser_ ? laser_->at(word) : 0};
    if (const auto pose = poses_.of(word)) beside.pose = pose->numbers();
    written = writer_.write(word, beside);
  }
  if (words.empty()) return;
  if (written) written = writer_.finish();
  if (!written) {
    // An incomplete row is cut off. If that fails, the failure to write that led here is reported all the same.
    [[maybe_unused]] const int cut = is_regular_ ? ::ftruncate(file_.number(), accepted_bytes_) : 0;
    if (!gave_up_) took(written);
    return;
  }
  accepted_bytes_ = written_bytes_;
  last_ = words.back();
  took(write_events());
  link_.taken.fetch_add(static_cast<std::int64_t>(words.size()), std::memory_order_release);
  for (const base::Word& word : words)
    link_.feedback.push({.word = word, .actual = word.position, .tool = poses_.tool()});
  state_writer_.observe(last_, {last_.position, last_.path_length}, tool_state_of(poses_, last_.position));
}

base::Result<void> FileSide::write(std::string_view bytes) {
  while (!bytes.empty()) {
    pollfd ready = {file_.number(), POLLOUT, 0};
    const bool has_space = ::poll(&ready, 1, 0) != 0;
    const ssize_t written =
        has_space ? ::write(file_.number(), bytes.data(), std::min(bytes.size(), most_at_once)) : -1;
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
      written_bytes_ += written;
      progress_ = realtime::now();
      continue;
    }
    const int error = has_space ? errno : EAGAIN;
    if (error != EAGAIN && error != EINTR)
      return base::failure(
          files::system_failure(error == EPIPE ? "io-pipe" : "io-write", "cannot write", path_, error));
    if (!waits()) return base::failure(files::system_failure("io-pipe", "cannot write", path_, EAGAIN));
  }
  return {};
}

/// For a reader, a moment. False if nobody wants that any longer.
bool FileSide::waits() {
  realtime::sleep_until(realtime::now() + nap);
  link_.beats.fetch_add(1, std::memory_order_relaxed);
  const bool is_to_end = is_orphan() || link_.stopping.load(std::memory_order_relaxed);
  gave_up_ = (is_to_end && realtime::now() - progress_ > sink_patience) || order() == Link::Order::abandon;
  return !gave_up_;
}

}  // namespace leadscrew::drive
