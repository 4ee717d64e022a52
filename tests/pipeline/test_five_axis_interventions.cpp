#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "five_axes.hpp"
#include "interventions.hpp"
#include "live_program.hpp"
#include "random_programs.hpp"

// Feed override, feed hold, resume and a planner that comes late, at any instant of programs of five axes.

namespace test_five_axis_interventions {

using namespace leadscrew;
using testing_support::any;
using testing_support::five_axes;
using testing_support::FiveAxisProgram;
using testing_support::LiveProgram;
using testing_support::TiltedProgram;
using testing_support::tilting_machine;
using testing_support::two_tools;
using testing_support::VectorProgram;

void keep_every_limit(const std::string& text, const machine::Machine& machine) {
  constexpr std::int64_t most_ticks = 6'000;
  RC_LOG() << machine.kinematics << "\n" << text << testing_support::limits_of(machine);
  LiveProgram whole(text, machine, two_tools());
  RC_PRE(whole.run({}, most_ticks));
  RC_PRE(whole.diagnostics == 0);
  const auto interventions = testing_support::random_interventions(whole.words.size());
  LiveProgram live(text, machine, two_tools());
  RC_ASSERT(live.run(interventions, 100 * most_ticks));
  testing_support::expect_kept(live);
}

RC_GTEST_PROP(FiveAxes, KeepEveryLimitWhoeverIntervenes, ()) {
  const machine::Machine machine = five_axes();
  keep_every_limit(FiveAxisProgram(machine).make(any(1, 4)), machine);
}

/// Vectors that are out of reach are diagnosed.
RC_GTEST_PROP(ToolVectors, KeepEveryLimitWhoeverIntervenes, ()) {
  const machine::Machine machine = five_axes();
  VectorProgram program(machine);
  program.make(any(1, 4));
  keep_every_limit(program.text, machine);
}

RC_GTEST_PROP(TiltedPlanes, KeepEveryLimitWhoeverIntervenes, ()) {
  const machine::Machine machine = tilting_machine();
  keep_every_limit(TiltedProgram().make(any(1, 4)), machine);
}

}  // namespace test_five_axis_interventions
