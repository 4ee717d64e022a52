#include <algorithm>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/toolpath/corridor_check.hpp>
#include <utility>

namespace leadscrew::toolpath {

namespace {

template <std::size_t D>
using Bezier = std::array<Vector<D>, 4>;

template <std::size_t D>
Bezier<D> interval_of(const TimeSpline<D>& motion, std::size_t k) {
  const Vector<D>* const c = &motion.points[k];
  Bezier<D> b;
  for (std::size_t i = 0; i < D; ++i) {
    b[0][i] = (c[0][i] + 4 * c[1][i] + c[2][i]) / 6;
    b[1][i] = (2 * c[1][i] + c[2][i]) / 3;
    b[2][i] = (c[1][i] + 2 * c[2][i]) / 3;
    b[3][i] = (c[1][i] + 4 * c[2][i] + c[3][i]) / 6;
  }
  return b;
}

/// Cuts at u, 0 < u < 1: the first part remains, the second is returned (de Casteljau).
template <std::size_t D>
Bezier<D> cut(Bezier<D>& b, double u) {
  const auto mix = [&](const Vector<D>& x, const Vector<D>& y) { return along(x, u, between(x, y)); };
  const Vector<D> ab = mix(b[0], b[1]), bc = mix(b[1], b[2]), cd = mix(b[2], b[3]);
  const Vector<D> abc = mix(ab, bc), bcd = mix(bc, cd), middle = mix(abc, bcd);
  const Bezier<D> second = {middle, bcd, cd, b[3]};
  b = {b[0], ab, abc, middle};
  return second;
}

template <std::size_t D>
class Check {
 public:
  explicit Check(const Corridor<D>& corridor) : corridor_(corridor), shares_(corridor.legs.size()) {}

  /// Goes on along a leg; looks closer where it seems to be farther off than any place before.
  void add(const Bezier<D>& part, std::size_t leg, int halvings = 4) {
    const CorridorLeg<D>& at = corridor_.legs[leg];
    const double share = share_of(part, at);
    if (share > std::max(shares_[leg], close) && halvings > 0) {
      Bezier<D> first = part;
      const Bezier<D> second = cut(first, 0.5);
      add(first, leg, halvings - 1);
      add(second, leg, halvings - 1);
      return;
    }
    shares_[leg] = std::max(shares_[leg], share);
    farthest_ = std::max(farthest_, goes_on(part, at) ? at.advance(part[3]) : greatest_advance(part, at));
    if (leg + 1 == corridor_.legs.size()) return;
    for (const Vector<D>& b : part) {
      if (at.advance(b) >= at.length) ahead_ = std::max(ahead_, corridor_.legs[leg + 1].advance(b));
    }
  }

  void pass(std::size_t joint, const Vector<D>& x) {
    const double off = size(between(corridor_.legs[joint].to, x));
    for (const std::size_t leg : {joint, joint + 1})
      shares_[leg] = std::max(shares_[leg], off / corridor_.legs[leg].margin);
    farthest_ = std::max(std::exchange(ahead_, 0.0), corridor_.legs[joint + 1].advance(x));
  }

  std::vector<double> shares() const { return shares_; }

 private:
  static constexpr double close = 0.95;  // below, it does not matter how near

  static bool goes_on(const Bezier<D>& part, const CorridorLeg<D>& leg) {
    const double b[] = {leg.advance(part[0]), leg.advance(part[1]), leg.advance(part[2]), leg.advance(part[3])};
    return b[0] <= b[1] && b[1] <= b[2] && b[2] <= b[3];
  }
  static double greatest_advance(const Bezier<D>& part, const CorridorLeg<D>& leg) {
    double most = 0;
    for (const Vector<D>& b : part) most = std::max(most, leg.advance(b));
    return most;
  }

  double share_of(const Bezier<D>& part, const CorridorLeg<D>& leg) const {
    double off = 0, least = leg.length;
    for (const Vector<D>& b : part) {
      off = std::max(off, size(leg.nearest(b).offset));
      least = std::min(least, leg.advance(b));
    }
    if (leg.is_arc) off = std::max(off, inside_of(part, leg));
    const double most = goes_on(part, leg) ? farthest_ : std::max(farthest_, greatest_advance(part, leg));
    return (off + std::max(0.0, most - least)) / leg.margin;
  }

  /// How far the part comes inside an arc, at most: a line across it bounds what lies beyond.
  static double inside_of(const Bezier<D>& part, const CorridorLeg<D>& leg) {
    Vector<D> outward{};
    for (const std::size_t i : {leg.first, leg.second}) outward[i] = part[0][i] + part[3][i] - 2 * leg.center[i];
    const double length = size(outward);
    double off = 0;
    for (const Vector<D>& b : part) {
      Vector<D> from{};
      for (const std::size_t i : {leg.first, leg.second}) from[i] = b[i] - leg.center[i];
      off = std::max(off, leg.radius - inner(outward, from) / length);
    }
    double across = 0;
    for (std::size_t i = 0; i < D; ++i) {
      if (i != leg.first && i != leg.second)
        for (const Vector<D>& b : part) across = std::max(across, std::abs(b[i] - leg.from[i]));
    }
    return numeric::hypot(off, across);
  }

  const Corridor<D>& corridor_;
  std::vector<double> shares_;
  double farthest_ = 0;  // along the leg
  double ahead_ = 0;     // and along the next, of what is beyond its end
};

}  // namespace

template <std::size_t D>
std::vector<double> shares_of_margins(const Corridor<D>& corridor, const TimeSpline<D>& motion) {
  Check<D> check(corridor);
  std::size_t leg = 0;
  for (std::size_t k = 0; k < motion.intervals(); ++k) {
    Bezier<D> rest = interval_of(motion, k);
    double from = static_cast<double>(k);
    const double to = from + 1;
    for (; leg < motion.passes.size() && motion.passes[leg] < to; ++leg) {
      const double pass = std::max(motion.passes[leg], from);
      Bezier<D> before = rest;
      if (pass > from) {
        rest = cut(before, (pass - from) / (to - from));
        check.add(before, leg);
      }
      check.pass(leg, rest[0]);
      from = pass;
    }
    check.add(rest, leg);
  }
  return check.shares();
}

template std::vector<double> shares_of_margins<2>(const Corridor<2>&, const TimeSpline<2>&);
template std::vector<double> shares_of_margins<3>(const Corridor<3>&, const TimeSpline<3>&);

}  // namespace leadscrew::toolpath
