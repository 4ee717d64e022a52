#pragma once
// The cycle: one call, one word.
//
// Time is an integer tick n and t = n·T. The segment of the motion that holds t gives s(t) in closed form, the curve of
// its piece gives the axes' positions; both in double-double, rounded once. Nothing is accumulated from word to word
// but the number of the tick and, from chunk to chunk, where the next begins (a fraction of a tick is as good as a
// whole one). No allocation, no lock, no clock, no exception; the only loop moves on through segments that have ended.

#include <cstddef>
#include <cstdint>
#include <leadscrew/base/time.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/interpolator/follower.hpp>
#include <leadscrew/interpolator/parameter_steps.hpp>
#include <leadscrew/interpolator/spindle_motion.hpp>
#include <leadscrew/interpolator/thread_figures.hpp>
#include <leadscrew/interpolator/word_kernels.hpp>
#include <leadscrew/planner/motion.hpp>
#include <optional>
#include <span>

namespace leadscrew::interpolator {

class Interpolator {
 public:
  /// Stands at `position`, behind so much of the path and in this line of the program, until a chunk is loaded.
  Interpolator(base::Period period, const base::AxisVector& position, double path_length = 0, base::Line line = {});

  /// Goes along NURBS curves by one of the published rules, for comparison; by arc length unless told otherwise.
  void step_by(StepRule rule) { rule_ = rule; }

  /// Does the next word lie beyond the end of the chunk (or is there none)? Then load the next chunk, or if there is
  /// none, stop asking: words run the stop tail, if the chunk has one, and stay at its end, at rest.
  bool wants_chunk() const { return !(now_ < end_); }

  /// Goes on with this chunk from where the one before ends in time, be that a fraction of a tick. Once a word has
  /// stood at rest for want of a chunk, it begins with the next word. A chunk that begins in motion may follow only a
  /// committed part that ends in motion, and one that begins at rest only rest (planner::Chunk::begins_at_rest). It is
  /// not copied: it must live until the next is loaded.
  void load(const planner::Chunk& chunk);

  /// The committed part has ended (wants_chunk()) and nothing that continues its motion will come: goes on through the
  /// stop tail to rest. Does nothing where there is no tail left to run. next() does it unasked.
  void run_stop_tail();

  /// Has the loaded chunk's committed part ended in motion, with neither a successor loaded nor the tail begun?
  bool has_stop_tail_left() const { return wants_chunk() && chunk_ && !in_tail_ && !chunk_->stop_tail.empty(); }
  /// Does the next word lie in a stop tail?
  bool stopping() const { return in_tail_ && !wants_chunk(); }
  /// Does the next word stand at rest because all motion has ended? Not in a dwell.
  bool at_rest() const { return wants_chunk() && !has_stop_tail_left(); }

  /// Before the first word: chunks that are in step with the spindle follow this one, which turns as events say. It stands
  /// at its index at the first word's time.
  void follow(const machine::Spindle& spindle) { spindle_.emplace(spindle); }
  /// Motion in step with the spindle, if there is any now, comes to rest on its line as soon as the limits allow, and ends:
  /// has_left_step() is true from then on, and no chunk may be loaded any more. All else goes on as it is.
  void leave_step() {
    if (thread_) thread_->is_left = true;
  }
  /// Has such motion come to rest?
  bool has_left_step() const { return has_left_; }
  /// Is motion on a line in step with the spindle, or waits for the index there?
  bool is_in_step() const { return thread_.has_value(); }
  /// So fast the spindle turns at the next word, revolutions per minute, either way; 0 where none is followed.
  double spindle_speed() const;
  /// The lines that were cut in step so far.
  const ThreadFigures& threads() const { return threads_; }
  /// The loaded chunk's part has ended (wants_chunk()), and another will be loaded, or put in its place: what no word has
  /// passed of its events is obeyed by the spindle with the next word.
  void leave_chunk();

  /// The word of this tick; moves on to the next tick.
  base::Word next();

  /// The words of this tick and of those that follow, as many as `words` holds and as lie before wants_chunk() says so;
  /// moves on behind them and returns how many: one where events are left in the part. Bit for bit what next() gives, at
  /// a quarter of its price along lines and arcs.
  std::size_t next(std::span<base::Word> words);
  /// By which kernel next() makes many words: the widest that the processor has, unless told otherwise. It must be had.
  void use(Kernel kernel) { kernel_ = kernel; }

  /// How many events of the loaded chunk have happened by the last word (planner::Chunk::event): in its period or
  /// before, never later than motion passes their places in.
  std::size_t events_passed() const { return passed_; }
  /// How many will have when the part ends that motion is in, the committed part or the tail.
  std::size_t events_of_part() const { return chunk_ ? chunk_->event_count(in_tail_) : 0; }

