// Where the fields of leadscrew.h are in WebAssembly, as web/src/engine/layout.ts has them.

#include <cstddef>

#include "leadscrew.h"

static_assert(sizeof(leadscrew_error) == 1136);
static_assert(offsetof(leadscrew_error, code) == 32);
static_assert(offsetof(leadscrew_error, message) == 80);
static_assert(offsetof(leadscrew_error, hint) == 592);
static_assert(offsetof(leadscrew_error, field) == 1104);

static_assert(sizeof(leadscrew_pulse_task) == 128);
static_assert(offsetof(leadscrew_pulse_task, kind) == 4);
static_assert(offsetof(leadscrew_pulse_task, turns) == 8);
static_assert(offsetof(leadscrew_pulse_task, bits) == 12);
static_assert(offsetof(leadscrew_pulse_task, start) == 24);
static_assert(offsetof(leadscrew_pulse_task, end) == 40);
static_assert(offsetof(leadscrew_pulse_task, center) == 56);
static_assert(offsetof(leadscrew_pulse_task, capacity) == 72);
static_assert(offsetof(leadscrew_pulse_task, method) == 80);
static_assert(offsetof(leadscrew_pulse_task, preload) == 84);
static_assert(offsetof(leadscrew_pulse_task, order) == 88);
static_assert(offsetof(leadscrew_pulse_task, tie) == 92);
static_assert(offsetof(leadscrew_pulse_task, semi_axes) == 96);
static_assert(offsetof(leadscrew_pulse_task, is_free) == 112);
static_assert(offsetof(leadscrew_pulse_task, places) == 116);
static_assert(offsetof(leadscrew_pulse_task, accumulation) == 120);

static_assert(sizeof(leadscrew_pulse_conventions) == 176);
static_assert(offsetof(leadscrew_pulse_conventions, bits) == 4);
static_assert(offsetof(leadscrew_pulse_conventions, capacity) == 16);
static_assert(offsetof(leadscrew_pulse_conventions, clocks_per_blu) == 24);
static_assert(offsetof(leadscrew_pulse_conventions, preload) == 32);
static_assert(offsetof(leadscrew_pulse_conventions, order) == 56);
static_assert(offsetof(leadscrew_pulse_conventions, tie) == 80);
static_assert(offsetof(leadscrew_pulse_conventions, end) == 104);
static_assert(offsetof(leadscrew_pulse_conventions, scale) == 136);
static_assert(offsetof(leadscrew_pulse_conventions, places) == 144);
static_assert(offsetof(leadscrew_pulse_conventions, accumulation) == 152);

static_assert(sizeof(leadscrew_pulse_figures) == 96);
static_assert(offsetof(leadscrew_pulse_figures, clocks) == 8);
static_assert(offsetof(leadscrew_pulse_figures, pulses) == 16);
static_assert(offsetof(leadscrew_pulse_figures, position) == 24);
static_assert(offsetof(leadscrew_pulse_figures, worst) == 40);
static_assert(offsetof(leadscrew_pulse_figures, worst_clock) == 56);
static_assert(offsetof(leadscrew_pulse_figures, error) == 64);
static_assert(offsetof(leadscrew_pulse_figures, max_error) == 72);
static_assert(offsetof(leadscrew_pulse_figures, rms_error) == 80);
static_assert(offsetof(leadscrew_pulse_figures, is_done) == 88);

static_assert(offsetof(leadscrew_error, severity) == 4);
static_assert(offsetof(leadscrew_error, line) == 16);
static_assert(offsetof(leadscrew_error, column) == 24);
static_assert(offsetof(leadscrew_error, file) == 848);

static_assert(sizeof(leadscrew_options) == 168);
static_assert(offsetof(leadscrew_options, start) == 8);
static_assert(offsetof(leadscrew_options, on_diagnostic) == 92);
static_assert(offsetof(leadscrew_options, file) == 100);
static_assert(offsetof(leadscrew_options, tools) == 104);
static_assert(offsetof(leadscrew_options, tools_length) == 108);
static_assert(offsetof(leadscrew_options, on_progress) == 116);
static_assert(offsetof(leadscrew_options, user) == 96);
static_assert(offsetof(leadscrew_options, step_rule) == 148);
static_assert(offsetof(leadscrew_options, path_mode) == 152);
static_assert(offsetof(leadscrew_options, has_tolerance) == 156);
static_assert(offsetof(leadscrew_options, tolerance) == 160);

static_assert(sizeof(leadscrew_limits) == 400);
static_assert(offsetof(leadscrew_limits, least) == 8);
static_assert(offsetof(leadscrew_limits, greatest) == 80);
static_assert(offsetof(leadscrew_limits, velocity) == 152);
static_assert(offsetof(leadscrew_limits, acceleration) == 224);
static_assert(offsetof(leadscrew_limits, jerk) == 296);
static_assert(offsetof(leadscrew_limits, tolerance) == 368);
static_assert(offsetof(leadscrew_limits, chord_error) == 376);
static_assert(offsetof(leadscrew_limits, axes) == 384);
static_assert(offsetof(leadscrew_limits, period) == 392);

