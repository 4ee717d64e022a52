#pragma once
// How far from physics: the least time in which the path can be travelled with the axes' velocities and accelerations
// and the programmed feed inside their limits, jerk not asked. No controller that stays on the path can be faster.
//
// The unknown is x(s) = ṡ², b = x′/2 = s̈, so that for each axis q̇² = q′²x and q̈ = q″x + q′b (Bobrow et al., 1985; Pham
// & Pham, "A new approach to time-optimal path parameterization based on reachability analysis", 2018):
//
//     x ≤ min(F², (v/q′)²)          |q″x + q′b| ≤ a          and whatever else is proven of speed and acceleration
//
// Between two knots an axis' q̇² changes by 2a a unit of its travel at the most, however b runs there:
//
//     |q′₁²x₁ − q′₀²x₀| ≤ 2a·∫|q′|ds
//
// which every motion keeps, so that what follows from it for x at knots is never below what a motion has:
//
//   backward  K_i = the greatest x at knot i from which knot i+1 can be reached with x ≤ K_{i+1}
//   forward   x_{i+1} = the greatest x at knot i+1 that can be reached from x ≤ x_i, at most K_{i+1}
//
// Where an axis turns back, q′ = 0, only the curve asks something of it, |q″|x ≤ a (a zero-inertia point: Pfeiffer & Johanni,
// 1987): there is a knot at each. A kink of the path is passed at the greatest speed at which words do not show it
// (greatest_speed_over_kink). Time is that of the fastest way between the two speeds. On lines that is exact with one interval; curves are cut finely enough for 1e-4 of the time, more finely where motion comes from rest or goes to it. Between
// two knots x is taken along a chord, which on curves makes the bound up to 2e-5 of itself higher than the least time.

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
  explicit TimeBound(const machine::Machine& machine) : constraints_(machine), machine_(machine) {}

  void push(const toolpath::Element& element);
  /// No more elements will come.
  void finish();

  /// Of what lies before the last stop seen, dwells included; of all after finish(). Seconds.
  double seconds() const { return seconds_; }

 private:
  static constexpr std::size_t most_rows =
      constraints::RowPairs::rows_before<constraints::AccelerationRow, constraints::kind_count>;
  /// A place of a curve, and what is asked there.
  struct Knot {
    double s = 0;
    double step = 0;          ///< how far the next may be
    double x_max = 0;         ///< by feed and velocities
    bool is_at_feed = false;  ///< by feed
    std::array<constraints::AccelerationRow, most_rows> rows{};
  };
  /// |by_end·x_end − by_begin·x_begin| ≤ change, both > 0.
  struct SquareBound {
    double by_begin = 0, by_end = 0, change = 0;
  };
  /// From one knot to the next. `x` stands for x at the first of them.
  struct Interval {
    double length = 0;                ///< > 0
    double x_max = 0, x_end_max = 0;  ///< at its two knots
    double top = 0, top_end = 0;      ///< of their line: greater where x is that low next to a knot alone
    double x_above = 0;               ///< how far between them x may lie above that line
    std::array<SquareBound, most_rows> squares{};
    std::size_t square_count = 0;
    double straight_b = 0;  ///< straight: the greatest |b|, which may change its sign inside
    double reach = 0;       ///< K

    bool is_straight() const { return straight_b > 0; }
  };

  void place_held(bool ends_at_rest);
  void add_straight(const geometry::Line& line, const toolpath::Piece& piece);
  void add_curved(const toolpath::Piece& piece, bool ends_at_rest);
  void slow_down_to(double speed);
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
  Knot knot_at(double s, const toolpath::Piece& piece) const;
  Knot next_knot(const Knot& here, double farthest, const toolpath::Piece& piece) const;
  Knot turning_back(std::size_t row, const Knot& begin, const Knot& end, const toolpath::Piece& piece) const;
  double x_above(const Knot& begin, const Knot& end, const toolpath::Piece& piece) const;
  static void add_squares(const Knot& begin, const Knot& end, Interval& interval);

  constraints::Constraints constraints_;
  machine::Machine machine_;
  std::optional<toolpath::Piece> held_;  ///< the last piece, until it is known how it ends
  std::vector<Interval> waiting_;
  bool begins_at_rest_ = true;    ///< what comes next
  bool is_in_step_ = false;       ///< likewise: as fast as a spindle that turns as it likes
  geometry::PointJet leaving_{};  ///< at the end of the last piece
  double x_begin_ = 0;            ///< x where what is waiting begins
  double seconds_ = 0;
};

}  // namespace leadscrew::planner
