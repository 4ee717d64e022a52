#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/gauss.hpp>
#include <leadscrew/planner/speed_problem.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <limits>
#include <optional>
#include <utility>

// How a problem is made: along the knots, once.

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
          const SpeedProblem* before)
      : problem_(problem),
        section_(section),
        constraints_(constraints),
        before_(before && before->feed_factor_ == problem.feed_factor_ ? before : nullptr),
        feed_factor_(problem.feed_factor_) {}

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
    seen_.speed_varies.assign(n, false);
    seen_.steps = problem_.knots_.breaks;
    bool is_taken_over = false;
    for (std::size_t k = 0; k < n; ++k) {
      const std::optional<std::size_t> same = interval_before(k);
      if (same) {
        take_over(k, *same);
      } else {
        if (is_taken_over) left_ = look(s[k], problem_.knots_.breaks[k] ? Side::right : Side::left);
        add_interval(k);
      }
      is_taken_over = same.has_value();
    }
    seen_.knots = problem_.caps_.knots;
    seen_.middles = problem_.caps_.middles;
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

  /// The interval of the problem before that has the same rows: its splines' knots are the same.
  std::optional<std::size_t> interval_before(std::size_t k) {
    if (!before_ || k == 0) return std::nullopt;
    const Knots &knots = problem_.knots_, &known = before_->knots_;
    while (knot_before_ < before_->intervals() && known.s[knot_before_] < knots.s[k]) ++knot_before_;
    const std::size_t same = knot_before_;
    if (same == 0 || same >= before_->intervals() || around(known.s, same) != around(knots.s, k)) return std::nullopt;
    if (known.breaks[same] != knots.breaks[k] || known.breaks[same + 1] != knots.breaks[k + 1]) return std::nullopt;
    return same;
  }
  void take_over(std::size_t k, std::size_t same) {
    const std::vector<Site>& sites = before_->sites_;
    while (site_before_ < sites.size() && sites[site_before_].interval < same) ++site_before_;
    for (; site_before_ < sites.size() && sites[site_before_].interval == same; ++site_before_) {
      Site& site = problem_.sites_.emplace_back(sites[site_before_]);
      const std::span<const Block> rows = before_->blocks(site);
      site.interval = static_cast<std::uint32_t>(k);
      site.first_block = static_cast<std::uint32_t>(problem_.blocks_.size());
      problem_.blocks_.insert(problem_.blocks_.end(), rows.begin(), rows.end());
      site.end_block = static_cast<std::uint32_t>(problem_.blocks_.size());
      problem_.pairs_ += site.pairs;
    }
    const SeenCaps& seen = before_->seen_;
    problem_.caps_.middles[k] = seen.middles[same];
    problem_.caps_.knots[k + 1] = seen.knots[same + 1];
    seen_.speed_varies[k] = seen.speed_varies[same];
    seen_.steps[k + 1] = seen.steps[same + 1];
  }

  void add_interval(std::size_t k) {
    const Knots& knots = problem_.knots_;
    SquareCaps& caps = problem_.caps_;
    const double begin = knots.s[k], end = knots.s[k + 1], half = (begin + end) / 2;
    const Look middle = look(half, Side::left), right = look(end, Side::left);
    caps.middles[k] = middle.cap;
    caps.knots[k + 1] = right.cap;
    seen_.speed_varies[k] = left_.speed_varies || middle.speed_varies || right.speed_varies;
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
      seen_.steps[k + 1] = !goes_on;
      caps.knots[k + 1] = std::min(caps.knots[k + 1], left_.cap);
    }
  }

  Site& begin_site(std::size_t interval, const Four& x) {
    pairs_ = 0;
    const auto block = static_cast<std::uint32_t>(problem_.blocks_.size());
    return problem_.sites_.emplace_back(Site{static_cast<std::uint32_t>(interval), block, block, false, -1, 0, x});
  }
  /// A pair of rows more of the site that was begun last: its block, and the lane of A; that of g is the next.
  std::pair<Block&, std::size_t> begin_pair() {
    if (pairs_ % 2 == 0) problem_.blocks_.emplace_back();
    ++problem_.pairs_;
    return {problem_.blocks_.back(), 2 * (pairs_++ % 2)};
  }
  void end_site(Site& site) const {
    site.end_block = static_cast<std::uint32_t>(problem_.blocks_.size());
    site.pairs = static_cast<std::uint8_t>(pairs_);
  }

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
      const bool here = seen_.speed_varies[k] &&
                        (differ(caps.knots[k], caps.middles[k]) || differ(caps.knots[k + 1], caps.middles[k]));
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
        step = step || seen_.steps[k] || seen_.steps[k + 1];
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
  const SpeedProblem* before_;
  double feed_factor_;
  std::size_t pairs_ = 0;  ///< of rows, of the site that was begun last
  SeenCaps& seen_ = problem_.seen_;
  std::size_t knot_before_ = 0, site_before_ = 0;  ///< that have been reached of the problem before
  Look left_;                                      ///< at the knot that has been reached, looking on
};

SpeedProblem::SpeedProblem(const Section& section, const constraints::Constraints& constraints, Knots knots,
                           double feed_factor, const SpeedProblem* before)
    : knots_(std::move(knots)), feed_factor_(feed_factor) {
  Builder(*this, section, constraints, before).build();
  find_creep();
  tie_variables();
}

}  // namespace leadscrew::planner
