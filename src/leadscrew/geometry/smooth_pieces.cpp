#include <algorithm>
#include <cmath>
#include <leadscrew/geometry/arc_length_map.hpp>
#include <leadscrew/geometry/kinks.hpp>
#include <leadscrew/geometry/nurbs_table.hpp>

namespace leadscrew::geometry {

using numeric::DoubleDouble;
using numeric::Jet;

namespace {

constexpr double negligible_step = 1e-9;  // of tangent and curvature

bool is_form(const NurbsForm& form) {
  const std::size_t n = form.points.size();
  if (form.degree < 1 || form.degree > 5) return false;
  const std::size_t p = static_cast<std::size_t>(form.degree);
  if (n <= p || form.knots.size() != n + p + 1 || form.weights.size() != n) return false;
  if (!std::is_sorted(form.knots.begin(), form.knots.end()) || !(form.knots[p] < form.knots[n])) return false;
  for (std::size_t i = p + 1; i + p < n; ++i) {
    if (form.knots[i] == form.knots[i + p]) return false;
  }
  return std::all_of(form.weights.begin(), form.weights.end(), [](double w) { return w > 0; });
}

Moving moving_coordinates(const std::vector<Point>& points) {
  Moving moving;
  for (std::size_t i = 0; i < base::axis_count; ++i) {
    const bool moves = std::any_of(points.begin(), points.end(), [&](const Point& p) { return p[i] != points[0][i]; });
    if (moves) moving.coordinate[moving.count++] = static_cast<std::uint8_t>(i);
  }
  return moving;
}

bool moves_on_span(const NurbsForm& form, std::size_t coordinate, std::size_t span) {
  for (std::size_t r = span - static_cast<std::size_t>(form.degree); r < span; ++r) {
    if (form.points[r][coordinate] != form.points[r + 1][coordinate]) return true;
  }
  return false;
}

base::AxisSet moving_on_span(const NurbsForm& form, const Moving& moving, std::size_t span) {
  base::AxisSet set;
  for (std::size_t k = 0; k < moving.count; ++k) {
    if (moves_on_span(form, moving.coordinate[k], span)) set.insert(base::all_axes[moving.coordinate[k]]);
  }
  return set;
}

/// By slots.
Metric metric_of_span(base::AxisSet moving_on_span, const std::optional<Point>& weights, const Moving& moving) {
  const Point weight = length_weights(moving_on_span, weights);
  Metric metric;
  for (std::size_t k = 0; k < moving.count; ++k) {
    if (weight[moving.coordinate[k]] > 0) metric.add(k, weight[moving.coordinate[k]]);
  }
  return metric;
}

/// How a stretch begins, seen from the one before.
enum class Joint : std::uint8_t {
  smooth,       ///< four derivatives pass through
  rough_third,  ///< q‴ has a step or a bend
  unknown,      ///< to be seen from the derivatives on both sides
  kink,         ///< a cut
};

/// Between two neighbouring knots or kinks.
struct Stretch {
  RationalBezier curve;
  Metric metric;
  base::AxisSet moving;
  SingularEnds singular;
  double longest = 0;  ///< bound of the length
  Joint joint = Joint::kink;
};

/// How often a knot counts.
std::size_t multiplicity(const std::vector<double>& knots, std::size_t last) {
  std::size_t count = 1;
  while (count <= last && knots[last - count] == knots[last]) ++count;
  return count;
}

Joint joint_at_knot(const NurbsForm& form, std::size_t span) {
  const std::size_t p = static_cast<std::size_t>(form.degree), times = multiplicity(form.knots, span);
  if (times + 1 >= p) return Joint::unknown;
  return p - times <= 3 ? Joint::rough_third : Joint::smooth;
}

/// q′ and q″ by arc length at an end.
struct EndDerivatives {
  std::array<double, base::axis_count> tangent{}, curvature{};
};

EndDerivatives derivatives_at(const RationalTaylor& curve, const Metric& metric) {
  std::array<Jet<>, base::axis_count> jets;
  for (std::size_t k = 0; k < curve.count; ++k) jets[k] = curve.jet(k, 0);
  double c11 = 0, c12 = 0;
  for (std::size_t k = 0; k < metric.count; ++k) {
    const Jet<>& q = jets[metric.slot[k]];
    const double square = metric.weight[k] * metric.weight[k];
    c11 += square * q.first * q.first;
    c12 += square * q.first * q.second;
  }
  const double x1 = 1 / std::sqrt(c11), x2 = -c12 / (c11 * c11);
  EndDerivatives result;
  for (std::size_t k = 0; k < curve.count; ++k) {
    result.tangent[k] = jets[k].first * x1;
    result.curvature[k] = jets[k].second * x1 * x1 + jets[k].first * x2;
  }
  return result;
}

double largest(const std::array<double, base::axis_count>& a) {
  double value = 0;
  for (const double x : a) value = std::max(value, std::abs(x));
  return value;
}
double difference(const std::array<double, base::axis_count>& a, const std::array<double, base::axis_count>& b) {
  double value = 0;
  for (std::size_t k = 0; k < a.size(); ++k) value = std::max(value, std::abs(a[k] - b[k]));
  return value;
}

/// Whether the curve passes from one stretch to another without a step of tangent or curvature; `between` is the length
/// of what lies between them, too short to be examined, along which either may change as it does next to it.
bool is_smooth(const Stretch& before, const Stretch& after, double between) {
  if (before.singular.end || after.singular.begin || before.metric != after.metric) return false;
  const EndDerivatives left = derivatives_at(from_end(before.curve), before.metric);
  const EndDerivatives right = derivatives_at(from_start(after.curve), after.metric);
  const double tangent = std::max(largest(left.tangent), largest(right.tangent));
  const double curvature =
      std::max({largest(left.curvature), largest(right.curvature), tangent / before.longest, tangent / after.longest});
  return difference(left.tangent, right.tangent) <= negligible_step * tangent + 2 * between * curvature &&
         difference(left.curvature, right.curvature) <=
             negligible_step * curvature + 10 * between * curvature * curvature / tangent;
}

/// Settles the joints that the knots leave open, and those about stretches too short to have a shape: derivatives that
/// are taken to be continuous at its knots may pass from one value to another within it.
void settle_joints(std::vector<Stretch>& stretches) {
  const auto is_short = [](const Stretch& stretch) { return stretch.longest < shortest_examined; };
  for (std::size_t i = 1; i < stretches.size(); ++i) {
    Stretch& stretch = stretches[i];
    if (stretch.joint == Joint::kink || is_short(stretches[i - 1])) {
      if (stretch.joint == Joint::unknown) stretch.joint = Joint::rough_third;
      continue;
    }
    std::size_t next = i;
    double between = 0;
    while (next + 1 < stretches.size() && is_short(stretches[next]) && stretches[next + 1].joint != Joint::kink) {
      between += stretches[next++].longest;
    }
    if (next == i && stretch.joint != Joint::unknown) continue;
    const bool smooth = is_smooth(stretches[i - 1], stretches[next], between);
    if (!smooth) stretch.joint = Joint::kink;
    if (smooth && stretch.joint == Joint::unknown) stretch.joint = Joint::rough_third;
  }
}

/// The curve between its knots and kinks, in order; stretches where nothing moves are left out.
std::vector<Stretch> stretches_of(const NurbsForm& form, const std::optional<Point>& weights, const Moving& moving,
                                  bool rational) {
  const std::size_t p = static_cast<std::size_t>(form.degree), n = form.points.size();
  std::vector<Stretch> stretches;
  bool stood_still = false;
  for (std::size_t span = p; span < n; ++span) {
    if (form.knots[span] == form.knots[span + 1]) continue;
    Stretch stretch;
    stretch.moving = moving_on_span(form, moving, span);
    stretch.metric = metric_of_span(stretch.moving, weights, moving);
    if (stretch.moving.empty()) {
      stood_still = true;
      continue;
    }
    stretch.curve = bezier_of_span(form, moving, rational, span);
    stretch.longest = longest_possible(stretch.curve, stretch.metric);
    const Kinks kinks = find_kinks(stretch.curve, stretch.metric);
    const bool first = stretches.empty();
    const bool cut = first || stood_still || kinks.at_start || stretches.back().singular.end ||
                     first_to_move(stretches.back().moving) != first_to_move(stretch.moving);
    stretch.joint = cut ? Joint::kink : joint_at_knot(form, span);
    stretch.singular.begin = kinks.at_start;
    stood_still = false;
    double cut_off = 0;
    for (const double t : kinks.inside) {
      const auto [before, after] = split(stretch.curve, (t - cut_off) / (1 - cut_off));
      stretches.push_back(
          {before, stretch.metric, stretch.moving, {stretch.singular.begin, true}, stretch.longest, stretch.joint});
      stretch.curve = after;
      stretch.singular.begin = true;
      stretch.joint = Joint::kink;
      cut_off = t;
    }
    stretch.singular.end = kinks.at_end;
    stretches.push_back(stretch);
  }
  settle_joints(stretches);
  return stretches;
}

bool is_rational(const NurbsForm& form) {
  return std::any_of(form.weights.begin(), form.weights.end(), [&](double w) { return w != form.weights[0]; });
}

}  // namespace

/// Fills a table, one smooth piece after another.
class NurbsAssembly {
 public:
  NurbsAssembly(const NurbsForm& form, const MapTolerance& tolerance, const std::optional<Point>& weights)
      : form_(form), tolerance_(tolerance), weights_(weights), moving_(moving_coordinates(form.points)) {
    table_->degree = static_cast<std::size_t>(form.degree);
    table_->rational = is_rational(form);
    table_->moving = moving_.coordinate;
    table_->moving_count = moving_.count;
    table_->weights = weights;
    table_->stride =
        NurbsTable::polynomials + (table_->rational ? table_->degree : 0) + moving_.count * (table_->degree + 2);
  }

