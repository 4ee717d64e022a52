#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/numeric/gauss.hpp>
#include <leadscrew/planner/speed_problem.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <limits>
#include <utility>

namespace leadscrew::planner {

namespace {

using constraints::RowPairs;

using namespace tuning::rows;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::array<double, 6> around(const std::vector<double>& s, std::size_t k) {
  std::array<double, 6> t;
  const auto last = static_cast<std::ptrdiff_t>(s.size()) - 1;
  for (std::ptrdiff_t i = 0; i < 6; ++i) {
    t[static_cast<std::size_t>(i)] =
        s[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(k) + i - 2, 0, last))];
  }
  return t;
}

/// c₀, c₁, c₂ of a clamped spline that goes on from x ∝ s^(4/3) at s₁, for x(s₁) = 1: x′ = 4/(3s₁), x″ = 4/(9s₁²).
std::array<double, 3> rest_tie(double s1, double h0, double h1) {
  const double slope = 4 / (3 * s1), bend = 4 / (9 * s1 * s1);
  const double g1 = 1 + slope * h0 / 3;
  return {1, g1, g1 + (h0 + h1) / 3 * (bend * h0 / 2 + slope)};
}

/// Do derivatives of the curve lie above those at both ends of an interval, by as much as counts at this speed?
bool is_above(const RowPairs& here, const RowPairs& left, const RowPairs& right, double fastest) {
  const auto above = [](double m, double x, double y) {
    return std::abs(m) > 1.001 * std::max(std::abs(x), std::abs(y));
  };
  for (std::size_t i = 0; i < RowPairs::size; ++i) {
    const auto& [a, j] = here.pairs[i];
    const auto& [left_a, left_j] = left.pairs[i];
    const auto& [right_a, right_j] = right.pairs[i];
    if (above(a.by_x, left_a.by_x, right_a.by_x) && std::abs(a.by_x) > least_peak * a.limit / squared(fastest))
      return true;
    if (above(j.by_x, left_j.by_x, right_j.by_x) &&
        std::abs(j.by_x) > least_peak * j.limit / (squared(fastest) * fastest)) {
      return true;
    }
  }
  return false;
}

}  // namespace

/// Goes along the knots once.
class SpeedProblem::Builder {
 public:
  Builder(SpeedProblem& problem, const Section& section, const constraints::Constraints& constraints,
          double feed_factor)
      : problem_(problem), section_(section), constraints_(constraints), feed_factor_(feed_factor) {}

  void build() {
    place_basis();
    reserve();
    const std::vector<double>& s = problem_.knots_.s;
    const std::size_t n = problem_.intervals();
    problem_.caps_.knots.assign(n + 1, infinity);
    problem_.caps_.middles.assign(n, infinity);
    left_ = look(s[0], Side::right);
    problem_.caps_.knots[0] = left_.cap;
    add_site(0, 0, left_.rows);
    speed_varies_.assign(n, false);
    cap_steps_ = problem_.knots_.breaks;
    for (std::size_t k = 0; k < n; ++k) add_interval(k);
    lower_varying_caps();
    cap_coefficients();
  }

 private:
  /// What is asked at one place.
  struct Look {
    RowPairs rows;
    double cap = 0;             ///< greatest x
    bool speed_varies = false;  ///< the cap is by a feed that varies along the path
  };
  RowPairs rows_at(double s, Side side) const { return constraints_.row_pairs({section_.jets(s, side), infinity}); }
  Look look(double s, Side side) const {
    const SeenPlace seen = section_.see(s, side);
    const constraints::Place place = seen.at_feed(feed_factor_);
    const double square = constraints_.greatest_square(place);
    const bool by_feed = square == squared(place.feed);
    return {constraints_.row_pairs({seen.jet, infinity}),
            (turns(seen.jet) && !by_feed ? turning_margin : feed_margin) * square, by_feed && seen.speed_varies};
  }

  void place_basis() {
    const std::vector<double>& s = problem_.knots_.s;
    const std::size_t n = problem_.intervals();
    problem_.basis_.reserve(n);
    problem_.places_.reserve(n);
    const auto [first, second, third] = numeric::gauss_3_places;
    for (std::size_t k = 0; k < n; ++k) {
      const CubicBasis& basis = problem_.basis_.emplace_back(around(s, k));
      SpeedProblem::Places& places = problem_.places_.emplace_back();
      std::size_t lane = 0;
      for (const double u : {first, second, third, 1.0}) {
        const Four value = basis.value(u);
        for (std::size_t i = 0; i < 4; ++i) places[i][lane] = value[i];
        ++lane;
      }
    }
    if (problem_.starts_at_rest()) problem_.start_tie_ = rest_tie(problem_.knots_.start_ramp, s[1] - s[0], s[2] - s[1]);
    if (problem_.ends_at_rest())
      problem_.end_tie_ = rest_tie(problem_.knots_.end_ramp, s[n] - s[n - 1], s[n - 1] - s[n - 2]);
  }

