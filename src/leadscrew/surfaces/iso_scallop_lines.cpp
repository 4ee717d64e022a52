// Passes at a constant ridge: each line is as far from the one before as its own places allow (Suresh and Yang, "Constant
// scallop-height machining"),
//
//     Δφ(r) = g/w        w = √(EG − F²)/|S_r + φ′ S_φ|
//
// with r the parameter along, φ(r) the one across. φ is a uniform B-spline of degree 5,
// so smooth that the tip has its curvature. Steps are added to its coefficients: first each that of its own place (Schoenberg's
// approximation, which does not swing), then times the least of wanted over found along its support, so that no place has more than
// it may.
//
// Tools with an edge that lean get a first guess so. Then the line's reach back is held against the last one's reach on
// (reach.hpp), and steps grow by the overlap until no gap is left and little overlap. Their guess is what the last two lines gone the
// same way had, as the lean changes sides with the way. A line may run out at the border only where the pass along the border leaves
// no gap to the last one.

#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/across_spline.hpp>
#include <leadscrew/surfaces/pass_lines.hpp>
#include <leadscrew/surfaces/reach.hpp>
#include <utility>

namespace leadscrew::surfaces {

namespace {

constexpr std::size_t fewest_spans = 32, most_spans = 512;
constexpr std::size_t places_per_span = 2;  // where steps are found, at the least
/// Of reaches: a line may bend as fast as ends of reaches are away from their contacts, or steps found from them do not settle.
constexpr std::size_t reaches_per_span = 4, fewest_reach_spans = 8;
constexpr double shortest_reach_span = 1.0 / 3;  // of the radius about which the edge is round
constexpr int most_step_rounds = 6;
constexpr double border_margin = 1e-3;       // of what is left to the border, where a line must not go beyond it
constexpr double least_overlap_gain = 1e-2;  // of a step, below which a line is not moved once more

class IsoScallopLines : public PassLines {
 public:
  explicit IsoScallopLines(PassLog& log);
  std::vector<Line> next(PassLog& log) override;

 private:
  double place(std::size_t sample) const {
    return spline_.knot(static_cast<double>(sample) / static_cast<double>(per_span_));
  }
  std::vector<StepPlace> steps_on(PassLog& log, const UniformSpline& line) const;
  UniformSpline fitted(const std::vector<double>& wanted) const {
    return spline_below(course_.run(), spline_.spans(), per_span_, wanted);
  }
  UniformSpline line_at(const UniformSpline& steps, double share) const;
  bool advance(PassLog& log);
  bool find_by_rule(PassLog& log);
  std::optional<Reaches> reaches_of(PassLog& log, const UniformSpline& line, double towards) const;
  std::vector<double> at_samples(const UniformSpline& line) const;
  double stretch(const std::vector<double>& step, const std::vector<std::optional<double>>& overlap,
                 const std::vector<double>& limit, std::vector<double>& wanted) const;
  std::optional<UniformSpline> steps_by_reach(PassLog& log);
  const std::optional<Reaches>& border_reaches(PassLog& log, bool rises);
  bool keep_inside(PassLog& log, const Reaches& here, bool rises, const std::vector<double>& left,
                   std::vector<double>& limit);
  bool limit_steps(PassLog& log, const Reaches& here, const std::vector<double>& left, const std::vector<double>& step,
                   std::vector<double>& limit);
  std::vector<Range> parts_inside() const;
  bool is_inside(double at, AcrossFunction::Memo& memo) const {
    return (course_.last - spline_.at_near(at, memo).value) * course_.sign_across() > 0;
  }

