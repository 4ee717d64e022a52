#pragma once
// Circular interpolation by search: at every clock the step is taken that F = x² + y² − R² asks for. F is kept by
// additions: after a step of x by s it is F + 2sx + 1, after one of y by t F + 2ty + 1, after both their sum.
//
// Methods, after "FPGA-based implementation of circular interpolation" (there for the first quadrant):
//
//   point comparison   one axis a clock: the shrinking one outside the circle, the growing one inside
//   least error        of the three steps that the quadrant allows the one with the least |F|
//   improved           the axis that is faster here steps at every clock; the other one where the middle of its two
//                      candidates lies on the wrong side of the circle

#include <leadscrew/pulse/arc.hpp>

namespace leadscrew::pulse {

enum class Search : std::uint8_t { point_comparison, least_error, improved_least_error };

/// Where point comparison goes when it stands on the circle: the published errors come of going outward, though its
/// text says inward.
enum class OnCircle : std::uint8_t { outward, inward };

/// The registers of a search in one quadrant: nothing else is needed from clock to clock inside it.
///
/// In each quadrant one coordinate shrinks to 0 while the other grows. Both are kept by what the next step of them adds
/// to F: 1 − 2|x| and 2|y| + 1 where x shrinks, the other way round where y does.
template <Search method, OnCircle on_circle, typename Register>
struct SearchRegisters {
  Register f = 0, by_shrinking = 0, by_growing = 0;  ///< F, and what a step of either axis adds to it
  Register last_shrinking = 1, last_growing = 0;     ///< what they are where the quadrant, or the path, ends
  std::int8_t sign_x = 0, sign_y = 0;
  std::int8_t y_shrinks = 0;  ///< a mask

  constexpr bool goes_on() const { return by_shrinking != last_shrinking && by_growing != last_growing; }

  /// One clock; while it goes on.
  [[gnu::always_inline]] constexpr Pulse<2> step() {
    if constexpr (prefers_branches<Register>) {
      return step_by_branches();
    } else {
      const auto [shrinks, grows] = choose();
      f += (shrinks & by_shrinking) + (grows & by_growing);
      by_shrinking -= 2 * shrinks;
      by_growing -= 2 * grows;
      return pulse_of(static_cast<std::int8_t>(shrinks), static_cast<std::int8_t>(grows));
    }
  }

  constexpr BasicPoint<Register> at() const {
    const auto shrinking = static_cast<Register>((by_shrinking - 1) / 2);  // along the tangent
    const auto growing = static_cast<Register>((by_growing - 1) / 2);
    const Register along_x = y_shrinks ? growing : shrinking, along_y = y_shrinks ? shrinking : growing;
    return {static_cast<Register>(sign_x * along_x), static_cast<Register>(sign_y * along_y)};
  }

 private:
  /// From masks, −1 where the axis steps.
  constexpr Pulse<2> pulse_of(std::int8_t shrinks, std::int8_t grows) const {
    const auto crossed = static_cast<std::int8_t>((shrinks ^ grows) & y_shrinks);
    return {
        {static_cast<std::int8_t>((shrinks ^ crossed) & sign_x), static_cast<std::int8_t>((grows ^ crossed) & sign_y)}};
  }

  /// Masks: −1 where the axis steps, else 0.
  struct Steps {
    Register shrinking = 0, growing = 0;
  };

  constexpr Steps choose() const {
    if constexpr (method == Search::point_comparison) {
      const Register outward = where_negative(on_circle == OnCircle::inward ? f : f - 1);
      return {~outward, outward};
    } else {
      // Of two steps, which add a and b: |F + a + b| < |F + b| where a(2F + 2b + a) < 0. As a < 0 for the shrinking
      // axis, and b > 0 for the other, and both are odd, neither bracket is 0.
      const Register shrinks = ~where_negative(2 * (f + by_growing) + by_shrinking);
      const Register grows = where_negative(2 * (f + by_shrinking) + by_growing);
      if constexpr (method == Search::least_error) return {shrinks, grows};
      // w² = v² − F − b: the place on the circle beside the next one of the long axis. It is nearer to v ∓ 1 than to v
      // where 4w² has passed (2v ∓ 1)², which is where the same brackets change sign.
      const Register growing_is_long = where_negative(by_shrinking + by_growing - 3);
      return {shrinks | ~growing_is_long, grows | growing_is_long};
    }
  }

