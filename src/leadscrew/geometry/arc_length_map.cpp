#include <algorithm>
#include <cmath>
#include <leadscrew/geometry/arc_length_map.hpp>
#include <leadscrew/numeric/gauss.hpp>
#include <limits>

namespace leadscrew::geometry {

using numeric::Jet;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double straight_deviation = 1e-15;  // mm or degrees
constexpr double straight_share = 1e-9;       // of the curve, at most
constexpr double negligible_length = 1e-13;   // mm or degrees: what is shorter is not subdivided
constexpr double standing = 1e-9;             // of the speed elsewhere: an end with less is singular
constexpr int deepest = 60;                   // halvings
constexpr std::size_t most_pieces =
    8192;  // of half a curve; if they were ever too few, the rest keeps to speed less well

/// x by s at one place, and what the error of a piece is measured against.
struct Node {
  double x1 = 0, x2 = 0, x3 = 0;  ///< x′, x″, x‴
  double speed = 0;               ///< v
  double scale = 0;               ///< k
  double condition = 0;           ///< rounding of v, relative, by that of the numbers that it is made of
};

struct Interval {
  double begin = 0, end = 0;  ///< x
  double length = 0;          ///< as Gauss has it
  SingularEnds singular;
};

class Mapper {
 public:
  /// is_graded: whether the curve has a singular end at x = 0.
  Mapper(const RationalTaylor& curve, const Metric& metric, double whole_length, const MapTolerance& tolerance,
         bool is_graded)
      : curve_(curve), metric_(metric), tolerance_(tolerance), whole_length_(whole_length), is_graded_(is_graded) {
    for (std::size_t k = 0; k < curve.count; ++k) {
      for (std::size_t i = 1; i <= curve.degree; ++i) reach_ = std::max(reach_, std::abs(curve.numerator[k][i]));
    }
    reach_ /= std::abs(curve.weight[0]);
  }

  double gauss(double a, double b) const {
    return numeric::integrate_gauss_8([&](double x) { return curve_.speed(metric_, x); }, a, b);
  }

  /// Whether the sum of the halves stands for the whole: within the tolerance or to rounding.
  bool agrees(double whole, double halves, double condition) const {
    return std::abs(whole - halves) <= (tolerance_.length + 16 * epsilon * condition) * halves;
  }

  /// |dC/dx|, all of whose terms are added up without their signs.
  double greatest_speed(double x) const {
    const double magnitude = std::abs(x);
    const auto unsigned_of = [&](const Coefficients& c) {
      double value = 0, slope = 0;
      for (std::size_t i = curve_.degree + 1; i-- > 0;) {
        slope = slope * magnitude + value;
        value = value * magnitude + std::abs(c[i]);
      }
      return std::pair(value, slope);
    };
    const auto [w, dw] = unsigned_of(curve_.weight);
    const double weight = curve_.rational ? curve_.weight_jet(x).value : 1;
    double sum = 0;
    for (std::size_t k = 0; k < metric_.count; ++k) {
      const auto [n, dn] = unsigned_of(curve_.numerator[metric_.slot[k]]);
      sum += metric_.weight[k] * (curve_.rational ? (dn * w + n * dw) / (weight * weight) : dn);
    }
    return sum;
  }

  Node node(double x) const {
    Node node;
    double c11 = 0, c12 = 0, c22 = 0, c13 = 0;
    const Jet<> weight = curve_.weight_jet(x);
    const Jet<> scale = curve_.rational ? numeric::reciprocal(weight) : Jet<>(1);
    for (std::size_t k = 0; k < metric_.count; ++k) {
      Jet<> q = curve_.numerator_jet(metric_.slot[k], x);
      if (curve_.rational) q = q * scale;
      if (metric_.weight[k] != 1) q = q * Jet<>(metric_.weight[k]);
      c11 += q.first * q.first;
      c12 += q.first * q.second;
      c22 += q.second * q.second;
      c13 += q.first * q.third;
    }
    const double v = std::sqrt(c11), v1 = c12 / v, v2 = (c22 + c13 - v1 * v1) / v;
    node.speed = v;
    node.condition = greatest_speed(x) / v;
    node.x1 = 1 / v;
    node.x2 = -v1 / (v * v * v);
    node.x3 = (3 * v1 * v1 / v - v2) / (v * v * v * v);
    const double curvature = std::sqrt(std::max(0.0, c22 * c11 - c12 * c12)) / (c11 * v);
    node.scale = std::max(curvature, 1 / (is_graded_ ? std::min(whole_length_, v * std::abs(x)) : whole_length_));
    return node;
  }

