#include <algorithm>
#include <cmath>
#include <leadscrew/toolpath/knot_removal.hpp>
#include <leadscrew/toolpath/tuning.hpp>

namespace leadscrew::toolpath {

namespace {

using namespace tuning::knot_removal;
using Place = Vector<3>;

/// Position and derivatives at a place, the third constant from there on.
struct PlaceJet {
  Place value{}, first{}, second{};

  void advance(double t, const Place& third) {
    for (std::size_t i = 0; i < 3; ++i) {
      value[i] += t * (first[i] + t / 2 * (second[i] + t / 3 * third[i]));
      first[i] += t * (second[i] + t / 2 * third[i]);
      second[i] += t * third[i];
    }
  }
};

PlaceJet difference(const PlaceJet& a, const PlaceJet& b) {
  return {between(b.value, a.value), between(b.first, a.first), between(b.second, a.second)};
}

class KnotRemoval {
 public:
  KnotRemoval(const TimeSpline<3>& motion, std::size_t first, std::size_t last, const Nearness& near)
      : motion_(motion), first_(first), near_(near), is_fixed_(last - first, false) {
    // With two intervals as they are at each end, position and two derivatives there are the motion's.
    for (std::size_t k = 0; k < std::min<std::size_t>(2, is_fixed_.size()); ++k)
      is_fixed_[k] = is_fixed_[is_fixed_.size() - 1 - k] = true;
  }

  SparseSpline spline() {
    for (int round = 0;; ++round) {
      if (round == most_rounds) is_fixed_.assign(is_fixed_.size(), true);
      merge();
      SparseSpline sparse = interpolant();
      if (!keep_where_off(sparse)) return sparse;
    }
  }

 private:
  std::size_t intervals() const { return is_fixed_.size(); }
  Place point(std::size_t k) const { return motion_.points[first_ + k]; }
  Place third(std::size_t k) const {
    Place d;
    for (std::size_t i = 0; i < 3; ++i)
      d[i] = (point(k + 3)[i] - point(k)[i]) - 3 * (point(k + 2)[i] - point(k + 1)[i]);
    return d;
  }
  PlaceJet jet(std::size_t k) const {
    const Place a = point(k), b = point(k + 1), c = point(k + 2);
    PlaceJet jet;
    for (std::size_t i = 0; i < 3; ++i) {
      jet.second[i] = (c[i] - b[i]) - (b[i] - a[i]);
      jet.first[i] = (c[i] - a[i]) / 2;
      jet.value[i] = b[i] + jet.second[i] / 6;
    }
    return jet;
  }

  /// Is the third derivative nearly the same in intervals [begin, end)?
  bool is_even(std::size_t begin, std::size_t end) const {
    Place least = third(begin), most = least;
    for (std::size_t k = begin; k < end; ++k) {
      if (is_fixed_[k]) return false;
      const Place d = third(k);
      for (std::size_t i = 0; i < 3; ++i) least[i] = std::min(least[i], d[i]), most[i] = std::max(most[i], d[i]);
    }
    const double span = static_cast<double>(end - begin);
    for (std::size_t i = 0; i < 3; ++i) {
      const double change = most[i] - least[i];
      if (change > near_.jerk_step[i] || change * span * span * span > bulges * near_.tolerance) return false;
    }
    return true;
  }

  /// Pairs of equal spans become one, level by level, where none beside them is shorter than either.
  void merge() {
    spans_.assign(intervals(), 1);
    for (std::size_t span = 2; span <= near_.longest_span; span *= 2) {
      std::vector<std::size_t> merged = spans_;
      for (std::size_t k = 0; k + span <= intervals(); k += span) {
        const std::size_t half = span / 2;
        if (spans_[k] != half || spans_[k + half] != half) continue;
        if (k > 0 && spans_[k - 1] < half) continue;
        if (k + span < intervals() && spans_[k + span] < half) continue;
        if (is_even(k, k + span)) std::fill_n(merged.begin() + static_cast<std::ptrdiff_t>(k), span, span);
      }
      spans_ = merged;
    }
  }

