#pragma once
// Lines and arcs as commands of motion_core.sv, where the formulas of E, S and D stand. Freestanding: integers alone.
//
// Where an octant begins and ends. Along the method of least error (pulse::CircularSearch) g steps at every clock while
// g < s, and s while s ≤ g:
//
//   After a step of g alone or of both F ≤ s − 1 and F ≥ −s, as what was chosen is no farther from the circle than the
//   other. The step is one of s alone where 2 (F + a) + b ≥ 0, F ≥ 2 s − g − 3/2: with F ≤ s − 1 only for s ≤ g; one
//   of g alone where 2 (F + b) + a < 0, F ≤ s − 2 g − 2: with F ≥ −s only for g < s.
//
// So every point is the one nearest to the circle by |F| in its column while g drives, or in its row while s does:
//
//   s(g) = √(R² − g²) rounded to the nearest,    g(s) likewise
//
// for s² + s < R² − g² is where |F| of s + 1 is less than that of s. The point at any g or s is known without those
// before it, but that at the last step of an octant the circle may fall by more than 1, where the path falls by 1. s
// begins to drive at the first g with s(g) ≤ g, that is 2 g² + g ≥ R².
//
// Even speed along the path. A step is as long as its projection on the tangent: where u is the coordinate that does not
// drive and v the one that does, u/R for the driving axis alone and (u + v)/R for both. A command has one word for either,
// so in a piece of the circle a step of one axis takes the time A and one of both A + C, and the speed is R/(A u + C v).
// By the sum w of the piece's ends p and q,
//
//   A = R w_u/(R² + p·q)      C = R w_v/(R² + p·q)
//
// make it 1 at both ends, and between them less: cos(α/2) in the middle of a piece of the angle α, its least. That is
// 7.6 % less for a whole octant, where A = 1 and A + C = √2, and falls with the square of α: to 0.05 % for the pieces
// below, of u/16 steps.
//
// The feed DDA overflows where the path is A + C longer; a step of one axis begins the next one with C/(A + C) of it made.

#include <cstdint>
#include <leadscrew/pulse/arc.hpp>

namespace leadscrew::driver {

/// What a unit of decision is loaded with.
struct Decision {
  std::int64_t decision = -1, straight = 0, diagonal = 0;  ///< E, S, D
  std::int8_t curve = 0;                                   ///< c
};

/// Of the feed word, and what a step of the driving axis alone adds to it beside. Both · 2^30.
struct Pace {
  static constexpr std::uint32_t one = std::uint32_t{1} << 30;
  static constexpr std::uint32_t one_over_root_2 = 759'250'124;

  std::uint32_t feed = one;      ///< 1/(A + C), over the move's feed
  std::uint32_t head_start = 0;  ///< C/(A + C), of an overflow
};

/// √n · 2^places, rounded to the nearest, of 29 to 30 bits; 0 < n < 2^60.
struct ScaledRoot {
  std::int64_t root;
  int places = 0;

  constexpr explicit ScaledRoot(std::int64_t n) {
    for (; n >> 58 == 0; n <<= 2) ++places;
    root = pulse::root(n, 0);
  }
};

/// In a plane: count steps of the driving axis, and the other one by its decision.
struct Octant {
  std::int64_t count = 0;  ///< ≥ 1
  bool x_drives = true;
  std::int8_t sign_x = 0, sign_y = 0;  ///< senses of the steps
  Decision other{};                    ///< of the axis that does not drive
  Pace pace{};                         ///< for an even speed along the path; 1 where not asked for
};

/// How an arc is cut.
enum class Cut : std::uint8_t {
  octants,  ///< at its octants alone
  pieces,   ///< each octant into as many that an even speed is kept, of 16 steps at least
};

/// The unit of an axis that makes `steps` while the driving one makes `count`, 0 ≤ steps ≤ count.
constexpr Decision along_line(std::int64_t steps, std::int64_t count) {
  return {2 * steps - count - 1, 2 * steps, 2 * steps - 2 * count, 0};
}

/// The octants of an arc in order: those of each quadrant, and last, where an end is beside the circle, what corrects
/// that. The same steps as pulse::CircularSearch<Search::least_error>, for |coordinates| ≤ pulse::greatest_coordinate.
class Octants {
 public:
  constexpr explicit Octants(const pulse::Arc& arc, Cut cut = Cut::octants)
      : cut_(cut),
        squared_radius_(arc.squared_radius()),
        end_(arc.end),
        at_(arc.start),
        direction_(arc.direction),
        x_ends_(pulse::absolute(arc.end.y) >= pulse::absolute(arc.end.x)),
        quadrant_(pulse::quadrant(arc.start, arc.direction)),
        borders_(pulse::borders(arc)) {
    enter();
  }

