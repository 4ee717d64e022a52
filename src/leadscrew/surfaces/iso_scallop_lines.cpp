// Passes at a constant ridge: each line is as far from the one before as its own places allow (Suresh and Yang, "Constant
// scallop-height machining"),
//
//     Δφ(r) = g/w        w = √(EG − F²)/|S_r + φ′ S_φ|
//
// with r the parameter along, φ(r) the one across. φ is a uniform B-spline of degree 5,
// so smooth that the tip has its curvature. Steps are added to its coefficients: first each that of its own place (Schoenberg's
// approximation, which does not swing), then times the least of wanted over found along its support, so that no place has more than
// it may.

#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/pass_lines.hpp>
#include <utility>

namespace leadscrew::surfaces {

namespace {

/// The six polynomials of a uniform B-spline of degree 5 on one of its spans, times 120: powers of x, 0 … 1.
constexpr std::array<std::array<double, 6>, 6> uniform_quintics = {{{1, -5, 10, -10, 5, -1},
                                                                    {26, -50, 20, 20, -20, 5},
                                                                    {66, 0, -60, 0, 30, -10},
                                                                    {26, 50, 20, -20, -20, 10},
                                                                    {1, 5, 10, 10, 5, -5},
                                                                    {0, 0, 0, 0, 0, 1}}};

constexpr std::size_t fewest_spans = 32, most_spans = 512;
constexpr std::size_t per_span = 2;  // places where steps are found

class UniformSpline : public AcrossFunction {
 public:
  UniformSpline(const Range& range, std::size_t spans, double value)
      : range_(range), spans_(spans), coefficients_(spans + 5, value) {}

  numeric::Jet<3> at(double place) const override;
  std::vector<double> breaks(double from, double to) const override;
  /// Where the surface has breaks across: crossings of them are breaks too.
  void cross(std::vector<double> across_breaks) { across_breaks_ = std::move(across_breaks); }

  std::size_t spans() const { return spans_; }
  std::vector<double>& coefficients() { return coefficients_; }
  const std::vector<double>& coefficients() const { return coefficients_; }
  double knot(double index) const {
    return range_.from + (range_.to - range_.from) * index / static_cast<double>(spans_);
  }

 private:
  Range range_;
  std::size_t spans_;
  std::vector<double> coefficients_;
  std::vector<double> across_breaks_;
};

numeric::Jet<3> UniformSpline::at(double place) const {
  const double scale = static_cast<double>(spans_) / (range_.to - range_.from);
  const double position = std::clamp((place - range_.from) * scale, 0.0, static_cast<double>(spans_));
  const std::size_t span = std::min(static_cast<std::size_t>(position), spans_ - 1);
  const double x = position - static_cast<double>(span);
  std::array<double, 6> c{};
  for (std::size_t k = 0; k < 6; ++k) {
    for (std::size_t i = 0; i < 6; ++i) c[i] += coefficients_[span + k] * uniform_quintics[k][i] / 120;
  }
  return {c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5])))),
          scale * (c[1] + x * (2 * c[2] + x * (3 * c[3] + x * (4 * c[4] + x * 5 * c[5])))),
          scale * scale * (2 * c[2] + x * (6 * c[3] + x * (12 * c[4] + x * 20 * c[5]))),
          scale * scale * scale * (6 * c[3] + x * (24 * c[4] + x * 60 * c[5]))};
}

std::vector<double> UniformSpline::breaks(double from, double to) const {
  std::vector<double> found;
  const std::size_t parts = 4 * spans_;
  double before = at(range_.from).value;
  for (std::size_t k = 1; k <= parts; ++k) {
    const double high_end = knot(static_cast<double>(k) / 4), after = at(high_end).value;
    // Those c with before < c ≤ after, or the other way round.
    const auto first = std::upper_bound(across_breaks_.begin(), across_breaks_.end(), std::min(before, after));
    for (auto it = first; it != across_breaks_.end() && *it <= std::max(before, after); ++it) {
      const double cut = *it;
      double low = knot(static_cast<double>(k - 1) / 4), high = high_end;
      for (int round = 0; round < 60; ++round) {
        const double middle = (low + high) / 2;
        ((at(middle).value < cut) == (before < cut) ? low : high) = middle;
      }
      found.push_back((low + high) / 2);
    }
    before = after;
  }
  std::erase_if(found, [&](double place) { return !(place > from && place < to); });
  return found;
}