static_assert(sizeof(leadscrew_word) == 120);
static_assert(offsetof(leadscrew_word, position) == 8);
static_assert(offsetof(leadscrew_word, tick) == 0);
static_assert(offsetof(leadscrew_word, speed) == 88);
static_assert(offsetof(leadscrew_word, feed) == 96);
static_assert(offsetof(leadscrew_word, state) == 112);

static_assert(sizeof(leadscrew_loop_options) == 96);
static_assert(offsetof(leadscrew_loop_options, controller) == 4);
static_assert(offsetof(leadscrew_loop_options, encoder) == 8);
static_assert(offsetof(leadscrew_loop_options, proportional) == 16);
static_assert(offsetof(leadscrew_loop_options, backlash) == 88);

static_assert(sizeof(leadscrew_followed) == 304);
static_assert(offsetof(leadscrew_followed, tick) == 8);
static_assert(offsetof(leadscrew_followed, position) == 16);
static_assert(offsetof(leadscrew_followed, velocity) == 88);
static_assert(offsetof(leadscrew_followed, control) == 160);
static_assert(offsetof(leadscrew_followed, current) == 232);

static_assert(sizeof(leadscrew_loop_figures) == 264);
static_assert(offsetof(leadscrew_loop_figures, periods) == 8);
static_assert(offsetof(leadscrew_loop_figures, greatest) == 16);
static_assert(offsetof(leadscrew_loop_figures, rms) == 88);
static_assert(offsetof(leadscrew_loop_figures, overshoot) == 160);
static_assert(offsetof(leadscrew_loop_figures, feed_greatest) == 232);
static_assert(offsetof(leadscrew_loop_figures, feed_mean) == 240);
static_assert(offsetof(leadscrew_loop_figures, contour) == 248);
static_assert(offsetof(leadscrew_loop_figures, contour_rms) == 256);

static_assert(sizeof(leadscrew_modes) == 256);
static_assert(offsetof(leadscrew_modes, line) == 8);
static_assert(offsetof(leadscrew_modes, block) == 24);
static_assert(offsetof(leadscrew_modes, motion) == 32);
static_assert(offsetof(leadscrew_modes, plane) == 40);
static_assert(offsetof(leadscrew_modes, units) == 48);
static_assert(offsetof(leadscrew_modes, distance) == 56);
static_assert(offsetof(leadscrew_modes, arc_distance) == 64);
static_assert(offsetof(leadscrew_modes, feed_mode) == 72);
static_assert(offsetof(leadscrew_modes, path_mode) == 80);
static_assert(offsetof(leadscrew_modes, retract) == 88);
static_assert(offsetof(leadscrew_modes, compensation) == 96);
static_assert(offsetof(leadscrew_modes, tool_length) == 104);
static_assert(offsetof(leadscrew_modes, spindle) == 112);
static_assert(offsetof(leadscrew_modes, coolant) == 120);
static_assert(offsetof(leadscrew_modes, system) == 128);
static_assert(offsetof(leadscrew_modes, tolerance) == 144);
static_assert(offsetof(leadscrew_modes, naive_cam) == 152);
static_assert(offsetof(leadscrew_modes, feed) == 160);
static_assert(offsetof(leadscrew_modes, spindle_speed) == 168);
static_assert(offsetof(leadscrew_modes, offset) == 176);
static_assert(offsetof(leadscrew_modes, tool) == 248);
static_assert(offsetof(leadscrew_modes, selected_tool) == 252);

static_assert(sizeof(leadscrew_judged) == 40);
static_assert(offsetof(leadscrew_judged, distance) == 8);
static_assert(offsetof(leadscrew_judged, tolerance) == 16);
static_assert(offsetof(leadscrew_judged, line) == 24);

static_assert(sizeof(leadscrew_verdict) == 48);
static_assert(offsetof(leadscrew_verdict, deviation) == 8);
static_assert(offsetof(leadscrew_verdict, tolerance) == 16);
static_assert(offsetof(leadscrew_verdict, start_error) == 24);
static_assert(offsetof(leadscrew_verdict, end_error) == 32);
static_assert(offsetof(leadscrew_verdict, objections) == 40);

static_assert(sizeof(leadscrew_checked) == 176);
static_assert(offsetof(leadscrew_checked, blocks) == 8);
static_assert(offsetof(leadscrew_checked, moves) == 16);
static_assert(offsetof(leadscrew_checked, bound) == 24);
static_assert(offsetof(leadscrew_checked, least) == 32);
static_assert(offsetof(leadscrew_checked, greatest) == 104);