  Course course_;
  UniformSpline spline_;
  std::size_t per_span_;
  std::vector<double> wanted_;  // steps told last, at all samples
  /// Of lines that are gone the same way, by reaches: the last, and the one before.
  struct Told {
    std::vector<double> last, before;
  };
  std::array<Told, 2> by_reach_;  // gone up and down, as it comes
  std::array<std::optional<Reaches>, 2>
      border_;                    // gone down and up, back from the last border, once they are asked for
  std::vector<StepPlace> there_;  // as in LineSteps
  std::size_t told_ = 0;
  bool is_done_ = false;
};

std::size_t spans_of_surface(const Surface& surface, Direction along) {
  return std::clamp(4 * (surface.breaks(along).size() - 1), fewest_spans, most_spans);
}

/// Of the shortest of three lines, mm.
double length_along(const Surface& surface, const Course& course) {
  double least = 1e300;
  for (const double across : {course.first, (course.first + course.last) / 2, course.last}) {
    double length = 0;
    std::optional<Vector> before;
    for (const double place : places_along(surface, course.along, course.run(), 17)) {
      const Vector at = course.along == Direction::u ? surface.at(place, across) : surface.at(across, place);
      if (before) length += numeric::distance(*before, at);
      before = at;
    }
    least = std::min(least, length);
  }
  return least;
}

std::size_t spans_for(const Machining& machining, const Course& course) {
  const std::size_t spans = spans_of_surface(*machining.surface, course.along);
  if (!has_reach(machining)) return spans;
  const double shortest = shortest_reach_span * (machining.cutter.radius - machining.cutter.corner_radius);
  const double fit = length_along(*machining.surface, course) / shortest;
  return fit < static_cast<double>(spans) ? std::max(fewest_reach_spans, static_cast<std::size_t>(fit)) : spans;
}

IsoScallopLines::IsoScallopLines(PassLog& log)
    : course_(course_of(*log.machining, log.machining->along)),
      spline_(course_.run(), spans_for(*log.machining, course_), course_.first),
      per_span_(places_per_span) {
  const Surface& surface = *log.machining->surface;
  if (has_reach(*log.machining)) {
    const std::size_t places = places_per_span * spans_of_surface(surface, course_.along), spans = spline_.spans();
    per_span_ = std::max(reaches_per_span, (places + spans - 1) / spans);
  }
  std::vector<double> across = surface.breaks(course_.along == Direction::u ? Direction::v : Direction::u);
  spline_.cross({across.begin() + 1, across.end() - 1});
}

/// At all samples; beyond the border as at it.
std::vector<StepPlace> IsoScallopLines::steps_on(PassLog& log, const UniformSpline& spline) const {
  const Range width = course_.width();
  const double direction = (course_.from < course_.to) == (told_ % 2 == 1) ? 1 : -1;
  std::vector<StepPlace> steps;
  AcrossFunction::Memo memo;
  for (std::size_t k = 0; k <= per_span_ * spline_.spans(); ++k) {
    numeric::Jet<3> across = spline.at_near(place(k), memo);
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

/// The line a share of the steps on.
UniformSpline IsoScallopLines::line_at(const UniformSpline& steps, double share) const {
  UniformSpline line = spline_;
  for (std::size_t i = 0; i < line.coefficients().size(); ++i) {
    line.coefficients()[i] += course_.sign_across() * share * steps.coefficients()[i];
  }
  return line;
}

/// Steps to the next line: the middle and the next one are found from the steps told last, and the steps from them. Where these are
/// nearly the same, the places that they come from move too little to change them.
bool IsoScallopLines::find_by_rule(PassLog& log) {
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
  return true;
}

/// At all samples inside the border. Of the next line, towards the last one, or of the last towards the next.
std::optional<Reaches> IsoScallopLines::reaches_of(PassLog& log, const UniformSpline& spline, double towards) const {
  const Range width = course_.width();
  const bool rises = (course_.from < course_.to) == (told_ % 2 == 1), is_next = towards != course_.sign_across();
  std::vector<std::optional<LinePlace>> places;
  AcrossFunction::Memo memo;
  for (std::size_t k = 0; k <= per_span_ * spline_.spans(); ++k) {
    const numeric::Jet<3> across = spline.at_near(place(k), memo);
    places.emplace_back();
    if (across.value < width.from || across.value > width.to) continue;
    places.back() = line_place(course_.along, place(k), rises != is_next ? 1 : -1, across);
  }
  return reaches_along(log, course_.along, places, towards);
}

std::vector<double> IsoScallopLines::at_samples(const UniformSpline& line) const {
  std::vector<double> values;
  AcrossFunction::Memo memo;
  for (std::size_t k = 0; k <= per_span_ * line.spans(); ++k) values.push_back(line.at_near(place(k), memo).value);
  return values;
}

/// Steps with the overlap added; where that is not known, in the same ratio as at the nearest sample where it is. Returns by how
/// much they change, of themselves, at the most.
double IsoScallopLines::stretch(const std::vector<double>& step, const std::vector<std::optional<double>>& overlap,
                                const std::vector<double>& limit, std::vector<double>& wanted) const {
  std::vector<std::size_t> known;
  for (std::size_t k = 0; k < overlap.size(); ++k) {
    if (overlap[k]) known.push_back(k);
  }
  double most = 0;
  std::size_t nearest = 0;  // of those known
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const auto is_nearer = [&](std::size_t a, std::size_t b) {
      return (a > k ? a - k : k - a) <= (b > k ? b - k : k - b);
    };
    while (nearest + 1 < known.size() && is_nearer(known[nearest + 1], known[nearest])) ++nearest;
    double ratio = 1;
    if (!known.empty()) {
      const std::size_t at = known[nearest];
      ratio = std::clamp(1 + *overlap[at] / step[at], 0.25, 4.0);
    }
    const double found = std::min(step[k] * ratio, limit[k]);
    most = std::max(most, std::abs(found / wanted[k] - 1));
    wanted[k] = found;
  }
  return most;
}

const std::optional<Reaches>& IsoScallopLines::border_reaches(PassLog& log, bool rises) {
  std::optional<Reaches>& reaches = border_[rises ? 1 : 0];
  if (!reaches) {
    std::vector<std::optional<LinePlace>> places;
    for (std::size_t k = 0; k <= per_span_ * spline_.spans(); ++k) {
      places.emplace_back(line_place(course_.along, place(k), rises ? 1 : -1, course_.last));
    }
    reaches = reaches_along(log, course_.along, places, -course_.sign_across());
  }
  return reaches;
}

/// Steps are limited to end short of the border where the line along it, gone this way, leaves a gap to this line's reaches: there the
/// next line must be between. left: to the border. Returns whether that is so anywhere.
bool IsoScallopLines::keep_inside(PassLog& log, const Reaches& here, bool rises, const std::vector<double>& left,
                                  std::vector<double>& limit) {
  const std::optional<Reaches>& border = border_reaches(log, rises);
  if (!border) return false;
  const bool is_u = course_.along == Direction::u;
  const std::vector<std::optional<double>> overlap = overlaps(course_.along, here, *border, course_.sign_across());
  bool is_needed = false;
  for (std::size_t k = 0; k < overlap.size(); ++k) {
    if (!here[k] || !overlap[k] || *overlap[k] >= -widest_gap * left[k]) continue;
    is_needed = true;
    // Reaches end ahead of their contacts or behind: the next line must go on until its own is there.
    const double ahead = 2 * std::abs((is_u ? (*border)[k]->u : (*border)[k]->v) - place(k));
    const auto more = 1 + static_cast<std::size_t>(ahead / (place(1) - place(0)));
    for (std::size_t i = k - std::min(k, more); i <= std::min(k + more, limit.size() - 1); ++i) {
      if (left[i] > 0) limit[i] = (1 - border_margin) * left[i];
    }
  }
  return is_needed;
}

/// Where the next line lies beyond the border, the one along the border is this line's neighbour: either the next, which comes back, or
/// one after some that are cut by the border. Returns whether steps are longer than the limit is now.
bool IsoScallopLines::limit_steps(PassLog& log, const Reaches& here, const std::vector<double>& left,
                                  const std::vector<double>& step, std::vector<double>& limit) {
  std::size_t beyond = 0;
  for (std::size_t k = 0; k < step.size(); ++k) beyond += step[k] > left[k] ? 1 : 0;
  if (beyond == 0) return false;
  const bool rises = (course_.from < course_.to) == (told_ % 2 == 1);
  if (!keep_inside(log, here, !rises, left, limit) && beyond == step.size()) return false;
  keep_inside(log, here, rises, left, limit);
  for (std::size_t k = 0; k < step.size(); ++k) {
    if (step[k] > limit[k]) return true;
  }
  return false;
}

/// None where a place has no reach.
std::optional<UniformSpline> IsoScallopLines::steps_by_reach(PassLog& log) {
  const std::optional<Reaches> here = reaches_of(log, spline_, course_.sign_across());
  if (!here) return std::nullopt;
  Told& told = by_reach_[told_ % 2];
  std::vector<double> wanted = told.last.empty() ? wanted_ : told.last, limit(wanted.size(), 1e300);
  for (std::size_t k = 0; k < told.before.size(); ++k) {
    wanted[k] *= std::clamp(wanted[k] / told.before[k], 0.8, 1.25);
  }
  std::vector<double> left = at_samples(spline_);
  for (double& across : left) across = (course_.last - across) * course_.sign_across();
  std::optional<UniformSpline> taken;
  for (int round = 0; round < most_step_rounds && !taken; ++round) {
    const UniformSpline tried = fitted(wanted);
    const std::vector<double> step = at_samples(tried);
    const std::optional<Reaches> there = reaches_of(log, line_at(tried, 1), -course_.sign_across());
    if (!there) return std::nullopt;
    const std::vector<std::optional<double>> overlap = overlaps(course_.along, *here, *there, course_.sign_across());
    bool has_gap = false;
    for (std::size_t k = 0; k < overlap.size(); ++k) {
      has_gap = has_gap || (overlap[k] && *overlap[k] < -widest_gap * step[k]);
    }
    const bool is_over = limit_steps(log, *here, left, step, limit);
    if (stretch(step, overlap, limit, wanted) < least_overlap_gain && !has_gap && !is_over) taken = tried;
  }
  if (!taken) taken = fitted(wanted);
  told.before = std::exchange(told.last, wanted);
  return taken;
}

bool IsoScallopLines::advance(PassLog& log) {
  const bool is_known = !by_reach_[told_ % 2].last.empty();
  if (!is_known && !find_by_rule(log)) return false;
  std::optional<UniformSpline> steps;
  if (has_reach(*log.machining)) steps = steps_by_reach(log);
  if (!steps && !log.failure) {
    if (is_known && !find_by_rule(log)) return false;
    steps = fitted(wanted_);
  }
  if (log.failure) return false;
  spline_ = line_at(*steps, 1);
  return true;
}

/// Where the line has not run out at the border, ascending.
std::vector<Range> IsoScallopLines::parts_inside() const {
  std::vector<Range> parts;
  const std::size_t count = 2 * per_span_ * spline_.spans();
  const auto at = [&](std::size_t k) {
    return spline_.knot(static_cast<double>(k) / (2 * static_cast<double>(per_span_)));
  };
  AcrossFunction::Memo memo;
  bool inside = is_inside(at(0), memo);
  double begin = at(0);
  for (std::size_t k = 1; k <= count; ++k) {
    const bool next = is_inside(at(k), memo);
    if (next == inside) continue;
    double low = at(k - 1), high = at(k);
    for (int round = 0; round < 60; ++round) {
      const double middle = (low + high) / 2;
      (is_inside(middle, memo) == inside ? low : high) = middle;
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
  const auto spline = std::make_shared<const UniformSpline>(spline_);
  std::vector<Line> lines;
  for (const Range& part : parts) {
    lines.push_back({course_.along, rises ? part.from : part.to, rises ? part.to : part.from, 0, spline});
  }
  if (!rises) std::reverse(lines.begin(), lines.end());
  return lines;
}

}  // namespace

std::unique_ptr<PassLines> iso_scallop_lines(PassLog& log) {
  return std::make_unique<IsoScallopLines>(log);
}

}  // namespace leadscrew::surfaces
