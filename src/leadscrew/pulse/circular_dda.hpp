#pragma once
// Circular interpolation by two integrators, each fed with the coordinate of the other axis.
//
//   +--------+  Δx = ∓ (overflow)      y ──▶ X integrator ──▶ Δx ──▶ x      x ──▶ Y integrator ──▶ Δy ──▶ y
//
// Both remainders are accumulated without a sign; the quadrant gives the pulses theirs. The arc is travelled quadrant
// by quadrant, each with counters of the steps that are left, at whose zero an axis stops.

#include <leadscrew/pulse/arc.hpp>
#include <leadscrew/pulse/quadrant_registers.hpp>

namespace leadscrew::pulse {

/// Which of the two integrators sees the other's new coordinate.
enum class Order : std::uint8_t {
  parallel,         ///< none: registers clocked together, as in hardware; Euler's method
  x_first,          ///< Y's: Koren's program, eq. 27
  shrinking_first,  ///< that of the axis whose coordinate grows
  growing_first,    ///< that of the axis whose coordinate shrinks
};

struct CircularDdaOptions {
  Order order = Order::x_first;
  Preload preload = Preload::half;  ///< at the start of every quadrant
  int places = 0;  ///< binary places of the radius in the capacity, 0 … 16: 0 as published; more where feed on circles
                   ///< of irrational radius is to be exact (R·2^places within the registers; 0 below 64 bits)
  /// q, where it is not the radius: 2ⁿ of n-bit registers, or any other; ≥ every |coordinate| of the arc, places 0; a turn
  /// takes 2πq clocks. 0: the radius, by places.
  std::int32_t capacity = 0;
};

template <typename Register>
class BasicCircularDda {
 public:
  static constexpr std::size_t axes = 2;

  constexpr explicit BasicCircularDda(const BasicArc<Register>& arc, CircularDdaOptions options = {})
      : arc_(arc),
        options_(options),
        radius_(static_cast<Register>(root(arc.squared_radius(), 0))),
        capacity_(options.capacity > 0 ? static_cast<Register>(options.capacity)
                                       : static_cast<Register>(root(arc.squared_radius(), options.places))),
        quadrant_(quadrant(arc.start, arc.direction)),
        borders_(borders(arc)) {
    if (capacity_ < 1) capacity_ = 1;
    load(arc.start);
    pass_on();
  }

  constexpr bool done() const { return now_.first.left == 0 && now_.second.left == 0; }

  constexpr Pulse<2> step() {
    if (!now_.goes_on()) return step_alone();
    const Pulse<2> pulse = now_.step();
    if (done()) pass_on();
    return pulse;
  }

  /// For a run of clocks: a copy, to be stepped by itself as long as it goes on and to be given back then.
  constexpr BasicQuadrantRegisters<Register> stretch() const { return now_; }
  constexpr void give_back(const BasicQuadrantRegisters<Register>& stretch) {
    now_ = stretch;
    settle();
  }
  /// To be stepped in place as long as they go on; settle() then, and step() from there.
  constexpr BasicQuadrantRegisters<Register>& registers() { return now_; }
  constexpr void settle() {
    if (done()) pass_on();
  }

  constexpr BasicPoint<Register> at() const {
    return {static_cast<Register>(target_.x - now_.x().sign * now_.x().left),
            static_cast<Register>(target_.y - now_.y().sign * now_.y().left)};
  }
  constexpr BasicIntegrator<Register> x() const { return now_.integrator(now_.x()); }
  constexpr BasicIntegrator<Register> y() const { return now_.integrator(now_.y()); }
  constexpr Register left_x() const { return now_.x().left; }
  constexpr Register left_y() const { return now_.y().left; }
  constexpr int in_quadrant() const { return quadrant_; }  ///< 0 … 3

 private:
  /// One axis has arrived. A counter may be left with an integrand that is 0: then nothing would ever overflow.
  constexpr Pulse<2> step_alone() {
    if (done()) return {};
    const bool is_first = now_.first.left > 0;
    auto& alone = is_first ? now_.first : now_.second;
    auto& arrived = is_first ? now_.second : now_.first;
    if (alone.integrand > 0 && !now_.step(alone)) return {};
    --alone.left;
    arrived.integrand = static_cast<Register>(arrived.integrand + arrived.change);
    arrived.beyond = static_cast<Register>(arrived.beyond + arrived.change);
    const Pulse<2> pulse = is_first == now_.x_is_first ? Pulse<2>{{alone.sign, 0}} : Pulse<2>{{0, alone.sign}};
    if (done()) pass_on();
    return pulse;
  }

  /// Into the next quadrant, if another follows.
  constexpr void pass_on() {
    while (borders_ > 0 && done()) {
      quadrant_ = after(quadrant_, arc_.direction);
      --borders_;
      load(target_);
    }
  }

  constexpr void load(BasicPoint<Register> at) {
    target_ = borders_ == 0 ? arc_.end : border(quadrant_, arc_.direction, radius_);
    const bool is_parallel = options_.order == Order::parallel;
    const bool x_shrinks = ((quadrant_ & 1) == 0) == arc_.is_counterclockwise();
    now_.x_is_first =
        is_parallel || options_.order == Order::x_first || (options_.order == Order::shrinking_first) == x_shrinks;
    now_.capacity = capacity_;
    now_.sees_new = is_parallel ? 0 : -1;
    const bool x_lags = absolute(at.y) < absolute(at.x);
    // In a quadrant no coordinate changes its sign.
    load(now_.x(), static_cast<Register>(target_.x - at.x), {absolute(at.y), absolute(target_.y)}, x_lags);
    load(now_.y(), static_cast<Register>(target_.y - at.y), {absolute(at.x), absolute(target_.x)}, !x_lags);
  }

  /// Of an axis: its displacement, and the other one's |coordinate| from here to the target.
  constexpr void load(typename BasicQuadrantRegisters<Register>::AxisIntegrator& axis, Register delta,
                      std::array<Register, 2> other, bool lags) {
    const auto unit = static_cast<Register>(Register{1} << options_.places);
    axis.integrand = static_cast<Register>(other[0] * unit);
    axis.change = static_cast<Register>(sign(static_cast<Register>(other[1] - other[0])) * unit);
    axis.beyond = static_cast<Register>(preloaded(options_.preload, capacity_, lags) + axis.integrand - capacity_);
    axis.left = absolute(delta);
    axis.sign = sign(delta);
  }

  BasicArc<Register> arc_;
  CircularDdaOptions options_;
  Register radius_, capacity_;
  int quadrant_, borders_;       ///< where it is; how many are still to be passed
  BasicPoint<Register> target_;  ///< of the quadrant
  BasicQuadrantRegisters<Register> now_;
};
using CircularDda = BasicCircularDda<std::int64_t>;

}  // namespace leadscrew::pulse
