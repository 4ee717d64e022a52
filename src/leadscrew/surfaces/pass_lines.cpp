// Passes along one of the parameters: Δ = min g/w over the pass, both taken in the middle between it and the next.

#include <algorithm>
#include <cmath>
#include <leadscrew/surfaces/pass_lines.hpp>

namespace leadscrew::surfaces {

namespace {

/// Places along a pass where its step is found, at the least.
constexpr std::size_t least_places = 33;

class ParameterLines : public PassLines {
 public:
  explicit ParameterLines(PassLog& log);
  std::vector<Line> next(PassLog& log) override;

 private:
  /// Of the pass of this number: 1 or −1.
  double direction(std::size_t number) const;
  double step_at_line(PassLog& log, double across, std::size_t number) const;
  double step_from(PassLog& log) const;
  void find_equal_steps(PassLog& log);

  Course course_;
  bool comes_back_ = false;
  double at_ = 0;    // across: of the pass told last
  double step_ = 0;  // of the parameter across, told last; 0: none yet
  bool is_equal_ = false;
  std::size_t told_ = 0;
  std::vector<double> places_;  // along, where steps are found
};

ParameterLines::ParameterLines(PassLog& log)
    : course_(course_of(*log.machining, log.machining->along)),
      comes_back_(log.machining->pattern != Pattern::zig),
      at_(course_.first),
      places_(places_along(*log.machining->surface, course_.along, course_.run(), least_places)) {
  if (log.machining->equal_steps) find_equal_steps(log);
}

double ParameterLines::direction(std::size_t number) const {
  const double first = course_.from < course_.to ? 1 : -1;
  return comes_back_ && number % 2 == 1 ? -first : first;
}

double ParameterLines::step_at_line(PassLog& log, double across, std::size_t number) const {
  return least_step(log, course_.along, places_, across, direction(number), course_.sign_across());
}

/// The step is found in the middle between both passes, and the middle from the step.
double ParameterLines::step_from(PassLog& log) const {
  double step = step_ > 0 ? step_ : step_at_line(log, at_, told_ - 1);
  for (int round = 0; round < 4 && !log.failure; ++round) {
    const double half = std::min(step, std::abs(course_.last - at_)) / 2;
    const double found = step_at_line(log, at_ + course_.sign_across() * half, told_ - 1);
    const bool is_near = std::abs(found - step) < 1e-3 * found;
    step = found;
    if (is_near) break;
  }
  return step;
}

/// ⌈width/least step⌉ steps, the least of all lines sampled more densely across than along.
void ParameterLines::find_equal_steps(PassLog& log) {
  const std::size_t lines = 4 * places_.size();
  const double width = course_.last - course_.first;
  double least = std::abs(width);
  for (std::size_t k = 0; k <= lines && !log.failure; ++k) {
    const double across = course_.first + width * static_cast<double>(k) / static_cast<double>(lines);
    for (std::size_t number = 0; number < (comes_back_ && !log.machining->cutter.is_ball() ? 2u : 1u); ++number) {
      least = std::min(least, step_at_line(log, across, number));
    }
  }
  if (log.failure) return;
  is_equal_ = true;
  step_ = std::abs(width) / std::ceil(std::abs(width) / least * (1 - 1e-12));
}

/// The remainder comes last.
std::vector<Line> ParameterLines::next(PassLog& log) {
  if (told_ == 0) {
    if (log.failure || are_too_many(log, course_, places_)) return {};
  } else {
    if (at_ == course_.last) return {};
    if (!is_equal_) step_ = step_from(log);
    if (log.failure) return {};
    const bool is_last = step_ * (1 + 1e-9) >= std::abs(course_.last - at_);
    at_ = is_last ? course_.last : at_ + course_.sign_across() * step_;
  }
  if (told_ >= 2 * most_passes) {
    log.fail(PassFailure::Kind::too_many, 0, 0, static_cast<double>(told_));
    return {};
  }
  const Range run = course_.run();
  const bool rises = direction(told_++) > 0;
  return {{course_.along, rises ? run.from : run.to, rises ? run.to : run.from, at_, nullptr}};
}

}  // namespace

std::unique_ptr<PassLines> lines_of(PassLog& log) {
  switch (log.machining->pattern) {
    case Pattern::spiral_in:
      return spiral_lines(log);
    case Pattern::planar:
      return planar_lines(log);
    case Pattern::iso_scallop:
      return iso_scallop_lines(log);
    case Pattern::zig:
    case Pattern::zigzag:
      break;
  }
  return std::make_unique<ParameterLines>(log);
}

}  // namespace leadscrew::surfaces
