#pragma once
// Feed override, feed hold and a planner that is kept from its work, at random instants of a program, and what must hold
// whatever was asked.

#include <rapidcheck.h>

#include <string>
#include <vector>

#include "live_program.hpp"
#include "random_programs.hpp"
#include "worst_ratios.hpp"

namespace leadscrew::testing_support {

/// Some in a motion of so many ticks and behind it; in the end the feed is as programmed.
inline std::vector<Intervention> random_interventions(std::size_t ticks) {
  std::vector<Intervention> interventions;
  std::int64_t at = 0;
  const int count = any(1, 8);
  for (int k = 0; k < count; ++k) {
    at += any(0, 1 + 2 * static_cast<int>(ticks) / count);
    const double factor = *rc::gen::element(0.0, 0.0, 0.01, 0.3, 0.5, 0.9, 1.0, 1.3, 2.0);
    interventions.push_back({at, factor, *rc::gen::element<std::int64_t>(0, 0, 0, 15, 45, 300)});
  }
  interventions.push_back({at + any(0, 300), 1.0, 0});
  for (const Intervention& each : interventions) {
    RC_LOG() << "tick " << each.tick << " factor " << each.factor << " silent " << each.silence << '\n';
  }
  return interventions;
}

/// Limits, the path, its ends, and never back.
inline void expect_kept(LiveProgram& live) {
  const referee::Verdict verdict = live.conclude();
  for (const referee::Violation& each : verdict.violations)
    RC_LOG() << each.what << " " << each.value << " of " << each.limit << " at " << each.t << "\n";
  RC_ASSERT(worst_planned(live.plan()) <= 1 + 1e-9);
  RC_ASSERT(worst_judged(verdict) <= 1.001);
  RC_ASSERT(verdict.deviation_mm <= verdict.tolerance_mm + 1e-6);
  RC_ASSERT(verdict.start_error_mm <= 1e-9);
  RC_ASSERT(verdict.end_error_mm <= 1e-9);
  RC_ASSERT(live.refused_windows() == 0);
  for (const base::Word& word : live.words) RC_ASSERT(word.feed >= -1e-6);
}

}  // namespace leadscrew::testing_support