  /// Two sites an interval and one more at a break; some more where the curve's derivatives have peaks.
  void reserve() {
    const Knots& knots = problem_.knots_;
    const std::size_t n = problem_.intervals();
    std::size_t sites = 2 * n + static_cast<std::size_t>(std::count(knots.breaks.begin(), knots.breaks.end(), true));
    sites += sites / 4;
    problem_.sites_.reserve(sites);
    const RowPairs first = rows_at(knots.s[0], Side::right), middle = rows_at(knots.s[n / 2], Side::right),
                   last = rows_at(knots.s[n], Side::left);
    std::size_t moving = 0;
    for (std::size_t i = 0; i < RowPairs::size; ++i)
      moving += first.pairs[i].bounds() || middle.pairs[i].bounds() || last.pairs[i].bounds();
    problem_.blocks_.reserve(sites * ((moving + 1) / 2));
  }

  void add_interval(std::size_t k) {
    const Knots& knots = problem_.knots_;
    SquareCaps& caps = problem_.caps_;
    const double begin = knots.s[k], end = knots.s[k + 1], half = (begin + end) / 2;
    const Look middle = look(half, Side::left), right = look(end, Side::left);
    caps.middles[k] = middle.cap;
    caps.knots[k + 1] = right.cap;
    speed_varies_[k] = left_.speed_varies || middle.speed_varies || right.speed_varies;
    if (k > 0 && knots.breaks[k]) add_site(k, 0, left_.rows);
    add_hull(k, {&left_.rows, &middle.rows, &right.rows});
    const double fastest = std::sqrt(std::max({caps.middles[k], caps.knots[k], caps.knots[k + 1]}));
    // Where the curve is made of several polynomials, peaks may lie anywhere.
    const bool peak = is_above(middle.rows, left_.rows, right.rows, fastest);
    const std::size_t borders = std::min(section_.borders(begin, end), most_borders);
    const std::size_t inside = borders > 0 || peak ? std::max<std::size_t>(3, 2 * borders + 1) : 0;
    for (std::size_t i = 1; i <= inside; ++i) {
      const double u = static_cast<double>(i) / static_cast<double>(inside + 1);
      const RowPairs here = 2 * i == inside + 1 ? middle.rows : rows_at(begin + u * (end - begin), Side::left);
      if ((peak && inside == 3) || is_above(here, left_.rows, right.rows, fastest)) add_site(k, u, here);
    }
    add_site(k, 1, right.rows);
    left_ = right;
    if (knots.breaks[k + 1]) {
      left_ = look(end, Side::right);
      const bool goes_on = left_.speed_varies && right.speed_varies &&
                           std::abs(left_.cap - right.cap) <= tuning::rows::same_cap * right.cap;
      cap_steps_[k + 1] = !goes_on;
      caps.knots[k + 1] = std::min(caps.knots[k + 1], left_.cap);
    }
  }

  Site& begin_site(std::size_t interval, const Four& x) {
    pairs_ = 0;
    const auto block = static_cast<std::uint32_t>(problem_.blocks_.size());
    return problem_.sites_.emplace_back(Site{static_cast<std::uint32_t>(interval), block, block, false, -1, x});
  }
  /// A pair of rows more of the site that was begun last: its block, and the lane of A; that of g is the next.
  std::pair<Block&, std::size_t> begin_pair() {
    if (pairs_ % 2 == 0) problem_.blocks_.emplace_back();
    ++problem_.pairs_;
    return {problem_.blocks_.back(), 2 * (pairs_++ % 2)};
  }
  void end_site(Site& site) const { site.end_block = static_cast<std::uint32_t>(problem_.blocks_.size()); }

  void add_site(std::size_t interval, double u, const RowPairs& at) {
    const CubicBasis& basis = problem_.basis_[interval];
    const Four x = basis.value(u), slope = basis.slope(u), bend = basis.bend(u);
    Site& site = begin_site(interval, x);
    if (u == 1) site.place = end_place;
    for (const RowPairs::Pair& pair : at.pairs) {
      if (!pair.bounds()) continue;
      const auto& [acceleration, jerk] = pair;
      const double a = 1 / (limit_margin * acceleration.limit), j = 1 / (limit_margin * jerk.limit);
      const auto [block, lane] = begin_pair();
      for (std::size_t k = 0; k < 4; ++k) {
        block.by[k][lane] = a * (acceleration.by_x * x[k] + acceleration.by_b * slope[k] / 2);
        block.by[k][lane + 1] = j * (jerk.by_x * x[k] + jerk.by_b * slope[k] / 2 + jerk.by_c * bend[k] / 2);
      }
    }
    end_site(site);
  }