static_assert(sizeof(leadscrew_figures) == 296);
static_assert(offsetof(leadscrew_figures, time) == 8);
static_assert(offsetof(leadscrew_figures, bound) == 16);
static_assert(offsetof(leadscrew_figures, dwell) == 24);
static_assert(offsetof(leadscrew_figures, length) == 32);
static_assert(offsetof(leadscrew_figures, feed_programmed) == 40);
static_assert(offsetof(leadscrew_figures, tolerance) == 48);
static_assert(offsetof(leadscrew_figures, velocity) == 56);
static_assert(offsetof(leadscrew_figures, acceleration) == 128);
static_assert(offsetof(leadscrew_figures, jerk) == 200);
static_assert(offsetof(leadscrew_figures, words) == 272);
static_assert(offsetof(leadscrew_figures, blocks) == 280);
static_assert(offsetof(leadscrew_figures, moves) == 288);

static_assert(sizeof(leadscrew_block) == 176);
static_assert(offsetof(leadscrew_block, line) == 8);
static_assert(offsetof(leadscrew_block, file) == 16);
static_assert(offsetof(leadscrew_block, visit) == 20);
static_assert(offsetof(leadscrew_block, begin) == 24);
static_assert(offsetof(leadscrew_block, seconds) == 32);
static_assert(offsetof(leadscrew_block, least_seconds) == 40);
static_assert(offsetof(leadscrew_block, length) == 48);
static_assert(offsetof(leadscrew_block, feed_asked) == 56);
static_assert(offsetof(leadscrew_block, feed_reached) == 64);
static_assert(offsetof(leadscrew_block, middle) == 72);
static_assert(offsetof(leadscrew_block, cause) == 144);
static_assert(offsetof(leadscrew_block, part) == 168);
static_assert(offsetof(leadscrew_block, pass) == 172);

static_assert(sizeof(leadscrew_pose) == 96);
static_assert(offsetof(leadscrew_pose, tip) == 8);
static_assert(offsetof(leadscrew_pose, direction) == 32);
static_assert(offsetof(leadscrew_pose, pole_angle) == 56);
static_assert(offsetof(leadscrew_pose, offset) == 64);
static_assert(offsetof(leadscrew_pose, tool) == 88);

static_assert(sizeof(leadscrew_hold) == 12);
static_assert(offsetof(leadscrew_hold, kind) == 4);
static_assert(offsetof(leadscrew_hold, axis) == 8);

static_assert(sizeof(leadscrew_tool) == 56);
static_assert(offsetof(leadscrew_tool, number) == 4);
static_assert(offsetof(leadscrew_tool, diameter) == 16);
static_assert(offsetof(leadscrew_tool, corner_radius) == 24);
static_assert(offsetof(leadscrew_tool, length) == 32);
static_assert(offsetof(leadscrew_tool, holder_diameter) == 40);
static_assert(offsetof(leadscrew_tool, holder_length) == 48);

static_assert(sizeof(leadscrew_surface) == 24);
static_assert(offsetof(leadscrew_surface, number) == 4);
static_assert(offsetof(leadscrew_surface, cells) == 12);
static_assert(offsetof(leadscrew_surface, corners) == 16);
static_assert(offsetof(leadscrew_surface, normals) == 20);

static_assert(sizeof(leadscrew_contour) == 32);
static_assert(offsetof(leadscrew_contour, line) == 8);
static_assert(offsetof(leadscrew_contour, count) == 24);
static_assert(offsetof(leadscrew_contour, places) == 28);

static_assert(sizeof(leadscrew_gouge) == 144);
static_assert(offsetof(leadscrew_gouge, line) == 8);
static_assert(offsetof(leadscrew_gouge, part) == 20);
static_assert(offsetof(leadscrew_gouge, pass) == 24);
static_assert(offsetof(leadscrew_gouge, tool_part) == 28);
static_assert(offsetof(leadscrew_gouge, surface) == 32);
static_assert(offsetof(leadscrew_gouge, depth) == 40);
static_assert(offsetof(leadscrew_gouge, clearance) == 48);
static_assert(offsetof(leadscrew_gouge, u) == 56);
static_assert(offsetof(leadscrew_gouge, v) == 64);
static_assert(offsetof(leadscrew_gouge, place) == 72);
static_assert(offsetof(leadscrew_gouge, tip) == 96);
static_assert(offsetof(leadscrew_gouge, direction) == 120);

static_assert(sizeof(leadscrew_state) == 344);
static_assert(offsetof(leadscrew_state, position) == 8);
static_assert(offsetof(leadscrew_state, velocity) == 80);
static_assert(offsetof(leadscrew_state, acceleration) == 152);
static_assert(offsetof(leadscrew_state, jerk) == 224);
static_assert(offsetof(leadscrew_state, path_length) == 296);
static_assert(offsetof(leadscrew_state, speed) == 304);
static_assert(offsetof(leadscrew_state, feed) == 312);
static_assert(offsetof(leadscrew_state, line) == 320);
static_assert(offsetof(leadscrew_state, state) == 328);
static_assert(offsetof(leadscrew_state, file) == 332);
static_assert(offsetof(leadscrew_state, visit) == 336);
