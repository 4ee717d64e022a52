// Passes round the range, from its border inwards: four legs along the parameters, each as far from the one outside as the
// ridge between them allows.
//
//     a₁ ┌───────◀───────┐
//        │  ┌─────◀────┐ │         Where two legs meet at an angle θ, places between the corners of neighbouring turns are
//        │  └─▶        │ ▲         Δ/(1 + sin θ/2) from both, more than Δ/2: steps are (1 + sin θ/2)/2 of what one leg allows.
//        ▼─────▶───────┘ │
//     a₀ ──────▶─────────┘
//        r₀              r₁
//
// That is so of a ball, which cuts round the ends of legs as well. A tool that leans by the pass cuts with an edge ahead of its contact
// or behind, and as far as its step only along legs. With i how far inside a leg alone leaves no more, legs are long enough where
//
//     an edge behind comes, at a leg's end, to i inside the last turn's leg that it meets,
//     an edge ahead begins, at a leg's begin, no farther than i inside the leg before:
//
// then each place between two turns lies within i of the one outside, or between legs that are a step apart. A leg may not begin or end
// outside the border: where it would have to, its edge leaves a strip at its begin or end to others. What meets it there goes on past it,
// to the last turn's leg if that is long enough, else to the border; and where both are cut off, at a corner, steps are shorter. Where i is not known, as of
// a tool that keeps its axis, legs go all the way to those that they meet: its edge is behind on one leg by as much as it is i on the other.

#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/pass_lines.hpp>
#include <utility>

namespace leadscrew::surfaces {

namespace {

constexpr std::size_t least_leg_places = 9;
constexpr double rounding_of_range = 1e-9;
/// Of the steps of turns whose corners are left by both of their legs: what these leave there becomes less, as edges are ahead and behind
/// by the less the nearer to the leg a place is.
constexpr double steps_about_corners = 0.5;

class SpiralLines : public PassLines {
 public:
  explicit SpiralLines(PassLog& log);
  std::vector<Line> next(PassLog& log) override;

 private:
  /// A side of the range: legs lie at `at`, gone towards `along_sign`; inside is at `inwards`.
  struct Side {
    Direction along = Direction::u;
    double border = 0, along_sign = 1, inwards = 1;
    double at = border;                        // the leg of this turn
    double outside = border, outside_far = 0;  // that of the last turn, and its far
    double step = 0;                           // to the leg inside
    double far = 0;                            // so far inside the leg alone leaves no more; 0 where it is not known
    double ahead = 0, behind = 0;              // the edge, of contacts
    // How far from the borders of the sides before and behind the edge has been, of this turn's leg, once it is told, and of the last's.
    double from = 0, to = 0, outside_from = 0, outside_to = 0;
    double half = 0;  // so far inside from here, and so far from there, opposite legs leave no more
  };
  void find_steps(PassLog& log);
  bool leaves_corners() const;
  double corner_factor(PassLog& log) const;
  bool is_too_many(PassLog& log) const;
  void finish(std::vector<Line>& lines);
  double corner(const Side& side, double meets, double far, double off, double line) const;
  double begin(std::size_t k) const;
  double end(std::size_t k) const;
  double end_inside(std::size_t k, double line) const;
  Line leg(std::size_t k, double end);
  /// How far inside the border of a side the last turn has left no more.
  double done(std::size_t k) const {
    return (sides_[k].outside - sides_[k].border) * sides_[k].inwards + sides_[k].outside_far;
  }
  /// Has an edge been as near to the border of the side as it has to be for the leg there, which comes from the last turn's?
  bool is_near(double edge, std::size_t k) const { return edge <= done(k) + rounding_of_range * std::abs(gap(k % 2)); }
  double inside(std::size_t k) const { return sides_[k].at + sides_[k].inwards * sides_[k].step; }
  /// From one border to the opposite, across the sides k and k + 2.
  double gap(std::size_t k) const { return (sides_[k + 2].at - sides_[k].at) * sides_[k].inwards; }
  double both(std::size_t k) const { return sides_[k].step + sides_[k + 2].step; }
  /// The widest gap between opposite legs, which go opposite ways and so have the same side of the tool towards each other.
  double widest(std::size_t k) const { return 2 * std::min(sides_[k].half, sides_[k + 2].half); }
  /// Whether one more leg is enough between them.
  bool is_last(std::size_t k) const { return gap(k) <= sides_[k].step + widest(k); }
  double middle(std::size_t k) const;

