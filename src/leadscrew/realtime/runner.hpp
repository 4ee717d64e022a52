#pragma once
// A controller on time: one thread makes a word every servo period, another plans ahead of it.
//
//   requests ──────▶ planner's thread ─▶ interpolator::Controller ─▶ cyclic thread ─▶ sink
//   (feed, stop)     ≤ look-ahead s             (chunks)              every period
//
// The schedule is absolute: word n is due at t₀ + n·T, or `lead` periods before, where the sink keeps words until their
// time has come. A word that was not made in time is made as soon as the thread runs again, with those that have come
// due meanwhile: counted as overruns, none lost, none repeated, all in order. A sink that has no room for a word gets
// the same one again a period later, and the schedule gives way by that: a slip. So a late computer costs the sink's
// lead, a slow sink costs time, and neither changes a word.
//
// A sink that drives depend on gets words in slices, each with the stop path behind it: what the cycle would do if
// nothing followed. Words of a slice are made together, when the first of them is due.
//
// A planner that is late is the interpolator's matter: the stop tail runs, and motion goes on from rest, when enough is
// planned not to be late again at once (feeder.hpp). The cycle neither allocates nor locks; its clock is for pacing
// alone.

#include <atomic>
#include <cstdint>
#include <functional>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/interpolator/controller.hpp>
#include <leadscrew/planner/overrides.hpp>
#include <leadscrew/realtime/feeder.hpp>
#include <leadscrew/realtime/histogram.hpp>
#include <leadscrew/realtime/ring.hpp>
#include <optional>
#include <thread>

namespace leadscrew::realtime {

/// Where words go; called by the cyclic thread: it must not wait. A sink that needs no stop path has `take` alone.
struct WordSink {
  std::function<bool(const base::Word&)> take;  ///< false if it has no room: it is given the word again
  std::function<bool(const base::PathPlace&)>
      append_stop_position;       ///< appends a place to the stop path; false if it is too long
  std::function<bool()> publish;  ///< a slice; false if nobody wants words any more
  /// An event of the period that ends with the word that take is given next (base::PassedEvent::tick): each once, in
  /// order; false if it has no room: it is given the event again. Absent: events are passed over.
  std::function<bool(const base::PassedEvent&)> event = {};
};

/// How a motion is run.
struct RunnerOptions {
  base::Period period{};        ///< of the cyclic thread
  base::AxisVector position{};  ///< where motion begins, mm or degrees
  double path_length = 0;       ///< behind it
  base::Line line{};            ///< of the program, there
  double look_ahead = 0.2;      ///< s of motion planned ahead of the cycle; a change of feed takes as long
  /// s that are enough where planner and cycle are in time (look_ahead.hpp); none: as far at all times.
  std::optional<double> least_look_ahead = {};
  std::int64_t lead = 0;   ///< periods that words are made ahead of their time
  std::int64_t slice = 1;  ///< words that are published together, at most; at rest each for itself
  /// That threads follow; its chunks come from a planner that was told so (planner::Planner::follow_spindle). None: they
  /// go as planned.
  std::optional<machine::Spindle> spindle = {};
};

/// What has happened so far.
struct Counters {
  std::int64_t words = 0;                         ///< published
  std::int64_t overruns = 0;                      ///< periods that the cyclic thread slept through
  std::int64_t slips = 0;                         ///< periods by which the schedule gave way to the sink
  std::int64_t late_chunks = 0;                   ///< chunks that came after the motion they continue had been stopped
  std::int64_t starvations = 0;                   ///< stop tails that ran because nothing followed
  double seconds_ahead = 0;                       ///< planned, not begun
  bool in_step = false;                           ///< is motion on a line in step with a simulated spindle?
  interpolator::ThreadFigures threads{};          ///< of such lines so far; while there are words, each for itself
  double override_factor = 1;                     ///< asked for; 0: held
  planner::AllowedOverrides allowed_overrides{};  ///< by the program, where motion is
  bool ended = false;                             ///< the last word has been taken, or nobody wants it
  bool too_long_to_rest = false;                  ///< a stop path was longer than the sink can hold: it was cut off
};

/// Plans in one thread and makes words on time in another.
class Runner {
 public:
  /// Nothing happens before start(). What the functions refer to must outlive this.
  Runner(const RunnerOptions& options, Planning planning, WordSink sink);
  ~Runner();  ///< stops at once
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Plans ahead, then makes the first word.
  void start();
  /// Feed override, 0 … 2; 0 holds. What was asked last counts.
  void override_feed(double factor);
  /// Brings motion to rest on the path, and ends.
  void stop();
  /// Makes no more words, whatever moves.
  void halt();

  /// Of now; any thread may ask.
  Counters counters() const;
  /// By how much the cyclic thread woke up late, ns.
  const Histogram& latencies() const { return latencies_; }
  /// What the system did not permit, once there is a word.
  const std::optional<base::Diagnostic>& notice() const { return notice_; }
  /// Why motion ended although more would have come (Feeder::failure), once it has.
  const std::optional<base::Diagnostic>& failure() const { return feeder_.failure(); }
  /// Has the first word been made?
  bool has_begun() const { return begun_.load(std::memory_order_acquire); }
  /// Has the last, or does nobody want it?
  bool has_ended() const { return ended_.load(std::memory_order_acquire); }

 private:
  void plan();
  void cycle();
  bool make_due(std::int64_t due) noexcept;
  bool take_events() noexcept;
  bool publish() noexcept;
  bool is_last() const noexcept;

  const RunnerOptions options_;
  Planning planning_;
  WordSink sink_;
  interpolator::Controller controller_;
  Histogram latencies_;
  std::optional<base::Diagnostic> notice_;

  Feeder feeder_;  ///< the planner's

  // The cycle's.
  std::optional<base::Word> waiting_;            ///< for room in the sink
  const planner::PlacedEvent* event_ = nullptr;  ///< likewise, of its period
  std::int64_t taken_ = 0;                       ///< words, by the sink
  std::int64_t published_ = 0;                   ///< of these
  planner::AllowedOverrides passed_overrides_;   ///< by the events that it has passed

  // Told by one thread to others.
  std::atomic<bool> begun_{false}, ended_{false}, halted_{false}, too_long_to_rest_{false};
  std::atomic<std::int64_t> last_chunk_{-1};  ///< number of the last one, once it is known
  std::atomic<std::int64_t> words_{0}, overruns_{0}, slips_{0}, late_chunks_{0};
  std::atomic<double> seconds_ahead_{0}, asked_{1};
  std::atomic<bool> stop_asked_{false};
  static_assert(std::atomic<planner::AllowedOverrides>::is_always_lock_free);
  std::atomic<planner::AllowedOverrides> allowed_overrides_{planner::AllowedOverrides{}};
  std::thread planner_thread_, cyclic_thread_;
};

}  // namespace leadscrew::realtime
