#include <algorithm>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/numeric/log_sum.hpp>
#include <leadscrew/toolpath/corridor_barrier.hpp>

namespace leadscrew::toolpath {

namespace {

constexpr double least_slack = 1e-12;  // relative
// Control points that are given had another interval, by some hundredths: so much more is allowed, in so many
// intervals beside them. Were it much more, motion would be too fast there, in fewer intervals than its path takes.
constexpr double given_relaxation = 1.05;
constexpr std::size_t given_intervals = 5;

constexpr std::array<double, 2> first_difference = {-1, 1};
constexpr std::array<double, 3> second_difference = {1, -2, 1};
constexpr std::array<double, 4> third_difference = {-1, 3, -3, 1};
constexpr std::array<double, 3> knot_weights = {1.0 / 6, 4.0 / 6, 1.0 / 6};
// At thirds of an interval.
constexpr std::array<double, 4> first_third_weights = {8.0 / 162, 93.0 / 162, 60.0 / 162, 1.0 / 162};
constexpr std::array<double, 4> second_third_weights = {1.0 / 162, 60.0 / 162, 93.0 / 162, 8.0 / 162};

template <std::size_t D, std::size_t count>
Vector<D> sum_of(const Vector<D>* points, const std::array<double, count>& factors) {
  Vector<D> sum{};
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < D; ++i) sum[i] += factors[k] * points[k][i];
  }
  return sum;
}

/// −log(g² − u²), g ∝ w^power: all its derivatives.
struct TwoSided {
  double slope, curvature, mixed, w_slope, w_curvature;
  TwoSided(double u, double g, double power, double w) {
    const double inverse = 1 / (g * g - u * u), square = 2 * inverse * inverse;
    const double g_slope = power * g / w, g_curvature = power * (power - 1) * g / (w * w);
    slope = 2 * u * inverse;
    curvature = square * (g * g + u * u);
    mixed = -2 * square * g * u * g_slope;
    w_slope = -2 * g * inverse * g_slope;
    w_curvature = curvature * g_slope * g_slope - 2 * g * inverse * g_curvature;
  }
};

template <std::size_t D>
struct Bounds {
  Vector<D> jerk{}, acceleration{}, velocity{};
  double h = 0;
  Bounds(const CorridorLimits<D>& limits, double interval) : h(interval) {
    for (std::size_t i = 0; i < D; ++i) {
      jerk[i] = limits.jerk[i] * h * h * h;
      acceleration[i] = limits.acceleration[i] * h * h;
      velocity[i] = limits.velocity[i] * h;
    }
  }
};

/// The four weights of the control points at a time, and which is the first.
struct SplinePlace {
  std::size_t first;
  std::array<double, 4> weights, slopes;
  SplinePlace(double time, std::size_t intervals) {
    const double begin = std::clamp(std::floor(time), 0.0, static_cast<double>(intervals) - 1);
    const double u = time - begin, v = 1 - u;
    first = static_cast<std::size_t>(begin);
    weights = {v * v * v / 6, ((3 * u - 6) * u * u + 4) / 6, (((3 - 3 * u) * u + 3) * u + 1) / 6, u * u * u / 6};
    slopes = {-v * v / 2, (3 * u - 4) * u / 2, ((2 - 3 * u) * u + 1) / 2, u * u / 2};
  }
};

template <std::size_t D>
using Square = std::array<std::array<double, D>, D>;

/// Does an offset hardly change with motion in that direction, length 1? So it is beside a leg, and beyond its end where
/// the next one turns by little.
template <std::size_t D>
bool is_across(const Vector<D>& offset, const Vector<D>& direction) {
  constexpr double nearly = 0.3;
  return std::abs(inner(offset, direction)) <= nearly * size(offset);
}

/// Adds terms to the model.
template <std::size_t D>
class Adder {
 public:
  Adder(NewtonModel<D>& model, double w) : model_(model), w_(w) {}

