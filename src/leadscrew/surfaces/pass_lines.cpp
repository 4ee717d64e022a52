// Passes along one of the parameters: Δ = min g/w over the pass.

#include <algorithm>
#include <cmath>
#include <leadscrew/surfaces/pass_lines.hpp>
#include <leadscrew/surfaces/reach.hpp>

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
  void find_equal_steps(PassLog& log);

  Course course_;
  bool comes_back_ = false;
  double at_ = 0;    // across: of the pass told last
  double step_ = 0;  // of the parameter across, told last; 0: none yet
  bool is_equal_ = false;
  std::size_t told_ = 0;
  LineSteps steps_;
};

ParameterLines::ParameterLines(PassLog& log)
    : course_(course_of(*log.machining, log.machining->along)),
      comes_back_(log.machining->pattern != Pattern::zig),
      at_(course_.first),
      steps_(course_.along, places_along(*log.machining->surface, course_.along, course_.run(), least_places)) {
  if (log.machining->equal_steps) find_equal_steps(log);
}

double ParameterLines::direction(std::size_t number) const {
  const double first = course_.from < course_.to ? 1 : -1;
  return comes_back_ && number % 2 == 1 ? -first : first;
}

/// ⌈width/least step⌉ steps, the least of lines all over the range, some in each span.
void ParameterLines::find_equal_steps(PassLog& log) {
  const std::vector<double>& places = steps_.places();
  const Direction across_direction = course_.along == Direction::u ? Direction::v : Direction::u;
  const std::size_t lines = 128 + 8 * (log.machining->surface->breaks(across_direction).size() - 1);
  const double width = course_.last - course_.first;
  double least = std::abs(width);
  for (std::size_t k = 0; k <= lines; ++k) {
    const double across = course_.first + width * static_cast<double>(k) / static_cast<double>(lines);
    for (std::size_t number = 0; number < (comes_back_ && !log.machining->cutter.is_ball() ? 2u : 1u); ++number) {
      const std::vector<StepPlace> steps =
          steps_along(log, course_.along, places, across, direction(number), course_.sign_across());
      if (log.failure) return;
      const double left = std::abs(course_.last - across), by_rule = least_on(places, steps);
      least = std::min(least, by_rule);
      if (has_reach(*log.machining) && left >= by_rule) {
        least = std::min(least, steps_.next(log, across, left, direction(number), course_.sign_across(), by_rule));
        if (log.failure) return;
      }
    }
  }
  is_equal_ = true;
  step_ = std::abs(width) / std::ceil(std::abs(width) / least * (1 - 1e-12));
}

/// The remainder comes last.
std::vector<Line> ParameterLines::next(PassLog& log) {
  if (told_ == 0) {
    if (log.failure || are_too_many(log, course_, steps_.places())) return {};
  } else {
    if (at_ == course_.last) return {};
    const double left = std::abs(course_.last - at_);
    if (!is_equal_) step_ = steps_.next(log, at_, left, direction(told_ - 1), course_.sign_across(), step_);
    if (log.failure) return {};
    const bool is_last = step_ * (1 + 1e-9) >= left;
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
