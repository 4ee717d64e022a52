#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/tip_travel.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <numbers>

namespace leadscrew::gcode {

namespace {

constexpr int most_places = 8192;                   // looked at along a block
constexpr int places_of_a_span = 64;                // of a curve
constexpr std::size_t most_waiting_stretches = 48;  // halvings

double norm_of_arm(const std::array<double, 3>& v) {
  return numeric::hypot(v[0], v[1], v[2]);
}

/// Of a path at t, 0 … 1.
base::AxisVector tip_at(const TipPath& path, double t) {
  base::AxisVector place;
  for (std::size_t i = 0; i < place.size(); ++i) place[i] = path.from[i] + t * (path.to[i] - path.from[i]);
  if (!path.is_arc) return place;
  const std::size_t first = base::index(first_axis(path.plane)), second = base::index(second_axis(path.plane));
  const double a = path.from[first] - path.center.first, b = path.from[second] - path.center.second;
  const auto [sine, cosine, cosine_less_one] = numeric::sines(t * path.turned);
  place[first] = path.center.first + cosine * a - sine * b;
  place[second] = path.center.second + sine * a + cosine * b;
  return place;
}

/// At most of |q″|, mm.
double bend_of(const kinematics::Transformation& transformation, const TipPath& path) {
  double turned = 0;
  double arms = norm_of_arm(transformation.tool) + norm_of_arm(transformation.chain.tool_zero());
  for (const kinematics::Turn& turn : transformation.chain.turns()) {
    const std::size_t axis = base::index(turn.axis);
    turned += std::fabs(path.to[axis] - path.from[axis]) * (std::numbers::pi / 180);
    arms += 4 * norm_of_arm(turn.point);
  }
  std::array<double, 3> way{};
  for (std::size_t i = 0; i < 3; ++i) way[i] = path.to[i] - path.from[i];
  arms += norm_of_arm({path.from[0], path.from[1], path.from[2]}) + norm_of_arm(way);
  double speed = norm_of_arm(way), bend = 0;
  if (path.is_arc) {
    const PlanePoint start = in_plane(path.from, path.plane);
    const double radius = numeric::hypot(start.first - path.center.first, start.second - path.center.second);
    arms += 2 * radius;
    speed += radius * std::fabs(path.turned);
    bend = radius * path.turned * path.turned;
  }
  return turned * turned * arms + 2 * turned * speed + bend;
}

void take(AxesReach& reach, const base::AxisVector& axes) {
  for (std::size_t i = 0; i < 3; ++i) {
    reach.low[i] = std::min(reach.low[i], axes[i]);
    reach.high[i] = std::max(reach.high[i], axes[i]);
  }
}

AxesReach reach_of_limits(const base::AxisVector& low, const base::AxisVector& high) {
  return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

/// The same of the peaks of parabolas through three places at even distances, where they lie between these:
/// q₁ − (q₂ − q₀)²/8(q₀ − 2q₁ + q₂).
void take_peaks(AxesReach& reach, const base::AxisVector& a, const base::AxisVector& b, const base::AxisVector& c) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double slope = (c[i] - a[i]) / 2, bend = a[i] - 2 * b[i] + c[i];
    if (!(std::fabs(slope) < std::fabs(bend))) continue;
    const double peak = b[i] - slope * slope / (2 * bend);
    reach.low[i] = std::min(reach.low[i], peak);
    reach.high[i] = std::max(reach.high[i], peak);
  }
}

/// May an axis be beyond what is known, by so much beyond both places?
bool may_reach_beyond(const AxesReach& known, const base::AxisVector& a, const base::AxisVector& b, double sag) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::min(a[i], b[i]) - sag < known.low[i] || std::max(a[i], b[i]) + sag > known.high[i]) return true;
  }
  return false;
}

/// Where an axis is known to be beyond its limit already, a thousandth of that is close enough.
double resolution_of(const AxesReach& known, const AxesReach& limit) {
  double beyond = 0;
  for (std::size_t i = 0; i < 3; ++i)
    beyond = std::max({beyond, limit.low[i] - known.low[i], known.high[i] - limit.high[i]});
  return std::max(travel_resolution, 1e-3 * beyond);
}

/// By de Boor's algorithm in homogeneous coordinates (Piegl and Tiller, eq. 5.15), u in the span that begins with
/// knots[span].
base::AxisVector curve_at(const NurbsCurve& curve, std::size_t span, double u) {
  const auto p = static_cast<std::size_t>(curve.degree);
  std::array<ControlPoint, highest_degree + 1> row;
  for (std::size_t k = 0; k <= p; ++k) {
    row[k] = curve.points[span - p + k];
    for (double& coordinate : row[k].position) coordinate *= row[k].weight;
  }
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t k = p; k >= r; --k) {
      const std::size_t i = span - p + k;
      const double alpha = (u - curve.knots[i]) / (curve.knots[i + p - r + 1] - curve.knots[i]);
      row[k].weight = (1 - alpha) * row[k - 1].weight + alpha * row[k].weight;
      for (std::size_t q = 0; q < row[k].position.size(); ++q)
        row[k].position[q] = (1 - alpha) * row[k - 1].position[q] + alpha * row[k].position[q];
    }
  }
  for (double& coordinate : row[p].position) coordinate /= row[p].weight;
  return row[p].position;
}

}  // namespace

AxesReach axes_reach(const kinematics::Transformation& transformation, const TipPath& path, const base::AxisVector& low,
                     const base::AxisVector& high) {
  struct Stretch {
    double from = 0, to = 1;
    base::AxisVector at_from{}, at_to{};
  };
  const double bend = bend_of(transformation, path) / 8;
  const auto axes_at = [&](double t) { return transformation.axes_of(tip_at(path, t)); };
  const AxesReach limit = reach_of_limits(low, high);
  AxesReach reach = limit;
  std::array<Stretch, most_waiting_stretches> waiting;
  std::size_t count = 1;
  waiting[0].at_from = axes_at(0);
  waiting[0].at_to = axes_at(1);
  take(reach, waiting[0].at_from);
  take(reach, waiting[0].at_to);
  for (int places = 0; count > 0 && places < most_places;) {
    const Stretch stretch = waiting[--count];
    const double width = stretch.to - stretch.from, sag = bend * width * width;
    if (sag <= resolution_of(reach, limit) || count + 2 > most_waiting_stretches) continue;
    if (!may_reach_beyond(reach, stretch.at_from, stretch.at_to, sag)) continue;
    const double middle = stretch.from + width / 2;
    const base::AxisVector axes = axes_at(middle);
    ++places;
    take(reach, axes);
    waiting[count++] = {middle, stretch.to, axes, stretch.at_to};
    waiting[count++] = {stretch.from, middle, stretch.at_from, axes};
  }
  return reach;
}

AxesReach axes_reach(const kinematics::Transformation& transformation, const NurbsCurve& curve,
                     const base::AxisVector& low, const base::AxisVector& high) {
  AxesReach reach = reach_of_limits(low, high);
  const auto p = static_cast<std::size_t>(curve.degree);
  for (std::size_t span = p; span < curve.points.size(); ++span) {
    const double from = curve.knots[span], width = curve.knots[span + 1] - from;
    if (!(width > 0)) continue;
    base::AxisVector before{}, last{};
    for (int k = 0; k <= places_of_a_span; ++k) {
      const base::AxisVector axes = transformation.axes_of(curve_at(curve, span, from + width * k / places_of_a_span));
      take(reach, axes);
      if (k > 1) take_peaks(reach, before, last, axes);
      before = last;
      last = axes;
    }
  }
  return reach;
}

}  // namespace leadscrew::gcode