class IsoScallopLines : public PassLines {
 public:
  explicit IsoScallopLines(PassLog& log);
  std::vector<Line> next(PassLog& log) override;

 private:
  double place(std::size_t sample) const { return spline_.knot(static_cast<double>(sample) / per_span); }
  std::vector<StepPlace> steps_on(PassLog& log, const UniformSpline& line) const;
  UniformSpline fitted(const std::vector<double>& wanted) const;
  UniformSpline line_at(const UniformSpline& steps, double share) const;
  bool advance(PassLog& log);
  std::vector<Range> parts_inside() const;
  bool is_inside(double at) const { return (course_.last - spline_.at(at).value) * course_.sign_across() > 0; }

  Course course_;
  UniformSpline spline_;
  std::vector<double> wanted_;    // steps told last, at all samples
  std::vector<StepPlace> there_;  // as in LineSteps
  std::size_t told_ = 0;
  bool is_done_ = false;
};

std::size_t spans_for(const Surface& surface, Direction along) {
  return std::clamp(4 * (surface.breaks(along).size() - 1), fewest_spans, most_spans);
}

IsoScallopLines::IsoScallopLines(PassLog& log)
    : course_(course_of(*log.machining, log.machining->along)),
      spline_(course_.run(), spans_for(*log.machining->surface, course_.along), course_.first) {
  const Surface& surface = *log.machining->surface;
  std::vector<double> across = surface.breaks(course_.along == Direction::u ? Direction::v : Direction::u);
  spline_.cross({across.begin() + 1, across.end() - 1});
}

/// At all samples; beyond the border as at it.
std::vector<StepPlace> IsoScallopLines::steps_on(PassLog& log, const UniformSpline& spline) const {
  const Range width = course_.width();
  const double direction = (course_.from < course_.to) == (told_ % 2 == 1) ? 1 : -1;
  std::vector<StepPlace> steps;
  for (std::size_t k = 0; k <= per_span * spline_.spans(); ++k) {
    numeric::Jet<3> across = spline.at(place(k));
    across.value = std::clamp(across.value, width.from, width.to);
    const LinePlace line = line_place(course_.along, place(k), direction, across);
    const std::optional<Contact> contact = contact_at(log, line);
    if (!contact) return {};
    const bool is_u = course_.along == Direction::u;
    const Vector &by_run = is_u ? contact->jet.u : contact->jet.v, &by_across = is_u ? contact->jet.v : contact->jet.u;
    const double step = step_at(log, *contact, line, numeric::sum(Vector{}, course_.sign_across(), by_across));
    if (log.failure) return {};
    const Frame& frame = contact->frame;
    const double area = std::sqrt(frame.E * frame.G - frame.F * frame.F);
    steps.push_back({step, area / numeric::norm(numeric::sum(by_run, across.first, by_across))});
  }
  return steps;
}

/// A spline that is no more than wanted anywhere.
UniformSpline IsoScallopLines::fitted(const std::vector<double>& wanted) const {
  UniformSpline steps(course_.run(), spline_.spans(), 0);
  std::vector<double>& c = steps.coefficients();
  const auto last = static_cast<std::ptrdiff_t>(wanted.size()) - 1;
  // The coefficient i belongs to the knot i − 2, and reaches three spans to both sides.
  const auto sample_of = [&](std::size_t i) {
    return (static_cast<std::ptrdiff_t>(i) - 2) * static_cast<std::ptrdiff_t>(per_span);
  };
  for (std::size_t i = 0; i < c.size(); ++i) {
    c[i] = wanted[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(sample_of(i), 0, last))];
  }
  std::vector<double> share;
  for (std::size_t k = 0; k < wanted.size(); ++k) share.push_back(wanted[k] / steps.at(place(k)).value);
  for (std::size_t i = 0; i < c.size(); ++i) {
    const std::ptrdiff_t reach = 3 * static_cast<std::ptrdiff_t>(per_span);
    const std::ptrdiff_t from = std::max<std::ptrdiff_t>(sample_of(i) - reach, 0),
                         to = std::min(sample_of(i) + reach, last);
    double least = 1e300;
    for (std::ptrdiff_t k = from; k <= to; ++k) least = std::min(least, share[static_cast<std::size_t>(k)]);
    c[i] *= least;
  }
  return steps;
}