  /// Appends the pieces of an interval. `begin` and `end` are its nodes, of no use where the end is singular.
  void map(const Interval& interval, const Node& begin, const Node& end, int depth,
           std::vector<MapPiece>& pieces) const {
    const double middle = (interval.begin + interval.end) / 2;
    const double first = gauss(interval.begin, middle), second = gauss(middle, interval.end);
    const double length = first + second;
    if (length <= 0) return;
    const bool is_singular = interval.singular.begin || interval.singular.end;
    if (is_straight(interval, length) || depth == 0) {
      pieces.push_back(straight(interval, length));
      return;
    }
    if (!is_singular &&
        (pieces.size() >= most_pieces || agrees(interval.length, length, std::max(begin.condition, end.condition)))) {
      MapPiece piece = quintic(interval, length, begin, end);
      const bool no_more = pieces.size() >= most_pieces;
      if (no_more && !is_monotonic(piece)) piece.c = {(interval.end - interval.begin) / length};
      if (no_more || is_good(piece, begin, end)) {
        pieces.push_back(piece);
        return;
      }
    }
    const Node inner = node(middle);
    map({interval.begin, middle, first, {interval.singular.begin, false}}, begin, inner, depth - 1, pieces);
    map({middle, interval.end, second, {false, interval.singular.end}}, inner, end, depth - 1, pieces);
  }

 private:
  MapPiece straight(const Interval& interval, double length) const {
    MapPiece piece{interval.begin, interval.end, length, {}, true};
    piece.c[0] = (interval.end - interval.begin) / length;
    return piece;
  }

  static MapPiece quintic(const Interval& interval, double h, const Node& begin, const Node& end) {
    const double span = interval.end - interval.begin;
    return {interval.begin, interval.end, h, quintic_map(span, h, {begin.x1, begin.x2}, {end.x1, end.x2}), false};
  }

  bool is_good(const MapPiece& piece, const Node& begin, const Node& end) const {
    const double h = piece.length;
    const auto& c = piece.c;
    const double k = std::max(begin.scale, end.scale);
    const double noise = 64 * epsilon * std::max({1.0, begin.condition, end.condition});  // rounding
    constexpr double peak = 0.85;  // of a rational curve's error, at the place that is looked at, at least
    // Towards a singular end s is of the size 1/k, and speed grows out of rest, v³ ≤ 9/2 j s²: nine times the step of q‴ is
    // still less than a thousandth of jerk there.
    const bool is_near_singular =
        is_graded_ && std::max(begin.speed, end.speed) * std::abs(piece.x_begin) < whole_length_;
    const double wider = is_near_singular ? 3 : 1;
    const double allowed = peak * tolerance_.speed + noise,
                 allowed_first = wider * tolerance_.first * k + 10 * noise / h,
                 allowed_second = wider * wider * tolerance_.second * k * k + 100 * noise / (h * h);
    if (begin.speed * std::abs(6 * c[2] - begin.x3) > allowed_second) return false;
    const double third_end = 6 * c[2] + h * (24 * c[3] + h * 60 * c[4]);
    if (end.speed * std::abs(third_end - end.x3) > allowed_second) return false;
    constexpr double outer = 0.27639320225002103;  // (1 − 1/√5)/2
    for (const double tau : {0.5, outer, 1 - outer}) {
      const double s = tau * h;
      const double x = s * (c[0] + s * (c[1] + s * (c[2] + s * (c[3] + s * c[4]))));
      const double x1 = c[0] + s * (2 * c[1] + s * (3 * c[2] + s * (4 * c[3] + s * 5 * c[4])));
      const double x2 = 2 * c[1] + s * (6 * c[2] + s * (12 * c[3] + s * 20 * c[4]));
      const Node there = node(piece.x_begin + x);
      if (std::abs(there.speed * x1 - 1) > allowed) return false;
      // v₁ = −x″ v³ of the true inverse.
      if (std::abs(there.speed * (x2 - there.x2 * (x1 * there.speed) * (x1 * there.speed))) > allowed_first)
        return false;
    }
    return is_monotonic(piece);
  }

