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

/// In each quadrant one coordinate shrinks to 0 while the other grows. Both are kept by what the next step of them adds
/// to F: 1 − 2|x| and 2|y| + 1 where x shrinks, the other way round where y does.
template <Search method, OnCircle on_circle = OnCircle::outward>
class CircularSearch {
 public:
  static constexpr std::size_t axes = 2;

  constexpr explicit CircularSearch(const Arc& arc)
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
    const auto [shrinks, grows] = choose();
    f_ += (shrinks & by_shrinking_) + (grows & by_growing_);
    by_shrinking_ -= 2 * shrinks;
    by_growing_ -= 2 * grows;
    const std::int64_t crossed = (shrinks ^ grows) & y_shrinks_;
    const Pulse<2> pulse{{static_cast<std::int8_t>((shrinks ^ crossed) & sign_x_),
                          static_cast<std::int8_t>((grows ^ crossed) & sign_y_)}};
    if (by_shrinking_ == last_shrinking_ || by_growing_ == last_growing_) leave();
    return pulse;
  }

  constexpr Point at() const {
    if (has_come_out_) return out_;
    const std::int64_t shrinking = (by_shrinking_ - 1) / 2, growing = (by_growing_ - 1) / 2;  // along the tangent
    return y_shrinks_ ? Point{sign_x_ * growing, sign_y_ * shrinking} : Point{sign_x_ * shrinking, sign_y_ * growing};
  }
  constexpr std::int64_t deviation() const { return f_; }  ///< F
  constexpr int in_quadrant() const { return quadrant_; }  ///< 0 … 3

 private:
  /// Masks, for a branch would be mispredicted every third clock: −1 where the axis steps, else 0.
  struct Steps {
    std::int64_t shrinking = 0, growing = 0;
  };
  static constexpr std::int64_t where_negative(std::int64_t value) { return value >> 63; }

  constexpr Steps choose() const {
    if constexpr (method == Search::point_comparison) {
      const std::int64_t outward = where_negative(on_circle == OnCircle::inward ? f_ : f_ - 1);
      return {~outward, outward};
    } else {
      // Of two steps, which add a and b: |F + a + b| < |F + b| where a(2F + 2b + a) < 0. As a < 0 for the shrinking
      // axis, and b > 0 for the other, and both are odd, neither bracket is 0.
      const std::int64_t shrinks = ~where_negative(2 * (f_ + by_growing_) + by_shrinking_);
      const std::int64_t grows = where_negative(2 * (f_ + by_shrinking_) + by_growing_);
      if constexpr (method == Search::least_error) return {shrinks, grows};
      // w² = v² − F − b: the place on the circle beside the next one of the long axis. It is nearer to v ∓ 1 than to v
      // where 4w² has passed (2v ∓ 1)², which is where the same brackets change sign.
      const std::int64_t growing_is_long = where_negative(by_shrinking_ + by_growing_ - 3);
      return {shrinks | ~growing_is_long, grows | growing_is_long};
    }
  }

  /// A quadrant. In the last one the axis that is fast near the end says when it is reached.
  constexpr void enter(Point at) {
    const auto [sign_x, sign_y] = tangent(quadrant_, direction_).step;
    const bool x_shrinks = ((quadrant_ & 1) == 0) == (direction_ == Direction::counterclockwise);
    sign_x_ = sign_x;
    sign_y_ = sign_y;
    y_shrinks_ = x_shrinks ? 0 : -1;
    by_shrinking_ = 1 - 2 * absolute(x_shrinks ? at.x : at.y);
    by_growing_ = 1 + 2 * absolute(x_shrinks ? at.y : at.x);
    last_shrinking_ = 1;
    last_growing_ = 0;
    if (borders_ > 0) return;
    const std::int64_t left = left_from(at);
    if (left <= 0) {
      has_come_out_ = true;
      out_ = at;
    } else if (x_ends_ != x_shrinks) {
      last_growing_ = by_growing_ + 2 * left;
    } else if (by_shrinking_ + 2 * left < 1) {
      last_shrinking_ = by_shrinking_ + 2 * left;
    }
  }

  /// Out of the quadrant, or to the end of the path.
  constexpr void leave() {
    const Point at = this->at();
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
  constexpr std::int64_t left_from(Point at) const {
    return x_ends_ ? sign_x_ * (end_.x - at.x) : sign_y_ * (end_.y - at.y);
  }

  /// To an end that is not where the path has come out.
  constexpr Pulse<2> correct() {
    const Pulse<2> pulse{{sign(end_.x - out_.x), sign(end_.y - out_.y)}};
    f_ += pulse.step[0] * (2 * out_.x + pulse.step[0]) + pulse.step[1] * (2 * out_.y + pulse.step[1]);
    out_.x += pulse.step[0];
    out_.y += pulse.step[1];
    return pulse;
  }

  std::int64_t f_ = 0, by_shrinking_ = 0, by_growing_ = 0;  ///< F, and what a step of either axis adds to it
  std::int64_t last_shrinking_ = 1, last_growing_ = 0;      ///< what they are where the quadrant, or the path, ends
  std::int64_t sign_x_ = 0, sign_y_ = 0;
  std::int64_t y_shrinks_ = 0;  ///< a mask
  bool has_come_out_ = false;
  Point end_, out_;  ///< out_: where the path has come out
  Direction direction_;
  bool x_ends_;
  int quadrant_, borders_;
};

}  // namespace leadscrew::pulse