  template <std::size_t count>
  void two_sided(std::size_t first, const std::array<double, count>& factors, std::size_t axis, double u, double g,
                 double power) {
    const TwoSided term(u, g, power, w_);
    model_.w_slope += term.w_slope;
    model_.w_curvature += term.w_curvature;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t row = D * (first + i) + axis;
      model_.slope[row] += term.slope * factors[i];
      model_.border[row] += term.mixed * factors[i];
      auto& entries = model_.hessian.row(row);
      for (std::size_t k = 0; k <= i; ++k) entries[D * (i - k)] += term.curvature * factors[i] * factors[k];
    }
  }

  /// A term of all coordinates: slope and Hessian in the sum of the points, weighted.
  template <std::size_t count>
  void vector(std::size_t first, const std::array<double, count>& factors, const Vector<D>& slope,
              const Square<D>& curvature, const Vector<D>& mixed) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t a = 0; a < D; ++a) {
        const std::size_t row = D * (first + i) + a;
        model_.slope[row] += slope[a] * factors[i];
        model_.border[row] += mixed[a] * factors[i];
        auto& entries = model_.hessian.row(row);
        for (std::size_t k = 0; k < i; ++k) {
          for (std::size_t b = 0; b < D; ++b) entries[D * (i - k) + a - b] += factors[i] * factors[k] * curvature[a][b];
        }
        for (std::size_t b = 0; b <= a; ++b) entries[a - b] += factors[i] * factors[i] * curvature[a][b];
      }
    }
  }

  /// −log(1 − |q|²/P²); q may change along `tangent` at no cost, if there is one.
  template <std::size_t count>
  void distance(std::size_t first, const std::array<double, count>& factors, const Vector<D>& q, double margin,
                const Vector<D>* tangent) {
    const double inverse = 2 / (margin * margin - inner(q, q));
    Vector<D> slope;
    Square<D> curvature;
    for (std::size_t a = 0; a < D; ++a) {
      slope[a] = inverse * q[a];
      for (std::size_t b = 0; b < D; ++b) {
        curvature[a][b] = inverse * inverse * q[a] * q[b] + (a == b ? inverse : 0);
        if (tangent != nullptr) curvature[a][b] -= inverse * (*tangent)[a] * (*tangent)[b];
      }
    }
    vector(first, factors, slope, curvature, {});
  }

 private:
  NewtonModel<D>& model_;
  double w_;
};

}  // namespace

template <std::size_t D>
CorridorBarrier<D>::CorridorBarrier(const Corridor<D>& corridor, std::size_t intervals, double start_interval)
    : corridor_(corridor), intervals_(intervals), start_interval_(start_interval) {
  double slowest = unlimited;
  for (const double v : corridor.limits.velocity) slowest = std::min(slowest, v);
  for (const CorridorLeg<D>& leg : corridor.legs) has_velocity_limit_ = has_velocity_limit_ || leg.feed > slowest;
  const double n = static_cast<double>(intervals);
  inequalities_ = static_cast<double>(2 * D) * n * (has_velocity_limit_ ? 3 : 2) + (places + 1) * n +
                  static_cast<double>(corridor.legs.size());
}

template <std::size_t D>
double CorridorBarrier<D>::relaxed(std::size_t k) const {
  if (corridor_.begin == CorridorEnd::moving && k < given_intervals) return given_relaxation;
  if (corridor_.end == CorridorEnd::moving && k + given_intervals >= intervals_) return given_relaxation;
  return 1;
}

/// Of interval k.
template <std::size_t D>
double CorridorBarrier<D>::feed_of(std::size_t k, const Passing& passing) const {
  const std::uint32_t from = passing.legs[places * k], to = passing.legs[places * (k + 1)];
  double feed = corridor_.legs[from].feed;
  for (std::uint32_t leg = from + 1; leg <= to; ++leg) feed = std::min(feed, corridor_.legs[leg].feed);
  return feed;
}

template <std::size_t D>
void CorridorBarrier<D>::assign(Passing& passing) const {
  const std::size_t count = places * intervals_ + 1;
  passing.legs.resize(count);
  std::uint32_t leg = 0;
  for (std::size_t i = 0; i < count; ++i) {
    while (leg < passing.passes.size() && static_cast<double>(i) > places * passing.passes[leg]) ++leg;
    passing.legs[i] = leg;
  }
}

