#pragma once
// The side of a drive that makes words: a program is planned ahead and made into words on time, for the drives behind a
// link. Nothing passes that was not checked: neither text that differs from what was read before, nor a word outside
// travel or limits (guarded_sink.hpp). In both cases motion comes to rest on the path.

#include <array>
#include <atomic>
#include <functional>
#include <leadscrew/drive/guarded_sink.hpp>
#include <leadscrew/drive/input_wait.hpp>
#include <leadscrew/drive/setup.hpp>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/pipeline/motion_source.hpp>
#include <leadscrew/realtime/runner.hpp>
#include <memory>
#include <optional>

namespace leadscrew::drive {

class LiveProgram;

class WordMaker {
 public:
  /// May motion go on with this chunk, which begins at rest? Asked by the planner's thread.
  using MayStart = std::function<bool(const planner::Chunk&)>;

  /// From rest at the position and path length of `first`. The program was read whole and found without error; it, the
  /// setup and the link must outlive this. Where it is read while it moves (Options::live) `program` is empty.
  WordMaker(const files::InputFile& program, const Setup& setup, const base::Word& first, Link& link,
            MayStart may_start);
  ~WordMaker();

  /// Plans ahead, then makes the first word.
  void start() { runner_->start(); }
  /// Until conclude().
  realtime::Runner& runner() { return *runner_; }
  /// Bytes of the program that were read. Anybody's.
  std::int64_t bytes_read() const { return bytes_read_.load(std::memory_order_relaxed); }
  /// Does motion wait for an input (M66), which does not come? Anybody's.
  bool waits_for_input() const { return input_wait_.waits(); }
  /// Has the runner ended because the last word of the program was made? Anybody's.
  bool has_come_to_end() const {
    return runner_->has_ended() && !has_failed_.load(std::memory_order_acquire) && !sink_.has_refused() &&
           !runner_->failure() && !runner_->counters().too_long_to_rest;
  }

  /// Ends the threads. What follows is known from then on.
  void conclude();
  const realtime::Counters& counters() const { return counters_; }
  const realtime::Histogram& latencies() const { return latencies_; }
  /// What the system did not permit; none without words.
  const std::optional<base::Diagnostic>& notice() const { return notice_; }
  /// Of a motion that is slower than it need be (pipeline::MotionSource::warning).
  std::optional<base::Diagnostic> warning() const { return source_.warning(); }
  std::int64_t blocks() const;
  /// Why motion ended before the program: `program-changed`, an error that was not there when the program was checked,
  /// `word-refused`, `travel-unchecked`, `planning-failed`; the first error of a program that is read while it moves.
  std::optional<base::Diagnostic> failure() const;

 private:
  gcode::ByteSource counted(gcode::ByteSource source);
  pipeline::MotionSource source_of(const Setup& setup);
  realtime::Planning planning(MayStart may_start);
  std::optional<planner::Chunk> next_chunk();
  bool inputs_let(const planner::Chunk& chunk);
  bool has_motion_ahead() const;
  /// Have the drives come to where a chunk with a pause before it begins? Who is asked sees them stand there. True of others.
  bool stands_before(const planner::Chunk& chunk);

  const files::InputFile& program_;
  std::atomic<std::int64_t> bytes_read_{0};
  std::unique_ptr<LiveProgram> live_;  ///< none: the program was read before
  pipeline::MotionSource source_;      ///< the planner's thread's, from start() to conclude()
  std::atomic<bool> has_failed_{false};
  InputWait input_wait_;                     ///< the planner's thread's
  std::optional<std::int64_t> stood_since_;  ///< ns, before a pause; the planner's thread's
  const double lead_;                        ///< s that words are made ahead of their time
  GuardedSink sink_;
  std::optional<realtime::Runner> runner_;
  realtime::Counters counters_;
  realtime::Histogram latencies_;
  std::optional<base::Diagnostic> notice_, refused_chunk_;
};

}  // namespace leadscrew::drive
