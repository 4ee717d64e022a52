#include <cmath>
#include <leadscrew/geometry/curve.hpp>

namespace leadscrew::geometry {

using numeric::DoubleDouble;

Point Line::evaluate(DoubleDouble s) const {
  if (s <= 0.0) return start_;
  if (DoubleDouble(length_) <= s) return end_;
  Point position = start_;
  slopes_.add(position, s);
  return position;
}

PointJet Line::jets(double s) const {
  PointJet jet;
  for (std::size_t i = 0; i < start_.size(); ++i) jet[i].value = start_[i];
  slopes_.add(jet, s);
  return jet;
}

double Arc::way(double radius, DoubleDouble sweep, double rise) {
  return std::hypot(radius * std::abs(sweep.value()), rise);
}

Arc::Arc(const Point& start, const Point& end, std::size_t first, std::size_t second, double center_first,
         double center_second, DoubleDouble sweep, double length)
    : start_(start),
      end_(end),
      first_(first),
      second_(second),
      center_first_(center_first),
      center_second_(center_second),
      x_(numeric::two_sum(start[first], -center_first)),
      y_(numeric::two_sum(start[second], -center_second)),
      radius_(std::hypot(x_.hi, y_.hi)),
      length_(length),
      rate_(sweep / DoubleDouble(length)) {
  Point straight_end = end;
  straight_end[first] = start[first];
  straight_end[second] = start[second];
  slopes_ = Slopes(start, straight_end, length);
  const Turned at_end = turned(length);
  defect_first_ = (DoubleDouble(end[first]) - at_end.first).value() / length;
  defect_second_ = (DoubleDouble(end[second]) - at_end.second).value() / length;
}

Arc::Turned Arc::turned(DoubleDouble s) const {
  // θ = hi + lo; sin and cos of hi come from the library, lo turns them by the first-order rule (lo² < 1e-32).
  const DoubleDouble angle = rate_ * s;
  const double sine = std::sin(angle.hi), cosine = std::cos(angle.hi);
  const DoubleDouble sin_angle{sine, cosine * angle.lo};
  const DoubleDouble cos_angle{cosine, -sine * angle.lo};
  return {x_ * cos_angle - y_ * sin_angle + center_first_, x_ * sin_angle + y_ * cos_angle + center_second_};
}

Point Arc::evaluate(DoubleDouble s) const {
  if (s <= 0.0) return start_;
  if (DoubleDouble(length_) <= s) return end_;
  Point position = start_;
  slopes_.add(position, s);
  const Turned in_plane = turned(s);
  position[first_] = (in_plane.first + defect_first_ * s.hi).value();
  position[second_] = (in_plane.second + defect_second_ * s.hi).value();
  return position;
}

PointJet Arc::jets(double s) const {
  PointJet jet;
  for (std::size_t i = 0; i < start_.size(); ++i) jet[i].value = start_[i];
  slopes_.add(jet, s);
  const double w = rate_.hi;
  const double sine = std::sin(w * s), cosine = std::cos(w * s);
  const double x = x_.hi * cosine - y_.hi * sine, y = x_.hi * sine + y_.hi * cosine;
  jet[first_] = {center_first_ + x + defect_first_ * s, -w * y + defect_first_, -w * w * x, w * w * w * y};
  jet[second_] = {center_second_ + y + defect_second_ * s, w * x + defect_second_, -w * w * y, -w * w * w * x};
  return jet;
}

DoubleDouble sweep_angle(double from_first, double from_second, double to_first, double to_second, int turns) {
  const double direction = turns < 0 ? -1 : 1;
  const double whole = std::abs(turns) - 1;
  if (from_first == to_first && from_second == to_second) return numeric::two_pi * (direction * (whole + 1));
  const double cross = from_first * to_second - from_second * to_first;
  const double dot = from_first * to_first + from_second * to_second;
  const double angle = direction * std::atan2(cross, dot);
  const DoubleDouble part = angle > 0 ? DoubleDouble(angle) : numeric::two_pi + angle;
  return (numeric::two_pi * whole + part) * direction;
}

}  // namespace leadscrew::geometry