template <std::size_t D>
void CorridorBarrier<D>::follow(const std::vector<Vector<D>>& points, std::vector<double>& passes) const {
  constexpr double apart = 0.25;
  const double last = static_cast<double>(intervals_) - 1;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const double low = i > 0 ? passes[i - 1] + apart : 1, high = i + 1 < passes.size() ? passes[i + 1] - apart : last;
    if (!(low <= high)) continue;
    const Vector<D>& joint = corridor_.legs[i].to;
    const auto off_at = [&](double time) {
      const SplinePlace at(time, intervals_);
      return between(joint, sum_of(&points[at.first], at.weights));
    };
    double time = std::clamp(passes[i], low, high);
    Vector<D> off = off_at(time);
    double best = inner(off, off);
    // Where the offset is across the velocity: a few steps of Newton's method, then smaller ones to whichever side is lower.
    double step = 0;
    for (int k = 0; k < 4; ++k) {
      const SplinePlace at(time, intervals_);
      const Vector<D> velocity = sum_of(&points[at.first], at.slopes);
      const double square = inner(velocity, velocity);
      if (!(square > 0)) break;
      step = std::clamp(-inner(off, velocity) / square, -2.0, 2.0);
      double next = std::clamp(time + step, low, high);
      Vector<D> there = off_at(next);
      double less = inner(there, there);
      for (int halving = 0; halving < 3 && !(less < best); ++halving) {
        next = std::clamp(time + (step /= 4), low, high);
        there = off_at(next);
        less = inner(there, there);
      }
      if (!(less < best)) break;
      const double moved = std::abs(next - time);
      time = next, off = there, best = less;
      if (moved < 0.01) break;
    }
    passes[i] = time;
  }
}

template <std::size_t D>
double CorridorBarrier<D>::value(double t, const CorridorPoint<D>& at, const Passing& passing) const {
  if (!(at.w > 0)) return unlimited;
  const Bounds<D> most(corridor_.limits, start_interval_ * numeric::cbrt(at.w));
  const std::vector<Vector<D>>& c = at.points;
  numeric::LogSum sum(least_slack);
  for (std::size_t k = 0; k < intervals_; ++k) {
    const double more = relaxed(k);
    const Vector<D> jerk = sum_of(&c[k], third_difference);
    double factor = 1;
    for (std::size_t i = 0; i < D; ++i) {
      const double share = jerk[i] / (more * most.jerk[i]);
      const double slack = 1 - share * share;
      if (!(slack > least_slack)) return unlimited;
      factor *= slack;
    }
    // Jerk and the others count in w as well: g² (1 − u²/g²).
    const Vector<D> acceleration = sum_of(&c[k + 1], second_difference);
    for (std::size_t i = 0; i < D; ++i) {
      const double share = acceleration[i] / (more * most.acceleration[i]);
      const double slack = 1 - share * share;
      if (!(slack > least_slack)) return unlimited;
      factor *= slack;
    }
    const Vector<D> velocity = sum_of(&c[k + 1], first_difference);
    if (has_velocity_limit_) {
      for (std::size_t i = 0; i < D; ++i) {
        const double share = velocity[i] / (more * most.velocity[i]);
        const double slack = 1 - share * share;
        if (!(slack > least_slack)) return unlimited;
        factor *= slack;
      }
    }
    const double feed = more * feed_of(k, passing) * most.h;
    if (feed < unlimited) {
      const double slack = 1 - inner(velocity, velocity) / (feed * feed);
      if (!(slack > least_slack)) return unlimited;
      factor *= slack;
    }
    if (!sum.add(factor)) return unlimited;
    const auto inside = [&](std::size_t place, const Vector<D>& x) {
      const CorridorLeg<D>& leg = corridor_.legs[passing.legs[place]];
      const Vector<D> off = leg.nearest(x).offset;
      return sum.add(1 - inner(off, off) / (leg.margin * leg.margin));
    };
    if (k > 0 && !inside(places * k, sum_of(&c[k], knot_weights))) return unlimited;
    if (!inside(places * k + 1, sum_of(&c[k], first_third_weights))) return unlimited;
    if (!inside(places * k + 2, sum_of(&c[k], second_third_weights))) return unlimited;
  }
  for (std::size_t i = 0; i < passing.passes.size(); ++i) {
    const SplinePlace place(passing.passes[i], intervals_);
    const Vector<D> off = between(corridor_.legs[i].to, sum_of(&c[place.first], place.weights));
    const double margin = corridor_.margin_at(i);
    if (!sum.add(1 - inner(off, off) / (margin * margin))) return unlimited;
  }
  // Of g² of all two-sided bounds: 2 log g each, g ∝ w, w^(2/3), w^(1/3).
  const double n = static_cast<double>(intervals_), d = static_cast<double>(D);
  double powers = n * d * (2.0 + 4.0 / 3 + (has_velocity_limit_ ? 2.0 / 3 : 0));
  for (std::size_t k = 0; k < intervals_; ++k) powers += feed_of(k, passing) < unlimited ? 2.0 / 3 : 0;
  return t * at.w - sum.value() - powers * numeric::log(at.w);
}

