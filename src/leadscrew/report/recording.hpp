#pragma once
// What a report needs of a train of words, in memory that does not grow with it: extremes of every channel over equal
// bins of time (two neighbours become one when the bins run out), the path thinned to a tolerance that grows as needed,
// and the worst blocks.

#include <array>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/line.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/machine/machine.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace leadscrew::report {

/// Least and greatest value of a channel over one bin of time.
struct Extent {
  double least = 0;
  double greatest = 0;
};

struct PathPoint {
  base::AxisVector position{};  ///< mm or degrees
  double feed = 0;              ///< mm/s; of a rapid 0, for it is not shown
  bool is_rapid = false;        ///< the way that leads here
};

/// What one block of the program took and how near it came to a limit.
struct BlockFigures {
  base::Line line{};
  double t_begin = 0;      ///< seconds
  double duration = 0;     ///< seconds
  double length = 0;       ///< mm
  double worst_ratio = 0;  ///< largest value over limit among velocity, acceleration and jerk of all axes
  base::Axis worst_axis{};
  int worst_order = 0;  ///< 1 velocity, 2 acceleration, 3 jerk
};

/// A move of the program, and what it took beyond its feed word.
struct LostBlock {
  base::Line line{};
  double feed_asked = 0;      ///< mm/s or degrees/s; infinite for a rapid, 0 of a dwell
  double feed_reached = 0;    ///< the greatest
  double duration = 0;        ///< s
  double lost = 0;            ///< s
  std::string cause;          ///< of most of that
  base::AxisVector middle{};  ///< halfway along it, mm or degrees
};

class Recording {
 public:
  /// The machine gives axes and limits and must outlive the recording.
  Recording(const machine::Machine& machine, base::Period period);

  /// `tip`: where the word brings the tool's tip, X, Y and Z of the workpiece, which the path then shows; null: the axes.
  void observe(const base::Word& word, const base::AxisVector* tip = nullptr);
  /// Of a word that will be observed: what the program asks for, or where rapids begin and end (programmed feed).
  void observe(const base::PassedEvent& event);
  void observe(const LostBlock& block);

  std::int64_t words() const;  ///< observed, the one at rest at the start among them
  double seconds() const;      ///< time of the last word
  double bin_seconds() const;  ///< duration of one bin: a power of two of periods

  /// Channels over time; derivatives (order 0 … 3: position, velocity, acceleration, jerk) are differences of words.
  std::span<const Extent> feed() const;
  double greatest_feed() const;   ///< of feed moves, mm/s
  double greatest_rapid() const;  ///< of rapids, mm/s
  std::span<const Extent> axis(base::Axis axis, int order) const;

  /// Is the path that of the tip?
  bool shows_tip() const;
  std::span<const PathPoint> path() const;             ///< at most 20000 points
  std::vector<BlockFigures> slowest_blocks() const;    ///< up to ten, the slowest first
  std::vector<BlockFigures> nearest_to_limit() const;  ///< up to ten, the nearest first
  std::vector<LostBlock> dearest_blocks() const;       ///< up to ten, the one that loses most first
  std::int64_t event_count() const;
  std::span<const base::PassedEvent> events() const;  ///< the first 200

 private:
  class Implementation;

 public:
  ~Recording();
  Recording(Recording&&) noexcept;
  Recording& operator=(Recording&&) noexcept;

 private:
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace leadscrew::report
