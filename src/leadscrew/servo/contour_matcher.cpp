#include <algorithm>
#include <cmath>
#include <leadscrew/servo/contour_matcher.hpp>
#include <limits>

namespace leadscrew::servo {

namespace {

constexpr std::int64_t most_lines = 512;  // in a window

}  // namespace

ContourMatcher::ContourMatcher(const base::AxisVector& scale, const ContourWindow& window) : scale_(scale) {
  for (std::size_t k = 0; k < base::axis_count; ++k) {
    if (scale[k] != 0) axes_.push_back(k);
  }
  const auto lines_of = [&](int periods) { return (std::max(1, periods) + stride_ - 1) / stride_; };
  stride_ = 1;
  stride_ = lines_of(window.behind + window.ahead) / most_lines + 1;
  behind_ = lines_of(window.behind);
  ahead_ = lines_of(window.ahead);
  rows_.resize(static_cast<std::size_t>(2 * (behind_ + ahead_)));
  path_.resize(rows_.size() + static_cast<std::size_t>(behind_ + 2 * ahead_ + 4));  // what rows in doubt may refer to
}

ContourMatcher::Point ContourMatcher::scaled(const base::AxisVector& position) const {
  Point point{};
  for (const std::size_t k : axes_) point[k] = position[k] * scale_[k];
  return point;
}

void ContourMatcher::observe(const base::AxisVector& commanded, const base::AxisVector& actual) {
  if (periods_++ % stride_ != 0) return;
  const Point word = scaled(commanded);
  if (vertices_ == 0 || word != vertex(vertices_ - 1))
    path_[static_cast<std::size_t>(vertices_++) % path_.size()] = word;
  waiting_.push_back({scaled(actual), vertices_ - 1});
  if (static_cast<std::int64_t>(waiting_.size()) <= ahead_) return;
  match(waiting_.front());
  waiting_.pop_front();
}

void ContourMatcher::finish() {
  for (const Waiting& period : waiting_) match(period);
  waiting_.clear();
  settle(in_doubt_);
}

/// Where on the line the point's foot is, 0 … 1. The last vertex, until there is one after it, is a line of no length.
double ContourMatcher::share_of(const Point& point, std::int64_t line, std::int64_t last) const {
  const Point& from = vertex(line);
  const Point& to = vertex(std::min(line + 1, last));
  double along = 0, length = 0;
  for (const std::size_t k : axes_) {
    const double step = to[k] - from[k];
    along += (point[k] - from[k]) * step;
    length += step * step;
  }
  return length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
}

double ContourMatcher::squared_distance(const Point& point, std::int64_t line, std::int64_t last) const {
  const double share = share_of(point, line, last);
  const Point& from = vertex(line);
  const Point& to = vertex(std::min(line + 1, last));
  double sum = 0;
  for (const std::size_t k : axes_) {
    const double offset = point[k] - from[k] - share * (to[k] - from[k]);
    sum += offset * offset;
  }
  return sum;
}

Contour ContourMatcher::contour(const MatchRow& row, std::size_t column) const {
  const std::int64_t line = row.first + static_cast<std::int64_t>(column);
  const double share = share_of(row.actual, line, row.last_vertex);
  const Point& from = vertex(line);
  const Point& to = vertex(std::min(line + 1, row.last_vertex));
  Contour contour{std::sqrt(squared_distance(row.actual, line, row.last_vertex)), {}, {}};
  for (const std::size_t k : axes_) {
    contour.actual[k] = row.actual[k] / scale_[k];
    contour.nearest[k] = (from[k] + share * (to[k] - from[k])) / scale_[k];
  }
  return contour;
}

void ContourMatcher::match(const Waiting& period) {
  const std::int64_t first = std::max<std::int64_t>(0, period.due - behind_);
  const std::int64_t last = std::min(period.due + ahead_, std::max<std::int64_t>(vertices_ - 2, period.due));
  const auto columns = static_cast<std::size_t>(last - first + 1);
  MatchRow& row = rows_[in_doubt_++];
  row.first = first;
  row.came_from.assign(columns, 0);
  row.actual = period.actual;
  row.last_vertex = vertices_ - 1;
  std::swap(sums_, sums_before_);
  sums_.resize(columns);
  const bool begins = sums_before_.empty();
  double best = begins ? 0 : std::numeric_limits<double>::infinity();
  std::size_t before = 0, best_column = 0;  // least of the row before, up to this line
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t column = 0; column < columns; ++column) {
    const std::int64_t line = first + static_cast<std::int64_t>(column);
    for (; before < sums_before_.size() && first_ + static_cast<std::int64_t>(before) <= line; ++before) {
      if (!(sums_before_[before] < best)) continue;
      best = sums_before_[before];
      best_column = before;
    }
    const double squared = squared_distance(period.actual, line, vertices_ - 1);
    row.came_from[column] = static_cast<std::uint16_t>(best_column);
    sums_[column] = best + squared;
    least = std::min(least, sums_[column]);
  }
  for (double& sum : sums_) sum -= least;  // only differences count
  first_ = first;
  if (in_doubt_ == rows_.size()) settle(rows_.size() / 2);
}

/// Settles the oldest `count` rows, traced back from the best column of the newest.
void ContourMatcher::settle(std::size_t count) {
  if (in_doubt_ == 0) return;
  auto column = static_cast<std::size_t>(std::min_element(sums_.begin(), sums_.end()) - sums_.begin());
  const std::size_t begin = settled_.size();
  settled_.resize(begin + count);
  for (std::size_t k = in_doubt_; k-- > 0;) {
    if (k < count) settled_[begin + k] = contour(rows_[k], column);
    column = rows_[k].came_from[column];
  }
  std::rotate(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(count),
              rows_.begin() + static_cast<std::ptrdiff_t>(in_doubt_));
  in_doubt_ -= count;
}

}  // namespace leadscrew::servo
