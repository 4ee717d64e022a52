#include <algorithm>
#include <leadscrew/results/figures.hpp>

namespace leadscrew::results {

namespace {

/// As the referee has it: a limit is not kept when it is passed by more than 0.1 %.
constexpr double largest_ratio = 1.001;

}  // namespace

std::int64_t count(const Diagnostics& diagnostics, base::Severity severity) {
  return std::ranges::count(diagnostics, severity, &base::Diagnostic::severity);
}

bool RunFigures::kept() const {
  return !verdict.objects() && summary.plan.greatest() <= largest_ratio;
}

std::vector<Extent> extents_of(const machine::Machine& machine, const pipeline::LostTime& words) {
  std::vector<Extent> extents;
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    if (!machine.has(axis)) continue;
    extents.push_back({axis, words.least_position()[i], words.greatest_position()[i]});
  }
  return extents;
}

}  // namespace leadscrew::results
