// What the cyclic thread of a runner calls from its first word to its last, but for the clock that it sleeps by: words
// in slices with the way to rest behind each, into a stream that another thread empties.
//
//   cycle_on_time            along lines, arcs and NURBS curves, through changes of chunk and starvations
//   cycle_on_time sabotage   the same, with one allocation while a word is taken: has to fail

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <leadscrew/realtime/runner.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <leadscrew/realtime/word_stream.hpp>
#include <mixed_paths.hpp>

#include "forbidden_calls.hpp"

namespace {

using namespace leadscrew;
using namespace testing_support;

void* volatile allocated = nullptr;

/// Chunks one after the other; each time one is refused the rest of the path is cut anew, from where its tail ended.
class Cuts {
 public:
  std::optional<planner::Chunk> next() {
    if (rest_.empty()) return std::nullopt;
    // Late now and then: motion is stopped by the tail of the chunk before.
    if (++handed_ % 8 == 0) realtime::sleep_until(realtime::now() + 150'000'000);
    const CutChunk cut = rest_.front();
    rest_.pop_front();
    before_ = std::exchange(last_, cut.rest);
    return cut.chunk;
  }
  void refuse() {
    last_ = before_;
    cut(before_);
  }

 private:
  void cut(double from) {
    rest_.clear();
    if (path_.length() - from < 1e-9) return;
    const auto cuts = cut_motion(path_, from, path_.length(), path_speed, path_jerk, 0.02);
    rest_.assign(cuts.begin(), cuts.end());
  }

  const Path path_ = mixed_path();
  std::deque<CutChunk> rest_ = [this] {
    const auto cuts = cut_motion(path_, 0, path_.length(), path_speed, path_jerk, 0.02);
    return std::deque<CutChunk>(cuts.begin(), cuts.end());
  }();
  double before_ = 0, last_ = 0;  // where motion rests if nothing follows: of the chunk before, of the last
  int handed_ = 0;
};

}  // namespace

int main(int argument_count, char** arguments) {
  if (!counts_each_function()) {
    std::puts("the counting does not count");
    return 2;
  }
  const bool is_sabotaged = argument_count > 1 && std::strcmp(arguments[1], "sabotage") == 0;
  using Stream = realtime::WordStream<4096, 4096>;
  const auto stream = std::make_unique<Stream>();
  Watch seen;
  Cuts cuts;
  const realtime::Planning planning = {
      .next = [&] { return cuts.next(); }, .refuse = [&] { cuts.refuse(); }, .override_feed = [](double) {}};
  const realtime::WordSink sink = {
      .take =
          [&](const base::Word& word) {
            watch().may_read_clock = watch().armed = true;
            if (is_sabotaged && base::count(word.tick) == 50) allocated = std::malloc(8);
            return stream->push(word);
          },
      .append_stop_position = [&](const base::PathPlace& to) { return stream->append_stop_position(to); },
      .publish =
          [&] {
            seen = watch();
            return stream->publish();
          }};
  realtime::Runner runner({.period = path_period, .look_ahead = 0.05, .lead = 20, .slice = 20}, planning, sink);
  runner.start();
  base::Word word;
  while (!runner.has_ended()) {
    while (stream->pop(word)) {
    }
    realtime::sleep_until(realtime::now() + 1'000'000);
  }
  const realtime::Counters counters = runner.counters();
  std::printf("%lld words, %lld starvations, %lld late chunks: %s\n", static_cast<long long>(counters.words),
              static_cast<long long>(counters.starvations), static_cast<long long>(counters.late_chunks),
              told(seen).c_str());
  // A run without what it is for proves nothing.
  return seen.calls == 0 && counters.words > 500 && counters.starvations > 0 && counters.late_chunks > 0 ? 0 : 1;
}
