#pragma once
// How far from physics: the least time in which the path can be travelled with the axes' velocities and accelerations
// and the programmed feed inside their limits, jerk not asked. No controller that stays on the path can be faster.
//
// The unknown is x(s) = ṡ², b = x′/2 = s̈, so that for each axis q̇² = q′²x and q̈ = q″x + q′b (Bobrow et al., 1985; Pham
// & Pham, "A new approach to time-optimal path parameterization based on reachability analysis", 2018):
//
//     x ≤ min(F², (v/q′)²)          |q″x + q′b| ≤ a          and whatever else is proven of speed and acceleration
//
//   backward  K_i = the greatest x at knot i from which knot i+1 can be reached with x ≤ K_{i+1}
//   forward   x_{i+1} = the greatest x at knot i+1 that can be reached from x_i, at most K_{i+1}
//
// with b constant between knots and the limits kept at both ends of each interval; time is that of the fastest way between the
// two speeds, b as great as it may be at either knot. On lines that is exact with one interval; curves are cut finely enough for 1e-4 of the time, more finely where motion comes from rest or goes to it.

#include <array>
#include <cstddef>
#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <optional>
#include <vector>

namespace leadscrew::planner {

/// Streaming, in bounded memory: where the path goes on without a stop for longer than is kept, what lies beyond is
/// taken as passable at full speed, which keeps the result a lower bound.
class TimeBound {
 public:
  explicit TimeBound(const constraints::Constraints& constraints) : constraints_(constraints) {}

  void push(const toolpath::Element& element);
  /// No more elements will come.
  void finish();

  /// Of what lies before the last stop seen, dwells included; of all after finish(). Seconds.
  double seconds() const { return seconds_; }

 private:
  /// |b + by_x·x| ≤ limit.
  struct AccelerationBound {
    double limit = 0, by_x = 0;
  };
  static constexpr std::size_t most_rows = constraints::RowPairs::size;
  /// From one knot to the next. `x` stands for x at the first of them.
  struct Interval {
    double length = 0;                                ///< > 0
    double x_max = 0, x_end_max = 0;                  ///< by feed and velocities, at its two knots
    std::array<AccelerationBound, most_rows> rows{};  ///< accelerations in its middle, in x and b
    std::size_t row_count = 0;
    double straight_b = 0;  ///< straight: the greatest |b|, which may change its sign inside
    double reach = 0;       ///< K

    bool is_straight() const { return straight_b > 0; }
  };

  void place_held(bool ends_at_rest);
  void add_straight(const geometry::Line& line, const toolpath::Piece& piece);
  void add_curved(const toolpath::Piece& piece, bool ends_at_rest);
  void settle_first_half();
  void stop();
  void settle(std::size_t count, double x_beyond);
  static double greatest_start(const Interval& interval, double x_end);
  static double greatest_end(const Interval& interval, double x_begin);
  struct Slopes {
    double up = 0, down = 0;
  };
  static Slopes greatest_slopes(const Interval& interval, double x_begin, double x_end);
  static double duration(const Interval& interval, double x_begin, double x_end);
  double velocity_limit(double s, const geometry::PointJet& jet, const toolpath::Piece& piece) const;
  void add_rows(const geometry::PointJet& middle, Interval& interval) const;

  constraints::Constraints constraints_;
  std::optional<toolpath::Piece> held_;  ///< the last piece, until it is known how it ends
  std::vector<Interval> waiting_;
  bool begins_at_rest_ = true;    ///< what comes next
  geometry::PointJet leaving_{};  ///< at the end of the last piece
  double x_begin_ = 0;            ///< x where what is waiting begins
  double seconds_ = 0;
};

}  // namespace leadscrew::planner
