#pragma once
// Where motion takes longer than its blocks' feed words ask: block by block, and by what was at its limit meanwhile.
//
// Each servo period is compared with the time that its path takes at the feed asked for; of a rapid, at the velocity of the
// axis that is nearest to its limit. What is left is lost, to the limit that words are nearest to around that period:
// velocity, acceleration or jerk of an axis (differences of words over period^k), the chord error, or to rest.

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <leadscrew/base/word.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/pipeline/near_limits.hpp>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace leadscrew::pipeline {

using LostByCause = std::map<Cause, double>;  ///< s
/// The most expensive first.
std::vector<std::pair<Cause, double>> ranked(const LostByCause& lost);

/// One move of one block.
struct BlockTime {
  base::Line line{};
  base::AxisVector from{}, to{};  ///< as programmed, mm or degrees
  base::AxisVector middle{};      ///< of the words, halfway along it
  double length = 0;              ///< travelled, as feed is counted
  double feed_asked = 0;          ///< mm/s or degrees/s; infinite for a rapid; 0 of a dwell
  double feed_reached = 0;        ///< the greatest
  double begin = 0;               ///< s, of the motion
  double seconds = 0;
  double least_seconds = 0;  ///< at the feed asked for
  Cause cause;               ///< the one that cost most; of no meaning where nothing is lost

  double lost() const { return seconds - least_seconds; }
};

/// Of a move that becomes a block: how long it is, as feed is counted; 0 of a dwell. Events, and moves of no length, become none.
std::optional<double> block_length(const gcode::Move& move);

/// Sums of all blocks' times are those of the motion: lost() together is time − Σ length/feed.
class LostTime {
 public:
  using Sink = std::function<void(const BlockTime&)>;

  /// `block` gets each move that words have passed, in order; may be empty. The machine must outlive this.
  LostTime(const machine::Machine& machine, Sink block);

  /// In place of the sink that it was made with.
  void on_block(Sink sink) { sink_ = std::move(sink); }
  /// Each move, before the first word of it. Does it become a block?
  bool observe(const gcode::Move& move);
  /// Each word, from that of t = 0.
  void observe(const base::Word& word);
  /// After the last word.
  void finish();

  const LostByCause& by_cause() const { return lost_; }
  const base::AxisVector& least_position() const { return least_; }
  const base::AxisVector& greatest_position() const { return greatest_; }

 private:
  struct Asked {
    BlockTime block;
    bool is_dwell = false;
    double length = 0;  ///< as programmed
  };
  void account();
  void go_to(const base::Word& word);
  void close_block();
  NearLimits near_limits() const;

  const machine::Machine& machine_;
  Sink sink_;
  std::deque<Asked> moves_;  ///< the first is in motion
  double travelled_ = 0;     ///< along it
  LostByCause lost_, lost_in_block_;
  std::array<base::Word, 4> words_{};  ///< the last, the latest behind
  std::int64_t count_ = 0;
  base::AxisVector least_{}, greatest_{};
};

}  // namespace leadscrew::pipeline
