#pragma once
// What a drive of a program has come to.

#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/drive/slide_figures.hpp>
#include <leadscrew/realtime/runner.hpp>
#include <optional>

namespace leadscrew::drive {

struct Figures {
  /// failed: the program could not be read on as it was checked, or a word was refused; motion came to rest on the
  /// path.
  enum class End { done, stopped, abandoned, tripped, failed };

  realtime::Counters counters;
  realtime::Histogram latencies;
  std::int64_t taken = 0;        ///< words, by the drives or the file
  bool has_drives = false;       ///< whose figures follow
  std::int64_t drives_late = 0;  ///< periods that the drives' process was late by
  std::int64_t braked = 0;       ///< periods in which the drives braked by themselves
  TrackedAxes axes;              ///< of the slides
  servo::FeedTracking feed;
  base::Word last{};  ///< that was taken
  End end = End::done;
  std::optional<base::Diagnostic> problem;  ///< why it was tripped or has failed; of one that was stopped, too
  std::int64_t blocks = 0;
  bool real_time = false;
};

}  // namespace leadscrew::drive
