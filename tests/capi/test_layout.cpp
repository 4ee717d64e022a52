#include <gtest/gtest.h>
#include <leadscrew.h>

#include <cstddef>

// What a program that was compiled with an earlier version relies on: sizes may grow at the end, nothing moves.

namespace test_layout {

TEST(Layout, OfErrors) {
  EXPECT_EQ(sizeof(leadscrew_error), 1136U);
  EXPECT_EQ(offsetof(leadscrew_error, size), 0U);
  EXPECT_EQ(offsetof(leadscrew_error, severity), 8U);
  EXPECT_EQ(offsetof(leadscrew_error, line), 16U);
  EXPECT_EQ(offsetof(leadscrew_error, column), 24U);
  EXPECT_EQ(offsetof(leadscrew_error, code), 32U);
  EXPECT_EQ(offsetof(leadscrew_error, message), 80U);
  EXPECT_EQ(offsetof(leadscrew_error, hint), 592U);
  EXPECT_EQ(offsetof(leadscrew_error, file), 848U);  // the first version's end
  EXPECT_EQ(offsetof(leadscrew_error, field), 1104U);
}

TEST(Layout, OfWords) {
  EXPECT_EQ(sizeof(leadscrew_word), 120U);
  EXPECT_EQ(offsetof(leadscrew_word, tick), 0U);
  EXPECT_EQ(offsetof(leadscrew_word, position), 8U);
  EXPECT_EQ(offsetof(leadscrew_word, path_length), 80U);
  EXPECT_EQ(offsetof(leadscrew_word, speed), 88U);
  EXPECT_EQ(offsetof(leadscrew_word, feed), 96U);
  EXPECT_EQ(offsetof(leadscrew_word, line), 104U);
  EXPECT_EQ(offsetof(leadscrew_word, state), 112U);
  EXPECT_EQ(offsetof(leadscrew_word, file), 114U);
  EXPECT_EQ(offsetof(leadscrew_word, visit), 116U);
}

TEST(Layout, OfEvents) {
  EXPECT_EQ(sizeof(leadscrew_event), 72U);
  EXPECT_EQ(offsetof(leadscrew_event, tick), 8U);
  EXPECT_EQ(offsetof(leadscrew_event, path_length), 16U);
  EXPECT_EQ(offsetof(leadscrew_event, value), 24U);
  EXPECT_EQ(offsetof(leadscrew_event, line), 32U);
  EXPECT_EQ(offsetof(leadscrew_event, output), 40U);
  EXPECT_EQ(offsetof(leadscrew_event, waits), 44U);
  EXPECT_EQ(offsetof(leadscrew_event, code), 48U);
  EXPECT_EQ(offsetof(leadscrew_event, file), 56U);  // the first version's end
  EXPECT_EQ(offsetof(leadscrew_event, visit), 60U);
  EXPECT_EQ(offsetof(leadscrew_event, q), 64U);
}

TEST(Layout, OfOptions) {
  EXPECT_EQ(sizeof(leadscrew_options), 200U);
  EXPECT_EQ(offsetof(leadscrew_options, start), 8U);
  EXPECT_EQ(offsetof(leadscrew_options, slice), 80U);
  EXPECT_EQ(offsetof(leadscrew_options, on_event), 88U);
  EXPECT_EQ(offsetof(leadscrew_options, on_diagnostic), 96U);
  EXPECT_EQ(offsetof(leadscrew_options, user), 104U);
  EXPECT_EQ(offsetof(leadscrew_options, file), 112U);
  EXPECT_EQ(offsetof(leadscrew_options, tools), 120U);  // the first version's end
  EXPECT_EQ(offsetof(leadscrew_options, tools_length), 128U);
  EXPECT_EQ(offsetof(leadscrew_options, tools_file), 136U);
  EXPECT_EQ(offsetof(leadscrew_options, on_progress), 144U);
  EXPECT_EQ(offsetof(leadscrew_options, on_subprogram), 152U);
  EXPECT_EQ(offsetof(leadscrew_options, fuel), 160U);
  EXPECT_EQ(offsetof(leadscrew_options, has_probe), 168U);
  EXPECT_EQ(offsetof(leadscrew_options, has_inputs), 172U);
  EXPECT_EQ(offsetof(leadscrew_options, allow_gouging), 176U);
  EXPECT_EQ(offsetof(leadscrew_options, step_rule), 180U);
  EXPECT_EQ(offsetof(leadscrew_options, path_mode), 184U);
  EXPECT_EQ(offsetof(leadscrew_options, has_tolerance), 188U);
  EXPECT_EQ(offsetof(leadscrew_options, tolerance), 192U);
}

TEST(Layout, OfMoves) {
  EXPECT_EQ(sizeof(leadscrew_move), 168U);
  EXPECT_EQ(offsetof(leadscrew_move, kind), 8U);
  EXPECT_EQ(offsetof(leadscrew_move, plane), 12U);
  EXPECT_EQ(offsetof(leadscrew_move, line), 16U);
  EXPECT_EQ(offsetof(leadscrew_move, end), 24U);
  EXPECT_EQ(offsetof(leadscrew_move, feed), 96U);
  EXPECT_EQ(offsetof(leadscrew_move, center), 104U);
  EXPECT_EQ(offsetof(leadscrew_move, turns), 120U);
  EXPECT_EQ(offsetof(leadscrew_move, degree), 124U);
  EXPECT_EQ(offsetof(leadscrew_move, points), 128U);
  EXPECT_EQ(offsetof(leadscrew_move, positions), 136U);
  EXPECT_EQ(offsetof(leadscrew_move, weights), 144U);
  EXPECT_EQ(offsetof(leadscrew_move, knots), 152U);
  EXPECT_EQ(offsetof(leadscrew_move, seconds), 160U);
}

TEST(Layout, OfStates) {
  EXPECT_EQ(sizeof(leadscrew_state), 344U);
  EXPECT_EQ(offsetof(leadscrew_state, position), 8U);
  EXPECT_EQ(offsetof(leadscrew_state, velocity), 80U);
  EXPECT_EQ(offsetof(leadscrew_state, acceleration), 152U);
  EXPECT_EQ(offsetof(leadscrew_state, jerk), 224U);
  EXPECT_EQ(offsetof(leadscrew_state, path_length), 296U);
  EXPECT_EQ(offsetof(leadscrew_state, speed), 304U);
  EXPECT_EQ(offsetof(leadscrew_state, feed), 312U);
  EXPECT_EQ(offsetof(leadscrew_state, line), 320U);
  EXPECT_EQ(offsetof(leadscrew_state, state), 328U);
  EXPECT_EQ(offsetof(leadscrew_state, file), 332U);
  EXPECT_EQ(offsetof(leadscrew_state, visit), 336U);  // the first version's end
}

TEST(Layout, OfPulseTasks) {
  EXPECT_EQ(sizeof(leadscrew_pulse_task), 144U);
  EXPECT_EQ(offsetof(leadscrew_pulse_task, kind), 8U);
  EXPECT_EQ(offsetof(leadscrew_pulse_task, turns), 12U);
  EXPECT_EQ(offsetof(leadscrew_pulse_task, bits), 16U);
  EXPECT_EQ(offsetof(leadscrew_pulse_task, start), 24U);
  EXPECT_EQ(offsetof(leadscrew_pulse_task, end), 40U);
  EXPECT_EQ(offsetof(leadscrew_pulse_task, center), 56U);
  EXPECT_EQ(offsetof(leadscrew_pulse_task, capacity), 72U);
  EXPECT_EQ(offsetof(leadscrew_pulse_task, method), 80U);
  EXPECT_EQ(offsetof(leadscrew_pulse_task, preload), 88U);
  EXPECT_EQ(offsetof(leadscrew_pulse_task, order), 96U);
  EXPECT_EQ(offsetof(leadscrew_pulse_task, tie), 104U);
  EXPECT_EQ(offsetof(leadscrew_pulse_task, semi_axes), 112U);
  EXPECT_EQ(offsetof(leadscrew_pulse_task, is_free), 128U);
  EXPECT_EQ(offsetof(leadscrew_pulse_task, places), 132U);
  EXPECT_EQ(offsetof(leadscrew_pulse_task, accumulation), 136U);  // the second version's end
}

TEST(Layout, OfPulseConventions) {
  EXPECT_EQ(sizeof(leadscrew_pulse_conventions), 176U);
  EXPECT_EQ(offsetof(leadscrew_pulse_conventions, bits), 8U);
  EXPECT_EQ(offsetof(leadscrew_pulse_conventions, capacity), 16U);
  EXPECT_EQ(offsetof(leadscrew_pulse_conventions, clocks_per_blu), 24U);
  EXPECT_EQ(offsetof(leadscrew_pulse_conventions, preload), 32U);
  EXPECT_EQ(offsetof(leadscrew_pulse_conventions, order), 56U);
  EXPECT_EQ(offsetof(leadscrew_pulse_conventions, tie), 80U);
  EXPECT_EQ(offsetof(leadscrew_pulse_conventions, end), 104U);
  EXPECT_EQ(offsetof(leadscrew_pulse_conventions, scale), 136U);
  EXPECT_EQ(offsetof(leadscrew_pulse_conventions, places), 144U);
  EXPECT_EQ(offsetof(leadscrew_pulse_conventions, accumulation), 152U);
}

TEST(Layout, OfPulseFigures) {
  EXPECT_EQ(sizeof(leadscrew_pulse_figures), 96U);
  EXPECT_EQ(offsetof(leadscrew_pulse_figures, clocks), 8U);
  EXPECT_EQ(offsetof(leadscrew_pulse_figures, pulses), 16U);
  EXPECT_EQ(offsetof(leadscrew_pulse_figures, position), 24U);
  EXPECT_EQ(offsetof(leadscrew_pulse_figures, worst), 40U);
  EXPECT_EQ(offsetof(leadscrew_pulse_figures, worst_clock), 56U);
  EXPECT_EQ(offsetof(leadscrew_pulse_figures, error), 64U);
  EXPECT_EQ(offsetof(leadscrew_pulse_figures, max_error), 72U);
  EXPECT_EQ(offsetof(leadscrew_pulse_figures, rms_error), 80U);
  EXPECT_EQ(offsetof(leadscrew_pulse_figures, is_done), 88U);
}

TEST(Layout, OfLimits) {
  EXPECT_EQ(sizeof(leadscrew_limits), 400U);
  EXPECT_EQ(offsetof(leadscrew_limits, least), 8U);
  EXPECT_EQ(offsetof(leadscrew_limits, greatest), 80U);
  EXPECT_EQ(offsetof(leadscrew_limits, velocity), 152U);
  EXPECT_EQ(offsetof(leadscrew_limits, acceleration), 224U);
  EXPECT_EQ(offsetof(leadscrew_limits, jerk), 296U);
  EXPECT_EQ(offsetof(leadscrew_limits, tolerance), 368U);
  EXPECT_EQ(offsetof(leadscrew_limits, chord_error), 376U);
  EXPECT_EQ(offsetof(leadscrew_limits, axes), 384U);
  EXPECT_EQ(offsetof(leadscrew_limits, period), 392U);  // the first version's end
}

TEST(Layout, OfLoops) {
  EXPECT_EQ(sizeof(leadscrew_loop_options), 96U);
  EXPECT_EQ(offsetof(leadscrew_loop_options, controller), 8U);
  EXPECT_EQ(offsetof(leadscrew_loop_options, encoder), 12U);
  EXPECT_EQ(offsetof(leadscrew_loop_options, proportional), 16U);
  EXPECT_EQ(offsetof(leadscrew_loop_options, backlash), 88U);
  EXPECT_EQ(sizeof(leadscrew_followed), 304U);
  EXPECT_EQ(offsetof(leadscrew_followed, position), 16U);
  EXPECT_EQ(offsetof(leadscrew_followed, current), 232U);
  EXPECT_EQ(sizeof(leadscrew_loop_figures), 264U);
  EXPECT_EQ(offsetof(leadscrew_loop_figures, greatest), 16U);
  EXPECT_EQ(offsetof(leadscrew_loop_figures, contour_rms), 256U);
}

TEST(Layout, OfChecked) {
  EXPECT_EQ(sizeof(leadscrew_checked), 176U);
  EXPECT_EQ(offsetof(leadscrew_checked, blocks), 8U);
  EXPECT_EQ(offsetof(leadscrew_checked, moves), 16U);
  EXPECT_EQ(offsetof(leadscrew_checked, bound), 24U);
  EXPECT_EQ(offsetof(leadscrew_checked, least), 32U);
  EXPECT_EQ(offsetof(leadscrew_checked, greatest), 104U);
}

TEST(Layout, OfFigures) {
  EXPECT_EQ(sizeof(leadscrew_figures), 296U);
  EXPECT_EQ(offsetof(leadscrew_figures, time), 8U);
  EXPECT_EQ(offsetof(leadscrew_figures, bound), 16U);
  EXPECT_EQ(offsetof(leadscrew_figures, dwell), 24U);
  EXPECT_EQ(offsetof(leadscrew_figures, length), 32U);
  EXPECT_EQ(offsetof(leadscrew_figures, feed_programmed), 40U);
  EXPECT_EQ(offsetof(leadscrew_figures, tolerance), 48U);
  EXPECT_EQ(offsetof(leadscrew_figures, velocity), 56U);
  EXPECT_EQ(offsetof(leadscrew_figures, acceleration), 128U);
  EXPECT_EQ(offsetof(leadscrew_figures, jerk), 200U);
  EXPECT_EQ(offsetof(leadscrew_figures, words), 272U);
  EXPECT_EQ(offsetof(leadscrew_figures, blocks), 280U);
  EXPECT_EQ(offsetof(leadscrew_figures, moves), 288U);
}

TEST(Layout, OfBlocks) {
  EXPECT_EQ(sizeof(leadscrew_block), 176U);
  EXPECT_EQ(offsetof(leadscrew_block, line), 8U);
  EXPECT_EQ(offsetof(leadscrew_block, file), 16U);
  EXPECT_EQ(offsetof(leadscrew_block, visit), 20U);
  EXPECT_EQ(offsetof(leadscrew_block, begin), 24U);
  EXPECT_EQ(offsetof(leadscrew_block, seconds), 32U);
  EXPECT_EQ(offsetof(leadscrew_block, least_seconds), 40U);
  EXPECT_EQ(offsetof(leadscrew_block, length), 48U);
  EXPECT_EQ(offsetof(leadscrew_block, feed_asked), 56U);
  EXPECT_EQ(offsetof(leadscrew_block, feed_reached), 64U);
  EXPECT_EQ(offsetof(leadscrew_block, middle), 72U);
  EXPECT_EQ(offsetof(leadscrew_block, cause), 144U);
  EXPECT_EQ(offsetof(leadscrew_block, part), 168U);
  EXPECT_EQ(offsetof(leadscrew_block, pass), 172U);
}

TEST(Layout, OfHolds) {
  EXPECT_EQ(sizeof(leadscrew_hold), 16U);
  EXPECT_EQ(offsetof(leadscrew_hold, kind), 8U);
  EXPECT_EQ(offsetof(leadscrew_hold, axis), 12U);
}

TEST(Layout, OfJudgements) {
  EXPECT_EQ(sizeof(leadscrew_judged), 40U);
  EXPECT_EQ(offsetof(leadscrew_judged, distance), 8U);
  EXPECT_EQ(offsetof(leadscrew_judged, tolerance), 16U);
  EXPECT_EQ(offsetof(leadscrew_judged, line), 24U);
  EXPECT_EQ(offsetof(leadscrew_judged, file), 32U);
  EXPECT_EQ(offsetof(leadscrew_judged, visit), 36U);
  EXPECT_EQ(sizeof(leadscrew_verdict), 48U);
  EXPECT_EQ(offsetof(leadscrew_verdict, deviation), 8U);
  EXPECT_EQ(offsetof(leadscrew_verdict, tolerance), 16U);
  EXPECT_EQ(offsetof(leadscrew_verdict, start_error), 24U);
  EXPECT_EQ(offsetof(leadscrew_verdict, end_error), 32U);
  EXPECT_EQ(offsetof(leadscrew_verdict, objections), 40U);
}

TEST(Layout, OfModes) {
  EXPECT_EQ(sizeof(leadscrew_modes), 256U);
  EXPECT_EQ(offsetof(leadscrew_modes, line), 8U);
  EXPECT_EQ(offsetof(leadscrew_modes, file), 16U);
  EXPECT_EQ(offsetof(leadscrew_modes, visit), 20U);
  EXPECT_EQ(offsetof(leadscrew_modes, block), 24U);
  EXPECT_EQ(offsetof(leadscrew_modes, motion), 32U);
  EXPECT_EQ(offsetof(leadscrew_modes, coolant), 120U);
  EXPECT_EQ(offsetof(leadscrew_modes, system), 128U);
  EXPECT_EQ(offsetof(leadscrew_modes, tolerance), 144U);
  EXPECT_EQ(offsetof(leadscrew_modes, feed), 160U);
  EXPECT_EQ(offsetof(leadscrew_modes, offset), 176U);
  EXPECT_EQ(offsetof(leadscrew_modes, tool), 248U);
  EXPECT_EQ(offsetof(leadscrew_modes, selected_tool), 252U);
}

}  // namespace test_layout