  /// All Bernstein coefficients of x′ on [0, h] are positive.
  static bool is_monotonic(const MapPiece& piece) {
    const double h = piece.length;
    double power = 1;
    std::array<double, 5> a{};  // of x′ by τ = σ/h
    for (std::size_t i = 0; i < 5; ++i, power *= h) a[i] = static_cast<double>(i + 1) * piece.c[i] * power;
    const std::array<double, 5> b = {a[0], a[0] + a[1] / 4, a[0] + a[1] / 2 + a[2] / 6,
                                     a[0] + 3 * a[1] / 4 + a[2] / 2 + a[3] / 4, a[0] + a[1] + a[2] + a[3] + a[4]};
    return *std::min_element(b.begin(), b.end()) > 0;
  }

  /// Whether an interval at a singular end is straight to rounding; or one that is too short for its rounding errors.
  bool is_straight(const Interval& interval, double length) const {
    if (length <= std::max(negligible_length, 64 * epsilon * reach_)) return true;
    if (!interval.singular.begin && !interval.singular.end) return false;
    if (length > straight_share * whole_length_) return false;
    if (interval.singular.begin && interval.singular.end) return false;
    // The chord against the tangent at the end that has one, in all coordinates.
    const double at = interval.singular.begin ? interval.end : interval.begin;
    double along = 0, tangent_2 = 0;
    std::array<double, base::axis_count> chord{}, tangent{};
    for (std::size_t k = 0; k < curve_.count; ++k) {
      tangent[k] = curve_.jet(k, at).first;
      chord[k] = curve_.jet(k, interval.end).value - curve_.jet(k, interval.begin).value;
      along += chord[k] * tangent[k];
      tangent_2 += tangent[k] * tangent[k];
    }
    if (along <= 0) return false;
    double across_2 = 0;
    for (std::size_t k = 0; k < curve_.count; ++k) {
      const double across = chord[k] - tangent[k] * (along / tangent_2);
      across_2 += across * across;
    }
    return across_2 <= straight_deviation * straight_deviation;
  }

  const RationalTaylor& curve_;
  const Metric& metric_;
  const MapTolerance& tolerance_;
  double whole_length_;
  bool is_graded_;
  double reach_ = 0;  ///< size of the curve, mm or degrees
};

/// By one application of the rule.
double rough_length(const RationalTaylor& curve, const Metric& metric, double a, double b) {
  const MapTolerance any;
  const Mapper mapper(curve, metric, 1, any, false);
  return mapper.gauss(a, b);
}

}  // namespace

std::array<double, 5> quintic_map(double span, double h, const MapEnd& begin, const MapEnd& end) {
  const double d = span - (begin.first + begin.second / 2 * h) * h;
  const double e = (end.first - begin.first - begin.second * h) * h, f = (end.second - begin.second) * h * h;
  const double cubed = h * h * h;
  return {begin.first, begin.second / 2, (10 * d - 4 * e + f / 2) / cubed, (-15 * d + 7 * e - f) / (cubed * h),
          (6 * d - 3 * e + f / 2) / (cubed * h * h)};
}

void map_arc_length(const RationalBezier& curve, const Metric& metric, SingularEnds singular,
                    const MapTolerance& tolerance, std::vector<MapPiece>& pieces_from_start,
                    std::vector<MapPiece>& pieces_from_end) {
  // Two halves, each by powers of the parameter from its own end: best conditioned, and exact about a singular end.
  const RationalTaylor start = from_start(curve), end = from_end(curve);
  const double first = rough_length(start, metric, 0, 0.5), second = rough_length(end, metric, -0.5, 0);
  const double fastest = std::max(start.speed(metric, 0.5), 2 * (first + second));
  if (start.speed(metric, 0) <= standing * fastest) singular.begin = true;
  if (end.speed(metric, 0) <= standing * fastest) singular.end = true;
  const Mapper from_the_start(start, metric, first + second, tolerance, singular.begin);
  const Mapper from_the_end(end, metric, first + second, tolerance, singular.end);
  const Interval before{0, 0.5, first, {singular.begin, false}}, after{-0.5, 0, second, {false, singular.end}};
  from_the_start.map(before, from_the_start.node(0), from_the_start.node(0.5), deepest, pieces_from_start);
  from_the_end.map(after, from_the_end.node(-0.5), from_the_end.node(0), deepest, pieces_from_end);
}

}  // namespace leadscrew::geometry
