#include <algorithm>
#include <cmath>
#include <leadscrew/geometry/arc_length_map.hpp>
#include <leadscrew/geometry/nurbs_table.hpp>
#include <leadscrew/geometry/rational.hpp>
#include <leadscrew/numeric/bisection.hpp>
#include <span>
#include <type_traits>

namespace leadscrew::geometry {

using numeric::DoubleDouble;
using numeric::Jet;
using numeric::Pair;

namespace {

constexpr double beside_node = 1e-3;  // of the distance to the next

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

void set_sum(double& coordinate, double origin, double moved) {
  coordinate = origin + moved;
}
void set_sum(numeric::Compensated& coordinate, double origin, double moved) {
  const DoubleDouble sum = numeric::two_sum(origin, moved);
  coordinate = {sum.hi, sum.lo};
}

template <std::size_t degree, typename T>
void evaluate_record(const NurbsTable& table, const double* record, double sigma,
                     std::array<T, base::axis_count>& position) {
  const double x = polynomial_from_zero<5>(record + NurbsTable::map, sigma);
  const double* numbers = record + NurbsTable::polynomials;
  double scale = 1;
  if (table.rational) {
    scale = 1 / (1 + polynomial_from_zero<degree>(numbers, x));
    numbers += degree;
  }
  for (std::size_t k = 0; k < table.moving_count; ++k, numbers += degree + 2) {
    set_sum(position[table.moving[k]], numbers[0], polynomial<degree>(numbers + 1, x) * scale);
  }
}

/// A number of a coordinate's, or of two: of two coordinates, or of one at two places.
template <typename T>
struct Numbers {
  const double *first = nullptr, *second = nullptr;