  constexpr bool done() const { return has_come_out_ && at_ == end_; }

  /// Not when done. Octants alone are at most 21 for any arc of R ≥ 8.
  constexpr Octant next() {
    if (has_come_out_) return correction();
    const std::int64_t s = s_, g = g_;
    Octant octant = g < s ? while_g_drives() : while_s_drives();
    if (cut_ == Cut::pieces) octant.pace = g < s ? pace(s, g, s_, g_) : pace(g, s, g_, s_);
    if (s_ == last_s_ || g_ == last_g_) leave();
    return octant;
  }

 private:
  static constexpr std::int64_t none = std::int64_t{1} << 62;

  constexpr std::int64_t deviation(std::int64_t s, std::int64_t g) const { return s * s + g * g - squared_radius_; }
  static constexpr std::int64_t by_shrinking(std::int64_t s) { return 1 - 2 * s; }
  static constexpr std::int64_t by_growing(std::int64_t g) { return 1 + 2 * g; }
  /// √(R² − v²), rounded; 0 beyond the circle.
  constexpr std::int64_t beside(std::int64_t v) const {
    const std::int64_t square = squared_radius_ - v * v;
    return square > 0 ? pulse::root(square, 0) : 0;
  }
  /// √(R² − square), rounded up; 0 beyond the circle.
  constexpr std::int64_t beyond(std::int64_t square) const {
    const std::int64_t rest = squared_radius_ - square;
    if (rest <= 0) return 0;
    const std::int64_t nearest = pulse::root(rest, 0);
    return nearest * nearest < rest ? nearest + 1 : nearest;
  }

  /// The first g with 2 g² + g ≥ R²: that is R/√2 or the one before, but for rounding.
  constexpr std::int64_t octant_end() const {
    std::int64_t g = pulse::root(squared_radius_ / 2, 0);
    while (g > 0 && 2 * (g - 1) * (g - 1) + g - 1 >= squared_radius_) --g;
    while (2 * g * g + g < squared_radius_) ++g;
    return g;
  }

  /// How many of the steps to the octant's end are of one piece; u: the coordinate that does not drive.
  constexpr std::int64_t steps_of_piece(std::int64_t steps, std::int64_t u) const {
    if (cut_ == Cut::octants) return steps;
    const std::int64_t most = u >> 4 > 32 ? u >> 4 : 32, pieces = (steps + most - 1) / most;
    return (steps + pieces - 1) / pieces;
  }

  /// Of a piece from (u, v) to (to_u, to_v).
  constexpr Pace pace(std::int64_t u, std::int64_t v, std::int64_t to_u, std::int64_t to_v) const {
    const ScaledRoot radius(squared_radius_);
    const std::int64_t sum = ((squared_radius_ + u * to_u + v * to_v) << 2 * radius.places) / radius.root;
    const std::int64_t both = u + to_u + v + to_v;
    return {static_cast<std::uint32_t>((sum << 30) / (both << radius.places)),
            static_cast<std::uint32_t>(((v + to_v) << 30) / both)};
  }

  constexpr Octant while_g_drives() {
    const std::int64_t a = by_shrinking(s_), b = by_growing(g_);
    const Decision decision{deviation(s_, g_) + b + (a - 1) / 2, b + 2, a + b + 3, 1};
    std::int64_t to = octant_end();
    if (last_g_ < to) to = last_g_;
    // s(g) ≤ s' where g² ≥ R² − s'² − s'
    const std::int64_t at_last_s = beyond(last_s_ * last_s_ + last_s_);
    if (at_last_s < to) to = at_last_s;
    if (to <= g_) to = g_ + 1;
    to = g_ + steps_of_piece(to - g_, s_);
    const Octant octant = of(to - g_, /*s_drives=*/false, decision);
    const std::int64_t before = to - 1 == g_ ? s_ : beside(to - 1), there = beside(to);
    s_ = there < before - 1 ? before - 1 : there;
    g_ = to;
    return octant;
  }

