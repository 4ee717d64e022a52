#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <leadscrew/drive/drive_side.hpp>
#include <leadscrew/drive/file_side.hpp>
#include <leadscrew/drive/slides.hpp>
#include <leadscrew/drive/tip_motions.hpp>
#include <leadscrew/drive/word_side.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <leadscrew/servo/machine_loops.hpp>

namespace leadscrew::drive {

namespace {

using Order = Link::Order;
using Phase = Link::Phase;

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

class DriveSide : public WordSide {
 public:
  DriveSide(Link& link, const Setup& setup, const State& begin)
      : WordSide(link, setup, begin),
        program_(begin.program),
        period_(setup.machine.period),
        machine_(setup.machine),
        axes_(begin.axes),
        servo_(*servo::Servo::create(servo::loops_of(setup.machine), period_)),
        tracking_(setup.machine.axis_set(), period_) {}

  base::Result<void> open(const Setup& setup) {
    const Options& options = setup.options;
    if (auto opened = open_events(setup); !opened) return opened;
    if (options.trace) {
      if (auto opened = trace_file_.open(*options.trace, program_, setup.machine, columns_of(setup.machine)); !opened)
        return opened;
    }
    if (options.axes) return axes_file_.open(*options.axes, program_, setup.machine);
    return {};
  }

  base::Result<void> run(const std::vector<base::PathPlace>& return_path) {
    wake_ = realtime::now();
    go(return_path);
    link_.phase.store(Phase::ready, std::memory_order_release);
    while (period()) wait();
    link_.concluding.store(true, std::memory_order_release);
    let_slides_settle();
    return conclude(std::array{&trace_file_, &axes_file_});
  }

 private:
  /// To where the first word will be; called off, to where the return path rests next.
  void go(const std::vector<base::PathPlace>& return_path) {
    took(observe());
    for (const base::PathPlace& place : return_path) {
      if (axes_.at_rest() && is_called_off()) return;
      follow(place);
      wait();
      took(observe());
    }
    while (!axes_.at_rest()) follow(axes_.place());
  }
  bool is_called_off() const { return is_orphan() || order() == Order::abandon; }

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
    const Order wanted = order();
    if (wanted == Order::abandon) link_.words.leave();
    if (take_word()) return true;
    // At rest nothing depends on the next word: there may be none, or the first may be still to come.
    const bool stands = last_.state == base::MotionState::rest || link_.taken.load(std::memory_order_relaxed) == 0;
    if (stands && !link_.words.has_left()) {
      if (wanted == Order::end) return false;
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
    for (const base::PassedEvent& event : take_events(word)) trace_file_.observe(event);
    follow({word.position, word.path_length});
    took(write_word(word));
    took(write_events());
    took(observe());
    link_.taken.fetch_add(1, std::memory_order_release);
    return true;
  }

  base::Result<void> write_word(const base::Word& word) {
    const auto pose = poses_.of(word);
    return trace_file_.write(word, {.pose = pose ? pose->numbers() : std::array<double, 6>{}});
  }

  /// Words have ceased; false where the way to rest has ended.
  bool come_to_rest() {
    base::PathPlace next = axes_.place();
    if (!link_.words.follow_stop_path(next) && axes_.at_rest()) return false;
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
    took(servo::check_followed(*followed, machine_));
    // Of the word before the last; motion rests where another tool, or none, is what feed is counted by.
    tracking_.observe(*followed, tip_motions_.next(poses_, *followed));
    Feedback feedback{last_, followed->position, tracking_.measured_feed(), 0, poses_.tool()};
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

  base::Result<void> observe() {
    base::Word word = last_;
    word.tick = base::Tick{periods_++};
    word.position = axes_.place().position;
    state_writer_.observe(last_, axes_.place(), tool_state_of(poses_, axes_.place().position));
    return axes_file_.write(word);
  }

  const std::string program_;  ///< its name
  const base::Period period_;
  const machine::Machine& machine_;
  Axes axes_;
  servo::Servo servo_;
  servo::Tracking tracking_;
  TipMotions tip_motions_;
  files::WordFile trace_file_, axes_file_;
  std::int64_t periods_ = 0, led_ = 0, wake_ = 0;
};

/// Opens its files, and takes words until there are no more.
template <class Side, class... ReturnPath>
void run(Side& side, Link& link, const Setup& setup, const ReturnPath&... return_path) {
  base::Result<void> done = side.open(setup);
  if (done) {
    done = side.run(return_path...);
  } else {
    side.give_up();
  }
  if (!done) link.fail(done.error());
}

}  // namespace

void run_drives(Link& link, const Setup& setup, Beginning& begin) {
  // A terminal sends ^C to both processes. What to do about it is the other's matter.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) std::signal(signal, SIG_IGN);
  if (setup.options.sink) {
    FileSide side(link, setup, begin.state);
    run(side, link, setup);
  } else {
    DriveSide side(link, setup, begin.state);  // with the thread that writes states, which has no deadline
    // What is not permitted, the command says of itself.
    static_cast<void>(realtime::become_real_time());
    run(side, link, setup, begin.return_path);
  }
  if (link.is_orphan()) {
    for (StateLock& lock : begin.held) lock.remove_file();
  }
}

}  // namespace leadscrew::drive
