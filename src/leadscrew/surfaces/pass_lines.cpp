#include <algorithm>
#include <cmath>
#include <leadscrew/surfaces/pass_lines.hpp>
#include <leadscrew/surfaces/step_over.hpp>

namespace leadscrew::surfaces {

namespace {

/// As far apart as the tool's outline allows on a surface that does not twist, less what a twist takes.
double step_of_outline(const Cutter& cutter, const Bending& bending, double height) {
  const double step = outline_step(cutter, bending.axis, bending.across, height);
  if (!(bending.radius < bending.tool_radius)) return step;
  const double without = step_over(bending.tool_radius, bending.across, height);
  return std::isinf(without) ? std::min(step, step_over(bending.radius, bending.across, height))
                             : step * step_over(bending.radius, bending.across, height) / without;
}

}  // namespace

double step_at(PassLog& log, const Bending& bending, double u, double v) {
  const Machining& machining = *log.machining;
  if (!(machining.scallop > 0)) return machining.step;
  const Cutter& cutter = machining.cutter;
  const double step = cutter.is_ball() ? step_over(bending.radius, bending.across, machining.scallop)
                                       : step_of_outline(cutter, bending, machining.scallop);
  if (!(step > 0)) log.fail(PassFailure::Kind::no_step, u, v);
  return std::min(step, 2 * cutter.radius);
}

namespace {

using Why = PassFailure::Kind;

/// Places along a pass where its step is found, at the least.
constexpr std::size_t least_places = 17;

/// Passes along one parameter: Δ = min g/w over the pass, with both taken in the middle between it and the next.
class ParameterLines : public PassLines {
 public:
  explicit ParameterLines(PassLog& log);
  std::vector<Line> next(PassLog& log) override;

 private:
  LinePlace place(double along, double across, double direction) const;
  double least_step(PassLog& log, double across);
  double step_from(PassLog& log, double across);
  bool is_too_many(PassLog& log);
  void find_equal_steps(PassLog& log);

