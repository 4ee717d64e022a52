#include <algorithm>
#include <leadscrew/referee/nurbs.hpp>
#include <leadscrew/referee/piece.hpp>
#include <limits>

namespace leadscrew::referee {

namespace {

bool is_curve(const gcode::NurbsCurve& curve) {
  if (curve.degree < 1 || curve.degree > gcode::highest_degree) return false;
  const auto degree = static_cast<std::size_t>(curve.degree);
  const std::size_t count = curve.points.size();
  return count > degree && curve.knots.size() == count + degree + 1 &&
         std::is_sorted(curve.knots.begin(), curve.knots.end()) && curve.knots[degree] < curve.knots[count] &&
         std::all_of(curve.points.begin(), curve.points.end(), [](const auto& point) { return point.weight > 0; });
}

}  // namespace

bool Nurbs::begin(const gcode::NurbsCurve& curve) {
  if (!is_curve(curve)) return false;
  degree_ = curve.degree;
  knots_ = curve.knots;
  points_.clear();
  for (const gcode::ControlPoint& point : curve.points) {
    Weighted& added = points_.emplace_back();
    added.moment = metric_.point(point.position);
    for (double& coordinate : added.moment) coordinate *= point.weight;
    added.weight = point.weight;
  }
  contact_.clear();
  tip_per_contact_ = 1;
  if (curve.contact.size() == points_.size()) {
    for (const auto& [x, y, z] : curve.contact) contact_.push_back({metric_.point({x, y, z}), 1});
  }
  span_ = degree() - 1;
  at_ = knots_[degree()];
  ends_.clear();
  return true;
}

/// Goes on to the next span of some length.
bool Nurbs::next_span() {
  do {
    if (++span_ >= points_.size()) return false;
  } while (!(knots_[span_] < knots_[span_ + 1]));
  at_ = knots_[span_];
  ends_.push_back(knots_[span_ + 1]);
  return true;
}

bool Nurbs::next(Bezier& segment) {
  while (!ends_.empty() || next_span()) {
    const double to = ends_.back();
    segment = segment_of(points_, span_, at_, to);
    const double middle = at_ + (to - at_) / 2;
    if (middle > at_ && middle < to && !(turns_little(metric_, segment) && is_even(segment, to))) {
      ends_.push_back(middle);
      continue;
    }
    ends_.pop_back();
    at_ = to;
    if (has_length(metric_, segment)) return true;
  }
  return false;
}

/// Is the tip as fast beside the contact all along the segment, to 1e-4? At its ends and in its middle the first legs of the
/// parts that begin there are looked at, which are C′/p.
bool Nurbs::is_even(const Bezier& segment, double to) {
  if (contact_.empty()) return true;
  const Bezier contact = segment_of(contact_, span_, at_, to);
  const Coordinates linear = coordinates_of(metric_, FeedAxes::xyz);
  const auto leg = [&](const Bezier& bezier, std::size_t from) {
    return distance_in(metric_, linear, projected(metric_, bezier.control[from]),
                       projected(metric_, bezier.control[from + 1]));
  };
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (const double share : {0.0, 0.5, 1.0}) {
    const double from = share < 1 ? share : 0;
    const std::size_t k = share < 1 ? 0 : degree() - 1;
    const double ratio = leg(part(metric_, segment, from, 1), k) / leg(part(metric_, contact, from, 1), k);
    least = std::min(least, ratio);
    greatest = std::max(greatest, ratio);
  }
  tip_per_contact_ = greatest;
  return greatest <= (1 + 1e-4) * least || !(greatest < std::numeric_limits<double>::infinity());
}

/// With x the argument of level r and i from the last point down to the r-th of the p + 1 that the span knows:
///   d_i ← (1 − α)·d_{i−1} + α·d_i,   α = (x − u_i)/(u_{i+p−r+1} − u_i)      ("The NURBS Book", sec. 5.2, eq. 5.15)
Bezier Nurbs::segment_of(const std::vector<Weighted>& points, std::size_t span, double from, double to) const {
  const std::size_t p = degree();
  Bezier segment;
  segment.degree = degree_;
  for (std::size_t j = 0; j <= p; ++j) {
    std::array<Weighted, gcode::highest_degree + 1> row;
    for (std::size_t k = 0; k <= p; ++k) row[k] = points[span - p + k];
    for (std::size_t r = 1; r <= p; ++r) {
      const double x = r <= p - j ? from : to;
      for (std::size_t k = p; k >= r; --k) {
        const std::size_t i = span - p + k;
        const double alpha = (x - knots_[i]) / (knots_[i + p - r + 1] - knots_[i]);
        row[k] = between(metric_, row[k - 1], row[k], alpha);
      }
    }
    segment.control[j] = row[p];
  }
  return segment;
}

double Nurbs::length_in(const Coordinates& coordinates) const {
  double sum = 0;
  for (std::size_t span = degree(); span < points_.size(); ++span) {
    if (!(knots_[span] < knots_[span + 1])) continue;
    sum += referee::length_in(metric_, coordinates, segment_of(points_, span, knots_[span], knots_[span + 1]));
  }
  return sum;
}

}  // namespace leadscrew::referee
