#include <cmath>
#include <leadscrew/geometry/curve.hpp>
#include <leadscrew/geometry/nurbs_table.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/numeric/sine.hpp>

namespace leadscrew::geometry {

using numeric::DoubleDouble;

Point Line::evaluate(DoubleDouble s) const {
  if (s <= 0.0) return start_;
  if (DoubleDouble(length_) <= s) return end_;
  Point position = start_;
  slopes_.add(start_, position, SplitLength(s));
  return position;
}

UnroundedPoint Line::evaluate_unrounded(DoubleDouble s) const {
  UnroundedPoint position = unrounded(DoubleDouble(length_) <= s ? end_ : start_);
  if (s <= 0.0 || DoubleDouble(length_) <= s) return position;
  slopes_.add(start_, position, SplitLength(s));
  return position;
}

Rates Line::rates(double, std::size_t first) const {
  return slopes_.rates(first);
}

PointJet Line::jets(double s) const {
  PointJet jet;
  for (std::size_t i = 0; i < start_.size(); ++i) jet[i].value = start_[i];
  slopes_.add(jet, s);
  return jet;
}

Line Line::part(double from, double to) const {
  return {evaluate(from), evaluate(to), to - from};
}

Arc Arc::part(double from, double to) const {
  const DoubleDouble sweep = DoubleDouble(rate_.hi.value, rate_.lo) * (DoubleDouble(to) - DoubleDouble(from));
  return {evaluate(from), evaluate(to), first_, second_, center_first_, center_second_, sweep, to - from};
}

void Line::append_shape(std::vector<double>& numbers) const {
  numbers.push_back(length_);
  slopes_.append_shape(numbers);
}

void Arc::append_shape(std::vector<double>& numbers) const {
  numbers.insert(numbers.end(), {static_cast<double>(first_), static_cast<double>(second_), x_.hi.value, y_.hi.value,
                                 radius_, length_, angle_rate(), defect_first_, defect_second_});
  slopes_.append_shape(numbers);
}

void Nurbs::append_shape(std::vector<double>& numbers) const {
  const NurbsTable& table = *table_;
  numbers.insert(numbers.end(), {length_, static_cast<double>(record_count_), static_cast<double>(break_count_),
                                 static_cast<double>(table.degree), static_cast<double>(table.rational)});
  numbers.push_back(static_cast<double>(table.moving_count));
  numbers.insert(numbers.end(), table.moving.begin(), table.moving.begin() + table.moving_count);
  const auto breaks = table.breaks.begin() + first_break_;
  numbers.insert(numbers.end(), breaks, breaks + break_count_);
  for (std::uint32_t index = first_record_; index < first_record_ + record_count_; ++index) {
    const double* const record = table.record(index);
    numbers.push_back(table.nodes[index]);
    numbers.insert(numbers.end(), record + NurbsTable::s_low, record + NurbsTable::parameter);
    const double* polynomials = record + NurbsTable::polynomials;
    if (table.rational) {
      numbers.insert(numbers.end(), polynomials, polynomials + table.degree);
      polynomials += table.degree;
    }
    for (std::size_t k = 0; k < table.moving_count; ++k, polynomials += table.degree + 2)
      numbers.insert(numbers.end(), polynomials + 1, polynomials + table.degree + 2);  // all but the origin
  }
}

void append_shape(const Curve& curve, std::vector<double>& numbers) {
  numbers.push_back(static_cast<double>(curve.index()));
  geometry::visit([&](const auto& kind) { kind.append_shape(numbers); }, curve);
}

Curve part(const Curve& curve, double from, double to) {
  return geometry::visit([&](const auto& kind) { return Curve(kind.part(from, to)); }, curve);
}

base::AxisSet moving(const Point& start, const Point& end) {
  base::AxisSet set;
  for (const base::Axis axis : base::all_axes) {
    if (start[base::index(axis)] != end[base::index(axis)]) set.insert(axis);
  }
  return set;
}

base::AxisSet moving(const Curve& curve) {
  if (const auto* nurbs = std::get_if<Nurbs>(&curve)) return nurbs->moving();
  base::AxisSet set = moving(geometry::start(curve), geometry::end(curve));
  if (const auto* arc = std::get_if<Arc>(&curve)) {
    set.insert(base::all_axes[arc->first()]);
    set.insert(base::all_axes[arc->second()]);
  }
  return set;
}

double Arc::helix_length(double radius, DoubleDouble sweep, double rise) {
  return numeric::hypot(radius * std::abs(sweep.value()), rise);
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
      radius_(numeric::hypot(x_.hi.value, y_.hi.value)),
      length_(length),
      rate_(sweep / DoubleDouble(length)) {
  Point straight_end = end;
  straight_end[first] = start[first];
  straight_end[second] = start[second];
  slopes_ = Slopes(start, straight_end, length);
  const Turned at_end = turned(SplitLength(length));
  defect_first_ = (end[first] - at_end.first.value()) / length;
  defect_second_ = (end[second] - at_end.second.value()) / length;
}

Arc::Turned Arc::turned(const SplitLength& s) const {
  // What is below a unit in the last place of the products is gathered in `small` and enters with the last rounding.
  //
  // Through small angles a rounding error of cos θ would count R times over, however short the arc: there the
  // displacement from the start is x(cos θ − 1) − y sin θ, whose errors are of the chord's size.
  const DoubleDouble angle = rate_.times(s);
  const bool is_small = std::abs(angle.hi) < small_angle;
  const numeric::Sines sines = numeric::sines(angle);
  const numeric::Split sine = sines.sine, cosine = is_small ? sines.cosine_less_one : sines.cosine;
  const double origin_first = is_small ? start_[first_] : center_first_;
  const double origin_second = is_small ? start_[second_] : center_second_;
  const auto sum = [](double origin, const DoubleDouble& a, const DoubleDouble& b, double small) {
    const DoubleDouble turned = numeric::two_sum(a.hi, b.hi);
    const DoubleDouble absolute = numeric::two_sum(origin, turned.hi);
    return numeric::Compensated(absolute.hi, absolute.lo + (turned.lo + (a.lo + b.lo + small)));
  };
  const DoubleDouble x_cosine = numeric::two_product(x_.hi, cosine), x_sine = numeric::two_product(x_.hi, sine);
  const DoubleDouble y_cosine = numeric::two_product(y_.hi, cosine), y_sine = numeric::two_product(y_.hi, sine);
  const double small_first = x_.lo * cosine.value - y_.lo * sine.value;
  const double small_second = x_.lo * sine.value + y_.lo * cosine.value;
  return {sum(origin_first, x_cosine, -y_sine, small_first + defect_first_ * s.hi.value),
          sum(origin_second, x_sine, y_cosine, small_second + defect_second_ * s.hi.value)};
}

template <typename T>
void Arc::go_along(std::array<T, base::axis_count>& position, DoubleDouble s) const {
  const SplitLength split(s);
  slopes_.add(start_, position, split);
  const Turned in_plane = turned(split);
  set(position[first_], in_plane.first.sum, in_plane.first.error);
  set(position[second_], in_plane.second.sum, in_plane.second.error);
}

Point Arc::evaluate(DoubleDouble s) const {
  if (s <= 0.0) return start_;
  if (DoubleDouble(length_) <= s) return end_;
  Point position = start_;
  go_along(position, s);
  return position;
}

UnroundedPoint Arc::evaluate_unrounded(DoubleDouble s) const {
  UnroundedPoint position = unrounded(DoubleDouble(length_) <= s ? end_ : start_);
  if (s <= 0.0 || DoubleDouble(length_) <= s) return position;
  go_along(position, s);
  return position;
}

Rates Arc::rates(double s, std::size_t first) const {
  Rates rates = slopes_.rates(first);
  const double w = angle_rate();
  const numeric::Sines sines = numeric::sines(w * s);
  const double x = x_.hi.value * sines.cosine - y_.hi.value * sines.sine;
  const double y = x_.hi.value * sines.sine + y_.hi.value * sines.cosine;
  if (first_ - first < rates.size()) rates[first_ - first] = -w * y + defect_first_;
  if (second_ - first < rates.size()) rates[second_ - first] = w * x + defect_second_;
  return rates;
}

PointJet Arc::jets(double s) const {
  PointJet jet;
  for (std::size_t i = 0; i < start_.size(); ++i) jet[i].value = start_[i];
  slopes_.add(jet, s);
  const double w = angle_rate();
  const numeric::Sines sines = numeric::sines(w * s);
  const double x = x_.hi.value * sines.cosine - y_.hi.value * sines.sine;
  const double y = x_.hi.value * sines.sine + y_.hi.value * sines.cosine;
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
  const double angle = direction * numeric::atan2(cross, dot);
  const DoubleDouble part = angle > 0 ? DoubleDouble(angle) : numeric::two_pi + angle;
  return (numeric::two_pi * whole + part) * direction;
}

}  // namespace leadscrew::geometry
