#pragma once
// A sink for words that go where the cyclic thread may not wait: to a file, over a network. They are kept until a
// thread of their own has handed them over, and their events before them.

#include <atomic>
#include <functional>
#include <leadscrew/base/word.hpp>
#include <leadscrew/realtime/ring.hpp>
#include <leadscrew/realtime/runner.hpp>
#include <memory>
#include <optional>
#include <thread>

namespace leadscrew::realtime {

/// Keeps at most 65536 words and 16384 events: who takes them must be that near. A sink that is full makes the schedule give way, as
/// any other (Counters::slips): no word is lost.
class WaitingSink {
 public:
  /// `take` may wait as long as it likes; false if it takes no more words: then motion ends. Called in the order of
  /// words by one thread, that of this sink, until end() returns.
  /// `take_event`, likewise: the events of the word that `take` is called with next; absent: they are passed over.
  explicit WaitingSink(std::function<bool(const base::Word&)> take,
                       std::function<bool(const base::PassedEvent&)> take_event = {});
  ~WaitingSink() { end(); }
  WaitingSink(const WaitingSink&) = delete;
  WaitingSink& operator=(const WaitingSink&) = delete;

  /// For a runner that ends before this does. Neither allocates nor locks; needs no stop path.
  WordSink sink();
  /// Hands over what is kept. The runner has ended.
  void end();

  /// Words handed over.
  std::int64_t taken() const { return taken_.load(std::memory_order_acquire); }
  /// Does nobody take words any more?
  bool is_refused() const { return refused_.load(std::memory_order_acquire); }

 private:
  static constexpr std::size_t most_words = 1 << 16, most_events = 1 << 14;

  void hand_over();
  bool hand_over_events(const base::Word& word);

  std::function<bool(const base::Word&)> take_;
  std::function<bool(const base::PassedEvent&)> take_event_;
  std::unique_ptr<Ring<base::Word, most_words>> kept_ = std::make_unique<Ring<base::Word, most_words>>();
  std::unique_ptr<Ring<base::PassedEvent, most_events>> kept_events_ =
      std::make_unique<Ring<base::PassedEvent, most_events>>();
  std::optional<base::PassedEvent> next_event_;  ///< of a word to come; the thread's
  std::atomic<bool> ended_{false}, refused_{false};
  std::atomic<std::int64_t> taken_{0};
  std::thread thread_;
};

}  // namespace leadscrew::realtime