  std::vector<Nurbs> pieces() {
    const std::vector<Stretch> stretches = stretches_of(form_, weights_, moving_, table_->rational);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const Stretch& stretch = stretches[i];
      if (stretch.joint == Joint::kink) begin_piece(stretch);
      if (stretch.joint == Joint::rough_third && s_.hi > 0) table_->breaks.push_back(s_.value());
      add(stretch);
      if (i + 1 == stretches.size() || stretches[i + 1].joint == Joint::kink) finish_piece(stretch);
    }
    join();
    return std::move(pieces_);
  }

 private:
  Point place(const RationalBezier& curve, std::size_t coefficient) const {
    Point point = form_.points[0];
    for (std::size_t k = 0; k < moving_.count; ++k) {
      point[moving_.coordinate[k]] = curve.origin[k] + curve.numerator[k][coefficient] / curve.weight[coefficient];
    }
    return point;
  }

  void begin_piece(const Stretch& stretch) {
    piece_ = Nurbs();
    piece_.table_ = table_;
    piece_.first_record_ = static_cast<std::uint32_t>(table_->nodes.size());
    piece_.first_break_ = static_cast<std::uint32_t>(table_->breaks.size());
    piece_.first_parameter_ = stretch.curve.parameter;
    piece_.start_ = place(stretch.curve, 0);
    s_ = {};
  }