  Direction along_;
  double from_ = 0, to_ = 0;  // along the first pass
  double at_ = 0, last_ = 0;  // across: of the pass told last, and of the last pass
  double step_ = 0;           // of the parameter across, told last; 0: none yet
  bool is_equal_ = false;
  std::size_t told_ = 0;
  std::vector<double> places_;  // along, where steps are found
};

ParameterLines::ParameterLines(PassLog& log) : along_(log.machining->along) {
  const Machining& machining = *log.machining;
  const bool u_rises = machining.start_corner == 1 || machining.start_corner == 4,
             v_rises = machining.start_corner <= 2;
  const bool is_u = along_ == Direction::u;
  const Range &along = is_u ? machining.u : machining.v, &across = is_u ? machining.v : machining.u;
  const bool rises_along = is_u ? u_rises : v_rises, rises_across = is_u ? v_rises : u_rises;
  from_ = rises_along ? along.from : along.to;
  to_ = rises_along ? along.to : along.from;
  at_ = rises_across ? across.from : across.to;
  last_ = rises_across ? across.to : across.from;
  // Twice a span, so that no bend of the surface is missed.
  const std::vector<double>& breaks = machining.surface->breaks(along_);
  std::vector<double> cuts = {along.from};
  for (const double cut : breaks) {
    if (cut > along.from && cut < along.to) cuts.push_back(cut);
  }
  cuts.push_back(along.to);
  const std::size_t parts = std::max<std::size_t>(4, (least_places - 1 + cuts.size() - 2) / (cuts.size() - 1));
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    for (std::size_t i = 0; i < parts; ++i) {
      places_.push_back(cuts[k] + (cuts[k + 1] - cuts[k]) * static_cast<double>(i) / static_cast<double>(parts));
    }
  }
  places_.push_back(along.to);
  if (machining.equal_steps) find_equal_steps(log);
}

LinePlace ParameterLines::place(double along, double across, double direction) const {
  const numeric::Jet<3> run{along, direction, 0, 0}, by = across;
  return along_ == Direction::u ? LinePlace{run, by} : LinePlace{by, run};
}

/// Of g/w along the line at `across`, the least of the parabola through the three places about the least.
double ParameterLines::least_step(PassLog& log, double across) {
  std::vector<double> steps;
  const double direction = from_ < to_ ? 1 : -1;
  for (const double along : places_) {
    const LinePlace at = place(along, across, direction);
    const std::optional<Contact> contact = contact_at(log, at);
    if (!contact) return 0;
    steps.push_back(step_at(log, contact->bending, at.u.value, at.v.value) / width_of(contact->frame, along_));
    if (log.failure) return 0;
  }
  const auto k = static_cast<std::size_t>(std::min_element(steps.begin(), steps.end()) - steps.begin());
  if (k == 0 || k + 1 == steps.size()) return steps[k];
  const double a = places_[k - 1] - places_[k], b = places_[k + 1] - places_[k];
  const double rise_a = (steps[k - 1] - steps[k]) / a, rise_b = (steps[k + 1] - steps[k]) / b;
  const double bend = (rise_b - rise_a) / (b - a), slope = rise_a - bend * a;
  return bend > 0 ? std::max(steps[k] - slope * slope / (4 * bend), 0.9 * steps[k]) : steps[k];
}

/// The step is found in the middle between both passes, and the middle from the step.
double ParameterLines::step_from(PassLog& log, double across) {
  const double sign = last_ > across ? 1 : -1;
  double step = step_ > 0 ? step_ : least_step(log, across);
  for (int round = 0; round < 4 && !log.failure; ++round) {
    const double middle = across + sign * std::min(step, std::abs(last_ - across)) / 2;
    const double found = least_step(log, middle);
    const bool is_near = std::abs(found - step) < 1e-3 * found;
    step = found;
    if (is_near) break;
  }
  return step;
}

/// How many steps the whole width takes, from some places of it.
bool ParameterLines::is_too_many(PassLog& log) {
  constexpr int parts = 8;
  double count = 0;
  for (int k = 0; k <= parts && !log.failure; ++k) {
    const double step = least_step(log, at_ + (last_ - at_) * k / parts);
    if (log.failure) return true;
    count += (k == 0 || k == parts ? 0.5 : 1) * std::abs(last_ - at_) / parts / step;
  }
  if (!(count < static_cast<double>(most_passes))) {
    const LinePlace begin = place(from_, at_, 1);
    log.fail(Why::too_many, begin.u.value, begin.v.value, count + 1);
  }
  return log.failure.has_value();
}

/// ⌈width/least step⌉ steps, the least of all lines sampled as densely across as along.
void ParameterLines::find_equal_steps(PassLog& log) {
  const std::size_t lines = 4 * places_.size();
  double least = std::abs(last_ - at_);
  for (std::size_t k = 0; k <= lines && !log.failure; ++k) {
    const double step = least_step(log, at_ + (last_ - at_) * static_cast<double>(k) / static_cast<double>(lines));
    least = std::min(least, step);
  }
  if (log.failure) return;
  is_equal_ = true;
  step_ = std::abs(last_ - at_) / std::ceil(std::abs(last_ - at_) / least * (1 - 1e-12));
}

std::vector<Line> ParameterLines::next(PassLog& log) {
  if (told_ == 0) {
    if (log.failure || is_too_many(log)) return {};
  } else {
    if (at_ == last_) return {};
    const double step = is_equal_ ? step_ : step_from(log, at_);
    if (log.failure) return {};
    step_ = step;
    // What would be less than a thousandth of a step is not told apart.
    at_ = step * (1 + 1e-9) < std::abs(last_ - at_) ? at_ + (last_ > at_ ? step : -step) : last_;
  }
  const bool back = log.machining->pattern != Pattern::zig && told_ % 2 == 1;
  ++told_;
  if (told_ > 2 * most_passes) {
    log.fail(Why::too_many, 0, 0, static_cast<double>(told_));
    return {};
  }
  return {{along_, back ? to_ : from_, back ? from_ : to_, at_, nullptr}};
}

}  // namespace

std::unique_ptr<PassLines> lines_of(PassLog& log) {
  return std::make_unique<ParameterLines>(log);
}

}  // namespace leadscrew::surfaces
