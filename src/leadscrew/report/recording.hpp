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
#include <vector>

namespace leadscrew::report {

/// Least and greatest value of a channel over one bin of time.
struct Extent {
  double least = 0;
  double greatest = 0;
};

struct PathPoint {
  base::AxisVector position{};  ///< mm or degrees
  double feed = 0;              ///< mm/s
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

class Recording {
 public:
  /// The machine gives axes and limits and must outlive the recording.
  Recording(const machine::Machine& machine, base::Period period);

  void observe(const base::Word& word);
  void observe(const base::PassedEvent& event);

  std::int64_t words() const;  ///< observed, the one at rest at the start among them
  double seconds() const;      ///< time of the last word
  double bin_seconds() const;  ///< duration of one bin: a power of two of periods

  /// Channels over time; derivatives (order 0 … 3: position, velocity, acceleration, jerk) are differences of words.
  std::span<const Extent> feed() const;
  std::span<const Extent> axis(base::Axis axis, int order) const;

  std::span<const PathPoint> path() const;             ///< at most 20000 points
  std::vector<BlockFigures> slowest_blocks() const;    ///< up to ten, the slowest first
  std::vector<BlockFigures> nearest_to_limit() const;  ///< up to ten, the nearest first
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
