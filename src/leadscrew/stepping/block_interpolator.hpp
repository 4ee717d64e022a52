#pragma once
// What turns a command of feed into steps, along one block, by any of the methods.
//
//                     lines, any number of axes                    arcs
//   koren             DDA, q = L                                   DDA, q = R, the new value used (eq. 27)
//   dda               DDA, q = L                                   DDA, q = R, registers clocked together
//   point comparison  the axis that is furthest behind             one axis a command, by the sign of F
//   least error,      Bresenham's: the longest axis at every       the least |F| of three steps; the faster axis
//   improved          command                                      at every command
//   bresenham         the same                                     as improved
//
// Axes beside the plane of an arc go with it as along a straight line, one of whose ways is the circle's: a linear DDA
// with q = √(n² + Σ Δ²) has the circle's n commands as its first integrand and clocks the circle by that one's
// overflows.

#include <leadscrew/pulse/circular_search.hpp>
#include <leadscrew/pulse/linear.hpp>
#include <leadscrew/stepping/block.hpp>
#include <leadscrew/stepping/line_point_comparison.hpp>
#include <leadscrew/stepping/point_to_point.hpp>
#include <leadscrew/stepping/program_circle.hpp>
#include <leadscrew/stepping/pulse_method.hpp>
#include <variant>

namespace leadscrew::stepping {

struct InterpolationOptions {
  pulse::Preload preload = pulse::Preload::half;  ///< of DDAs; Koren's registers begin empty
  int places = 0;  ///< 0 … 16, of the radius in circular DDAs: more where feed on circles is to be exact
};

/// Fills in how many commands a block takes by a method: of a line exactly so many or up to one less; of an arc within
/// a few.
void count_commands(Block& block, PulseMethod method);

class BlockInterpolator {
 public:
  /// Of nothing: done.
  BlockInterpolator() = default;
  /// Of a block with counted commands.
  BlockInterpolator(const Block& block, PulseMethod method, const InterpolationOptions& options);

  bool done() const { return !turns() && !goes_straight(); }

  /// What one command makes; at most one step of each axis. Is there any?
  bool step(AxisPulse& pulse) {
    pulse = {};
    const Stepped straight = step_straight(pulse);
    const bool turned = straight.clocks_circle && step_circle(pulse);
    return turned || straight.any;
  }

  /// Steps that the counter of an axis still holds; in the plane of an arc those of the quadrant, as far as the method
  /// keeps any.
  std::int64_t left(std::size_t axis) const;

 private:
  using Straight = std::variant<std::monostate, pulse::LinearDda<3>, pulse::LinearDda<base::axis_count>,
                                LinePointComparison<base::axis_count>, PointToPoint<base::axis_count>>;
  using Circle = std::variant<std::monostate, ProgramCircle, pulse::CircularSearch<pulse::Search::point_comparison>,
                              pulse::CircularSearch<pulse::Search::least_error>,
                              pulse::CircularSearch<pulse::Search::improved_least_error>>;

  void load_straight(const Block& block, PulseMethod method, const InterpolationOptions& options);
  void load_circle(const Block& block, PulseMethod method, const InterpolationOptions& options);

  bool turns() const {
    return with(circle_, [](const auto& circle) { return !circle.done(); });
  }
  bool goes_straight() const {
    return with(straight_, [&](const auto& straight) {
      if (!has_circle_) return !straight.done();
      for (std::size_t lane = 1; lane < lanes_; ++lane) {
        if (straight.left(lane) > 0) return true;
      }
      return false;
    });
  }

  struct Stepped {
    bool any = false, clocks_circle = false;
  };

  Stepped step_straight(AxisPulse& pulse) {
    Stepped stepped{false, has_circle_ && lanes_ == 0};
    with(straight_, [&](auto& straight) {
      const bool circle_is_late = has_circle_ && straight.left(0) == 0;
      const auto lane_pulse = straight.step();
      for (std::size_t lane = has_circle_; lane < lanes_; ++lane) {
        pulse.step[axis_of_[lane]] = lane_pulse.step[lane];
        stepped.any |= lane_pulse.step[lane] != 0;
      }
      stepped.clocks_circle = has_circle_ && (circle_is_late || lane_pulse.step[0] != 0);
      return true;
    });
    return stepped;
  }

  bool step_circle(AxisPulse& pulse) {
    return with(circle_, [&](auto& circle) {
      if (circle.done()) return false;
      const auto [x, y] = circle.step().step;
      pulse.step[first_] = x;
      pulse.step[second_] = y;
      return x != 0 || y != 0;
    });
  }

  /// What a visitor says of the kind that the variant holds; false of none.
  template <typename Variant, typename Visitor>
  static bool with(Variant& variant, const Visitor& visitor) {
    if (auto* second = std::get_if<1>(&variant)) return visitor(*second);
    if (auto* third = std::get_if<2>(&variant)) return visitor(*third);
    if (auto* fourth = std::get_if<3>(&variant)) return visitor(*fourth);
    if (auto* fifth = std::get_if<4>(&variant)) return visitor(*fifth);
    return false;
  }

  bool has_circle_ = false;
  std::size_t first_ = 0, second_ = 1;  // axes of the circle
  std::size_t lanes_ = 0;  // of the straight part; its first one is the circle's clock, if there is a circle
  std::array<std::size_t, base::axis_count> axis_of_{};
  Straight straight_;
  Circle circle_;
};

}  // namespace leadscrew::stepping