  T operator[](std::size_t k) const {
    if constexpr (std::is_same_v<T, Pair>) {
      return Pair{first[k], second[k]};
    } else {
      return first[k];
    }
  }
  Numbers operator+(std::size_t k) const { return {first + k, second + k}; }
};
inline double lane(double value, std::size_t) {
  return value;
}
inline double lane(Pair values, std::size_t k) {
  return values[k];
}

/// What a record's coordinates are made of: the denominator's reciprocal with its derivatives by x, 1 unless the curve
/// is rational; and x itself, with derivatives by what is asked for.
template <typename T>
struct RecordPlace {
  Jet<3, T> scale = numeric::all<T>(1), x;
};

/// One coordinate or two beside one another, from their first number on, with derivatives as those of place.x.
/// Operations are those of Jet: a coordinate gives the same bits alone and beside another.
template <typename T, typename X>
Jet<3, T> coordinate_jets(const NurbsTable& table, Numbers<T> numbers, const RecordPlace<X>& place) {
  const X x = place.x.value;
  T value{}, first{}, half{}, sixth{};
  for (std::size_t k = table.degree + 1; k-- > 0;) {
    sixth = sixth * x + half;
    half = half * x + first;
    first = first * x + value;
    value = value * x + numbers[1 + k];
  }
  T second = 2.0 * half, third = 6.0 * sixth;
  if (table.rational) {
    const Jet<3, X>& w = place.scale;
    third = third * w.value + 3.0 * second * w.first + 3.0 * first * w.second + value * w.third;
    second = second * w.value + 2.0 * first * w.first + value * w.second;
    first = first * w.value + value * w.first;
    value = value * w.value;
  }
  const Jet<3, X>& u = place.x;  // Faà di Bruno's formula
  return {numbers[0] + value, first * u.first, second * u.first * u.first + first * u.second,
          third * u.first * u.first * u.first + 3.0 * second * u.first * u.second + first * u.third};
}

template <typename T>
void set_coordinates(const NurbsTable& table, const double* numbers, const RecordPlace<double>& place, std::size_t k,
                     PointJet& jets) {
  const Jet<3, T> both = coordinate_jets<T>(table, {numbers, numbers + table.degree + 2}, place);
  for (std::size_t i = 0; i < sizeof(T) / sizeof(double); ++i) {
    jets[table.moving[k + i]] = {lane(both.value, i), lane(both.first, i), lane(both.second, i), lane(both.third, i)};
  }
}

/// Position, with derivatives by whatever those of x are by.
PointJet record_jets(const NurbsTable& table, const double* record, const Jet<>& x, const Point& rest) {
  PointJet jets;
  for (std::size_t i = 0; i < rest.size(); ++i) jets[i].value = rest[i];
  const double* numbers = record + NurbsTable::polynomials;
  RecordPlace<double> place{1, x};
  if (table.rational) {
    place.scale =
        numeric::reciprocal(Jet<>(1) + polynomial_jet(numbers, table.degree - 1, x.value) * Jet<>::parameter(x.value));
    numbers += table.degree;
  }
  std::size_t k = 0;
  for (; k + 1 < table.moving_count; k += 2, numbers += 2 * (table.degree + 2))
    set_coordinates<Pair>(table, numbers, place, k, jets);
  if (k < table.moving_count) set_coordinates<double>(table, numbers, place, k, jets);
  return jets;
}

/// Of two places, each by its own record.
PointJetOf<Pair> record_jets(const NurbsTable& table, Numbers<Pair> records, const Jet<3, Pair>& x, const Point& rest) {
  PointJetOf<Pair> jets;
  for (std::size_t i = 0; i < rest.size(); ++i) jets[i].value = numeric::all<Pair>(rest[i]);
  Numbers<Pair> numbers = records + NurbsTable::polynomials;
  RecordPlace<Pair> place{numeric::all<Pair>(1), x};
  if (table.rational) {
    const Jet<3, Pair> weight = polynomial_jet(numbers, table.degree - 1, x.value) * Jet<3, Pair>::parameter(x.value);
    place.scale = numeric::reciprocal(Jet<3, Pair>(numeric::all<Pair>(1)) + weight);
    numbers = numbers + table.degree;
  }
  for (std::size_t k = 0; k < table.moving_count; ++k, numbers = numbers + (table.degree + 2))
    jets[table.moving[k]] = coordinate_jets(table, numbers, place);
  return jets;
}

/// A record's polynomials, counted from another x.
void add_polynomials(const NurbsTable& table, const double* numbers, double x, std::vector<double>& out) {
  const std::size_t degree = table.degree;
  Coefficients weight{1};
  if (table.rational) {
    std::copy_n(numbers, degree, weight.begin() + 1);
    weight = shifted(weight, x);
    for (std::size_t i = 1; i <= degree; ++i) out.push_back(weight[i] / weight[0]);
    numbers += degree;
  }
  for (std::size_t k = 0; k < table.moving_count; ++k, numbers += degree + 2) {
    Coefficients numerator{};
    std::copy_n(numbers + 1, degree + 1, numerator.begin());
    numerator = shifted(numerator, x);
    const double moved = numerator[0] / weight[0];
    out.push_back(numbers[0] + moved);
    for (std::size_t i = 0; i <= degree; ++i) out.push_back((numerator[i] - moved * weight[i]) / weight[0]);
  }
}

/// Where the table is to be exact: x′ = 1/v and x″ = −v₁/v³ (arc_length_map.hpp).
MapEnd exact_end(const NurbsTable& table, const double* record, double x, const Point& weights, const Point& rest) {
  const PointJet jets = record_jets(table, record, Jet<>::parameter(x), rest);
  double c11 = 0, c12 = 0;
  for (std::size_t i = 0; i < jets.size(); ++i) {
    const double square = weights[i] * weights[i];
    c11 += square * jets[i].first * jets[i].first;
    c12 += square * jets[i].first * jets[i].second;
  }
  return {1 / std::sqrt(c11), -c12 / (c11 * c11)};
}

}  // namespace

std::size_t first_to_move(base::AxisSet moving) {
  for (const std::size_t first : {0, 6, 3}) {
    for (std::size_t i = first; i < first + 3; ++i) {
      if (moving.contains(base::all_axes[i])) return first;
    }
  }
  return base::axis_count;
}

Point length_weights(base::AxisSet moving, const std::optional<Point>& weights) {
  if (weights) return *weights;
  Point weight{};
  const std::size_t first = first_to_move(moving);
  for (std::size_t i = first; i < first + 3 && i < weight.size(); ++i) weight[i] = 1;
  return weight;
}

/// A place on a piece: its record, and the parameter x in it with derivatives by s.
struct Nurbs::Located {
  const double* record = nullptr;
  Jet<> x;
};

std::size_t Nurbs::record_at(double s) const {
  const std::size_t bucket =
      std::min<std::size_t>(static_cast<std::size_t>(s * buckets_per_length_), bucket_count_ - 1);
  const std::uint32_t* const buckets = table_->buckets.data() + first_bucket_ + bucket;
  const double* const nodes = table_->nodes.data();
  // The last record that begins at s or before. There are seldom more than two in a bucket.
  return numeric::last_index(buckets[0], buckets[1], [&](std::size_t index) { return nodes[index] <= s; });
}

/// 0 < s < length; from the start.
template <typename T>
void Nurbs::go_along(std::array<T, base::axis_count>& position, DoubleDouble s) const {
  const NurbsTable& table = *table_;
  const std::size_t index = record_at(s.hi);
  const double* const record = table.record(index);
  const double sigma = (s.hi - table.nodes[index]) + (s.lo - record[NurbsTable::s_low]);
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
}

Point Nurbs::evaluate(DoubleDouble s) const {
  if (s <= 0.0) return start_;
  if (DoubleDouble(length_) <= s) return end_;
  Point position = start_;
  go_along(position, s);
  return position;
}

UnroundedPoint Nurbs::evaluate_unrounded(DoubleDouble s) const {
  UnroundedPoint position = unrounded(DoubleDouble(length_) <= s ? end_ : start_);
  if (s <= 0.0 || DoubleDouble(length_) <= s) return position;
  go_along(position, s);
  return position;
}

Nurbs::Located Nurbs::locate(double s) const {
  const std::size_t index = record_at(std::clamp(s, 0.0, length_));
  const double* const record = table_->record(index);
  const double sigma = s - table_->nodes[index] - record[NurbsTable::s_low];
  return {record, polynomial_jet(record + NurbsTable::map, 4, sigma) * Jet<>::parameter(sigma)};
}

PointJet Nurbs::jets(double s) const {
  const Located at = locate(s);
  return record_jets(*table_, at.record, at.x, start_);
}

PointJetOf<Pair> Nurbs::jets(Pair s) const {
  Numbers<Pair> records;
  Pair sigma;
  const auto locate = [&](std::size_t lane) {
    const std::size_t index = record_at(std::clamp(s[lane], 0.0, length_));
    const double* const record = table_->record(index);
    sigma[lane] = s[lane] - table_->nodes[index] - record[NurbsTable::s_low];
    return record;
  };
  records.first = locate(0);
  records.second = locate(1);
  const Jet<3, Pair> x = polynomial_jet(records + NurbsTable::map, 4, sigma) * Jet<3, Pair>::parameter(sigma);
  return record_jets(*table_, records, x, start_);
}

double Nurbs::parameter(double s) const {
  if (s <= 0) return first_parameter_;
  if (s >= length_) return last_parameter_;
  const Located at = locate(s);
  return at.record[NurbsTable::parameter] + at.record[NurbsTable::width] * at.x.value;
}

double Nurbs::parameter_rate(double s) const {
  const Located at = locate(s);
  return at.record[NurbsTable::width] * at.x.first;
}

PointJet Nurbs::jets_at(double u) const {
  const std::size_t index = numeric::last_index(first_record_, first_record_ + record_count_ - 1, [&](std::size_t i) {
    return table_->record(i)[NurbsTable::parameter] <= u;
  });
  const double* const record = table_->record(index);
  const double width = record[NurbsTable::width];
  const Jet<> x((u - record[NurbsTable::parameter]) / width, 1 / width, 0, 0);
  return record_jets(*table_, record, x, start_);
}

std::span<const double> Nurbs::breaks() const {
  const std::span all(table_->breaks.data() + first_break_, break_count_);
  const auto first = std::ranges::upper_bound(all, 0.0), last = std::ranges::lower_bound(all, length_);
  return first < last ? std::span(first, last) : std::span<const double>();
}

Nurbs Nurbs::part(double from, double to) const {
  if (from == 0 && to == length_) return *this;
  const auto table = std::make_shared<NurbsTable>();
  table->degree = table_->degree;
  table->rational = table_->rational;
  table->moving = table_->moving;
  table->moving_count = table_->moving_count;
  table->stride = table_->stride;
  table->weights = table_->weights;
  const std::size_t first = record_at(from), last = record_at(to);
  for (std::size_t record = first; record <= last; ++record) add_part(record, from, to, *table);

  Nurbs part;
  for (const double s : breaks()) {
    if (s > from && s - from < to - from) table->breaks.push_back(s - from);
  }
  part.break_count_ = static_cast<std::uint32_t>(table->breaks.size());
  part.record_count_ = static_cast<std::uint32_t>(table->nodes.size());
  part.length_ = to - from;
  part.first_parameter_ = parameter(from);
  part.last_parameter_ = parameter(to);
  part.moving_ = moving_;
  part.start_ = evaluate(from);
  part.end_ = evaluate(to);
  part.add_buckets(*table);
  part.table_ = table;
  return part;
}

/// What of the record lies between two lengths of this piece.
void Nurbs::add_part(std::size_t record, double from, double to, NurbsTable& table) const {
  const double* const numbers = table_->record(record);
  const auto begin_of = [&](std::size_t index) {
    return DoubleDouble(table_->nodes[index]) + DoubleDouble(table_->record(index)[NurbsTable::s_low]);
  };
  const bool is_last = record + 1 == first_record_ + record_count_;
  const DoubleDouble begin = begin_of(record), end = is_last ? DoubleDouble(length_) : begin_of(record + 1);
  const double width = (end - begin).value();
  const double low = (DoubleDouble(from) - begin).value(), high = (DoubleDouble(to) - begin).value();
  const double sigma = std::max(low, 0.0), end_sigma = std::min(high, width);
  if (!(sigma < end_sigma) && !table.nodes.empty()) return;
  // Beside a node the table is as good as exact; what is short is left as it is.
  const auto is_inside = [&](double at) { return at > beside_node * width && at < (1 - beside_node) * width; };
  const bool is_long = end_sigma - sigma > beside_node * width;
  const bool cuts_begin = is_long && is_inside(low), cuts_end = is_long && is_inside(high);

  Coefficients map{};
  std::copy_n(numbers + NurbsTable::map, 5, map.begin() + 1);
  const auto map_end = [&](double at, bool is_exact) -> MapEnd {
    const Jet<> x = polynomial_jet(map.data(), 5, at);
    return is_exact ? exact_end(*table_, numbers, x.value, length_weights(moving_, table_->weights), start_)
                    : MapEnd{x.first, x.second};
  };
  const double x = sigma > 0 ? polynomial_jet(map.data(), 5, sigma).value : 0;
  Coefficients moved = sigma > 0 ? shifted(map, sigma) : map;
  if (cuts_begin || cuts_end) {
    const double difference = polynomial_jet(map.data(), 5, end_sigma).value - x;
    const auto c = quintic_map(difference, end_sigma - sigma, map_end(sigma, cuts_begin), map_end(end_sigma, cuts_end));
    std::copy(c.begin(), c.end(), moved.begin() + 1);
  }
  const DoubleDouble s = sigma > 0 ? DoubleDouble() : begin - DoubleDouble(from);
  table.nodes.push_back(s.hi);
  std::vector<double>& out = table.records;
  out.push_back(s.lo);
  out.insert(out.end(), moved.begin() + 1, moved.end());
  out.push_back(numbers[NurbsTable::parameter] + numbers[NurbsTable::width] * x);
  out.push_back(numbers[NurbsTable::width]);
  add_polynomials(*table_, numbers + NurbsTable::polynomials, x, out);
}

void Nurbs::add_buckets(NurbsTable& table) {
  const std::uint32_t last = first_record_ + record_count_ - 1;
  first_bucket_ = static_cast<std::uint32_t>(table.buckets.size());
  bucket_count_ = 2 * record_count_;
  buckets_per_length_ = bucket_count_ / length_;
  std::uint32_t record = first_record_;
  for (std::uint32_t bucket = 0; bucket <= bucket_count_; ++bucket) {
    const double s = bucket / buckets_per_length_;
    while (record < last && table.nodes[record + 1] <= s) ++record;
    table.buckets.push_back(record);
  }
}

}  // namespace leadscrew::geometry
