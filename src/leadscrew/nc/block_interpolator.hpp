#pragma once
// What turns a command of feed into steps, along one block, by any of the methods.
//
//                     lines, any number of axes                    arcs
//   koren             DDA, q = L                                   DDA, q = R, the new value used (eq. 27)
//   dda               DDA, q = L                                   DDA, q = R, registers clocked together
//   point comparison  the axis that is furthest behind             one axis a command, by the sign of F
//   least error,      Bresenham's: the longest axis at every       the least |F| of three steps; the faster axis
//   improved          command                                      at every command
//   bresenham         the same                                     as least error
//
// Axes beside the plane of an arc go with it (helix.hpp): the first integrand of their DDA, with q = √(n² + Σ Δ²), is
// the circle's n commands.
//
// The method is chosen once for a run of commands, not at each of them: each has a loop of its own.

#include <leadscrew/nc/arc_tape.hpp>
#include <leadscrew/nc/block.hpp>
#include <leadscrew/nc/helix.hpp>
#include <leadscrew/nc/method_traits.hpp>
#include <leadscrew/nc/point_to_point.hpp>
#include <leadscrew/nc/step_writer.hpp>
#include <leadscrew/pulse/stretch.hpp>

namespace leadscrew::nc {

/// Fills in how many commands a block takes by a method, and the capacity of its DDA: exactly so many, but of arcs of
/// more than ArcTape::most_commands within block.uncertain. Shorter ones are recorded on the tape, if that does not
/// hold them already.
void count_commands(Block& block, PulseMethod method, const InterpolationOptions& options, ArcTape& tape);

class BlockInterpolator {
 public:
  /// Without a block: done at once.
  BlockInterpolator() = default;
  /// Of a block with counted commands.
  BlockInterpolator(const Block& block, PulseMethod method, const InterpolationOptions& options);
  /// The same; an arc that the tape holds is taken from there, until when the tape must stay as it is.
  BlockInterpolator(const Block& block, PulseMethod method, const InterpolationOptions& options, const ArcTape& tape);

  bool done() const {
    return std::visit([](const auto& state) { return state.done(); }, state_);
  }

  /// What one command makes; at most one step of each axis.
  AxisPulse step();

  /// One command after the other, each after as many clocks as the feed says, until it is done or the buffer is full:
  /// at most so many, > 0. How many there were.
  template <typename Feed>
  std::int64_t run(Feed& feed, std::int64_t most, StepWriter& steps) {
    return std::visit([&](auto& state) { return run(state, feed, most, steps); }, state_);
  }

  /// Steps that the counter of an axis still holds; in the plane of an arc those of the quadrant, as far as the method
  /// keeps any.
  std::int64_t left(std::size_t axis) const;

 private:
  static constexpr std::size_t all = base::axis_count, all_beside = all - 2;
  // Of few axes and of all, for those that stand still take their time too.
  template <class Circle>
  using OfCircle = TypeList<Circle, Helix<Circle, 1>, Helix<Circle, all_beside>>;
  template <class Row>
  using OfLines = TypeList<typename Row::template Line<2>, typename Row::template Line<3>,
                           typename Row::template Line<5>, typename Row::template Line<all>>;
  template <class>
  struct OfRows;
  template <class... Rows>
  struct OfRows<TypeList<Rows...>> {
    using Interpolators = Joined<TypeList<PointToPoint<all>>, OfLines<Rows>..., OfCircle<ArcTape::Player>,
                                 OfCircle<typename Rows::Circle>...>;
  };
  using State = OfRows<MethodRows>::Interpolators::Variant;

  void load_line(const Block& block, PulseMethod method, const InterpolationOptions& options);
  template <std::size_t axes>
  void load_line(const Block& block, const LatticeVector& delta, PulseMethod method,
                 const InterpolationOptions& options);
  template <typename Circle>
  void load_arc(const Block& block, const Circle& circle, PulseMethod method, const InterpolationOptions& options);

  template <typename Interpolator, typename Feed>
  std::int64_t run(Interpolator& interpolator, Feed& feed, std::int64_t most, StepWriter& steps) {
    if (most <= 0 || steps.is_full()) return 0;
    // What is not seen from elsewhere can be kept in the processor's registers.
    Interpolator copy = interpolator;
    Feed clock = feed;
    StepWriter writer = steps;
    const auto lanes = lanes_;
    const bool in_order = in_order_;
    std::int64_t commands = 0;
    pulse::step_through(copy, [&](auto& state) __attribute__((always_inline)) {
      writer.pass(clock.skip());
      if constexpr (requires { state.step_one(); }) {
        const auto [axis, step] = state.step_one();
        writer.put(lanes[axis], step);
      } else {
        const auto pulse = state.step();
        for (std::size_t i = 0; i < pulse.step.size(); ++i) writer.put(lanes[i], pulse.step[i]);
        if (!in_order) writer.order(pulse.step.size());
      }
      return ++commands < most && !writer.is_full();
    });
    interpolator = copy;
    feed = clock;
    steps = writer;
    return commands;
  }

  State state_ = PointToPoint<all>({});
  std::array<base::Axis, base::axis_count> lanes_{};  // of the interpolator's axes; beyond the block's they never step
  bool in_order_ = true;
};

}  // namespace leadscrew::nc
