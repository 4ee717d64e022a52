#include <algorithm>
#include <array>
#include <leadscrew/numeric/log_sum.hpp>
#include <leadscrew/study/tube_barrier.hpp>
#include <limits>

namespace leadscrew::study {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least_slack = 1e-12;  // relative; below, second derivatives are rounding

constexpr std::array<double, 2> first_difference = {-1, 1};
constexpr std::array<double, 3> second_difference = {1, -2, 1};
constexpr std::array<double, 4> third_difference = {-1, 3, -3, 1};
constexpr std::array<double, 3> knot_weights = {1.0 / 6, 4.0 / 6, 1.0 / 6};

template <std::size_t size>
PlaneVector sum_of(const std::vector<PlaneVector>& points, std::size_t first, const std::array<double, size>& factors) {
  PlaneVector sum;
  for (std::size_t i = 0; i < size; ++i) sum = sum + factors[i] * points[first + i];
  return sum;
}

PlaneVector knot_at(const std::vector<PlaneVector>& points, std::size_t k) {
  return sum_of(points, k, knot_weights);
}

PlaneVector position_at(const std::vector<PlaneVector>& points, double time) {
  const SplineWeights at = position_weights(time, points.size() - 3);
  return sum_of(points, at.first, at.weights);
}

/// From the nearest place of a line to x; and whether that place is one of its ends.
struct FromLine {
  PlaneVector offset;
  bool is_beyond = false;
  PlaneVector normal;
};
FromLine from_line(const TubeLeg& leg, PlaneVector x) {
  const double length = leg.length();
  const PlaneVector along = 1 / length * (leg.to - leg.from), from = x - leg.from;
  const double place = dot(along, from);
  if (place <= 0) return {from, true};
  if (place >= length) return {x - leg.to, true};
  return {from - place * along, false, {-along.y, along.x}};
}

/// −log(g − u) − log(g + u), g ∝ w^power.
void add_two_sided(TubeModel& model, std::size_t first, std::span<const double> factors, std::size_t axis, double u,
                   double g, double power, double w) {
  const double below = 1 / (g - u), above = 1 / (g + u);
  const double slope = power * g / w, curvature = power * (power - 1) * g / (w * w);
  const double second = below * below + above * above;
  model.add(first, factors, axis, below - above, second, (above * above - below * below) * slope);
  model.add_to_w(-(below + above) * slope, second * slope * slope - (below + above) * curvature);
}

/// −log(1 − q·q/P²), of whose Hessian only what `shape` says of that of q·q/2.
void add_distance(TubeModel& model, std::size_t first, std::span<const double> factors, PlaneVector q, double tolerance,
                  TubeModel::Hessian shape) {
  const double inverse = 2 / (tolerance * tolerance - dot(q, q)), square = inverse * inverse;
  model.add(first, factors, inverse * q,
            {inverse * shape.xx + square * q.x * q.x, inverse * shape.xy + square * q.x * q.y,
             inverse * shape.yy + square * q.y * q.y},
            {});
}

void add_line(TubeModel& model, const TubeLeg& leg, double tolerance, std::size_t k, PlaneVector x) {
  const FromLine from = from_line(leg, x);
  const PlaneVector n = from.normal;
  const TubeModel::Hessian shape =
      from.is_beyond ? TubeModel::Hessian{1, 0, 1} : TubeModel::Hessian{n.x * n.x, n.x * n.y, n.y * n.y};
  add_distance(model, k, knot_weights, from.offset, tolerance, shape);
}

/// −log(R + P − |x − c|) − log(n·(x − c) − R + P)
void add_arc(TubeModel& model, const TubeLeg& leg, double tolerance, PlaneVector n, std::size_t k, PlaneVector x) {
  const PlaneVector from = x - leg.center;
  const double distance = norm(from);
  const PlaneVector e = 1 / distance * from;
  const double outer = 1 / (leg.radius + tolerance - distance), across = outer / distance;
  const double inner = 1 / (dot(n, from) - leg.radius + tolerance);
  const double along = outer * outer - across, tangent = inner * inner;
  model.add(k, knot_weights, outer * e - inner * n,
            {along * e.x * e.x + across + tangent * n.x * n.x, along * e.x * e.y + tangent * n.x * n.y,
             along * e.y * e.y + across + tangent * n.y * n.y},
            {});
}

bool add_slack(numeric::LogSum& sum, const TubeLeg& leg, double tolerance, PlaneVector outward, PlaneVector x) {
  if (leg.is_arc) {
    const PlaneVector from = x - leg.center;
    return sum.add((leg.radius + tolerance - norm(from)) / tolerance) &&
           sum.add((dot(outward, from) - leg.radius + tolerance) / tolerance);
  }
  const PlaneVector offset = from_line(leg, x).offset;
  return sum.add(1 - dot(offset, offset) / (tolerance * tolerance));
}

/// Downhill from `time` to where the motion is nearest to the joint.
double nearest_time(const std::vector<PlaneVector>& points, PlaneVector joint, double time, double low, double high) {
  const auto squared = [&](double t) {
    const PlaneVector q = position_at(points, t) - joint;
    return dot(q, q);
  };
  time = std::clamp(time, low, high);
  double best = squared(time);
  for (const double step : {2.0, 0.5, 0.1, 0.02, 0.004}) {
    for (const double move : {-step, step}) {
      for (double next = time + move; next >= low && next <= high; next += move) {
        const double there = squared(next);
        if (!(there < best)) break;
        best = there;
        time = next;
      }
    }
  }
  return time;
}

}  // namespace