  /// The same choices. Of the least error's two conditions one holds at every clock, so that the step that it asks for
  /// can be made before the other is looked at.
  [[gnu::always_inline]] constexpr Pulse<2> step_by_branches() {
    bool shrinks = true, grows = true;
    if constexpr (method == Search::point_comparison) {
      shrinks = on_circle == OnCircle::inward ? f >= 0 : f > 0;
      grows = !shrinks;
      shrinks ? shrink() : grow();
    } else if (method == Search::improved_least_error ? by_shrinking + by_growing < 3
                                                      : 2 * (f + by_shrinking) + by_growing < 0) {
      grow();
      shrinks = 2 * f + by_shrinking >= 0;
      if (shrinks) shrink();
    } else {
      shrink();
      grows = method == Search::improved_least_error && 2 * f + by_growing < 0;
      if (grows) grow();
    }
    const bool x_steps = y_shrinks ? grows : shrinks, y_steps = y_shrinks ? shrinks : grows;
    return {{x_steps ? sign_x : std::int8_t{0}, y_steps ? sign_y : std::int8_t{0}}};
  }
  [[gnu::always_inline]] constexpr void shrink() {
    f = static_cast<Register>(f + by_shrinking);
    by_shrinking = static_cast<Register>(by_shrinking + 2);
  }
  [[gnu::always_inline]] constexpr void grow() {
    f = static_cast<Register>(f + by_growing);
    by_growing = static_cast<Register>(by_growing + 2);
  }
};

template <Search method, OnCircle on_circle = OnCircle::outward, typename Register = std::int64_t>
class CircularSearch {
 public:
  static constexpr std::size_t axes = 2;
  using Registers = SearchRegisters<method, on_circle, Register>;

  constexpr explicit CircularSearch(const BasicArc<Register>& arc)
      : end_(arc.end),
        direction_(arc.direction),
        x_ends_(absolute(arc.end.y) >= absolute(arc.end.x)),
        quadrant_(quadrant(arc.start, arc.direction)),
        borders_(borders(arc)) {
    enter(arc.start);
  }

  constexpr bool done() const { return has_come_out_ && out_ == end_; }

  constexpr Pulse<2> step() {
    if (has_come_out_) return correct();
    const Pulse<2> pulse = now_.step();
    if (!now_.goes_on()) leave();
    return pulse;
  }

  /// To be stepped in place as long as they go on; settle() then, and step() from there.
  constexpr Registers& registers() { return now_; }
  constexpr void settle() {
    if (!has_come_out_ && !now_.goes_on()) leave();
  }

  constexpr BasicPoint<Register> at() const { return has_come_out_ ? out_ : now_.at(); }
  constexpr Register deviation() const { return now_.f; }  ///< F
  constexpr int in_quadrant() const { return quadrant_; }  ///< 0 … 3

 private:
  /// A quadrant. In the last one the axis that is fast near the end says when it is reached.
  constexpr void enter(BasicPoint<Register> at) {
    const auto [sign_x, sign_y] = tangent(quadrant_, direction_).step;
    const bool x_shrinks = ((quadrant_ & 1) == 0) == (direction_ == Direction::counterclockwise);
    now_.sign_x = sign_x;
    now_.sign_y = sign_y;
    now_.y_shrinks = x_shrinks ? 0 : -1;
    now_.by_shrinking = static_cast<Register>(1 - 2 * absolute(x_shrinks ? at.x : at.y));
    now_.by_growing = static_cast<Register>(1 + 2 * absolute(x_shrinks ? at.y : at.x));
    now_.last_shrinking = 1;
    now_.last_growing = 0;
    if (borders_ > 0) return;
    const Register left = left_from(at);
    const auto last = static_cast<Register>(now_.by_shrinking + 2 * left);
    if (left <= 0) {
      now_.last_shrinking = now_.by_shrinking;  // they do not go on
      has_come_out_ = true;
      out_ = at;
    } else if (x_ends_ != x_shrinks) {
      now_.last_growing = static_cast<Register>(now_.by_growing + 2 * left);
    } else if (last < 1) {
      now_.last_shrinking = last;
    }
  }

  /// Out of the quadrant, or to the end of the path.
  constexpr void leave() {
    const BasicPoint<Register> at = now_.at();
    if (borders_ > 0 || left_from(at) > 0) {
      quadrant_ = after(quadrant_, direction_);
      --borders_;
      enter(at);
    } else {
      has_come_out_ = true;
      out_ = at;
    }
  }

  /// Steps from here to the end.
  constexpr Register left_from(BasicPoint<Register> at) const {
    return static_cast<Register>(x_ends_ ? now_.sign_x * (end_.x - at.x) : now_.sign_y * (end_.y - at.y));
  }

  /// To an end that is not where the path has come out.
  constexpr Pulse<2> correct() {
    const Pulse<2> pulse{{sign(static_cast<Register>(end_.x - out_.x)), sign(static_cast<Register>(end_.y - out_.y))}};
    now_.f = static_cast<Register>(now_.f + pulse.step[0] * (2 * out_.x + pulse.step[0]) +
                                   pulse.step[1] * (2 * out_.y + pulse.step[1]));
    out_.x = static_cast<Register>(out_.x + pulse.step[0]);
    out_.y = static_cast<Register>(out_.y + pulse.step[1]);
    return pulse;
  }

  Registers now_;
  bool has_come_out_ = false;
  BasicPoint<Register> end_, out_;  ///< out_: where the path has come out
  Direction direction_;
  bool x_ends_;
  int quadrant_, borders_;
};

}  // namespace leadscrew::pulse