  constexpr Octant while_s_drives() {
    const std::int64_t a = by_shrinking(s_), b = by_growing(g_);
    const Decision decision{-deviation(s_, g_) - a - (b + 1) / 2, -(a + 2), -(a + b + 3), -1};
    std::int64_t to = last_s_;
    if (last_g_ != none) {
      // g(s) ≥ g' where s² < R² − g'² + g'
      const std::int64_t at_last_g = beyond(last_g_ * last_g_ - last_g_) - 1;
      if (at_last_g > to) to = at_last_g < s_ ? at_last_g : s_ - 1;
    }
    to = s_ - steps_of_piece(s_ - to, g_);
    const Octant octant = of(s_ - to, /*s_drives=*/true, decision);
    const std::int64_t before = to + 1 == s_ ? g_ : beside(to + 1), there = beside(to);
    g_ = there > before + 1 ? before + 1 : there;
    s_ = to;
    return octant;
  }

  constexpr Octant of(std::int64_t count, bool s_drives, const Decision& other) const {
    return {count, s_drives == x_shrinks_, sign_x_, sign_y_, other, {}};
  }

  constexpr void enter() {
    const auto [sign_x, sign_y] = pulse::tangent(quadrant_, direction_).step;
    sign_x_ = sign_x;
    sign_y_ = sign_y;
    x_shrinks_ = ((quadrant_ & 1) == 0) == (direction_ == pulse::Direction::counterclockwise);
    s_ = pulse::absolute(x_shrinks_ ? at_.x : at_.y);
    g_ = pulse::absolute(x_shrinks_ ? at_.y : at_.x);
    last_s_ = 0;
    last_g_ = none;
    if (borders_ > 0) return;
    const std::int64_t left = left_from_here();
    if (left <= 0) {
      has_come_out_ = true;
    } else if (x_ends_ != x_shrinks_) {
      last_g_ = g_ + left;
    } else if (left < s_) {
      last_s_ = s_ - left;
    }
  }

  /// Out of the quadrant, or to the end of the path.
  constexpr void leave() {
    const std::int64_t along = x_shrinks_ ? s_ : g_, across = x_shrinks_ ? g_ : s_;
    at_ = {x_shrinks_ ? -sign_x_ * along : sign_x_ * along, x_shrinks_ ? sign_y_ * across : -sign_y_ * across};
    if (borders_ > 0 || left_from_here() > 0) {
      quadrant_ = pulse::after(quadrant_, direction_);
      --borders_;
      enter();
    } else {
      has_come_out_ = true;
    }
  }

  constexpr std::int64_t left_from_here() const {
    return x_ends_ ? sign_x_ * (end_.x - at_.x) : sign_y_ * (end_.y - at_.y);
  }

  /// To an end that is not where the path has come out: both axes, then the one that has further to go.
  constexpr Octant correction() {
    const std::int64_t x = end_.x - at_.x, y = end_.y - at_.y;
    const std::int64_t far_x = pulse::absolute(x), far_y = pulse::absolute(y), both = far_x < far_y ? far_x : far_y;
    Octant octant{both, true, pulse::sign(x), pulse::sign(y), {0, 0, 0, 0}, {}};
    if (both == 0) octant = {far_x + far_y, far_x > 0, pulse::sign(x), pulse::sign(y), {}, {}};
    if (cut_ == Cut::pieces && both > 0) octant.pace.feed = Pace::one_over_root_2;
    at_.x += x == 0 ? 0 : octant.sign_x * octant.count;
    at_.y += y == 0 ? 0 : octant.sign_y * octant.count;
    return octant;
  }

  Cut cut_;
  std::int64_t squared_radius_;
  pulse::Point end_, at_;  // at_: where the quadrant begins, or the path has come out
  std::int64_t s_ = 0, g_ = 0, last_s_ = 0, last_g_ = none;
  pulse::Direction direction_;
  std::int8_t sign_x_ = 0, sign_y_ = 0;
  bool x_ends_, x_shrinks_ = true, has_come_out_ = false;
  int quadrant_, borders_;
};

}  // namespace leadscrew::driver
