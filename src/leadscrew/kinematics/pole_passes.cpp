#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/pole_passes.hpp>
#include <leadscrew/kinematics/solutions.hpp>
#include <leadscrew/numeric/functions.hpp>

namespace leadscrew::kinematics {

namespace {

constexpr double same_place = 1e-4;  ///< mm; a vertex so near the nearest place is that place
constexpr double reach_by_miss = 3;  ///< H by m over the rate of the direction

double square_of(double x) {
  return x * x;
}

/// w, 1 at 0 and 0 from 1 on with three derivatives.
double share_of_miss(double x) {
  return std::abs(x) < 1 ? square_of(square_of(1 - x * x)) : 0;
}

/// The axis about which a direction turns towards another; 0 where they are the same.
Vector turning_axis(const Vector& from, const Vector& to) {
  const Vector cross = cross_product(from, to);
  const double length = numeric::hypot(cross[0], cross[1], cross[2]);
  return length > 0 ? unit_vector(cross) : Vector{};
}

}  // namespace

bool PolePass::is_held(double s) const {
  return s >= first - same_place / 2 && s <= last + same_place / 2;
}

Vector PolePass::applied(double s, const Vector& direction) const {
  if (is_held(s)) return pole;
  const bool is_before = s < first;
  const double share = is_before ? share_of_miss((first - s) / entry) : share_of_miss((s - last) / exit);
  const double miss = is_before ? entry_miss : exit_miss;
  return share * miss > 0 ? unit_vector(turned(direction, is_before ? entry_axis : exit_axis, share * miss))
                          : direction;
}

PolePasses::PolePasses(const Chain& chain, double cone) : cone_(cone), cone_sine_(numeric::sin(cone)) {
  if (cone > 0) poles_ = poles_of(chain);
}

std::optional<Vector> PolePasses::pole_near(const Vector& direction) const {
  for (const Vector& pole : poles_) {
    if (is_within(pole, direction, cone_sine_)) return pole;
  }
  return std::nullopt;
}

void PolePasses::observe(const DirectionSegment& segment) {
  end_ = segment.to;
  if (poles_.empty()) return;
  if (open_ && !is_within(open_->pole, segment.circle.at(0), cone_sine_)) end_stretch(false);
  std::optional<Vector> pole;
  if (segment.circle.may_come_near(poles_.front(), cone_)) {
    pole = pole_near(segment.circle.at(segment.circle.nearest_to_axis(poles_.front())));
  }
  if (open_ && (!pole || *pole != open_->pole)) end_stretch(false);
  if (pole) extend(segment, *pole);
  is_at_start_ = false;
  settle(false);
}

void PolePasses::extend(const DirectionSegment& segment, const Vector& pole) {
  if (!open_) open_ = Stretch{pole, segment.from, is_at_start_, {}, {}};
  const double length = segment.to - segment.from;
  double share = segment.circle.nearest_to_axis(pole);
  if (share * length < same_place) share = 0;
  if ((1 - share) * length < same_place) share = 1;
  const double rate = length > 0 ? segment.circle.angle() / length : 0;
  const Place nearest{segment.from + share * length, segment.circle.at(share), rate};
  if (share < 1 && !open_->first) open_->first = nearest;
  if (share > 0 || !open_->last) open_->last = nearest;
}

/// No nearest place is where the path begins or ends: there the tool is held as it was programmed.
void PolePasses::end_stretch(bool at_end) {
  Stretch stretch = *open_;
  open_.reset();
  if (!stretch.first || !stretch.last) return;
  const bool begins_nearest = stretch.is_from_start && stretch.first->s <= stretch.begin;
  const bool ends_nearest = at_end && stretch.last->s >= end_;
  if (begins_nearest) stretch.first = stretch.last;
  if (ends_nearest) stretch.last = begins_nearest ? std::nullopt : stretch.first;
  if (!stretch.last || stretch.last->s <= floor_ || (at_end && stretch.last->s >= end_)) return;
  found_.push_back(pass_of(stretch));
}

PolePass PolePasses::pass_of(const Stretch& stretch) const {
  PolePass pass;
  pass.pole = stretch.pole;
  pass.first = stretch.first->s;
  pass.last = stretch.last->s;
  pass.entry_miss = angle_between(stretch.first->direction, pass.pole);
  pass.exit_miss = angle_between(stretch.last->direction, pass.pole);
  pass.entry_axis = turning_axis(stretch.first->direction, pass.pole);
  pass.exit_axis = turning_axis(stretch.last->direction, pass.pole);
  pass.greatest = pass.last > pass.first ? cone_ : pass.entry_miss;
  const auto reach = [](double miss, double rate) {
    const double wanted = rate > 0 ? reach_by_miss * miss / rate : longest_reach;
    return std::clamp(wanted, shortest_reach, longest_reach);
  };
  const double before = found_.empty() ? settled_.empty() ? floor_ : std::max(floor_, settled_.back().end())
                                       : (found_.back().last + pass.first) / 2;
  pass.entry = std::min(reach(pass.entry_miss, stretch.first->rate), pass.first - before);
  pass.exit = reach(pass.exit_miss, stretch.last->rate);
  return pass;
}

/// The next pass takes half of the way to it, the end of the path all; a path that is known far enough leaves it as it is.
void PolePasses::settle(bool all) {
  while (!found_.empty()) {
    PolePass& pass = found_.front();
    if (found_.size() > 1) {
      pass.exit = std::min(pass.exit, (found_[1].first - pass.last) / 2);
    } else if (all) {
      pass.exit = std::min(pass.exit, end_ - pass.last);
    } else if (open_ || end_ < pass.last + 2 * longest_reach) {
      return;
    }
    settled_.push_back(pass);
    found_.pop_front();
  }
}

double PolePasses::known_until() const {
  if (poles_.empty()) return end_;
  double until = end_;
  if (open_) until = std::min(until, open_->begin);
  if (!found_.empty()) until = std::min(until, found_.front().first);
  return until - longest_reach;
}

void PolePasses::close() {
  if (open_) end_stretch(true);
  settle(true);
  floor_ = end_;
  is_at_start_ = true;
}

std::vector<const PolePass*> PolePasses::between(double from, double to) const {
  std::vector<const PolePass*> passes;
  for (const PolePass& pass : settled_) {
    if (pass.begin() < to && pass.end() > from) passes.push_back(&pass);
  }
  return passes;
}

void PolePasses::forget_before(double s) {
  while (!settled_.empty() && settled_.front().end() < s) settled_.pop_front();
}

}  // namespace leadscrew::kinematics
