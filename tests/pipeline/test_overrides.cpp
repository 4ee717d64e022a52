#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "interventions.hpp"
#include "live_program.hpp"
#include "random_programs.hpp"

// Programs that change what of the overrides is obeyed (M48 to M50, M52, M53), overridden, held and kept waiting at any
// instant: still no limit exceeded, never off the path, at rest at the end, and what is obeyed is what the events say
// that motion has passed.

namespace test_overrides {

using namespace leadscrew;
using testing_support::any;
using testing_support::expect_kept;
using testing_support::limits_of;
using testing_support::LiveProgram;
using testing_support::random_interventions;
using testing_support::random_machine;
using testing_support::RandomProgram;

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
  const auto interventions = random_interventions(*ticks);
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
