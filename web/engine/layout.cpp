// Where the fields of leadscrew.h are in WebAssembly, as web/src/engine/layout.ts has them.

#include <cstddef>

#include "leadscrew.h"

static_assert(sizeof(leadscrew_error) == 1136);
static_assert(offsetof(leadscrew_error, code) == 32);
static_assert(offsetof(leadscrew_error, message) == 80);
static_assert(offsetof(leadscrew_error, hint) == 592);
static_assert(offsetof(leadscrew_error, field) == 1104);

static_assert(sizeof(leadscrew_pulse_task) == 96);
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

static_assert(sizeof(leadscrew_pulse_conventions) == 136);
static_assert(offsetof(leadscrew_pulse_conventions, bits) == 4);
static_assert(offsetof(leadscrew_pulse_conventions, capacity) == 16);
static_assert(offsetof(leadscrew_pulse_conventions, clocks_per_blu) == 24);
static_assert(offsetof(leadscrew_pulse_conventions, preload) == 32);
static_assert(offsetof(leadscrew_pulse_conventions, order) == 56);
static_assert(offsetof(leadscrew_pulse_conventions, tie) == 80);
static_assert(offsetof(leadscrew_pulse_conventions, end) == 104);

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
