#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/banded.hpp>
#include <leadscrew/numeric/gauss.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <leadscrew/toolpath/tube_spline.hpp>
#include <leadscrew/toolpath/tuning.hpp>
#include <limits>
#include <utility>

namespace leadscrew::toolpath {

using geometry::Point;

namespace {

using namespace tuning::tube;
using tuning::allowed_time;

constexpr double rounding = 1e-9;

}  // namespace

TubeSpline::TubeSpline(const State& start, const Vertex& vertex, double longest)
    : vertices_{vertex}, start_(start), begin_(vertex.u), longest_(longest) {}

void TubeSpline::retreat_to(std::size_t vertex) {
  vertices_.resize(vertex + 1);
  end_.reset();
}

double TubeSpline::smoothing_length(double u) const {
  double length = longest_;
  const auto next =
      std::lower_bound(apexes_.begin(), apexes_.end(), u, [](const Apex& a, double at) { return a.u < at; });
  if (next != apexes_.end()) length = std::min(length, next->length + cone_slope * (next->u - u));
  if (next != apexes_.begin())
    length = std::min(length, std::prev(next)->length + cone_slope * (u - std::prev(next)->u));
  return length;
}

/// ℓ that is not worth it. Beside chords of a small tolerance it may be short, as ℓ about them is.
double TubeSpline::shortest_length(double u) const {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < vertices_.size(); ++i) {
    const double apart = std::max({0.0, vertices_[i - 1].u - u, u - vertices_[i].u});
    shortest = std::min(shortest, shortest_smoothing * vertices_[i].tolerance + cone_slope * apart);
  }
  return shortest;
}

/// Keeps the apexes that lie on no other's cone: then the neighbours of a place say what ℓ is.
void TubeSpline::shorten(double u, double length) {
  auto at =
      std::lower_bound(apexes_.begin(), apexes_.end(), u, [](const Apex& a, double place) { return a.u < place; });
  const auto hidden = [&](const Apex& apex) { return apex.length >= length + cone_slope * std::abs(apex.u - u); };
  auto last = at;
  while (last != apexes_.end() && hidden(*last)) ++last;
  while (at != apexes_.begin() && hidden(*std::prev(at))) --at;
  at = apexes_.erase(at, last);
  apexes_.insert(at, {u, length});
}

void TubeSpline::place_knots() {
  const double last = vertices_.back().u;
  std::vector<double>& t = stretch_.knots;
  t.assign(quintic_degree + 1, begin_);
  whole_ = false;
  std::size_t spans = 0;
  double x = begin_;
  const auto step_at = [&](double u) {
    const double here = smoothing_length(u);
    return std::min(here, smoothing_length(u + here)) / spans_per_length;
  };
  while (static_cast<double>(spans) < window_spans && x < last) {
    x += step_at(x);
    t.push_back(x);
    ++spans;
  }
  if (end_ && x >= last) {
    whole_ = true;
    // The last knot is the end: the spans shrink a little, and there are four at least.
    const std::size_t wanted = std::max(spans, fewest_spans);
    if (wanted > spans) {
      t.resize(quintic_degree + 1);
      for (std::size_t k = 1; k <= wanted; ++k)
        t.push_back(begin_ + (last - begin_) * static_cast<double>(k) / static_cast<double>(wanted));
    } else {
      const double share = (last - begin_) / (x - begin_);
      for (std::size_t k = quintic_degree + 1; k < t.size(); ++k) t[k] = begin_ + (t[k] - begin_) * share;
    }
    t.back() = last;
    t.insert(t.end(), quintic_degree, last);
  } else {
    while (t.back() > last) t.pop_back();  // no more spans than the polyline reaches
    if (t.size() == quintic_degree + 1) t.push_back(last);
    for (std::size_t k = 0; k < quintic_degree; ++k) t.push_back(t.back() + step_at(t.back()));
  }
  stretch_.points.assign(t.size() - quintic_degree - 1, Point{});
}

