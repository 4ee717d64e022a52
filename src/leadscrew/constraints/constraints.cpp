#include <algorithm>
#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <limits>

namespace leadscrew::constraints {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double greatest_speed_of(const SpeedRow& row, double least_rate = 0) {
  const double rate = std::abs(row.rate);
  return rate > least_rate ? row.limit / rate : infinity;
}
double greatest_speed_of(const SquareRow& row, double = 0) {
  return std::sqrt(row.greatest);
}

/// Limit over the rate by which it grows with the derivative itself along the tangent.
double along_tangent_of(const SpeedRow& row) {
  return greatest_speed_of(row);
}
double along_tangent_of(const SquareRow& row) {
  return greatest_speed_of(row);
}
double along_tangent_of(const AccelerationRow& row) {
  return row.by_b != 0 ? row.limit / std::abs(row.by_b) : infinity;
}
double along_tangent_of(const JerkRow& row) {
  return row.by_c != 0 ? row.limit / std::abs(row.by_c) : infinity;
}

}  // namespace

machine::Derivatives LimitRatios::of_axis(base::Axis axis) const {
  machine::Derivatives result;
  for_each_kind([&](auto kind) {
    using Kind = KindAt<kind>;
    if constexpr (Kind::is_proven && Kind::is_of_axes) {
      double& of_derivative = result.*derivative_of<typename Kind::Row>;
      of_derivative = std::max(of_derivative, values_[offset<kind> + base::index(axis)]);
    }
  });
  return result;
}

machine::Derivatives LimitRatios::by_derivative() const {
  machine::Derivatives result;
  for_each_kind([&](auto kind) {
    using Kind = KindAt<kind>;
    if constexpr (Kind::is_proven) {
      double& of_derivative = result.*derivative_of<typename Kind::Row>;
      for (std::size_t i = 0; i < row_count<kind>; ++i)
        of_derivative = std::max(of_derivative, values_[offset<kind> + i]);
    }
  });
  return result;
}

std::array<LimitRatios::Named, LimitRatios::path_limits> LimitRatios::of_path() const {
  std::array<Named, path_limits> result{};
  std::size_t next = 0;
  for_each_kind([&](auto kind) {
    using Kind = KindAt<kind>;
    if constexpr (Kind::is_proven && !Kind::is_of_axes) {
      const double ratio = values_[offset<kind>];  // a row of x says that of speeds
      result[next++] = {Kind::name, std::is_same_v<typename Kind::Row, SquareRow> ? ratio * ratio : ratio};
    }
  });
  return result;
}

double LimitRatios::greatest() const {
  return *std::max_element(values_.begin(), values_.end());
}

double Constraints::greatest_square(const Place& at) const {
  double speed = infinity, square = infinity;
  each_row(at, [&](auto, std::size_t, const auto& row) {
    using Row = std::remove_cvref_t<decltype(row)>;
    if constexpr (std::is_same_v<Row, SpeedRow>) speed = std::min(speed, greatest_speed_of(row));
    if constexpr (std::is_same_v<Row, SquareRow>) square = std::min(square, row.greatest);
  });
  return std::min(speed * speed, square);
}

double Constraints::greatest_speed(const Place& at, double least_rate) const {
  double speed = infinity;
  each_row(at, [&](auto kind, std::size_t, const auto& row) {
    using Row = std::remove_cvref_t<decltype(row)>;
    if constexpr (is_speed<Row> && KindAt<kind>::is_proven) speed = std::min(speed, greatest_speed_of(row, least_rate));
  });
  return speed;
}

machine::Derivatives Constraints::along_tangent(const Place& at, base::AxisSet skip) const {
  machine::Derivatives limits{infinity, infinity, infinity};
  each_row(at, [&](auto kind, std::size_t index, const auto& row) {
    using Kind = KindAt<kind>;
    if constexpr (!Kind::is_proven) return;
    if (Kind::is_of_axes && skip.contains(base::all_axes[index])) return;
    double& limit = limits.*derivative_of<typename Kind::Row>;
    limit = std::min(limit, along_tangent_of(row));
  });
  return limits;
}

double Constraints::greatest_square_by_curve(const Place& at) const {
  double square = infinity;
  each_row(at, [&](auto, std::size_t, const auto& row) {
    using Row = std::remove_cvref_t<decltype(row)>;
    if constexpr (std::is_same_v<Row, AccelerationRow>) {
      if (row.by_x != 0) square = std::min(square, row.limit / std::abs(row.by_x));
    }
    if constexpr (std::is_same_v<Row, JerkRow>) {
      const double root = row.by_x != 0 ? numeric::cbrt(row.limit / std::abs(row.by_x)) : infinity;
      square = std::min(square, root * root);
    }
  });
  return square;
}

machine::Derivatives Constraints::of_axis(base::Axis axis) const {
  machine::Derivatives limits{infinity, infinity, infinity};
  for_each_kind([&](auto kind) {
    using Kind = KindAt<kind>;
    if constexpr (Kind::is_of_axes) {
      double& limit = limits.*derivative_of<typename Kind::Row>;
      limit = std::min(limit, std::get<kind>(kinds_).limit(base::index(axis)));
    }
  });
  return limits;
}

}  // namespace leadscrew::constraints
