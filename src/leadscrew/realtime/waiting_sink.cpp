#include <leadscrew/realtime/schedule.hpp>
#include <leadscrew/realtime/waiting_sink.hpp>
#include <utility>

namespace leadscrew::realtime {

namespace {

constexpr std::int64_t nap = 1'000'000;  // ns, of a thread that has handed over all there is

}  // namespace

WaitingSink::WaitingSink(std::function<bool(const base::Word&)> take)
    : take_(std::move(take)), thread_([this] { hand_over(); }) {}

WordSink WaitingSink::sink() {
  // Refused, it takes what it will not keep: publish() is asked behind words that were taken.
  return {.take = [this](const base::Word& word) { return is_refused() || kept_->push(word); },
          .lead_on = {},
          .publish = [this] { return !is_refused(); }};
}

void WaitingSink::end() {
  ended_.store(true, std::memory_order_release);
  if (thread_.joinable()) thread_.join();
}

void WaitingSink::hand_over() {
  while (true) {
    const bool is_last_look = ended_.load(std::memory_order_acquire);
    for (base::Word word; !is_refused() && kept_->pop(word);) {
      if (take_(word)) {
        taken_.fetch_add(1, std::memory_order_release);
      } else {
        refused_.store(true, std::memory_order_release);
      }
    }
    if (is_last_look || is_refused()) return;
    sleep_until(now() + nap);
  }
}

}  // namespace leadscrew::realtime
