// Passes in parallel vertical planes: the lines of the surface on which one coordinate, z, is constant,
//
//     z(r, φ(r)) = c        φ′ = −z_r/z_φ, and so on
//
// with r the parameter along and φ the one across, along which z rises or falls throughout. On the surface two lines lie
// dc/√(1 − n_z²) apart.

#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/pass_lines.hpp>
#include <memory>
#include <utility>
#include <vector>

namespace leadscrew::surfaces {

namespace {

constexpr std::size_t least_section_places = 33;
constexpr double least_border_sine = 0.98;

/// One coordinate of a surface with its derivatives by r and φ.
struct Level {
  double z = 0, r = 0, f = 0, rr = 0, rf = 0, ff = 0, rrr = 0, rrf = 0, rff = 0, fff = 0;
};
Level level_of(const SurfaceJet& jet, Direction along, std::size_t k) {
  if (along == Direction::u) {
    return {jet.s[k],  jet.u[k],   jet.v[k],   jet.uu[k],  jet.uv[k],
            jet.vv[k], jet.uuu[k], jet.uuv[k], jet.uvv[k], jet.vvv[k]};
  }
  return {jet.s[k],  jet.v[k],   jet.u[k],   jet.vv[k],  jet.uv[k],
          jet.uu[k], jet.vvv[k], jet.uvv[k], jet.uuv[k], jet.uuu[k]};
}

/// The function φ of one plane.
class Section : public AcrossFunction {
 public:
  Section(std::shared_ptr<const Surface> surface, Direction along, std::size_t coordinate, const Range& width,
          double level, std::shared_ptr<const std::vector<double>> places)
      : surface_(std::move(surface)),
        along_(along),
        coordinate_(coordinate),
        width_(width),
        level_(level),
        places_(std::move(places)) {}

  numeric::Jet<3> at(double place) const override;
  std::vector<double> breaks(double from, double to) const override;
  std::size_t bytes() const override { return sizeof *this; }
  /// Where the plane meets the range, ascending.
  std::vector<Range> parts() const;
  bool meets(double place) const { return off(place, width_.from) * off(place, width_.to) <= 0; }
  double across(double place) const;
  /// Of the border from the plane.
  double distance(double place) const {
    return std::min(std::abs(off(place, width_.from)), std::abs(off(place, width_.to)));
  }

 private:
  double off(double place, double across) const {
    const Vector s = along_ == Direction::u ? surface_->at(place, across) : surface_->at(across, place);
    return s[coordinate_] - level_;
  }