  void add(const Stretch& stretch) {
    piece_.moving_.insert(stretch.moving);
    from_start_.clear();
    from_end_.clear();
    map_arc_length(stretch.curve, stretch.metric, stretch.singular, tolerance_, from_start_, from_end_);
    const RationalTaylor start = from_start(stretch.curve), end = from_end(stretch.curve);
    for (const MapPiece& piece : from_start_) add_record(stretch.curve, start, piece, 0);
    for (const MapPiece& piece : from_end_) add_record(stretch.curve, end, piece, 1);
  }

  void add_record(const RationalBezier& curve, const RationalTaylor& taylor, const MapPiece& piece, double t_of_zero) {
    table_->nodes.push_back(s_.hi);
    std::vector<double>& out = table_->records;
    out.push_back(s_.lo);
    out.insert(out.end(), piece.c.begin(), piece.c.end());
    out.push_back(curve.parameter + curve.width * (t_of_zero + piece.x_begin));
    out.push_back(curve.width);
    const Coefficients weight = piece.is_straight ? Coefficients{1} : shifted(taylor.weight, piece.x_begin);
    if (table_->rational) {
      for (std::size_t i = 1; i <= taylor.degree; ++i) out.push_back(weight[i] / weight[0]);
    }
    for (std::size_t k = 0; k < moving_.count; ++k) {
      const Coefficients numerator =
          piece.is_straight ? chord(taylor, k, piece) : shifted(taylor.numerator[k], piece.x_begin);
      const double origin = taylor.origin[k] + numerator[0] / weight[0];
      const double moved = origin - taylor.origin[k];
      out.push_back(origin);
      for (std::size_t i = 0; i <= taylor.degree; ++i) out.push_back((numerator[i] - moved * weight[i]) / weight[0]);
    }
    s_ = s_ + piece.length;
  }

  static Coefficients chord(const RationalTaylor& taylor, std::size_t slot, const MapPiece& piece) {
    const double begin = taylor.jet(slot, piece.x_begin).value, end = taylor.jet(slot, piece.x_end).value;
    return {begin, (end - begin) / (piece.x_end - piece.x_begin)};
  }

  void finish_piece(const Stretch& stretch) {
    piece_.record_count_ = static_cast<std::uint32_t>(table_->nodes.size()) - piece_.first_record_;
    piece_.break_count_ = static_cast<std::uint32_t>(table_->breaks.size()) - piece_.first_break_;
    if (piece_.record_count_ == 0) return;
    piece_.length_ = s_.value();
    piece_.last_parameter_ = stretch.curve.parameter + stretch.curve.width;
    piece_.end_ = place(stretch.curve, stretch.curve.degree);
    piece_.add_buckets(*table_);
    pieces_.push_back(piece_);
  }

  /// Pieces meet in one point; a clamped curve begins and ends at its first and last control points.
  void join() {
    if (pieces_.empty()) return;
    const std::size_t p = table_->degree, n = form_.points.size();
    if (form_.knots[0] == form_.knots[p]) pieces_.front().start_ = form_.points.front();
    if (form_.knots[n] == form_.knots[n + p]) pieces_.back().end_ = form_.points.back();
    for (std::size_t i = 1; i < pieces_.size(); ++i) pieces_[i - 1].end_ = pieces_[i].start_;
  }

  const NurbsForm& form_;
  const MapTolerance& tolerance_;
  const std::optional<Point>& weights_;
  Moving moving_;
  std::shared_ptr<NurbsTable> table_ = std::make_shared<NurbsTable>();
  std::vector<Nurbs> pieces_;
  Nurbs piece_;
  DoubleDouble s_;
  std::vector<MapPiece> from_start_, from_end_;
};

std::vector<Nurbs> smooth_pieces(const NurbsForm& form, const MapTolerance& tolerance,
                                 const std::optional<Point>& weights) {
  if (!is_form(form)) return {};
  return NurbsAssembly(form, tolerance, weights).pieces();
}

}  // namespace leadscrew::geometry