TubeAssignment assigned(const Tube& tube, const std::vector<PlaneVector>& points, std::vector<double> passes) {
  TubeAssignment result{std::move(passes), {}, {}};
  const std::size_t knots = points.size() - 2;
  result.legs.reserve(knots);
  result.outward.resize(knots);
  std::size_t leg = 0;
  for (std::size_t k = 0; k < knots; ++k) {
    while (leg < result.passes.size() && static_cast<double>(k) > result.passes[leg]) ++leg;
    result.legs.push_back(leg);
    if (!tube.legs[leg].is_arc) continue;
    const PlaneVector from = knot_at(points, k) - tube.legs[leg].center;
    result.outward[k] = 1 / norm(from) * from;
  }
  return result;
}

std::vector<double> nearest_passes(const Tube& tube, const std::vector<PlaneVector>& points,
                                   std::vector<double> passes) {
  const double last = static_cast<double>(points.size()) - 4;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const double low = i > 0 ? passes[i - 1] + 0.5 : 1, high = i + 1 < passes.size() ? passes[i + 1] - 0.5 : last;
    if (low <= high) passes[i] = nearest_time(points, tube.legs[i].to, passes[i], low, high);
  }
  return passes;
}

std::vector<double> pass_slacks(const Tube& tube, const std::vector<PlaneVector>& points,
                                const TubeAssignment& assignment) {
  std::vector<double> slacks;
  for (std::size_t i = 0; i < assignment.passes.size(); ++i) {
    const PlaneVector q = position_at(points, assignment.passes[i]) - tube.legs[i].to;
    slacks.push_back(1 - dot(q, q) / (tube.tolerance * tube.tolerance));
  }
  return slacks;
}

double TubeBarrier::inequalities(std::size_t intervals) const {
  // Two sides and two axes of jerk and acceleration; speed; the tube's two walls.
  return static_cast<double>(4 * intervals + 4 * (intervals + 1) + (intervals + 2) + 2 * (intervals + 1) +
                             tube_.legs.size());
}

TubeBarrier::Bounds TubeBarrier::bounds(double w) const {
  const double root = std::cbrt(w), h = start_interval_ * root;
  return {tube_.jerk * h * h * h, tube_.acceleration * h * h, tube_.feed * h};
}

double TubeBarrier::value(double t, const TubeIterate& at, const TubeAssignment& assignment) const {
  if (!(at.w > 0)) return infinity;
  const Bounds most = bounds(at.w);
  const std::vector<PlaneVector>& c = at.points;
  const std::size_t n = c.size() - 3;
  numeric::LogSum sum(least_slack);
  const auto both = [&](PlaneVector u, double g) {
    return sum.add(1 - u.x * u.x / (g * g)) && sum.add(1 - u.y * u.y / (g * g));
  };
  for (std::size_t k = 0; k < n; ++k) {
    if (!both(sum_of(c, k, third_difference), most.jerk)) return infinity;
  }
  for (std::size_t k = 0; k <= n; ++k) {
    if (!both(sum_of(c, k, second_difference), most.acceleration)) return infinity;
    const TubeLeg& leg = tube_.legs[assignment.legs[k]];
    if (!add_slack(sum, leg, tube_.tolerance, assignment.outward[k], knot_at(c, k))) return infinity;
  }
  for (std::size_t k = 0; k < n + 2; ++k) {
    const PlaneVector u = sum_of(c, k, first_difference);
    if (!sum.add(1 - dot(u, u) / (most.velocity * most.velocity))) return infinity;
  }
  for (const double slack : pass_slacks(tube_, c, assignment)) {
    if (!sum.add(slack)) return infinity;
  }
  // The slacks above are relative; those of the barrier grow with w, w^(2/3) and, squared, w^(2/3).
  const auto count = static_cast<double>(n);
  const double scaled = 4 * count + (4 * (count + 1) + (count + 2)) * 2 / 3;
  return t * at.w - sum.value() - scaled * std::log(at.w);
}