  std::shared_ptr<const Surface> surface_;
  Direction along_;
  std::size_t coordinate_;
  Range width_;
  double level_;
  std::shared_ptr<const std::vector<double>> places_;  ///< by all sections of a pattern
};

/// Newton's method kept between two places of opposite sides.
double Section::across(double place) const {
  double low = width_.from, high = width_.to;
  const double at_low = off(place, low), at_high = off(place, high);
  if (at_low * at_high > 0) return std::abs(at_low) < std::abs(at_high) ? low : high;
  const double rises = at_low < at_high ? 1 : -1;
  double found = low + (high - low) * at_low / (at_low - at_high);
  if (!(found >= low && found <= high)) found = (low + high) / 2;
  for (int round = 0; round < 60; ++round) {
    const LinePlace at = line_place(along_, place, 1, found);
    const Level level = level_of(surface_->jet(at.u.value, at.v.value), along_, coordinate_);
    const double off_level = level.z - level_;
    (off_level * rises < 0 ? low : high) = found;
    const double next = found - off_level / level.f;
    const double previous = found;
    found = next > low && next < high ? next : (low + high) / 2;
    if (std::abs(next - previous) <= 1e-15 * (width_.to - width_.from) || high - low <= 0) {
      found = std::clamp(next, width_.from, width_.to);
      break;
    }
  }
  return found;
}

numeric::Jet<3> Section::at(double place) const {
  const double f = across(place);
  const LinePlace at = line_place(along_, place, 1, f);
  const Level z = level_of(surface_->jet(at.u.value, at.v.value), along_, coordinate_);
  const double first = -z.r / z.f;
  const double second = -(z.rr + 2 * z.rf * first + z.ff * first * first) / z.f;
  const double third = -(z.rrr + 3 * z.rrf * first + 3 * z.rff * first * first + z.fff * first * first * first +
                         3 * (z.rf + z.ff * first) * second) /
                       z.f;
  return {f, first, second, third};
}

/// Crossings of the surface's own breaks, between the places that are looked at.
std::vector<double> Section::breaks(double from, double to) const {
  const std::vector<double>& across_breaks = surface_->breaks(along_ == Direction::u ? Direction::v : Direction::u);
  std::vector<double> found;
  if (across_breaks.size() < 3) return found;
  std::vector<double> places = {from};
  for (const double place : *places_) {
    if (place > from && place < to) places.push_back(place);
  }
  places.push_back(to);
  double before = across(from);
  for (std::size_t k = 1; k < places.size(); ++k) {
    const double after = across(places[k]);
    // Those c with before < c ≤ after, or the other way round.
    const auto first = std::upper_bound(across_breaks.begin(), across_breaks.end(), std::min(before, after));
    for (auto it = first; it != across_breaks.end() && *it <= std::max(before, after); ++it) {
      const double cut = *it;
      double low = places[k - 1], high = places[k];
      for (int round = 0; round < 60; ++round) {
        const double middle = (low + high) / 2;
        ((across(middle) < cut) == (before < cut) ? low : high) = middle;
      }
      found.push_back((low + high) / 2);
    }
    before = after;
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Range> Section::parts() const {
  const double least = least_section_gap * (places_->back() - places_->front());
  std::vector<Range> parts;
  bool inside = meets(places_->front());
  double begin = places_->front();
  for (std::size_t k = 1; k < places_->size(); ++k) {
    const bool next = meets((*places_)[k]);
    if (next == inside) continue;
    double low = (*places_)[k - 1], high = (*places_)[k];
    for (int round = 0; round < 60; ++round) {
      const double middle = (low + high) / 2;
      (meets(middle) == inside ? low : high) = middle;
    }
    if (inside) {
      parts.push_back({begin, low});
    } else if (!parts.empty() && high - parts.back().to < least) {
      begin = parts.back().from;
      parts.pop_back();
    } else {
      begin = high;
    }
    inside = next;
  }
  if (inside) parts.push_back({begin, places_->back()});
  std::erase_if(parts, [&](const Range& part) { return part.to - part.from < least; });
  return parts;
}

class PlanarLines : public PassLines {
 public:
  explicit PlanarLines(PassLog& log);
  std::vector<Line> next(PassLog& log) override;

 private:
  void find_parameters(PassLog& log);
  StepPlace step_of(PassLog& log, const Section& section, double place) const;
  double step_to(PassLog& log, double level, double next) const;
  bool is_too_many(PassLog& log);
  bool advance(PassLog& log);
  void find_borders(const Surface& surface);
  double sine_at_border(const Surface& surface, double run) const;
  Section section(const std::shared_ptr<const Surface>& surface, double level) const {
    return {surface, course_.along, coordinate_, course_.width(), level, places_};
  }

  Course course_;
  std::size_t coordinate_ = 1;
  std::shared_ptr<const std::vector<double>> places_;
  double from_ = 0, to_ = 0, at_ = 0, step_ = 0;  // levels
  bool begins_at_border_ = false, ends_at_border_ = false;
  std::vector<Line> borders_;  // still to be gone along, the next at the end
  std::size_t told_ = 0;
  std::shared_ptr<const Section> section_;
};

PlanarLines::PlanarLines(PassLog& log) : coordinate_(log.machining->along == Direction::u ? 1 : 0) {
  find_parameters(log);
}

/// Which parameter goes along: across it the coordinate must rise or fall everywhere. Levels from least to greatest, from the start
/// corner's side on; whether the border lies in the plane there.
void PlanarLines::find_parameters(PassLog& log) {
  const Machining& machining = *log.machining;
  const Surface& surface = *machining.surface;
  const std::vector<double> us = places_along(surface, Direction::u, machining.u, least_section_places),
                            vs = places_along(surface, Direction::v, machining.v, least_section_places);
  Range by_u = {1e300, -1e300}, by_v = by_u, level = by_u;
  const auto widen = [](Range& range, double x) { range = {std::min(range.from, x), std::max(range.to, x)}; };
  for (const double u : us) {
    for (const double v : vs) {
      const SurfaceJet jet = surface.jet(u, v);
      widen(by_u, jet.u[coordinate_] / numeric::norm(jet.u));
      widen(by_v, jet.v[coordinate_] / numeric::norm(jet.v));
      widen(level, jet.s[coordinate_]);
    }
  }
  const auto steepness = [](const Range& range) { return std::max(range.from, -range.to); };
  const bool runs_along_u = steepness(by_v) >= steepness(by_u);
  if (!(std::max(steepness(by_u), steepness(by_v)) > 1e-3)) {
    log.fail(PassFailure::Kind::section, machining.u.from, machining.v.from);
    return;
  }
  course_ = course_of(machining, runs_along_u ? Direction::u : Direction::v);
  places_ = std::make_shared<const std::vector<double>>(
      section_places(surface, course_, coordinate_, runs_along_u ? us : vs));
  const auto border = [&](double across) {
    Range range = {1e300, -1e300};
    for (const double place : *places_) {
      widen(range, (runs_along_u ? surface.at(place, across) : surface.at(across, place))[coordinate_]);
    }
    return range;
  };
  const Range first = border(course_.first), last = border(course_.last);
  const bool rises = first.from + first.to < last.from + last.to;
  from_ = rises ? level.from : level.to;
  to_ = rises ? level.to : level.from;
  const double flat = 1e-9 * (level.to - level.from);
  begins_at_border_ = first.to - first.from <= flat;
  ends_at_border_ = last.to - last.from <= flat;
  if (begins_at_border_) from_ = (first.from + first.to) / 2;
  if (ends_at_border_) to_ = (last.from + last.to) / 2;
  find_borders(surface);
}

/// The least sine of the angle at which planes meet the border at one end of the parameter along.
double PlanarLines::sine_at_border(const Surface& surface, double run) const {
  const Range width = course_.width();
  double least = 1;
  for (std::size_t k = 0; k < least_section_places; ++k) {
    const double across = width.from + (width.to - width.from) * static_cast<double>(k) / (least_section_places - 1);
    const LinePlace place = line_place(course_.along, run, 1, across);
    const SurfaceJet jet = surface.jet(place.u.value, place.v.value);
    const std::optional<Frame> frame = frame_of(jet, 1);
    if (!frame) continue;
    const Vector& tangent = course_.along == Direction::u ? jet.v : jet.u;
    const double n = frame->n[coordinate_];
    least = std::min(least, std::abs(tangent[coordinate_]) / (numeric::norm(tangent) * std::sqrt(1 - n * n)));
  }
  return least;
}

/// Where planes meet the border at a sharp angle, places at it are farther than half a step from all of them: a pass goes along it.
void PlanarLines::find_borders(const Surface& surface) {
  const Direction across = course_.along == Direction::u ? Direction::v : Direction::u;
  if (!begins_at_border_) borders_.push_back({course_.along, course_.to, course_.from, course_.first, nullptr});
  if (sine_at_border(surface, course_.to) < least_border_sine) {
    borders_.push_back({across, course_.last, course_.first, course_.to, nullptr});
  }
  if (!ends_at_border_) borders_.push_back({course_.along, course_.from, course_.to, course_.last, nullptr});
  if (sine_at_border(surface, course_.from) < least_border_sine) {
    borders_.push_back({across, course_.first, course_.last, course_.from, nullptr});
  }
}

/// Where a section is at a place along, or where the border is nearest to it.
StepPlace PlanarLines::step_of(PassLog& log, const Section& section, double place) const {
  const double direction = (course_.from < course_.to) == (told_ % 2 == 1) ? 1 : -1;
  const numeric::Jet<3> across = section.meets(place) ? section.at(place) : numeric::Jet<3>(section.across(place));
  const LinePlace line = line_place(course_.along, place, direction, across);
  const std::optional<Contact> contact = contact_at(log, line);
  if (!contact) return {};
  Vector towards{};
  towards[coordinate_] = to_ > from_ ? 1 : -1;
  const double step = step_at(log, *contact, line, towards), n = contact->frame.n[coordinate_];
  return {step, 1 / std::sqrt(std::max(1 - n * n, 1e-12))};
}

/// The least along the section in the middle between two levels; where that meets nothing, at the place nearest to it.
double PlanarLines::step_to(PassLog& log, double level, double next) const {
  const std::shared_ptr<const Surface>& surface = log.machining->surface;
  const Section here = section(surface, level), at = section(surface, (level + next) / 2),
                there = section(surface, next);
  std::vector<double> places, steps;
  std::copy_if(places_->begin(), places_->end(), std::back_inserter(places),
               [&](double place) { return at.meets(place); });
  if (places.empty()) {
    places.push_back(*std::min_element(places_->begin(), places_->end(),
                                       [&](double a, double b) { return at.distance(a) < at.distance(b); }));
  }
  for (const double place : places) {
    steps.push_back(step_between(step_of(log, here, place), step_of(log, at, place), step_of(log, there, place)));
    if (log.failure) return 0;
  }
  return least_of(places, steps);
}

bool PlanarLines::is_too_many(PassLog& log) {
  constexpr int parts = 8;
  double count = 1;
  for (int k = 1; k < 2 * parts; k += 2) {
    const double level = from_ + (to_ - from_) * k / (2 * parts), step = step_to(log, level, level);
    if (log.failure) return true;
    count += std::abs(to_ - from_) / parts / step;
  }
  if (!(count <= static_cast<double>(most_passes))) {
    log.fail(PassFailure::Kind::too_many, log.machining->u.from, log.machining->v.from, count);
  }
  return log.failure.has_value();
}

/// To the next level; false at the end. Where the border is no plane, the outermost pass lies half a step inside the outermost point.
bool PlanarLines::advance(PassLog& log) {
  const double sign = to_ > from_ ? 1 : -1;
  const double before = told_ == 0 ? from_ : at_;
  if (told_ == 0 && begins_at_border_) {
    at_ = from_;
    return true;
  }
  const double inside = before + sign * 1e-6 * std::abs(to_ - from_);
  double step = step_ > 0 ? step_ : step_to(log, inside, inside);
  for (int round = 0; round < 2 && !log.failure; ++round) {
    step = step_to(log, before, before + sign * std::min(step, std::abs(to_ - before)));
  }
  if (log.failure) return false;
  step_ = step;
  const double left = std::abs(to_ - before), edge = ends_at_border_ ? 0 : step / 2;
  if (told_ == 0) {
    at_ = left > step ? from_ + sign * step / 2 : (from_ + to_) / 2;
    return true;
  }
  if (left <= edge * (1 + 1e-9) || left <= 1e-9 * step) return false;
  at_ = left - edge > step * (1 + 1e-9) ? before + sign * step : to_ - sign * std::min(edge, left / 2);
  return true;
}

std::vector<Line> PlanarLines::next(PassLog& log) {
  if (log.failure || (told_ == 0 && is_too_many(log))) return {};
  std::vector<Range> parts;
  // A plane may meet nothing where the range's border is bent.
  while (parts.empty()) {
    if (!advance(log)) {
      if (log.failure || borders_.empty()) return {};
      const Line border = borders_.back();
      borders_.pop_back();
      return {border};
    }
    if (told_ >= 2 * most_passes) {
      log.fail(PassFailure::Kind::too_many, 0, 0, static_cast<double>(told_));
      return {};
    }
    section_ = std::make_shared<const Section>(section(log.machining->surface, at_));
    // What lies in the plane of the border does so but for rounding.
    const bool is_border = (begins_at_border_ && at_ == from_) || (ends_at_border_ && at_ == to_);
    parts = is_border ? std::vector<Range>{course_.run()} : section_->parts();
    ++told_;
  }
  const bool rises = (course_.from < course_.to) == (told_ % 2 == 1);
  std::vector<Line> lines;
  for (const Range& part : parts) {
    lines.push_back({course_.along, rises ? part.from : part.to, rises ? part.to : part.from, 0, section_});
  }
  if (!rises) std::reverse(lines.begin(), lines.end());
  return lines;
}

}  // namespace

std::unique_ptr<PassLines> planar_lines(PassLog& log) {
  return std::make_unique<PlanarLines>(log);
}

}  // namespace leadscrew::surfaces
