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
// That is so of a ball, which cuts round the ends of legs as well. A tool that leans by the pass cuts nothing ahead of the edge that it
// touches with, but has its steps along legs up to their ends: legs go on beyond corners, to where the one outside leaves no more.

#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/pass_lines.hpp>

namespace leadscrew::surfaces {

namespace {

constexpr std::size_t least_leg_places = 9;

class SpiralLines : public PassLines {
 public:
  explicit SpiralLines(PassLog& log);
  std::vector<Line> next(PassLog& log) override;

 private:
  /// A side of the range: legs lie at `at`, gone towards `along_sign`; inside is at `inwards`.
  struct Side {
    Direction along = Direction::u;
    double at = 0, along_sign = 1, inwards = 1;
    double step = 0;    // to the leg inside
    double reach = 0;   // legs that arrive here may end so far inside
    double beyond = 0;  // legs that arrive here go on so far outside

    double end() const { return at - inwards * beyond; }
    double end_inside() const { return at + inwards * reach; }
  };
  void find_steps(PassLog& log);
  double corner_factor(PassLog& log) const;
  bool is_too_many(PassLog& log) const;
  void finish(std::vector<Line>& lines);
  /// From one border to the opposite, across the sides k and k + 2.
  double gap(std::size_t k) const { return (sides_[k + 2].at - sides_[k].at) * sides_[k].inwards; }
  double least(std::size_t k) const { return std::min(sides_[k].step, sides_[k + 2].step); }
  double both(std::size_t k) const { return sides_[k].step + sides_[k + 2].step; }

  std::array<Side, 4> sides_;  // in the order in which they are gone
  double begin_ = 0;           // along the first side: where the turn begins
  std::size_t told_ = 0;
  bool is_done_ = false;
};

SpiralLines::SpiralLines(PassLog& log) {
  const Course course = course_of(*log.machining, log.machining->along);
  const Direction along = course.along, across = along == Direction::u ? Direction::v : Direction::u;
  const double run = course.from < course.to ? 1 : -1, width = course.sign_across();
  sides_ = {{{along, course.first, run, width},
             {across, course.to, width, -run},
             {along, course.last, -run, -width},
             {across, course.from, -width, run}}};
  begin_ = course.from;
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
    factor = std::min(factor, (1 + std::sin(inside / 2)) / 2);
  }
  return factor;
}

void SpiralLines::find_steps(PassLog& log) {
  const double factor = has_reach(*log.machining) ? 1 : corner_factor(log);
  std::array<LineReach, 4> reaches;
  for (std::size_t k = 0; k < 4 && !log.failure; ++k) {
    Side& side = sides_[k];
    const Side &before = sides_[(k + 3) % 4], &after = sides_[(k + 1) % 4];
    const Range run = {std::min(before.at, after.at), std::max(before.at, after.at)};
    LineSteps steps(side.along, places_along(*log.machining->surface, side.along, run, least_leg_places));
    const double step = steps.next(log, side.at, gap(k % 2), side.along_sign, side.inwards, side.step / factor);
    side.step = factor * step;
    if (has_reach(*log.machining)) reaches[k] = steps.reach(log, side.at, side.along_sign, side.inwards);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    Side& side = sides_[k];
    side.reach = side.step;
    if (has_reach(*log.machining))
      side.reach = std::clamp(reaches[k].across - reaches[(k + 3) % 4].along, 0.0, side.step);
  }
}

bool SpiralLines::is_too_many(PassLog& log) const {
  const double turns = std::min(gap(0) / both(0), gap(1) / both(1));
  if (!(turns < static_cast<double>(most_passes))) {
    const LinePlace begin = line_place(sides_[0].along, begin_, 1, sides_[0].at);
    log.fail(PassFailure::Kind::too_many, begin.u.value, begin.v.value, turns);
  }
  return log.failure.has_value();
}

/// The last turn's end: one more leg in the middle where two opposite ones are more than a step apart.
void SpiralLines::finish(std::vector<Line>& lines) {
  const auto [first, second, third, fourth] = sides_;
  if (gap(0) <= least(0) || gap(1) <= least(1)) {
    lines.push_back({fourth.along, third.at, first.at, fourth.at, nullptr});
  } else if (gap(0) <= both(0)) {
    const double middle = (first.at + third.at) / 2;
    lines.push_back(
        {fourth.along, third.at, first.at + first.inwards * std::min(first.reach, gap(0) / 2), fourth.at, nullptr});
    lines.push_back({first.along, fourth.at, second.end_inside(), middle, nullptr});
  } else {
    const double middle = (second.at + fourth.at) / 2, inner = first.at + first.inwards * first.step;
    lines.push_back({fourth.along, third.at, first.end_inside(), fourth.at, nullptr});
    lines.push_back(
        {first.along, fourth.at, second.at + second.inwards * std::min(second.reach, gap(1) / 2), inner, nullptr});
    lines.push_back({second.along, inner, third.end_inside(), middle, nullptr});
  }
  is_done_ = true;
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
  const auto [first, second, third, fourth] = sides_;
  std::vector<Line> lines = {{first.along, begin_, second.end(), first.at, nullptr},
                             {second.along, first.at, third.end(), second.at, nullptr},
                             {third.along, second.at, fourth.end(), third.at, nullptr}};
  if (gap(0) <= both(0) || gap(1) <= both(1)) {
    finish(lines);
    return lines;
  }
  lines.push_back({fourth.along, third.at, first.end_inside(), fourth.at, nullptr});
  begin_ = fourth.at;
  for (Side& side : sides_) {
    side.at += side.inwards * side.step;
    side.beyond = side.step - side.reach;
  }
  return lines;
}

}  // namespace

std::unique_ptr<PassLines> spiral_lines(PassLog& log) {
  return std::make_unique<SpiralLines>(log);
}

}  // namespace leadscrew::surfaces