void TubeBarrier::assemble(double t, const TubeIterate& at, const TubeAssignment& assignment, Passes passes,
                           TubeModel& model) const {
  model.reset(at.points.size());
  model.add_to_w(t, 0);
  assemble_limits(at, model);
  assemble_knots(at, assignment, model);
  assemble_passes(at, assignment, passes, model);
}

void TubeBarrier::assemble_limits(const TubeIterate& at, TubeModel& model) const {
  const Bounds most = bounds(at.w);
  const std::size_t n = at.points.size() - 3;
  for (std::size_t k = 0; k < n; ++k) {
    const PlaneVector u = sum_of(at.points, k, third_difference);
    add_two_sided(model, k, third_difference, 0, u.x, most.jerk, 1, at.w);
    add_two_sided(model, k, third_difference, 1, u.y, most.jerk, 1, at.w);
  }
  for (std::size_t k = 0; k <= n; ++k) {
    const PlaneVector u = sum_of(at.points, k, second_difference);
    add_two_sided(model, k, second_difference, 0, u.x, most.acceleration, 2.0 / 3, at.w);
    add_two_sided(model, k, second_difference, 1, u.y, most.acceleration, 2.0 / 3, at.w);
  }
  // −log(V² − u·u), V² ∝ w^(2/3)
  const double square = most.velocity * most.velocity;
  const double slope = 2.0 / 3 * square / at.w, curvature = -1.0 / 3 * slope / at.w;
  for (std::size_t k = 0; k < n + 2; ++k) {
    const PlaneVector u = sum_of(at.points, k, first_difference);
    const double inverse = 1 / (square - dot(u, u)), twice = 2 * inverse;
    model.add(k, first_difference, twice * u,
              {twice + twice * twice * u.x * u.x, twice * twice * u.x * u.y, twice + twice * twice * u.y * u.y},
              -twice * inverse * slope * u);
    model.add_to_w(-inverse * slope, inverse * inverse * slope * slope - inverse * curvature);
  }
}

void TubeBarrier::assemble_knots(const TubeIterate& at, const TubeAssignment& assignment, TubeModel& model) const {
  for (std::size_t k = 0; k + 2 < at.points.size(); ++k) {
    const TubeLeg& leg = tube_.legs[assignment.legs[k]];
    const PlaneVector x = knot_at(at.points, k);
    if (leg.is_arc) {
      add_arc(model, leg, tube_.tolerance, assignment.outward[k], k, x);
    } else {
      add_line(model, leg, tube_.tolerance, k, x);
    }
  }
}

void TubeBarrier::assemble_passes(const TubeIterate& at, const TubeAssignment& assignment, Passes passes,
                                  TubeModel& model) const {
  const TubeMotion motion{at.points, {}, 0};
  for (std::size_t i = 0; i < assignment.passes.size(); ++i) {
    const double time = assignment.passes[i];
    const SplineWeights weights = position_weights(time, motion.intervals());
    const PlaneVector q = motion.at(time) - tube_.legs[i].to, velocity = motion.velocity(time);
    TubeModel::Hessian shape = {1, 0, 1};
    const double speed = norm(velocity), along = std::abs(dot(q, velocity));
    // Where it passes nearest, distances change only across its velocity.
    if (passes == Passes::following && speed > 0 && along <= 0.3 * norm(q) * speed) {
      const PlaneVector v = 1 / speed * velocity;
      shape = {1 - v.x * v.x, -v.x * v.y, 1 - v.y * v.y};
    }
    add_distance(model, weights.first, weights.weights, q, tube_.tolerance, shape);
  }
}

}  // namespace leadscrew::study
