#include <leadscrew/cli/figures.hpp>

namespace leadscrew::cli {

namespace {

/// As the referee has it: a limit is not kept when it is passed by more than 0.1 %.
constexpr double largest_ratio = 1.001;

}  // namespace

bool RunFigures::kept() const {
  return !verdict.objects() && summary.plan.greatest() <= largest_ratio;
}

}  // namespace leadscrew::cli
