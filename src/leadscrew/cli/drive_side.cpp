#include <csignal>
#include <leadscrew/cli/drive_side.hpp>
#include <leadscrew/cli/terminal.hpp>
#include <leadscrew/cli/word_file.hpp>
#include <leadscrew/realtime/drives.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <mutex>
#include <thread>

namespace leadscrew::cli {

namespace {

using Order = DriveLink::Order;
using Phase = DriveLink::Phase;

constexpr std::int64_t state_interval = 100'000'000;  // ns between two states on disk

/// Writes states in a thread of its own: the drives do not wait for a disk.
class StateKeeper {
 public:
  StateKeeper(std::optional<std::string> path, const DriveState& state) : path_(std::move(path)), state_(state) {
    if (path_) thread_ = std::thread([this] { keep(); });
  }
  ~StateKeeper() { end(); }

  void observe(const base::Word& word, const base::AxisVector& axes) {
    const std::lock_guard lock(mutex_);
    state_.word = word;
    state_.axes = axes;
    changed_ = true;
  }

  /// The last state, when all stands still.
  base::Result<void> conclude(DriveState::Kind kind) {
    end();
    state_.kind = kind;
    if (!path_) return {};
    return write_state(*path_, state_);
  }

 private:
  void keep() {
    while (!ended_.load()) {
      DriveState state;
      bool changed = false;
      {
        const std::lock_guard lock(mutex_);
        state = state_;
        changed = std::exchange(changed_, false);
      }
      // The last state says whether this can be done.
      if (changed) static_cast<void>(write_state(*path_, state));
      realtime::sleep_until(realtime::now() + state_interval);
    }
  }
  void end() {
    ended_.store(true);
    if (thread_.joinable()) thread_.join();
  }

  std::optional<std::string> path_;
  DriveState state_;
  bool changed_ = false;
  std::mutex mutex_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

class DriveSide {
 public:
  DriveSide(DriveLink& link, const Job& job, const DriveState& begin)
      : link_(link),
        period_(job.machine.period),
        drives_(job.machine, period_, begin.axes),
        keeper_(job.arguments.drive.state, begin),
        last_(begin.word) {}

  base::Result<void> open(const Job& job) {
    const DriveArguments& arguments = job.arguments.drive;
    if (arguments.trace) {
      if (auto opened = trace_.open(*arguments.trace, job.machine); !opened) return opened;
    }
    if (arguments.axes) return axes_.open(*arguments.axes, job.machine);
    return {};
  }

  base::Result<void> run(double feed) {
    wake_ = realtime::now();
    approach(feed);
    link_.phase.store(Phase::ready, std::memory_order_release);
    while (period()) wait();
    return conclude();
  }
  /// Nothing moves: a file that was asked for cannot be opened, and that is what is told.
  void give_up() { static_cast<void>(keeper_.conclude(DriveState::Kind::stopped)); }

 private:
  /// From where the axes stand to where the first word will be; called off, they stand somewhere on the way.
  void approach(double feed) {
    const base::AxisVector target = last_.position;
    took(observe());
    for (;; wait()) {
      if (is_called_off() && drives_.at_rest()) return;
      if (is_called_off()) drives_.call_off();
      if (drives_.approach(target, feed)) return;
      took(observe());
    }
  }
  bool is_called_off() const { return failed_ || is_orphan() || link_.order.load() == Order::abandon; }

  /// The drives' own clock: what this process is late by is time that stood still for them.
  void wait() {
    wake_ += period_.nanoseconds;
    realtime::sleep_until(wake_);
    const std::int64_t late = (realtime::now() - wake_) / period_.nanoseconds;
    wake_ += late * period_.nanoseconds;
    link_.late_periods.fetch_add(late, std::memory_order_relaxed);
  }

  /// One period; false when all is over. What cannot be written down is not done: then no more words are accepted.
  bool period() {
    const Order order = failed_ ? Order::abandon : link_.order.load(std::memory_order_acquire);
    if (order == Order::abandon) link_.words.leave();
    if (take_word()) return true;
    // At rest nothing depends on the next word: there may be none, or the first may be still to come.
    const bool stands = last_.state == base::MotionState::rest || link_.taken.load(std::memory_order_relaxed) == 0;
    if (stands && !link_.words.has_left()) {
      if (order == Order::end) return false;
      if (!is_orphan()) {
        drives_.follow(drives_.position());
        return true;
      }
    }
    return link_.words.leave_if_empty() ? come_to_rest() : take_word();
  }

  bool take_word() {
    base::Word word;
    if (!link_.words.pop(word)) return false;
    last_ = word;
    drives_.follow(word.position);
    took(trace_.write(word));
    took(observe());
    link_.taken.fetch_add(1, std::memory_order_release);
    return true;
  }

  /// Words have ceased; false where the way to rest has ended.
  bool come_to_rest() {
    base::AxisVector next = drives_.position();
    if (!link_.words.follow_way(next) && drives_.at_rest()) return false;
    drives_.follow(next);
    link_.braked.fetch_add(1, std::memory_order_relaxed);
    took(observe());
    return true;
  }

  /// Nobody will send the first word.
  bool is_orphan() const { return ::getppid() != parent_; }

  base::Result<void> observe() {
    base::Word word = last_;
    word.tick = base::Tick{periods_++};
    word.position = drives_.position();
    keeper_.observe(last_, word.position);
    link_.feedback.push({last_, word.position});
    return axes_.write(word);
  }

  void took(const base::Result<void>& result) {
    if (!result && !failed_) failed_ = result.error();
  }

  /// Files first: who sees the last state finds them. One that could not be written takes no other with it.
  base::Result<void> conclude() {
    for (WordFile* file : {&trace_, &axes_}) took(file->publish());
    if (is_orphan() && link_.has_terminal.load(std::memory_order_acquire)) Terminal::restore(link_.terminal);
    const bool has_left = link_.words.has_left();
    const bool ended = !has_left && last_is_end();
    took(keeper_.conclude(ended ? DriveState::Kind::ended : DriveState::Kind::stopped));
    if (failed_) return base::failure(*failed_);
    link_.phase.store(has_left ? Phase::tripped : Phase::ended, std::memory_order_release);
    return {};
  }
  bool last_is_end() const { return link_.at_end.load(std::memory_order_acquire); }

  DriveLink& link_;
  base::Period period_;
  realtime::Drives drives_;
  StateKeeper keeper_;
  WordFile trace_, axes_;
  base::Word last_;  ///< taken
  std::int64_t periods_ = 0, wake_ = 0;
  std::optional<base::Diagnostic> failed_;
  const pid_t parent_ = ::getppid();
};

}  // namespace

void run_drives(DriveLink& link, const Job& job, const DriveState& begin, double feed) {
  // A terminal sends ^C to both processes. What to do about it is the other's matter.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  DriveSide side(link, job, begin);  // with the thread that writes states, which is no hurry of anybody's
  // What is not permitted, the command says of itself.
  static_cast<void>(realtime::become_real_time());
  base::Result<void> done = side.open(job);
  if (done) {
    done = side.run(feed);
  } else {
    side.give_up();
  }
  if (!done) link.fail(done.error());
}

}  // namespace leadscrew::cli
