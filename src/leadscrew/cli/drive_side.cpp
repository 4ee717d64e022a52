#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <leadscrew/cli/drive_side.hpp>
#include <leadscrew/cli/slides.hpp>
#include <leadscrew/cli/terminal.hpp>
#include <leadscrew/cli/word_file.hpp>
#include <leadscrew/realtime/latest.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <leadscrew/servo/machine_loops.hpp>
#include <thread>

namespace leadscrew::cli {

namespace {

using Order = DriveLink::Order;
using Phase = DriveLink::Phase;

constexpr std::int64_t state_interval = 100'000'000;  // ns between two states on disk

/// The axes, as they are told: one call a period.
class Axes {
 public:
  /// They stand there.
  explicit Axes(const base::PathPlace& place) : place_(place) {}

  void follow(const base::PathPlace& place) {
    const bool stayed = place.position == place_.position;
    rest_ = stayed && stayed_;
    stayed_ = stayed;
    place_ = place;
  }
  const base::PathPlace& place() const { return place_; }
  /// With neither speed nor acceleration.
  bool at_rest() const { return rest_; }

 private:
  base::PathPlace place_;
  bool stayed_ = true, rest_ = true;
};

/// Writes states in a thread of its own: the drives do not wait for a disk.
class StateKeeper {
 public:
  StateKeeper(std::optional<std::string> path, const DriveState& state) : path_(std::move(path)), state_(state) {
    if (path_) thread_ = std::thread([this] { keep(); });
  }
  ~StateKeeper() { end(); }

  void observe(const base::Word& word, const base::PathPlace& axes) { seen_.put({word, axes}); }

  /// The last state, when all stands still.
  base::Result<void> conclude(DriveState::Kind kind) {
    end();
    static_cast<void>(take_seen());
    state_.kind = kind;
    if (!path_) return {};
    return write_state(*path_, state_);
  }

 private:
  struct Seen {
    base::Word word;
    base::PathPlace axes;
  };

  void keep() {
    while (!ended_.load()) {
      // The last state says whether this can be done.
      if (take_seen()) static_cast<void>(write_state(*path_, state_));
      realtime::sleep_until(realtime::now() + state_interval);
    }
  }
  bool take_seen() {
    Seen seen;
    if (!seen_.take(seen)) return false;
    state_.kind = DriveState::Kind::moving;
    state_.word = seen.word;
    state_.axes = seen.axes;
    return true;
  }
  void end() {
    ended_.store(true);
    if (thread_.joinable()) thread_.join();
  }

  std::optional<std::string> path_;
  DriveState state_;  ///< its thread's, while there is one
  realtime::Latest<Seen> seen_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

class DriveSide {
 public:
  DriveSide(DriveLink& link, const Job& job, const DriveState& begin)
      : link_(link),
        period_(job.machine.period),
        machine_(job.machine),
        axes_(begin.axes),
        servo_(*servo::Servo::create(servo::loops_of(job.machine), period_)),
        tracking_(job.machine.axis_set()),
        keeper_(job.arguments.drive.state, begin),
        last_(begin.word) {}

  base::Result<void> open(const Job& job) {
    const DriveArguments& arguments = job.arguments.drive;
    if (arguments.trace) {
      if (auto opened = trace_file_.open(*arguments.trace, job.machine); !opened) return opened;
    }
    if (arguments.axes) return axes_file_.open(*arguments.axes, job.machine);
    return {};
  }

  base::Result<void> run(const std::vector<base::PathPlace>& way_back) {
    wake_ = realtime::now();
    go(way_back);
    link_.phase.store(Phase::ready, std::memory_order_release);
    while (period()) wait();
    return conclude();
  }
  /// Nothing moves: a file that was asked for cannot be opened, and that is what is told.
  void give_up() { static_cast<void>(keeper_.conclude(DriveState::Kind::stopped)); }

