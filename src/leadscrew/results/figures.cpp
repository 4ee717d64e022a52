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

}  // namespace leadscrew::results