  /// The quasi-interpolant of de Boor and Fix: of position and two derivatives at each knot. But for rounding it is the motion
  /// itself where no knot is missing.
  SparseSpline interpolant() const {
    const double begin = static_cast<double>(first_);
    SparseSpline sparse;
    sparse.knots = {begin - 1};
    for (std::size_t k = 0; k < intervals(); k += spans_[k]) sparse.knots.push_back(begin + static_cast<double>(k));
    const double end = begin + static_cast<double>(intervals());
    sparse.knots.push_back(end);
    sparse.knots.push_back(end + 1);
    sparse.points.push_back(point(0));
    for (std::size_t j = 1; j + 1 < sparse.knots.size(); ++j) {
      const double before = sparse.knots[j] - sparse.knots[j - 1], behind = sparse.knots[j + 1] - sparse.knots[j];
      const PlaceJet at = jet(static_cast<std::size_t>(sparse.knots[j] - begin));
      Place c = at.value;
      for (std::size_t i = 0; i < 3; ++i)
        c[i] += (behind - before) / 3 * at.first[i] - before * behind / 6 * at.second[i];
      sparse.points.push_back(c);
    }
    sparse.points.push_back(point(intervals() + 2));
    return sparse;
  }

  /// Position and two derivatives at each knot but the first and the last.
  static std::vector<PlaceJet> jets_of(const SparseSpline& sparse) {
    const std::vector<double>& t = sparse.knots;
    const std::size_t n = t.size();
    const auto knot = [&](std::ptrdiff_t j) {  // beyond both ends they go on by one
      if (j < 0) return t[0] + static_cast<double>(j);
      const auto k = static_cast<std::size_t>(j);
      return k < n ? t[k] : t[n - 1] + static_cast<double>(k - (n - 1));
    };
    std::vector<Place> slopes(n - 1);  // of the first derivative, as a spline
    for (std::size_t j = 0; j + 1 < n; ++j) {
      const auto k = static_cast<std::ptrdiff_t>(j);
      const double width = knot(k + 2) - knot(k - 1);
      for (std::size_t i = 0; i < 3; ++i) slopes[j][i] = 3 * (sparse.points[j + 1][i] - sparse.points[j][i]) / width;
    }
    std::vector<PlaceJet> jets(n);
    for (std::size_t j = 1; j + 1 < n; ++j) {
      const double before = t[j] - t[j - 1], behind = t[j + 1] - t[j];
      PlaceJet& jet = jets[j];
      for (std::size_t i = 0; i < 3; ++i) {
        jet.second[i] = 2 * (slopes[j][i] - slopes[j - 1][i]) / (before + behind);
        jet.first[i] = (slopes[j - 1][i] * behind + slopes[j][i] * before) / (before + behind);
        jet.value[i] = sparse.points[j][i] - (behind - before) / 3 * jet.first[i] + before * behind / 6 * jet.second[i];
      }
    }
    return jets;
  }

  /// Where the spline is farther from the motion than it may be, knots stay; is there such a place where they did not yet?
  bool keep_where_off(const SparseSpline& sparse) {
    const std::vector<PlaceJet> jets = jets_of(sparse);
    bool is_off = false;
    const std::vector<std::size_t> spans = spans_;
    for (std::size_t j = 1; j + 2 < sparse.knots.size(); ++j) {
      const auto begin = static_cast<std::size_t>(sparse.knots[j] - sparse.knots[1]);
      const std::size_t span = spans[begin];
      Place slope;
      for (std::size_t i = 0; i < 3; ++i)
        slope[i] = (jets[j + 1].second[i] - jets[j].second[i]) / static_cast<double>(span);
      PlaceJet off = difference(jets[j], jet(begin));
      bool is_near = true;
      for (std::size_t k = begin; k < begin + span; ++k) {
        const Place step = between(third(k), slope);
        for (std::size_t i = 0; i < 3; ++i)
          is_near = is_near && std::abs(step[i]) <= near_.jerk_step[i] * (1 + 1e-6) + 1e-13;
        for (const double part : {0.5, 0.5}) {
          off.advance(part, step);
          is_near = is_near && size(off.value) <= near_.tolerance;
        }
      }
      if (is_near) continue;
      const std::size_t from = begin - std::min(begin, spans[begin > 0 ? begin - 1 : 0]),
                        to = begin + span < intervals() ? begin + span + spans[begin + span] : intervals();
      for (std::size_t k = from; k < to; ++k) {
        is_off = is_off || !is_fixed_[k];
        is_fixed_[k] = true;
      }
    }
    return is_off;
  }

  const TimeSpline<3>& motion_;
  std::size_t first_;
  Nearness near_;
  std::vector<bool> is_fixed_;      ///< of intervals: they are not merged
  std::vector<std::size_t> spans_;  ///< of each interval: how many are one with it
};

}  // namespace

SparseSpline without_needless_knots(const TimeSpline<3>& motion, std::size_t first, std::size_t last,
                                    const Nearness& near) {
  return KnotRemoval(motion, first, last, near).spline();
}

}  // namespace leadscrew::toolpath