 private:
  /// To where the first word will be; called off, to where the way rests next.
  void go(const std::vector<base::PathPlace>& way_back) {
    took(observe());
    for (const base::PathPlace& place : way_back) {
      if (axes_.at_rest() && is_called_off()) return;
      follow(place);
      wait();
      took(observe());
    }
    while (!axes_.at_rest()) follow(axes_.place());
  }
  bool is_called_off() const { return failed_ || is_orphan() || link_.order.load() == Order::abandon; }

  /// The drives' own clock: what this process is late by is time that stood still for them.
  void wait() {
    link_.beats.fetch_add(1, std::memory_order_relaxed);
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
        follow(axes_.place());
        return true;
      }
    }
    return link_.words.leave_if_empty() ? come_to_rest() : take_word();
  }

  bool take_word() {
    base::Word word;
    if (!link_.words.pop(word)) return false;
    last_ = word;
    follow({word.position, word.path_length});
    took(trace_file_.write(word));
    took(observe());
    link_.taken.fetch_add(1, std::memory_order_release);
    return true;
  }

  /// Words have ceased; false where the way to rest has ended.
  bool come_to_rest() {
    base::PathPlace next = axes_.place();
    if (!link_.words.follow_way(next) && axes_.at_rest()) return false;
    follow(next);
    link_.braked.fetch_add(1, std::memory_order_relaxed);
    took(observe());
    return true;
  }

  /// A period: axes are led there, and slides follow.
  void follow(const base::PathPlace& place) {
    axes_.follow(place);
    base::Word word = last_;
    word.tick = base::Tick{led_++};
    word.position = place.position;
    const std::optional<servo::Followed> followed = servo_.follow(word);
    if (!followed) return;
    took(check_followed(*followed, machine_));
    tracking_.observe(*followed);
    Feedback feedback{last_, followed->position, tracking_.measured_feed()};
    for (std::size_t i = 0; i < followed->position.size(); ++i)
      feedback.following_error =
          std::max(feedback.following_error, std::abs(followed->word.position[i] - followed->position[i]));
    link_.feedback.push(feedback);
  }
  /// Where they overshoot, they do so now.
  void let_slides_settle() {
    constexpr double settling = 0.1;  // s
    for (double left = settling / period_.seconds(); left > 0; --left) follow(axes_.place());
    for (const base::Axis axis : base::all_axes) {
      if (machine_.has(axis)) link_.slides.axes[base::index(axis)] = tracking_.axis(axis);
    }
    link_.slides.feed = tracking_.feed();
  }

  /// Nobody will send the first word.
  bool is_orphan() const { return ::getppid() != parent_; }

  base::Result<void> observe() {
    base::Word word = last_;
    word.tick = base::Tick{periods_++};
    word.position = axes_.place().position;
    keeper_.observe(last_, axes_.place());
    return axes_file_.write(word);
  }

  void took(const base::Result<void>& result) {
    if (!result && !failed_) failed_ = result.error();
  }

  /// Files first: who sees the last state finds them. One that could not be written takes no other with it.
  base::Result<void> conclude() {
    link_.concluding.store(true, std::memory_order_release);
    let_slides_settle();
    for (WordFile* file : {&trace_file_, &axes_file_}) took(file->publish());
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
  const base::Period period_;
  const machine::Machine& machine_;
  Axes axes_;
  servo::Servo servo_;
  servo::Tracking tracking_;
  StateKeeper keeper_;
  WordFile trace_file_, axes_file_;
  base::Word last_;  ///< taken
  std::int64_t periods_ = 0, led_ = 0, wake_ = 0;
  std::optional<base::Diagnostic> failed_;
  const pid_t parent_ = ::getppid();
};

}  // namespace

void run_drives(DriveLink& link, const Job& job, const DriveState& begin,
                const std::vector<base::PathPlace>& way_back) {
  // A terminal sends ^C to both processes. What to do about it is the other's matter.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  DriveSide side(link, job, begin);  // with the thread that writes states, which is no hurry of anybody's
  // What is not permitted, the command says of itself.
  static_cast<void>(realtime::become_real_time());
  base::Result<void> done = side.open(job);
  if (done) {
    done = side.run(way_back);
  } else {
    side.give_up();
  }
  if (!done) link.fail(done.error());
}

}  // namespace leadscrew::cli
