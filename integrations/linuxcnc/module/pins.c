/* SPDX-License-Identifier: GPL-2.0-only */
#include "pins.h"

#include <math.h>

#include "hal.h"
#include "state.h"

static struct pins {
  hal_float_t* seconds_ahead;
  hal_s32_t *late, *starvations;
  hal_float_t* jerk[leadscrew_tp_axes];
}* pins;
static double first_jerk[leadscrew_tp_axes];

int pins_create(int component, const double jerk[leadscrew_tp_axes]) {
  pins = hal_malloc(sizeof *pins);
  if (!pins) return -1;
  int problem = hal_pin_float_newf(HAL_OUT, &pins->seconds_ahead, component, "leadscrew-tp.seconds-ahead");
  if (!problem) problem = hal_pin_s32_newf(HAL_OUT, &pins->late, component, "leadscrew-tp.late");
  if (!problem) problem = hal_pin_s32_newf(HAL_OUT, &pins->starvations, component, "leadscrew-tp.starvations");
  for (int axis = 0; axis < leadscrew_tp_axes && !problem; ++axis) {
    problem = hal_pin_float_newf(HAL_IN, &pins->jerk[axis], component, "leadscrew-tp.%c-jerk", "xyzabcuvw"[axis]);
    if (!problem) *pins->jerk[axis] = first_jerk[axis] = jerk[axis];
  }
  return problem;
}

void pins_update(void) {
  const struct leadscrew_tp_figures figures = leadscrew_tp_figures_now(leadscrew_state.planning);
  *pins->seconds_ahead = figures.seconds_ahead;
  *pins->late = (hal_s32_t)figures.late_chunks;
  *pins->starvations = (hal_s32_t)figures.starvations;
}

double pins_jerk(int axis) {
  const double asked = *pins->jerk[axis];
  return asked > 0 && isfinite(asked) ? asked : first_jerk[axis];
}
