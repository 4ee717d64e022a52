#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "live_program.hpp"
#include "random_program.hpp"
#include "worst_ratios.hpp"

// Programs that change what of the overrides is obeyed (M48 to M50, M52, M53), overridden, held and kept waiting at any
// instant: still no limit exceeded, never off the path, at rest at the end, and what is obeyed is what the events say
// that motion has passed.

namespace test_overrides {

using namespace leadscrew;
using testing_support::any;
using testing_support::Intervention;
using testing_support::limits_of;
using testing_support::LiveProgram;
using testing_support::random_machine;
using testing_support::RandomProgram;
using testing_support::worst_judged;
using testing_support::worst_planned;

constexpr std::int64_t most_ticks = 6'000;

std::string with_overrides(const std::string& program) {
  std::string text;
  for (std::size_t at = 0; at < program.size();) {
    const std::size_t end = program.find('\n', at) + 1;
    const std::string block = program.substr(at, end - at);
    at = end;
    const bool is_plain = block.starts_with("G1 ") || block.starts_with("G0 ") || block.starts_with("G2 ") ||
                          block.starts_with("G3 ") || block.starts_with("G4 ");
    for (int k = is_plain ? *rc::gen::element(0, 0, 1, 1, 2) : 0; k > 0; --k) {
      text += *rc::gen::element("M48", "M49", "M50", "M50 P0", "M52", "M52 P0", "M53", "M53 P0", "M51 P0");
      text += '\n';
    }
    text += block;
  }
  return text;
}

std::vector<base::Event> programmed_events(const std::string& text, const machine::Machine& machine) {
  const machine::ToolTable tools;
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, nullptr);
  std::vector<base::Event> events;
  for (gcode::Move move; reader.next(move);) {
    if (move.kind == gcode::Move::Kind::event) events.push_back(move.event);
  }
  return events;
}

std::vector<Intervention> random_interventions(int ticks) {
  std::vector<Intervention> interventions;
  std::int64_t at = 0;
  const int count = any(1, 8);
  for (int k = 0; k < count; ++k) {
    at += any(0, 1 + 2 * ticks / count);
    const double factor = *rc::gen::element(0.0, 0.0, 0.01, 0.3, 0.5, 1.0, 1.3, 2.0);
    interventions.push_back({at, factor, *rc::gen::element<std::int64_t>(0, 0, 0, 15, 45, 300)});
  }
  interventions.push_back({at + any(0, 300), 1.0, 0});
  for (const Intervention& each : interventions) {
    RC_LOG() << "tick " << each.tick << " factor " << each.factor << " silent " << each.silence << '\n';
  }
  return interventions;
}

void expect_kept(LiveProgram& live) {
  const referee::Verdict verdict = live.conclude();
  RC_ASSERT(worst_planned(live.plan()) <= 1 + 1e-9);
  RC_ASSERT(worst_judged(verdict) <= 1.001);
  RC_ASSERT(verdict.deviation_mm <= verdict.tolerance_mm + 1e-6);
  RC_ASSERT(verdict.end_error_mm <= 1e-9);
  for (const base::Word& word : live.words) RC_ASSERT(word.feed >= -1e-6);  // never back
}

RC_GTEST_PROP(Overrides, KeepEveryLimitWhateverIsObeyed, ()) {
  machine::Machine machine = random_machine();
  machine.period = {1'000'000};
  std::string text;
  std::optional<std::size_t> ticks;
  for (int blocks = 24; !ticks; blocks = std::max(1, blocks / 2)) {
    text = with_overrides(RandomProgram::make(blocks));
    LiveProgram whole(text, machine);
    if (whole.run({}, most_ticks)) ticks = whole.words.size();
  }
  RC_LOG() << text << limits_of(machine);
  const auto interventions = random_interventions(static_cast<int>(*ticks));
  LiveProgram live(text, machine);
  RC_ASSERT(live.run(interventions, 100 * most_ticks));
  expect_kept(live);
  // Each once and in order, late chunks or not.
  RC_ASSERT(std::vector<base::Event>(live.events.begin(), live.events.end()) == programmed_events(text, machine));
  planner::AllowedOverrides passed;
  for (const base::Event& event : live.events) passed.pass(event);
  RC_ASSERT(live.allowed() == passed);
}

}  // namespace test_overrides