template <std::size_t D>
void CorridorBarrier<D>::assemble(double t, const CorridorPoint<D>& at, const Passing& passing,
                                  NewtonModel<D>& model) const {
  const double w = at.w;
  const Bounds<D> most(corridor_.limits, start_interval_ * numeric::cbrt(w));
  const std::vector<Vector<D>>& c = at.points;
  model.reset(c.size());
  model.w_slope = t;
  Adder<D> add(model, w);
  const auto tube = [&](std::size_t place, std::size_t first, const auto& weights) {
    const CorridorLeg<D>& leg = corridor_.legs[passing.legs[place]];
    const auto near = leg.nearest(sum_of(&c[first], weights));
    add.distance(first, weights, near.offset, leg.margin,
                 is_across(near.offset, near.tangent) ? &near.tangent : nullptr);
  };
  for (std::size_t k = 0; k < intervals_; ++k) {
    const double more = relaxed(k);
    const Vector<D> jerk = sum_of(&c[k], third_difference), acceleration = sum_of(&c[k + 1], second_difference),
                    velocity = sum_of(&c[k + 1], first_difference);
    for (std::size_t i = 0; i < D; ++i) {
      add.two_sided(k, third_difference, i, jerk[i], more * most.jerk[i], 1);
      add.two_sided(k + 1, second_difference, i, acceleration[i], more * most.acceleration[i], 2.0 / 3);
      if (has_velocity_limit_) add.two_sided(k + 1, first_difference, i, velocity[i], more * most.velocity[i], 1.0 / 3);
    }
    const double feed = more * feed_of(k, passing) * most.h;
    if (feed < unlimited) {
      // −log(g² − |u|²), g ∝ w^(1/3)
      const double inverse = 1 / (feed * feed - inner(velocity, velocity)), g = feed;
      const double g_slope = g / (3 * w), g_curvature = -2 * g / (9 * w * w);
      Vector<D> slope, mixed;
      Square<D> curvature;
      for (std::size_t a = 0; a < D; ++a) {
        slope[a] = 2 * inverse * velocity[a];
        mixed[a] = -4 * inverse * inverse * g * g_slope * velocity[a];
        for (std::size_t b = 0; b < D; ++b)
          curvature[a][b] = 4 * inverse * inverse * velocity[a] * velocity[b] + (a == b ? 2 * inverse : 0);
      }
      add.vector(k + 1, first_difference, slope, curvature, mixed);
      model.w_slope += -2 * g * inverse * g_slope;
      model.w_curvature += (2 * inverse * inverse * (g * g + inner(velocity, velocity))) * g_slope * g_slope -
                           2 * g * inverse * g_curvature;
    }
    if (k > 0) tube(places * k, k, knot_weights);
    tube(places * k + 1, k, first_third_weights);
    tube(places * k + 2, k, second_third_weights);
  }
  for (std::size_t i = 0; i < passing.passes.size(); ++i) {
    const SplinePlace place(passing.passes[i], intervals_);
    const Vector<D> off = between(corridor_.legs[i].to, sum_of(&c[place.first], place.weights));
    Vector<D> velocity = sum_of(&c[place.first], place.slopes);
    const double speed = size(velocity);
    for (double& v : velocity) v /= speed;
    const bool may_move = speed > 0 && is_across(off, velocity);
    add.distance(place.first, place.weights, off, corridor_.margin_at(i), may_move ? &velocity : nullptr);
  }
  model.fix_ends();
}

template class CorridorBarrier<2>;
template class CorridorBarrier<3>;

}  // namespace leadscrew::toolpath