void TubeSpline::take_samples() {
  samples_.clear();
  const std::vector<double>& t = stretch_.knots;
  const std::size_t spans = stretch_.spans();
  const double from = begin_, to = t[spans + quintic_degree];
  std::size_t span = 0;
  const auto put = [&](double u, std::size_t vertex) {
    Sample sample;
    sample.u = u;
    sample.vertex = vertex;
    const Vertex &a = vertices_[vertex - 1], &b = vertices_[vertex];
    const double share = (u - a.u) / (b.u - a.u);
    for (std::size_t i = 0; i < a.position.size(); ++i) {
      sample.position[i] = share >= 1 ? b.position[i] : a.position[i] + share * (b.position[i] - a.position[i]);
    }
    while (span + 1 < spans && stretch_.span_end(span) <= u) ++span;
    sample.span = span;
    sample.basis = quintic_values(t.data() + span, u);
    samples_.push_back(sample);
  };
  std::size_t vertex = 1;
  while (vertex + 1 < vertices_.size() && vertices_[vertex].u <= from) ++vertex;
  put(from, vertex);
  double u = from;
  while (u < to && vertex < vertices_.size()) {
    const double end = std::min(to, vertices_[vertex].u);
    while (span + 1 < spans && stretch_.span_end(span) <= u) ++span;
    const double width = stretch_.span_end(span) - stretch_.span_begin(span);
    const double step =
        std::min(width / samples_per_span, std::sqrt(8 * sample_sagitta * vertices_[vertex].margin * width));
    const double left = end - u;
    if (left > step) {
      u += left / std::ceil(left / step);
      put(u, vertex);
      continue;
    }
    u = end;
    put(u, vertex);
    if (u >= vertices_[vertex].u) ++vertex;
  }
  for (std::size_t i = 0; i + 1 < samples_.size(); ++i) {
    const double half = (samples_[i + 1].u - samples_[i].u) / 2;
    samples_[i].weight += half;
    samples_[i + 1].weight += half;
  }
}

/// Of the free points, first … last: sums of squares of rows of six, each less its target.
class TubeSpline::NormalEquations {
 public:
  NormalEquations(std::vector<Point>& points, std::size_t first, std::size_t last)
      : points_(points), first_(first), last_(last), right_(last - first, Point{}) {
    matrix_.reset(last - first);
  }

  /// target: none for 0.
  void add(std::size_t span, const Six& row, double weight, const Point* target) {
    for (std::size_t a = 0; a < row.size(); ++a) {
      const std::size_t i = span + a;
      if (i < first_ || i >= last_) continue;
      const double scaled = weight * row[a];
      Point& b = right_[i - first_];
      if (target) {
        for (std::size_t k = 0; k < b.size(); ++k) b[k] += scaled * (*target)[k];
      }
      for (std::size_t d = 0; d < row.size(); ++d) {
        const std::size_t j = span + d;
        if (j < first_ || j >= last_) {
          const double product = scaled * row[d];
          for (std::size_t k = 0; k < b.size(); ++k) b[k] -= product * points_[j][k];
        } else if (j <= i) {
          matrix_.add(i - first_, j - first_, scaled * row[d]);
        }
      }
    }
  }

  /// Where all that is known of a coordinate is one value, rounding must not move it.
  void solve(const std::vector<Sample>& samples) {
    matrix_.factor(1e-15);
    std::vector<double> column(right_.size());
    for (std::size_t k = 0; k < base::axis_count; ++k) {
      const double at = points_[0][k];
      const auto stands = [&](const Point& point) { return point[k] == at; };
      const auto from = points_.begin(), to = points_.end();
      const bool moves =
          !std::all_of(from, from + static_cast<std::ptrdiff_t>(first_), stands) ||
          !std::all_of(from + static_cast<std::ptrdiff_t>(last_), to, stands) ||
          std::any_of(samples.begin(), samples.end(), [&](const Sample& sample) { return sample.position[k] != at; });
      for (std::size_t i = 0; i < column.size(); ++i) column[i] = right_[i][k];
      if (moves) matrix_.solve(column);
      for (std::size_t i = 0; i < column.size(); ++i) points_[first_ + i][k] = moves ? column[i] : at;
    }
  }

 private:
  std::vector<Point>& points_;
  std::size_t first_, last_;
  numeric::BandedMatrix<quintic_degree> matrix_;
  std::vector<Point> right_;
};

