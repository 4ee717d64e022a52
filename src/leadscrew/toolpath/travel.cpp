#include <algorithm>
#include <cmath>
#include <leadscrew/toolpath/travel.hpp>
#include <limits>
#include <vector>

namespace leadscrew::toolpath {

namespace {

/// Where the axes of a piece are at even lengths, ends included.
class Samples {
 public:
  explicit Samples(const AxisPath& axes)
      : axes_(axes), length_(axes.length()), step_(length_ / static_cast<double>(parts_of(axes))) {
    const std::size_t parts = parts_of(axes);
    points_.reserve(parts + 1);
    for (std::size_t k = 0; k <= parts; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(parts);
      points_.push_back(at(length_ * share));
    }
  }

  /// The greatest of sign · coordinate; NaN counts as infinity. Exact only where it is, or may be, above the limit.
  double greatest(std::size_t axis, double sign, double limit) const {
    std::size_t best = 0;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      if (std::isnan(points_[k][axis])) return std::numeric_limits<double>::infinity();
      if (sign * points_[k][axis] > sign * points_[best][axis]) best = k;
    }
    const double sampled = sign * points_[best][axis];
    if (points_.size() == 2 || sampled + bulge(axis) <= limit) return sampled;
    return std::max(sampled, peak(axis, sign, static_cast<double>(best) * step_));
  }

 private:
  geometry::Point at(double s) const { return axes_.position(numeric::DoubleDouble(s)); }

  /// More than a smooth curve rises above its samples: as much as it goes from one to the next.
  double bulge(std::size_t axis) const {
    double most = 0;
    for (std::size_t k = 1; k < points_.size(); ++k)
      most = std::max(most, std::abs(points_[k][axis] - points_[k - 1][axis]));
    return most;
  }

  /// By golden section within a part of either side.
  double peak(std::size_t axis, double sign, double around) const {
    constexpr double golden = 0.6180339887498949;
    double low = std::max(0.0, around - step_), high = std::min(length_, around + step_);
    double greatest = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < 48; ++k) {
      const double left = high - golden * (high - low), right = low + golden * (high - low);
      const double of_left = sign * at(left)[axis], of_right = sign * at(right)[axis];
      greatest = std::max({greatest, of_left, of_right});
      (of_left < of_right ? low : high) = of_left < of_right ? left : right;
    }
    return greatest;
  }

  static std::size_t parts_of(const AxisPath& axes) {
    constexpr double least = 32, most = 4096, angle = 0.2;  // rad
    constexpr double of_polynomial = 4;
    if (axes.line()) return 1;
    const geometry::Arc* arc = axes.arc();
    const double parts = arc ? std::abs(arc->angle_rate()) * arc->length() / angle
                             : of_polynomial * static_cast<double>(axes.breaks().size() + 1);
    return static_cast<std::size_t>(std::clamp(parts, least, most));
  }

  AxisPath axes_;
  double length_, step_;
  std::vector<geometry::Point> points_;
};

/// Far from where travel ends: on a line by its ends, on an arc by its length, which no axis of its plane outruns.
bool is_far_inside(const AxisPath& axes, std::size_t axis, double least, double most) {
  const geometry::Arc* arc = axes.arc();
  if (!axes.line() && !arc) return false;
  const double start = axes.start()[axis], end = axes.end()[axis];
  const double reach = arc && (axis == arc->first() || axis == arc->second()) ? 1.001 * arc->length() : 0;
  const auto is_inside = [&](double q) { return q - reach >= least && q + reach <= most; };
  return is_inside(start) && is_inside(end);
}

}  // namespace

std::optional<TravelExcess> check_travel(Piece& piece, const machine::Machine& machine, const geometry::Point& start,
                                         double slack) {
  const AxisPath axes = piece.axes();
  const double length = axes.length();
  if (!std::isfinite(length)) return TravelExcess{base::Axis::X, length};
  std::optional<Samples> samples;
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const std::size_t i = base::index(axis);
    const double least = std::min(machine.limits(axis).travel_min, start[i]) - slack;
    const double most = std::max(machine.limits(axis).travel_max, start[i]) + slack;
    if (is_far_inside(axes, i, least, most)) continue;
    if (!samples) samples.emplace(axes);
    const double high = samples->greatest(i, 1, most), low = -samples->greatest(i, -1, -least);
    if (!(high <= most)) return TravelExcess{axis, high};
    if (!(low >= least)) return TravelExcess{axis, low};
  }
  piece.travel.passed_ = true;
  return std::nullopt;
}

void widen(const Piece& piece, base::AxisSet axes, geometry::Point& least, geometry::Point& greatest) {
  const AxisPath path = piece.axes();
  std::optional<Samples> samples;
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    if (!axes.contains(axis) || is_far_inside(path, i, least[i], greatest[i])) continue;
    if (!samples) samples.emplace(path);
    greatest[i] = std::max(greatest[i], samples->greatest(i, 1, greatest[i]));
    least[i] = std::min(least[i], -samples->greatest(i, -1, -least[i]));
  }
}

}  // namespace leadscrew::toolpath
