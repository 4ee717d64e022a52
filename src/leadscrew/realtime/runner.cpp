#include <algorithm>
#include <leadscrew/realtime/runner.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <utility>

namespace leadscrew::realtime {

namespace {

constexpr std::int64_t nap = 500'000;  // ns, of a planner that has planned enough
constexpr std::size_t fewest_chunks = 64;
constexpr double short_chunk = 5e-3;  // s; most are longer

std::size_t chunks_within(double look_ahead) {
  return std::max(fewest_chunks, static_cast<std::size_t>(look_ahead / short_chunk));
}

void add(std::atomic<std::int64_t>& counter, std::int64_t count) noexcept {
  counter.store(counter.load(std::memory_order_relaxed) + count, std::memory_order_relaxed);
}

}  // namespace

Runner::Runner(const RunnerOptions& options, Planning planning, WordSink sink)
    : options_(options),
      planning_(std::move(planning)),
      sink_(std::move(sink)),
      controller_(options.period, options.position, chunks_within(std::max(options.look_ahead, Feeder::farthest)),
                  options.path_length, options.line),
      feeder_(planning_, controller_, options.look_ahead, options.least_look_ahead.value_or(options.look_ahead)) {
  if (options_.spindle) controller_.follow(*options_.spindle);
}

Runner::~Runner() {
  halt();
  if (planner_thread_.joinable()) planner_thread_.join();
  if (cyclic_thread_.joinable()) cyclic_thread_.join();
}

void Runner::start() {
  planner_thread_ = std::thread([this] { plan(); });
}

void Runner::override_feed(double factor) {
  asked_.store(std::clamp(factor, 0.0, 2.0), std::memory_order_relaxed);
}

void Runner::stop() {
  stop_asked_.store(true, std::memory_order_relaxed);
}

void Runner::halt() {
  halted_.store(true, std::memory_order_release);
}

Counters Runner::counters() const {
  Counters counters;
  counters.words = words_.load(std::memory_order_acquire);
  counters.overruns = overruns_.load(std::memory_order_relaxed);
  counters.slips = slips_.load(std::memory_order_relaxed);
  counters.late_chunks = late_chunks_.load(std::memory_order_relaxed);
  counters.starvations = controller_.starvations();
  counters.in_step = controller_.is_in_step();
  counters.threads = controller_.threads();
  counters.seconds_ahead = seconds_ahead_.load(std::memory_order_relaxed);
  counters.override_factor = asked_.load(std::memory_order_relaxed);
  counters.allowed_overrides = allowed_overrides_.load(std::memory_order_relaxed);
  counters.ended = has_ended();
  counters.too_long_to_rest = too_long_to_rest_.load(std::memory_order_acquire);
  return counters;
}

// The planner's thread.

void Runner::plan() {
  while (!halted_.load(std::memory_order_acquire) && !has_ended()) {
    feeder_.request(asked_.load(std::memory_order_relaxed), stop_asked_.load(std::memory_order_relaxed));
    feeder_.cycle_was_late(1e-9 * static_cast<double>(latencies_.longest()));
    const bool has_gone_on = feeder_.step();
    if (feeder_.last_chunk()) last_chunk_.store(*feeder_.last_chunk(), std::memory_order_release);
    late_chunks_.store(feeder_.late_chunks(), std::memory_order_relaxed);
    seconds_ahead_.store(controller_.seconds_ahead(), std::memory_order_relaxed);
    if (has_gone_on) continue;
    if (!begun_.load(std::memory_order_relaxed)) {
      begun_.store(true, std::memory_order_release);
      cyclic_thread_ = std::thread([this] { cycle(); });
    }
    sleep_until(now() + nap);
  }
}

// The cyclic thread.

void Runner::cycle() {
  notice_ = become_real_time();
  const std::int64_t period = options_.period.nanoseconds;
  std::int64_t origin = now();  // when the first word is due at the sink's end, less the lead
  for (std::int64_t wake = origin; !halted_.load(std::memory_order_acquire); wake += period) {
    sleep_until(wake);
    const std::int64_t time = now();
    latencies_.observe(time - wake);
    const std::int64_t passed = (time - origin) / period;
    add(overruns_, passed - (wake - origin) / period);
    wake = origin + passed * period;
    if (!make_due(passed + 1 + options_.lead)) break;
    if (!waiting_) continue;
    // No room: the schedule gives way.
    const std::int64_t slip = std::max<std::int64_t>(0, passed + 1 + options_.lead - taken_);
    origin += slip * period;
    add(slips_, slip);
  }
  ended_.store(true, std::memory_order_release);
}

/// Makes words until so many have been published, or the sink has no room. False when the last has been, or nobody
/// wants more.
bool Runner::make_due(std::int64_t due) noexcept {
  while (published_ < due) {
    if (!waiting_) {
      if (stop_asked_.load(std::memory_order_relaxed)) controller_.leave_step();
      waiting_ = controller_.next();
      event_ = controller_.next_event();
    }
    if (!take_events() || !sink_.take(*waiting_)) return true;
    ++taken_;
    const bool rests = waiting_->state == base::MotionState::rest;
    if ((rests || taken_ - published_ >= options_.slice) && !publish()) return false;
    waiting_.reset();
    if (is_last()) return false;
  }
  return true;
}

/// Those of the word that waits go before it. False if there is no room.
bool Runner::take_events() noexcept {
  for (; event_ != nullptr; event_ = controller_.next_event()) {
    if (sink_.event && !sink_.event(planner::passed_at(waiting_->tick, *event_))) return false;
    passed_overrides_.pass(*event_);
    allowed_overrides_.store(passed_overrides_, std::memory_order_relaxed);
  }
  return true;
}

/// The words so far, and the stop path behind the one that waits.
bool Runner::publish() noexcept {
  interpolator::Interpolator onward = controller_.onward();
  for (base::MotionState state = waiting_->state; sink_.append_stop_position && state != base::MotionState::rest;) {
    const base::Word word = onward.next();
    state = word.state;
    if (sink_.append_stop_position({word.position, word.path_length})) continue;
    too_long_to_rest_.store(true, std::memory_order_release);
    return false;
  }
  if (sink_.publish && !sink_.publish()) return false;
  published_ = taken_;
  words_.store(published_, std::memory_order_release);
  return true;
}

/// The first word at rest behind all motion.
bool Runner::is_last() const noexcept {
  if (controller_.has_left_step()) return controller_.stands();
  const std::int64_t last = last_chunk_.load(std::memory_order_acquire);
  return last >= 0 && controller_.begun() == last && controller_.stands();
}

}  // namespace leadscrew::realtime
