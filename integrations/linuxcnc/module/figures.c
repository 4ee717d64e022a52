/* SPDX-License-Identifier: GPL-2.0-only */
#include "figures.h"

#include "hal.h"
#include "state.h"

static struct pins {
  hal_float_t* seconds_ahead;
  hal_s32_t *late, *starvations;
}* pins;

int figures_create(int component) {
  pins = hal_malloc(sizeof *pins);
  if (!pins) return -1;
  int problem = hal_pin_float_newf(HAL_OUT, &pins->seconds_ahead, component, "leadscrew-tp.seconds-ahead");
  if (!problem) problem = hal_pin_s32_newf(HAL_OUT, &pins->late, component, "leadscrew-tp.late");
  if (!problem) problem = hal_pin_s32_newf(HAL_OUT, &pins->starvations, component, "leadscrew-tp.starvations");
  return problem;
}

void figures_update(void) {
  const struct leadscrew_tp_figures figures = leadscrew_tp_figures_now(leadscrew_state.planning);
  *pins->seconds_ahead = figures.seconds_ahead;
  *pins->late = (hal_s32_t)figures.late_chunks;
  *pins->starvations = (hal_s32_t)figures.starvations;
}
