#pragma once
// Circular interpolation by search: at every clock the step is taken that F = x² + y² − R² asks for. F is kept by
// additions: after a step of x by s it is F + 2sx + 1, after one of y by t F + 2ty + 1, after both their sum.
//
// Methods, after "Four circular interpolators in an FPGA" (there for the first quadrant):
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

template <Search method, OnCircle on_circle = OnCircle::outward>
class CircularSearch {
 public:
  static constexpr std::size_t axes = 2;

  constexpr explicit CircularSearch(const Arc& arc)
      : end_(arc.end),
        at_(arc.start),
        direction_(arc.direction),
        x_ends_(absolute(arc.end.y) >= absolute(arc.end.x)),
        quadrant_(quadrant(arc.start, arc.direction)),
        borders_(borders(arc)) {
    enter();
  }

  constexpr bool done() const { return left_ <= 0 && at_ == end_; }

  constexpr Pulse<2> step() {
    if (left_ <= 0) return correct();
    const auto [x_steps, y_steps] = choose();
    // Masks, for a branch would go the wrong way every third clock.
    f_ += (-x_steps & by_x_) + (-y_steps & by_y_);
    by_x_ += 2 * x_steps;
    by_y_ += 2 * y_steps;
    left_ -= x_ends_ ? x_steps : y_steps;
    const Pulse<2> pulse{{static_cast<std::int8_t>(-x_steps & sign_x_), static_cast<std::int8_t>(-y_steps & sign_y_)}};
    at_.x += pulse.step[0];
    at_.y += pulse.step[1];
    // No quadrant is left but over an axis.
    if ((at_.x == 0 || at_.y == 0) && left_ > 0 && quadrant(at_, direction_) != quadrant_) {
      quadrant_ = quadrant(at_, direction_);
      --borders_;
      enter();
    }
    return pulse;
  }

  constexpr Point at() const { return at_; }
  constexpr std::int64_t deviation() const { return f_; }  ///< F
  constexpr int in_quadrant() const { return quadrant_; }  ///< 0 … 3

 private:
  struct Steps {
    std::int64_t x = 0, y = 0;  // 0 or 1
  };

  constexpr Steps choose() const {
    if constexpr (method == Search::point_comparison) {
      const bool inward = on_circle == OnCircle::inward ? f_ >= 0 : f_ > 0;
      return {inward == x_shrinks_, inward != x_shrinks_};
    } else if constexpr (method == Search::least_error) {
      // |F + a + b| ≤ |F + a| where b(2F + 2a + b) ≤ 0; what the shrinking axis adds is below 0, the other's above.
      const std::int64_t twice = 2 * f_ + by_x_ + by_y_;
      const std::int64_t shrinks = twice + (x_shrinks_ ? by_y_ : by_x_) >= 0;
      const std::int64_t grows = twice + (x_shrinks_ ? by_x_ : by_y_) <= 0;
      return x_shrinks_ ? Steps{shrinks, grows} : Steps{grows, shrinks};
    } else {
      const std::int64_t x = absolute(at_.x), y = absolute(at_.y);
      const bool y_is_long = x > y || (x == y && x_shrinks_);
      const bool both = asks_for_both(y_is_long ? x : y, y_is_long ? by_y_ : by_x_, y_is_long == x_shrinks_);
      return {both || !y_is_long, both || y_is_long};
    }
  }

  /// The place on the circle beside the next one of the long axis: w² = v² − F − (what the long axis' step adds). It
  /// is nearer to v ∓ 1 than to v where 4w² has passed (2v ∓ 1)²: twice F and the like is enough to tell.
  constexpr bool asks_for_both(std::int64_t v, std::int64_t by_long, bool shrinks) const {
    const std::int64_t beyond = 4 * (f_ + by_long);  // 4v² − 4w²
    return shrinks ? beyond >= 4 * v - 1 : beyond <= -4 * v - 1;
  }

  /// A quadrant. In the last one the axis that is fast near the end says when it is reached.
  constexpr void enter() {
    const auto [sign_x, sign_y] = tangent(quadrant_, direction_).step;
    sign_x_ = sign_x;
    sign_y_ = sign_y;
    by_x_ = 2 * sign_x * at_.x + 1;
    by_y_ = 2 * sign_y * at_.y + 1;
    x_shrinks_ = ((quadrant_ & 1) == 0) == (direction_ == Direction::counterclockwise);
    if (borders_ <= 0) left_ = x_ends_ ? sign_x * (end_.x - at_.x) : sign_y * (end_.y - at_.y);
  }

  /// To an end that is not where the path has come out.
  constexpr Pulse<2> correct() {
    const Pulse<2> pulse{{sign(end_.x - at_.x), sign(end_.y - at_.y)}};
    at_.x += pulse.step[0];
    at_.y += pulse.step[1];
    return pulse;
  }

  Point end_, at_;
  std::int64_t f_ = 0, by_x_ = 0, by_y_ = 0;     ///< F, and what a step of x or y adds to it
  std::int64_t left_ = 4 * greatest_coordinate;  ///< steps to the end, once that is in this quadrant
  Direction direction_;
  bool x_ends_, x_shrinks_ = false;
  int quadrant_, borders_;
  std::int8_t sign_x_ = 0, sign_y_ = 0;
};

}  // namespace leadscrew::pulse
