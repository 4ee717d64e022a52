#include <leadscrew/realtime/schedule.hpp>
#include <leadscrew/realtime/waiting_sink.hpp>
#include <utility>

namespace leadscrew::realtime {

namespace {

constexpr std::int64_t nap = 1'000'000;  // ns, of a thread that has handed over all there is

}  // namespace

WaitingSink::WaitingSink(std::function<bool(const base::Word&)> take,
                         std::function<bool(const base::PassedEvent&)> take_event)
    : take_(std::move(take)), take_event_(std::move(take_event)), thread_([this] { hand_over(); }) {}

WordSink WaitingSink::sink() {
  // Refused, it takes what it will not keep: publish() is asked behind words that were taken.
  WordSink sink = {.take = [this](const base::Word& word) { return is_refused() || kept_->push(word); },
                   .append_stop_position = {},
                   .publish = [this] { return !is_refused(); }};
  if (take_event_)
    sink.event = [this](const base::PassedEvent& event) { return is_refused() || kept_events_->push(event); };
  return sink;
}

void WaitingSink::end() {
  ended_.store(true, std::memory_order_release);
  if (thread_.joinable()) thread_.join();
}

void WaitingSink::hand_over() {
  while (true) {
    const bool is_last_look = ended_.load(std::memory_order_acquire);
    for (base::Word word; !is_refused() && kept_->pop(word);) {
      if (hand_over_events(word) && take_(word)) {
        taken_.fetch_add(1, std::memory_order_release);
      } else {
        refused_.store(true, std::memory_order_release);
      }
    }
    if (is_last_look || is_refused()) return;
    sleep_until(now() + nap);
  }
}

/// Those that happened by then: they were kept before the word was. False if they are not taken.
bool WaitingSink::hand_over_events(const base::Word& word) {
  while (true) {
    if (!next_event_ && !kept_events_->pop(next_event_.emplace())) next_event_.reset();
    if (!next_event_ || next_event_->tick > word.tick) return true;
    if (!take_event_(*next_event_)) return false;
    next_event_.reset();
  }
}

}  // namespace leadscrew::realtime
