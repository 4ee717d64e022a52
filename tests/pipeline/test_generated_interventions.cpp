#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "generated_programs.hpp"
#include "interventions.hpp"
#include "live_program.hpp"

// Feed override, feed hold, resume and a planner that comes late, at any instant of compensated moves, canned cycles,
// patterns, lathe cycles, loops, subprograms, probing moves and threads: as in all other motion, the same path within its limits.

namespace test_generated_interventions {

using namespace leadscrew;
using testing_support::GeneratedProgram;
using testing_support::LiveProgram;
using Kind = GeneratedProgram::Kind;

void promises_hold(Kind kind) {
  constexpr std::int64_t most_ticks = 8'000;
  machine::Machine machine;
  machine.period = {1'000'000};
  for (std::size_t i = 0; i < 3; ++i) {
    machine.axes[i] = campaign::random_limits(testing_support::rapid_draws, {{30, 500}, {500, 3e4}, {5e3, 3e6}});
  }
  const GeneratedProgram program(kind, machine);
  RC_LOG() << program.text << testing_support::limits_of(machine);
  gcode::ReaderOptions options;
  options.dialect = program.dialect;
  LiveProgram whole(program.text, program.machine, {}, options);
  RC_PRE(whole.run({}, most_ticks));
  RC_ASSERT(whole.diagnostics == 0);
  RC_ASSERT(whole.words.size() > 50u);
  LiveProgram live(program.text, program.machine, {}, options);
  RC_ASSERT(live.run(testing_support::random_interventions(whole.words.size()), 100 * most_ticks));
  testing_support::expect_kept(live);
  RC_ASSERT(live.events.size() == whole.events.size());
  for (std::size_t k = 0; k < live.events.size(); ++k) {
    RC_ASSERT(live.events[k].kind == whole.events[k].kind);
    RC_ASSERT(live.events[k].value == whole.events[k].value);
  }
}

RC_GTEST_PROP(GeneratedMoves, BesideAContourKeepEveryPromise, ()) {
  promises_hold(Kind::compensated);
}
RC_GTEST_PROP(GeneratedMoves, OfCannedCyclesKeepEveryPromise, ()) {
  promises_hold(Kind::cycles);
}
RC_GTEST_PROP(GeneratedMoves, OnPatternsOfHolesKeepEveryPromise, ()) {
  promises_hold(Kind::pattern);
}
RC_GTEST_PROP(GeneratedMoves, OfLatheCyclesKeepEveryPromise, ()) {
  promises_hold(Kind::lathe);
}
RC_GTEST_PROP(GeneratedMoves, OfLoopsAndSubprogramsKeepEveryPromise, ()) {
  promises_hold(Kind::flow);
}
RC_GTEST_PROP(GeneratedMoves, ThatProbeKeepEveryPromise, ()) {
  promises_hold(Kind::probing);
}

RC_GTEST_PROP(GeneratedMoves, OfThreadsKeepEveryPromise, ()) {
  promises_hold(Kind::threads);
}

}  // namespace test_generated_interventions