void TubeSpline::solve() {
  const std::vector<double>& t = stretch_.knots;
  std::vector<Point>& c = stretch_.points;
  const std::size_t n = c.size();
  begin_with(start_, t.data(), c.data());
  const std::size_t first = start_.count;
  std::size_t last = n;  // one past the last free point
  if (whole_) {
    std::array<double, 12> mirrored;
    for (std::size_t k = 0; k < mirrored.size(); ++k) mirrored[k] = -t[t.size() - 1 - k];
    std::array<Point, State::most> points;
    begin_with(*end_, mirrored.data(), points.data());
    for (std::size_t k = 0; k < end_->count; ++k) c[n - 1 - k] = points[k];
    last = n - end_->count;
  }
  if (first >= last) return;

  NormalEquations equations(c, first, last);
  for (const Sample& sample : samples_) equations.add(sample.span, sample.basis, sample.weight, &sample.position);
  constexpr double place_of_gauss = numeric::gauss_3_abscissa;
  const auto [outer, inner, mirrored] = numeric::gauss_3_weights;
  for (std::size_t span = 0; span < stretch_.spans(); ++span) {
    const double from = stretch_.span_begin(span), to = stretch_.span_end(span), width = to - from;
    const double length = std::min(smoothing_length(from), smoothing_length(to));
    const double cube = length * length * length, factor = width * cube * cube;
    for (const auto& [place, weight] : {std::pair{-place_of_gauss, outer}, {0.0, inner}, {place_of_gauss, mirrored}}) {
      const Six row = quintic_third_derivatives(t.data() + span, from + width * (1 + place) / 2);
      equations.add(span, row, factor * weight, nullptr);
    }
  }
  equations.solve(samples_);
}

/// |D²_i| of the control points.
std::vector<double> TubeSpline::bends() const {
  const std::vector<double>& t = stretch_.knots;
  const std::vector<Point>& c = stretch_.points;
  std::vector<double> bend(c.size() - 2);
  std::vector<Point> slope(c.size() - 1);
  for (std::size_t i = 0; i < slope.size(); ++i) {
    const double factor = 5 / (t[i + 6] - t[i + 1]);
    for (std::size_t k = 0; k < slope[i].size(); ++k) slope[i][k] = factor * (c[i + 1][k] - c[i][k]);
  }
  for (std::size_t i = 0; i < bend.size(); ++i) bend[i] = 4 / (t[i + 6] - t[i + 2]) * distance(slope[i + 1], slope[i]);
  return bend;
}

/// Where the samples are on the curve, and whether it takes longer by feed than the polyline. None where it turns back.
std::optional<bool> TubeSpline::is_detour(std::size_t judged) {
  const std::vector<Point>& c = stretch_.points;
  Point before{}, step_before{};
  double last_u = 0, u_before = 0, time = 0, time_before = 0;  // of the curve and of the polyline, by feed
  bool turns_back = false;
  for (Sample& sample : samples_) {
    Point there{};
    for (std::size_t a = 0; a < sample.basis.size(); ++a) {
      for (std::size_t k = 0; k < there.size(); ++k) there[k] += sample.basis[a] * c[sample.span + a][k];
    }
    sample.distance = distance(there, sample.position);
    // Nearly on the spot: motion would all but stop, at a bend that is hard to plan.
    const Point step = difference(there, before);
    const double along = dot(step, step_before), lengths = norm(step) * norm(step_before);
    if (&sample - samples_.data() > 1 && sample.span < judged && along < back * lengths &&
        norm(step) + norm(step_before) < least_advance * (sample.u - u_before)) {
      turns_back = true;
      worst_ = sample.vertex;
    }
    if (&sample != samples_.data()) {
      const double pace = vertices_[sample.vertex].pace, apart = sample.u - last_u;
      sample.lengthened = apart > rounding * longest_ ? norm(step) / apart : 0;
      if (sample.span < settled_spans()) {
        time += pace * norm(step);
        time_before += pace * apart;
      }
    }
    u_before = std::exchange(last_u, sample.u);
    step_before = step;
    before = there;
  }
  if (turns_back) return std::nullopt;
  return time > std::max(most_lengthened * time_before, time_before + allowed_time);
}