  /// Where widths of neighbours differ, the parabola is told less well: jerk is taken a little greater.
  double jerk_factor(std::size_t interval) const {
    const std::vector<double>& s = problem_.knots_.s;
    const double h = problem_.basis_[interval].h;
    double uneven = 0;
    if (interval > 0) uneven = std::max(uneven, std::abs(problem_.basis_[interval - 1].h / h - 1));
    if (interval + 2 < s.size()) uneven = std::max(uneven, std::abs((s[interval + 2] - s[interval + 1]) / h - 1));
    uneven = std::min(uneven, 0.4);
    return uneven > 0.04 ? 1 + 0.04 * uneven * uneven : 1;
  }

  void add_hull(std::size_t interval, const std::array<const RowPairs*, 3>& at) {
    const CubicBasis& basis = problem_.basis_[interval];
    const double of_jerk = jerk_factor(interval);
    const std::array<double, 3> places = {0, 0.5, 1}, parts = {-0.5, 2, -0.5};
    Site& site = begin_site(interval, basis.value(0.5));
    site.hull = true;
    site.place = middle_place;
    for (std::size_t i = 0; i < RowPairs::size; ++i) {
      const auto bounds = [&](const RowPairs* rows) { return rows->pairs[i].bounds(); };
      if (std::none_of(at.begin(), at.end(), bounds)) continue;
      const auto [block, lane] = begin_pair();
      for (std::size_t p = 0; p < 3; ++p) {
        const auto& [acceleration, jerk] = at[p]->pairs[i];
        const double a = 1 / (limit_margin * acceleration.limit), j = of_jerk / (limit_margin * jerk.limit);
        const Four x = basis.value(places[p]), slope = basis.slope(places[p]), bend = basis.bend(places[p]);
        for (std::size_t k = 0; k < 4; ++k) {
          block.by[k][lane] += parts[p] * a * (acceleration.by_x * x[k] + acceleration.by_b * slope[k] / 2);
          block.by[k][lane + 1] +=
              parts[p] * j * (jerk.by_x * x[k] + jerk.by_b * slope[k] / 2 + jerk.by_c * bend[k] / 2);
        }
      }
    }
    end_site(site);
  }

  /// x keeps below caps at knots and in the middles and weaves between. Where they are all one, it is levelled on them; where
  /// a feed varies, what it is above them in between would fail the proof, and the window would be planned again.
  void lower_varying_caps() {
    SquareCaps& caps = problem_.caps_;
    const std::size_t n = problem_.intervals(), first = problem_.starts_at_rest() ? 0 : intervals_begun;
    const auto differ = [](double a, double b) { return std::abs(a - b) > tuning::rows::same_cap * b; };
    bool before = false;
    for (std::size_t k = first; k < n; ++k) {
      const bool here =
          speed_varies_[k] && (differ(caps.knots[k], caps.middles[k]) || differ(caps.knots[k + 1], caps.middles[k]));
      if (here || before) caps.knots[k] *= varying_feed_margin;
      if (here) caps.middles[k] *= varying_feed_margin;
      before = here;
    }
    if (before) caps.knots[n] *= varying_feed_margin;
  }

  /// A coefficient is no greater than the greatest x over the two intervals in the middle of its reach; the spline lies
  /// in the hull of its coefficients. Where the programmed speed falls at a knot, the smaller holds on both sides.
  void cap_coefficients() {
    const std::size_t n = problem_.intervals();
    SquareCaps& caps = problem_.caps_;
    caps.coefficients.assign(n + 3, infinity);
    for (std::size_t i = 0; i < n + 3; ++i) {
      const std::size_t from = i >= 2 ? std::min(i - 2, n - 1) : 0, to = i >= 1 ? std::min(i - 1, n - 1) : 0;
      double greatest = 0;
      bool step = false;
      for (std::size_t k = from; k <= to; ++k) {
        greatest = std::max({greatest, caps.middles[k], caps.knots[k], caps.knots[k + 1]});
        step = step || cap_steps_[k] || cap_steps_[k + 1];
      }
      if (step) {
        for (std::size_t k = from; k <= to; ++k)
          greatest = std::min({greatest, caps.middles[k], caps.knots[k], caps.knots[k + 1]});
      }
      caps.coefficients[i] = greatest;
    }
  }

  SpeedProblem& problem_;
  const Section& section_;
  const constraints::Constraints& constraints_;
  double feed_factor_;
  std::size_t pairs_ = 0;           ///< of rows, of the site that was begun last
  std::vector<bool> speed_varies_;  ///< of each interval: its caps are by a feed that varies
  std::vector<bool> cap_steps_;     ///< at each knot: may the cap be another behind it?
  Look left_;                       ///< at the knot that has been reached, looking on
};

