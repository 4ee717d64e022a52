#include <algorithm>
#include <leadscrew/geometry/nurbs.hpp>
#include <leadscrew/geometry/nurbs_table.hpp>
#include <leadscrew/geometry/rational.hpp>

namespace leadscrew::geometry {

using numeric::DoubleDouble;
using numeric::Jet;

namespace {

/// c[0] + c[1] x + … + c[degree] x^degree.
template <std::size_t degree>
double polynomial(const double* c, double x) {
  double value = c[degree];
  for (std::size_t k = degree; k-- > 0;) value = value * x + c[k];
  return value;
}

/// The same without a constant term, c beginning with the linear one.
template <std::size_t degree>
double polynomial_from_zero(const double* c, double x) {
  return polynomial<degree - 1>(c, x) * x;
}

template <std::size_t degree>
void evaluate_record(const NurbsTable& table, const double* record, double sigma, Point& position) {
  const double x = polynomial_from_zero<5>(record + NurbsTable::map, sigma);
  const double* numbers = record + NurbsTable::polynomials;
  double scale = 1;
  if (table.rational) {
    scale = 1 / (1 + polynomial_from_zero<degree>(numbers, x));
    numbers += degree;
  }
  for (std::size_t k = 0; k < table.moving_count; ++k, numbers += degree + 2) {
    position[table.moving[k]] = numbers[0] + polynomial<degree>(numbers + 1, x) * scale;
  }
}

/// Position and derivatives by x.
PointJet record_jets(const NurbsTable& table, const double* record, double x, const Point& rest) {
  PointJet jets;
  for (std::size_t i = 0; i < rest.size(); ++i) jets[i] = Jet(rest[i]);
  const double* numbers = record + NurbsTable::polynomials;
  Jet scale = 1;
  if (table.rational) {
    scale = numeric::reciprocal(Jet(1) + polynomial_jet(numbers, table.degree - 1, x) * Jet::parameter(x));
    numbers += table.degree;
  }
  for (std::size_t k = 0; k < table.moving_count; ++k, numbers += table.degree + 2) {
    jets[table.moving[k]] = Jet(numbers[0]) + polynomial_jet(numbers + 1, table.degree, x) * scale;
  }
  return jets;
}

}  // namespace

/// A place on a piece: its record, and the parameter x in it with derivatives by s.
struct Nurbs::Located {
  const double* record = nullptr;
  Jet x;
};

std::size_t Nurbs::record_at(double s) const {
  const std::size_t bucket =
      std::min<std::size_t>(static_cast<std::size_t>(s * buckets_per_length_), bucket_count_ - 1);
  const std::uint32_t* const buckets = table_->buckets.data() + first_bucket_ + bucket;
  const double* const nodes = table_->nodes.data();
  // The last record that begins at s or before. There are seldom more than two in a bucket.
  std::size_t low = buckets[0], high = buckets[1];
  while (low < high) {
    const std::size_t middle = (low + high + 1) / 2;
    if (nodes[middle] <= s) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  return low;
}

Point Nurbs::evaluate(DoubleDouble s) const {
  if (s <= 0.0) return start_;
  if (DoubleDouble(length_) <= s) return end_;
  s = s + begin_;
  const NurbsTable& table = *table_;
  const std::size_t index = record_at(s.hi);
  const double* const record = table.record(index);
  const double sigma = (s.hi - table.nodes[index]) + (s.lo - record[NurbsTable::s_low]);
  Point position = start_;
  switch (table.degree) {
    case 1:
      evaluate_record<1>(table, record, sigma, position);
      break;
    case 2:
      evaluate_record<2>(table, record, sigma, position);
      break;
    case 3:
      evaluate_record<3>(table, record, sigma, position);
      break;
    case 4:
      evaluate_record<4>(table, record, sigma, position);
      break;
    default:
      evaluate_record<5>(table, record, sigma, position);
  }
  return position;
}

Nurbs::Located Nurbs::locate(double s) const {
  const std::size_t index = record_at(std::clamp(s, 0.0, length_) + begin_);
  const double* const record = table_->record(index);
  s += begin_;
  const double sigma = s - table_->nodes[index] - record[NurbsTable::s_low];
  return {record, polynomial_jet(record + NurbsTable::map, 4, sigma) * Jet::parameter(sigma)};
}

PointJet Nurbs::jets(double s) const {
  const Located at = locate(s);
  PointJet jets = record_jets(*table_, at.record, at.x.value, start_);
  for (std::size_t k = 0; k < table_->moving_count; ++k) {
    Jet& jet = jets[table_->moving[k]];
    jet = numeric::compose(jet, at.x);
  }
  return jets;
}

double Nurbs::parameter(double s) const {
  if (s <= 0) return first_parameter_;
  if (s >= length_) return last_parameter_;
  const Located at = locate(s);
  return at.record[NurbsTable::parameter] + at.record[NurbsTable::width] * at.x.value;
}

PointJet Nurbs::jets_at(double u) const {
  std::size_t low = first_record_, high = first_record_ + record_count_ - 1;
  while (low < high) {
    const std::size_t middle = (low + high + 1) / 2;
    if (table_->record(middle)[NurbsTable::parameter] <= u) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  const double* const record = table_->record(low);
  const double width = record[NurbsTable::width];
  const Jet x((u - record[NurbsTable::parameter]) / width, 1 / width, 0, 0);
  PointJet jets = record_jets(*table_, record, x.value, start_);
  for (std::size_t k = 0; k < table_->moving_count; ++k) {
    Jet& jet = jets[table_->moving[k]];
    jet = numeric::compose(jet, x);
  }
  return jets;
}

std::vector<double> Nurbs::breaks() const {
  std::vector<double> inside;
  for (std::uint32_t i = 0; i < break_count_; ++i) {
    const double s = table_->breaks[first_break_ + i] - begin_;
    if (s > 0 && s < length_) inside.push_back(s);
  }
  return inside;
}

Nurbs Nurbs::part(double from, double to) const {
  Nurbs part = *this;
  part.first_parameter_ = parameter(from);
  part.last_parameter_ = parameter(to);
  part.start_ = evaluate(from);
  part.end_ = evaluate(to);
  part.begin_ = begin_ + from;
  part.length_ = to - from;
  return part;
}

}  // namespace leadscrew::geometry