/// Is the window inside the tube? Where it is not, ℓ is shortened.
bool TubeSpline::check() {
  const std::vector<double> bend = bends();
  const auto greatest_bend = [&](std::size_t span) { return *std::max_element(&bend[span], &bend[span] + 4); };

  // Towards an end that is none the curve is free, and what it does there is not settled.
  const std::size_t judged = whole_ ? stretch_.spans() : std::max(settled_spans(), stretch_.spans() * 3 / 4);
  const std::optional<bool> detour = is_detour(judged);
  turns_back_ = !detour;
  if (turns_back_) return false;
  double worst = 1, greatest = 0, left = std::numeric_limits<double>::infinity();
  bool inside = true;
  std::vector<Apex> found;
  for (std::size_t i = 1; i < samples_.size(); ++i) {
    const Sample &a = samples_[i - 1], &b = samples_[i];
    if (a.span >= judged) break;
    const double apart = b.u - a.u, bent = std::max(greatest_bend(a.span), greatest_bend(b.span));
    const double off = std::max(a.distance, b.distance) + apart * apart / 8 * bent;
    double share = off / vertices_[b.vertex].margin;
    if (a.span < settled_spans()) {
      greatest = std::max(greatest, share);
      left = std::min(left, vertices_[b.vertex].words - off);
    }
    if (*detour && b.lengthened > 1) share = std::max(share, b.lengthened);
    if (share <= 1) continue;  // NaN counts as outside
    inside = false;
    const double u = a.distance > b.distance ? a.u : b.u;
    found.push_back({u, smoothing_length(u) * std::clamp(std::sqrt(0.9 / share), shortened_most, shortened_least)});
    if (share > worst) {
      worst = share;
      worst_ = b.vertex;
    }
  }
  least_asked_ = {begin_, longest_};
  for (const Apex& apex : found) {
    if (apex.length < least_asked_.length) least_asked_ = apex;
    if (apex.length < smoothing_length(apex.u)) shorten(apex.u, apex.length);
  }
  if (inside) greatest_share_ = std::max(greatest_share_, greatest);
  sagitta_ = std::max(left, 0.0);
  return inside;
}

/// How many of the window's spans are settled if it is inside the tube.
std::size_t TubeSpline::settled_spans() const {
  return whole_ ? stretch_.spans() : std::max<std::size_t>(1, stretch_.spans() / settled_share);
}

TubeSpline::Outcome TubeSpline::settle() {
  if (!knows_enough()) return Outcome::wants_more;
  // A short curve has some lengths to bend in.
  if (end_ && !begun_) longest_ = std::min(longest_, (vertices_.back().u - begin_) / lengths_per_curve);
  begun_ = true;
  for (int round = 0; round < most_rounds; ++round) {
    place_knots();
    take_samples();
    solve();
    if (check()) {
      if (whole_) {
        begin_ = vertices_.back().u;
        return Outcome::ended;
      }
      const std::size_t spans = settled_spans();
      const double end = stretch_.span_end(spans - 1);
      start_ = stretch_.state(spans, end);
      // A coordinate that stands still does so without rounding.
      for (std::size_t k = 0; k < base::axis_count; ++k) {
        const double at = stretch_.points[0][k];
        if (!std::all_of(stretch_.points.begin(), stretch_.points.end(), [&](const Point& c) { return c[k] == at; }))
          continue;
        start_.derivative[0][k] = at;
        for (std::size_t r = 1; r < start_.count; ++r) start_.derivative[r][k] = 0;
      }
      begin_ = end;
      stretch_.points.resize(spans + quintic_degree);
      stretch_.knots.resize(spans + 2 * quintic_degree + 1);
      std::size_t gone = 0;
      while (gone + 2 < vertices_.size() && vertices_[gone + 1].u <= begin_) ++gone;
      vertices_.erase(vertices_.begin(), vertices_.begin() + static_cast<std::ptrdiff_t>(gone));
      std::erase_if(apexes_, [&](const Apex& apex) { return apex.u < begin_ - 10 * longest_; });
      return Outcome::settled;
    }
    const double worst = vertices_[worst_].u;
    if (turns_back_ || smoothing_length(worst) < shortest_length(worst)) break;
    // The worst vertex may be far from where the curve leaves the tube.
    if (least_asked_.length < least_share * shortest_length(least_asked_.u)) break;
  }
  return Outcome::failed;
}

}  // namespace leadscrew::toolpath