  std::array<Side, 4> sides_;  // in the order in which they are gone
  bool has_corners_ = false;   // legs end where they meet
  std::size_t told_ = 0;
  bool is_done_ = false;
};

SpiralLines::SpiralLines(PassLog& log)
    : has_corners_(log.machining->cutter.is_ball() || !(log.machining->scallop > 0)) {
  const Course course = course_of(*log.machining, log.machining->along);
  const Direction along = course.along, across = along == Direction::u ? Direction::v : Direction::u;
  const double run = course.from < course.to ? 1 : -1, width = course.sign_across();
  sides_ = {{{along, course.first, run, width},
             {across, course.to, width, -run},
             {along, course.last, -run, -width},
             {across, course.from, -width, run}}};
}

/// By the sharpest corner of the turn.
double SpiralLines::corner_factor(PassLog& log) const {
  double factor = 1;
  for (std::size_t k = 0; k < 4; ++k) {
    const Side &a = sides_[k], &b = sides_[(k + 1) % 4];
    const std::optional<Contact> contact = contact_at(log, line_place(a.along, b.at, a.along_sign, a.at));
    if (!contact) return 1;
    const bool a_is_u = a.along == Direction::u;
    const Vector &by_a = a_is_u ? contact->jet.u : contact->jet.v, &by_b = a_is_u ? contact->jet.v : contact->jet.u;
    const double inside = kinematics::angle_between(numeric::sum(Vector{}, -a.along_sign, by_a),
                                                    numeric::sum(Vector{}, b.along_sign, by_b));
    factor = std::min(factor, (1 + numeric::sin(inside / 2)) / 2);
  }
  return factor;
}

void SpiralLines::find_steps(PassLog& log) {
  const double factor = has_corners_ ? corner_factor(log) : 1;
  std::array<std::optional<LineReach>, 4> reaches;
  for (std::size_t k = 0; k < 4 && !log.failure; ++k) {
    Side& side = sides_[k];
    const Side &before = sides_[(k + 3) % 4], &after = sides_[(k + 1) % 4];
    const Range run = {std::min(before.at, after.at), std::max(before.at, after.at)};
    LineSteps steps(side.along, places_along(*log.machining->surface, side.along, run, least_leg_places));
    const double step = steps.next(log, side.at, gap(k % 2), side.along_sign, side.inwards, side.step / factor);
    side.step = factor * step;
    side.half = side.step / 2;
    if (!has_reach(*log.machining) || log.failure) continue;
    const Range legs = {std::min({run.from, before.outside, after.outside}),
                        std::max({run.to, before.outside, after.outside})};
    const LineSteps whole(side.along, places_along(*log.machining->surface, side.along, legs, least_leg_places));
    reaches[k] = whole.reach(log, side.at, side.along_sign, side.inwards);
  }
  if (!has_reach(*log.machining)) return;
  const bool is_known =
      std::all_of(reaches.begin(), reaches.end(), [](const auto& reach) { return reach.has_value(); });
  for (std::size_t k = 0; k < 4; ++k) {
    Side& side = sides_[k];
    const LineReach reach = is_known ? *reaches[k] : LineReach{};
    side.half = side.far = std::min(reach.across, side.step);
    side.ahead = reach.ahead;
    side.behind = reach.behind;
    if (!is_known) side.outside_far = 0;
  }
  if (has_corners_ || !leaves_corners()) return;
  for (Side& side : sides_) {
    side.step *= steps_about_corners;
    side.half = side.far = std::min(side.far, side.step);
  }
}

/// Is there a corner of the turn that neither of its legs can cut up to, as the border cuts off the end of one and the begin of the
/// other?
bool SpiralLines::leaves_corners() const {
  for (std::size_t k = 0; k < 4; ++k) {
    const Side &side = sides_[k], &before = sides_[(k + 3) % 4];
    const double begin = (before.at - before.border) * before.inwards + before.far;
    if (side.ahead > begin && before.behind > done(k)) return true;
  }
  return false;
}

bool SpiralLines::is_too_many(PassLog& log) const {
  const double turns = std::min(gap(0) / both(0), gap(1) / both(1));
  if (!(turns < static_cast<double>(most_passes))) {
    const LinePlace begin = line_place(sides_[0].along, sides_[3].at, 1, sides_[0].at);
    log.fail(PassFailure::Kind::too_many, begin.u.value, begin.v.value, turns);
  }
  return log.failure.has_value();
}

/// Where a leg begins or ends that comes from a leg of the side or meets it; off: how far its edge is short. Not inside the line where the
/// corner is, nor outside the border.
double SpiralLines::corner(const Side& side, double meets, double far, double off, double line) const {
  const double of_line = (line - side.border) * side.inwards,
               of_edge = (meets - side.border) * side.inwards + far - off;
  return side.border + side.inwards * (has_corners_ ? of_line : std::clamp(of_edge, 0.0, of_line));
}

double SpiralLines::begin(std::size_t k) const {
  const Side &side = sides_[k], &before = sides_[(k + 3) % 4];
  // The first leg comes from the last turn's fourth.
  const double meets = k == 0 ? before.outside : before.at, far = k == 0 ? before.outside_far : before.far;
  if (!has_corners_ && !is_near(k == 0 ? before.outside_to : before.to, k)) return before.border;
  return corner(before, meets, far, side.ahead, meets);
}

double SpiralLines::end(std::size_t k) const {
  const Side& after = sides_[(k + 1) % 4];
  if (!has_corners_ && !is_near(after.outside_from, k)) return after.border;
  return corner(after, after.outside, after.outside_far, sides_[k].behind, after.at);
}

/// Of a leg that meets one of this turn.
double SpiralLines::end_inside(std::size_t k, double line) const {
  const Side& after = sides_[(k + 1) % 4];
  if (!has_corners_ && !is_near(after.from, k)) return end(k);
  return corner(after, after.at, after.far, sides_[k].behind, line);
}

/// That of a side in this turn, and where its edge has been.
Line SpiralLines::leg(std::size_t k, double end) {
  Side& side = sides_[k];
  const Side &before = sides_[(k + 3) % 4], &after = sides_[(k + 1) % 4];
  const double begin = this->begin(k);
  side.from = (begin - before.border) * before.inwards + side.ahead;
  side.to = (end - after.border) * after.inwards + side.behind;
  return {side.along, begin, end, side.at, nullptr};
}

/// Where one more leg lies between opposite ones, gone as that of the side k.
double SpiralLines::middle(std::size_t k) const {
  const Side& side = sides_[k];
  return side.at + side.inwards * gap(k) * side.step / (side.step + widest(k));
}

/// The last turn's end: one more leg in the middle where two opposite ones are too far apart.
void SpiralLines::finish(std::vector<Line>& lines) {
  const auto& [first, second, third, fourth] = sides_;
  if (gap(0) <= widest(0) || gap(1) <= widest(1)) {
    lines.push_back(leg(3, end_inside(3, first.at)));
  } else if (is_last(0)) {
    lines.push_back(leg(3, end_inside(3, middle(0))));
    lines.push_back({first.along, corner(fourth, fourth.at, fourth.far, first.ahead, fourth.at),
                     end_inside(0, inside(1)), middle(0), nullptr});
  } else {
    lines.push_back(leg(3, end_inside(3, inside(0))));
    lines.push_back({first.along, corner(fourth, fourth.at, fourth.far, first.ahead, fourth.at),
                     end_inside(0, middle(1)), inside(0), nullptr});
    lines.push_back({second.along, corner(first, inside(0), first.far, second.ahead, inside(0)),
                     end_inside(1, inside(2)), middle(1), nullptr});
  }
}

/// One turn.
std::vector<Line> SpiralLines::next(PassLog& log) {
  if (is_done_) return {};
  find_steps(log);
  if (log.failure || (told_ == 0 && is_too_many(log))) return {};
  if (told_++ > 2 * most_passes) {
    log.fail(PassFailure::Kind::too_many, 0, 0, static_cast<double>(told_));
    return {};
  }
  std::vector<Line> lines;
  for (std::size_t k = 0; k < 3; ++k) lines.push_back(leg(k, end(k)));
  is_done_ = is_last(0) || is_last(1);
  if (is_done_) {
    finish(lines);
    return lines;
  }
  for (const std::size_t k : {0u, 1u}) {
    if (gap(k) > both(k)) continue;
    // One leg is too few here, and two would cross.
    for (Side* side : {&sides_[k], &sides_[k + 2]}) side->step *= gap(k) / both(k) / 2;
  }
  lines.push_back(leg(3, end_inside(3, inside(0))));
  for (Side& side : sides_) {
    side.outside = std::exchange(side.at, side.at + side.inwards * side.step);
    side.outside_far = side.far;
    side.outside_from = side.from;
    side.outside_to = side.to;
  }
  return lines;
}

}  // namespace

std::unique_ptr<PassLines> spiral_lines(PassLog& log) {
  return std::make_unique<SpiralLines>(log);
}

}  // namespace leadscrew::surfaces
