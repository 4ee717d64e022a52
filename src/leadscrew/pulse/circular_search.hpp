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

class CircularSearch {
 public:
  static constexpr std::size_t axes = 2;

  constexpr CircularSearch(Search method, const Arc& arc, OnCircle on_circle = OnCircle::outward)
      : method_(method),
        on_circle_(on_circle),
        direction_(arc.direction),
        end_(arc.end),
        at_(arc.start),
        x_ends_(absolute(arc.end.y) >= absolute(arc.end.x)),
        quadrant_(quadrant(arc.start, arc.direction)),
        borders_(borders(arc)) {
    const auto [sign_x, sign_y] = tangent(quadrant_, direction_).step;
    sign_x_ = sign_x;
    sign_y_ = sign_y;
    look_for_end();
  }

  constexpr bool done() const { return is_at_end_ && at_ == end_; }

  constexpr Pulse<2> step() {
    if (is_at_end_) return correct();
    const Pulse<2> pulse = choose();
    move(pulse);
    look_for_end();
    if (!is_at_end_ && quadrant(at_, direction_) != quadrant_) enter();
    return pulse;
  }

  constexpr Point at() const { return at_; }
  constexpr std::int64_t deviation() const { return f_; }  ///< F

 private:
  constexpr Pulse<2> choose() const {
    const std::int64_t by_x = 2 * sign_x_ * at_.x + 1, by_y = 2 * sign_y_ * at_.y + 1;
    const Pulse<2> x{{sign_x_, 0}}, y{{0, sign_y_}}, both{{sign_x_, sign_y_}};
    const bool x_shrinks = ((quadrant_ & 1) == 0) == (direction_ == Direction::counterclockwise);
    switch (method_) {
      case Search::point_comparison: {
        const bool inward = on_circle_ == OnCircle::inward ? f_ >= 0 : f_ > 0;
        return inward == x_shrinks ? x : y;
      }
      case Search::least_error: {
        const std::int64_t d = absolute(f_ + by_x + by_y), dx = absolute(f_ + by_x), dy = absolute(f_ + by_y);
        if (d <= dx && d <= dy) return both;
        return dx <= dy ? x : y;
      }
      case Search::improved_least_error:
        break;
    }
    const bool y_is_long = absolute(at_.x) > absolute(at_.y) || (absolute(at_.x) == absolute(at_.y) && x_shrinks);
    return y_is_long ? (asks_for_both(absolute(at_.x), by_y, x_shrinks) ? both : y)
                     : (asks_for_both(absolute(at_.y), by_x, !x_shrinks) ? both : x);
  }

  /// The place on the circle beside the next one of the long axis: w² = v² − F − (what the long axis' step adds). It
  /// is nearer to v ∓ 1 than to v where 4w² has passed (2v ∓ 1)².
  constexpr bool asks_for_both(std::int64_t v, std::int64_t by_long, bool shrinks) const {
    const std::int64_t w = v * v - f_ - by_long, middle = shrinks ? 2 * v - 1 : 2 * v + 1;
    return shrinks ? 4 * w <= middle * middle : 4 * w >= middle * middle;
  }

  constexpr void move(const Pulse<2>& pulse) {
    f_ += pulse.step[0] * (2 * at_.x + pulse.step[0]) + pulse.step[1] * (2 * at_.y + pulse.step[1]);
    at_.x += pulse.step[0];
    at_.y += pulse.step[1];
  }

  constexpr void enter() {
    quadrant_ = quadrant(at_, direction_);
    --borders_;
    const auto [sign_x, sign_y] = tangent(quadrant_, direction_).step;
    sign_x_ = sign_x;
    sign_y_ = sign_y;
    look_for_end();
  }

  /// In the last quadrant the axis that is fast near the end says when it is reached.
  constexpr void look_for_end() {
    if (borders_ > 0) return;
    is_at_end_ = x_ends_ ? sign_x_ * (end_.x - at_.x) <= 0 : sign_y_ * (end_.y - at_.y) <= 0;
  }

  /// To an end that is not where the path has come out.
  constexpr Pulse<2> correct() {
    const Pulse<2> pulse{{sign(end_.x - at_.x), sign(end_.y - at_.y)}};
    move(pulse);
    return pulse;
  }

  Search method_;
  OnCircle on_circle_;
  Direction direction_;
  Point end_, at_;
  bool x_ends_, is_at_end_ = false;
  int quadrant_, borders_;
  std::int8_t sign_x_ = 0, sign_y_ = 0;
  std::int64_t f_ = 0;
};

}  // namespace leadscrew::pulse
