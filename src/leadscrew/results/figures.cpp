#include <fmt/format.h>

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

std::string line_text(base::Line line) {
  std::string text = fmt::format("line {}", base::number(line));
  if (base::file(line) != 0) text += fmt::format(" of subprogram file {}", base::file(line));
  if (base::visit(line) != 0) text += fmt::format(", visit {}", base::visit(line));
  return text;
}

bool RunFigures::kept() const {
  return !verdict.objects() && summary.plan.greatest() <= largest_ratio;
}

std::vector<Extent> extents_of(const machine::Machine& machine, const base::AxisVector& least,
                               const base::AxisVector& greatest) {
  std::vector<Extent> extents;
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    if (machine.has(axis)) extents.push_back({axis, least[i], greatest[i]});
  }
  return extents;
}

}  // namespace leadscrew::results