/// The line a share of the steps on.
UniformSpline IsoScallopLines::line_at(const UniformSpline& steps, double share) const {
  UniformSpline line = spline_;
  for (std::size_t i = 0; i < line.coefficients().size(); ++i) {
    line.coefficients()[i] += course_.sign_across() * share * steps.coefficients()[i];
  }
  return line;
}

/// To the next line: the middle and the next one are found from the steps told last, and the steps from them. Where these are
/// nearly the same, the places that they come from move too little to change them.
bool IsoScallopLines::advance(PassLog& log) {
  const std::vector<StepPlace> here = there_.empty() ? steps_on(log, spline_) : std::exchange(there_, {});
  if (log.failure) return false;
  if (wanted_.empty()) {
    for (const StepPlace& place : here) wanted_.push_back(place.step / place.width);
  }
  constexpr double near = 1e-3;
  bool is_near = false;
  for (int round = 0; round < 2 && !is_near; ++round) {
    const UniformSpline step = fitted(wanted_);
    const std::vector<StepPlace> middle = steps_on(log, line_at(step, 0.5));
    std::vector<StepPlace> there = steps_on(log, line_at(step, 1));
    if (log.failure) return false;
    is_near = true;
    for (std::size_t k = 0; k < wanted_.size(); ++k) {
      const double found = step_between(here[k], middle[k], there[k]);
      is_near = is_near && std::abs(found - wanted_[k]) < near * found;
      wanted_[k] = found;
    }
    if (is_near && log.machining->cutter.is_ball()) there_ = std::move(there);
  }
  spline_ = line_at(fitted(wanted_), 1);
  return true;
}

/// Where the line has not run out at the border, ascending.
std::vector<Range> IsoScallopLines::parts_inside() const {
  std::vector<Range> parts;
  const std::size_t count = 2 * per_span * spline_.spans();
  const auto at = [&](std::size_t k) { return spline_.knot(static_cast<double>(k) / (2 * per_span)); };
  bool inside = is_inside(at(0));
  double begin = at(0);
  for (std::size_t k = 1; k <= count; ++k) {
    const bool next = is_inside(at(k));
    if (next == inside) continue;
    double low = at(k - 1), high = at(k);
    for (int round = 0; round < 60; ++round) {
      const double middle = (low + high) / 2;
      (is_inside(middle) == inside ? low : high) = middle;
    }
    if (inside) {
      parts.push_back({begin, low});
    } else {
      begin = high;
    }
    inside = next;
  }
  if (inside) parts.push_back({begin, at(count)});
  const Range run = course_.run();
  std::erase_if(parts, [&](const Range& part) { return part.to - part.from < 1e-4 * (run.to - run.from); });
  return parts;
}

/// The last goes along the border.
std::vector<Line> IsoScallopLines::next(PassLog& log) {
  if (log.failure || is_done_) return {};
  const Range run = course_.run();
  if (told_ == 0) {
    if (are_too_many(log, course_, places_along(*log.machining->surface, course_.along, run, 17))) return {};
  } else if (!advance(log)) {
    return {};
  }
  if (told_ >= 2 * most_passes) {
    log.fail(PassFailure::Kind::too_many, 0, 0, static_cast<double>(told_));
    return {};
  }
  const std::vector<Range> parts = parts_inside();
  const bool rises = (course_.from < course_.to) == (told_ % 2 == 0);
  ++told_;
  if (parts.empty()) {
    is_done_ = true;
    return {{course_.along, rises ? run.from : run.to, rises ? run.to : run.from, course_.last, nullptr}};
  }
  std::vector<Line> lines;
  for (const Range& part : parts) {
    lines.push_back({course_.along, rises ? part.from : part.to, rises ? part.to : part.from, 0, &spline_});
  }
  if (!rises) std::reverse(lines.begin(), lines.end());
  return lines;
}

}  // namespace

std::unique_ptr<PassLines> iso_scallop_lines(PassLog& log) {
  return std::make_unique<IsoScallopLines>(log);
}

}  // namespace leadscrew::surfaces
