#pragma once
// Where the time goes of words that are made as fast as they can be. A look at a clock takes as long as a word:
// planning is timed chunk by chunk, and of every 61 words one is.

#include <cstddef>
#include <cstdint>
#include <ctime>
#include <leadscrew/realtime/histogram.hpp>

namespace leadscrew::realtime {

/// Of the system.
struct SystemClocks {
  /// s of the processor that this thread has had: on a busy machine less than the clock on the wall says. A call of the
  /// system.
  static double processor_seconds() {
    const std::timespec time = read(CLOCK_THREAD_CPUTIME_ID);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / 1e9;
  }
  /// ns of a clock on the wall, without a call of the system.
  static std::int64_t nanoseconds() {
    const std::timespec time = read(CLOCK_MONOTONIC);
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
  }

 private:
  static std::timespec read(clockid_t clock) {
    std::timespec time = {};
    ::clock_gettime(clock, &time);
    return time;
  }
};

/// Times what prepares words, and samples of what makes them.
template <class Clocks = SystemClocks>
class StopWatch {
 public:
  static constexpr std::int64_t words_per_sample = 61;  ///< prime: in step with nothing a program repeats

  /// `works`: is there something to time? If not, no clock is looked at.
  template <class Work>
  auto prepare(bool works, Work&& work) {
    if (!works) return work();
    const double begin = Clocks::processor_seconds();
    auto result = work();
    preparing_ += Clocks::processor_seconds() - begin;
    return result;
  }

  template <class Work>
  auto cycle(Work&& work) {
    if (words_++ % words_per_sample != 0) return work();
    const std::int64_t begin = Clocks::nanoseconds();
    auto result = work();
    const std::int64_t duration = Clocks::nanoseconds() - begin;
    sampled_ += duration;
    samples_.observe(duration);
    return result;
  }

  /// How many words until cycle() times one; 0 if it is the next.
  std::size_t words_until_sample() const {
    return static_cast<std::size_t>((words_per_sample - words_ % words_per_sample) % words_per_sample);
  }

  /// Work that makes many words, and returns them; of every 61 such calls one is timed. No sample.
  template <class Work>
  auto many(Work&& work) {
    const bool is_timed = calls_++ % words_per_sample == 0;
    const std::int64_t begin = is_timed ? Clocks::nanoseconds() : 0;
    const auto made = work();
    const auto count = static_cast<std::int64_t>(made.size());
    words_ += count;
    together_ += count;
    if (!is_timed) return made;
    timed_ += Clocks::nanoseconds() - begin;
    timed_words_ += count;
    return made;
  }

  /// s of the processor.
  double preparing() const { return preparing_; }
  /// s on the wall, of all words if the samples are like the others.
  double cycling() const {
    const auto estimate = [](std::int64_t nanoseconds, std::int64_t words, std::int64_t of) {
      return of == 0 ? 0
                     : static_cast<double>(nanoseconds) / 1e9 * static_cast<double>(words) / static_cast<double>(of);
    };
    return estimate(sampled_, words_ - together_, static_cast<std::int64_t>(samples_.count())) +
           estimate(timed_, together_, timed_words_);
  }
  /// ns of each sample, the two looks at the clock included.
  const realtime::Histogram& samples() const { return samples_; }

 private:
  double preparing_ = 0;                  // s
  std::int64_t words_ = 0, sampled_ = 0;  // ns
  realtime::Histogram samples_;
  std::int64_t calls_ = 0, together_ = 0;     // of many(), and the words of all
  std::int64_t timed_ = 0, timed_words_ = 0;  // ns
};

}  // namespace leadscrew::realtime