  /// The tick of the next word.
  base::Tick tick() const { return tick_; }

  // For whoever asks about times of their own, in copies (pipeline::Trajectory).

  /// When the loaded chunk's committed part ends, seconds since the first word's time.
  numeric::DoubleDouble end() const { return end_; }
  /// Right behind load(), or later along the same chunk: the next word is that of this time, not before the chunk begins nor
  /// before the word before, as if it were the first. Its tick is left as it is; next(span) goes by ticks
  /// and must not follow.
  void seek(numeric::DoubleDouble time) { now_ = time; }
  struct OnPath {
    const toolpath::Piece& piece;
    planner::PathState along;
  };
  /// Where the next word lies; none where it rests.
  std::optional<OnPath> on_path();

 private:
  /// A line in step with the spindle.
  struct Thread {
    Follower follower;
    double begin = 0;  ///< revolutions that way, where the line begins
    bool waits = true;
    bool is_left = false;
  };

  base::Word next_word();
  base::Word next_in_step();
  void begin_thread();
  void end_thread(const toolpath::Piece& piece);
  void wait_for_index(Thread& thread, numeric::DoubleDouble now);
  void follow_spindle(Thread& thread, numeric::DoubleDouble now, double length);
  double begin_of(const Thread& thread) const;
  bool begins_at_depth() const;  ///< a tap's way back
  double way() const { return direction_ < 0 ? -1 : 1; }
  double turned(numeric::DoubleDouble time) const;
  void turn_spindle(numeric::DoubleDouble time);
  base::AxisVector position(const toolpath::Piece& piece, std::size_t index, numeric::DoubleDouble s);
  void begin_part(std::span<const planner::Segment> segments, numeric::DoubleDouble end);
  void pass_events(std::size_t piece, double s);
  const planner::Segment& segment_at(numeric::DoubleDouble time);
  std::size_t next_of_piece(std::span<base::Word> words);
  std::size_t ticks_before(numeric::DoubleDouble end, std::size_t most) const;

  base::Period period_;
  double ticks_per_second_;
  base::Tick tick_{};
  const planner::Chunk* chunk_ = nullptr;
  std::span<const planner::Segment> segments_;  ///< of the committed part or the tail
  std::size_t segment_ = 0;
  bool in_tail_ = false;
  std::size_t passed_ = 0;               ///< events of the chunk
  bool waited_ = false;                  ///< a word has stood at rest for want of a chunk
  numeric::DoubleDouble now_;            ///< time of the next word, seconds
  numeric::DoubleDouble begin_;          ///< of the motion that the chunk is part of, seconds
  numeric::DoubleDouble end_;            ///< of the committed part, or of the tail when that runs, seconds
  numeric::DoubleDouble segment_begin_;  ///< seconds
  numeric::DoubleDouble segment_end_;    ///< seconds
  double length_before_ = 0;             ///< travelled before the piece, as if it had been travelled from its start
  bool on_piece_ = false;                ///< has anything been travelled?
  // The sum of the lengths of all pieces before, and the distance along the last: the same bits, wherever chunks are
  // cut.
  double length_before_end_ = 0;  ///< travelled before the piece on which the part ends
  double end_on_piece_ = 0;       ///< where on it the part ends
  base::AxisVector rest_;
  base::Line line_;
  StepRule rule_ = StepRule::arc_length;
  // Parameter steps along a piece go on through all chunks that share it, so pieces are told apart by a number.
  std::int64_t first_number_ = 0;     ///< of the chunk's first piece
  std::int64_t last_number_ = 0;      ///< of the piece on which the committed part ends
  std::int64_t stepped_number_ = -1;  ///< of the piece along which steps are taken
  double parameter_ = 0;              ///< where the last step ended
  double stepped_ = 0;                ///< and its path length
  Kernel kernel_ = widest_kernel();
  std::optional<SpindleMotion> spindle_;
  double direction_ = 0;          ///< in which it was told to turn: 1 clockwise, -1 counterclockwise, 0 to stand
  std::optional<Thread> thread_;  ///< that motion is on, or waits for
  double index_ = 0;              ///< revolutions the spindle's way, at the index where the last thread began
  double stood_at_ = 0;           ///< revolutions clockwise, where the last line in step ended
  bool has_left_ = false;
  std::size_t turned_ = 0;  ///< events of the chunk that the spindle has obeyed
  ThreadFigures threads_;
};

}  // namespace leadscrew::interpolator