SpeedProblem::SpeedProblem(const Section& section, const constraints::Constraints& constraints, Knots knots,
                           double feed_factor)
    : knots_(std::move(knots)) {
  Builder(*this, section, constraints, feed_factor).build();
  find_creep();
  tie_variables();
}

/// Largest |A| and |g| over coefficients between 0 and a bound are no greater than the rows' sums of magnitudes times
/// it: the bound for which each row alone is kept with a margin.
double SpeedProblem::bound_of_rows(const Site& site) const {
  double bound = infinity;
  double greatest_by_j = 0;
  for (const Block& block : blocks(site)) {
    Lanes by{};
    for (const Lanes& row : block.by) {
      for (std::size_t lane = 0; lane < 4; ++lane) by[lane] += std::abs(row[lane]);
    }
    for (const std::size_t a : {0, 2}) {
      if (by[a] > 0) bound = std::min(bound, 0.3 / by[a]);
      greatest_by_j = std::max(greatest_by_j, by[a + 1]);
    }
  }
  return greatest_by_j > 0 ? std::min(bound, squared(numeric::cbrt(0.3 / greatest_by_j))) : bound;
}

/// At most half of the caps, inside every row, and from coefficient to coefficient no steeper than 1.5.
void SpeedProblem::find_creep() {
  const std::size_t n = intervals();
  std::vector<double>& y = creep_;
  y.assign(n + 3, infinity);
  for (std::size_t i = 0; i < n + 3; ++i) y[i] = 0.5 * caps_.coefficients[i];
  for (const Site& site : sites_) {
    if (site.hull) continue;
    const double bound = bound_of_rows(site);
    for (std::size_t j = 0; j < 4; ++j) y[site.interval + j] = std::min(y[site.interval + j], bound);
  }
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 1; i < n + 3; ++i) y[i] = std::min(y[i], 1.5 * y[i - 1]);
    for (std::size_t i = n + 2; i-- > 0;) y[i] = std::min(y[i], 1.5 * y[i + 1]);
    tie_creep();
  }
}

void SpeedProblem::tie_creep() {
  const std::size_t n = intervals();
  double start = infinity, end = infinity;
  for (std::size_t j = 0; j < 3; ++j) {
    start = std::min(start, creep_[j] / start_tie_[j]);
    end = std::min(end, creep_[n + 2 - j] / end_tie_[j]);
  }
  for (std::size_t j = 0; j < 3; ++j) {
    if (starts_at_rest()) creep_[j] = start * start_tie_[j];
    if (ends_at_rest()) creep_[n + 2 - j] = end * end_tie_[j];
  }
}

void SpeedProblem::tie_variables() {
  const std::size_t n = intervals();
  variable_.assign(n + 3, -1);
  weight_.assign(n + 3, 1.0);
  const std::size_t first = starts_at_rest() ? 2 : 3;  // the first free coefficient, or the last that is tied to it
  const std::size_t last = ends_at_rest() ? n : ends_in_creep() ? n - creep_tail : n + 2;
  for (std::size_t i = starts_at_rest() ? 0 : 3; i < n + 3; ++i) {
    variable_[i] = static_cast<std::int32_t>(std::clamp(i, first, last) - first);
    if (i <= 2) weight_[i] = start_tie_[i];
    if (ends_at_rest() && i >= n) weight_[i] = end_tie_[n + 2 - i];
    if (ends_in_creep() && i >= last) weight_[i] = creep_[i] / creep_[last];
  }
  variable_count_ = last - first + 1;
}

double SpeedProblem::greatest_ratio(const Site& site, std::span<const double> c) const {
  const double* at = &c[site.interval];
  const double x = dot(site.x, at);
  if (!(x > 0)) return infinity;
  double of_a = 0, of_g = 0;
  for (const Block& block : blocks(site)) {
    Lanes y;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      y[lane] = std::abs(block.by[0][lane] * at[0] + block.by[1][lane] * at[1] + block.by[2][lane] * at[2] +
                         block.by[3][lane] * at[3]);
    }
    of_a = std::max({of_a, y[0], y[2]});
    of_g = std::max({of_g, y[1], y[3]});
  }
  return std::max(of_a, of_g * std::sqrt(x));
}

void SpeedProblem::shift(double by) {
  for (double& s : knots_.s) s -= by;
}

void SpeedProblem::settle() {
  places_ = {};
  weight_ = {};
  caps_ = {};
  sites_.shrink_to_fit();
  blocks_.shrink_to_fit();
}

}  // namespace leadscrew::planner
