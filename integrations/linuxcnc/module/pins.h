/* SPDX-License-Identifier: GPL-2.0-only
 *
 * Pins that tell how planning keeps up:
 *   leadscrew-tp.seconds-ahead  s of motion that are planned and not begun
 *   leadscrew-tp.late           pieces of motion that came after what they continue had been stopped
 *   leadscrew-tp.starvations    ways to rest that were taken because nothing followed
 * and that ask for limits:
 *   leadscrew-tp.x-jerk … w-jerk  limit of jerk of an axis, units/s^3; at first the parameter's. Of motion that begins at rest behind
 *                                 a program, MDI command, jog or abort. What is not above 0 asks for the parameter's. */
#pragma once

#include "planning.h"

/* Makes them; limits of jerk as the parameters have them. 0, or what HAL says against it. */
int pins_create(int component, const double jerk[leadscrew_tp_axes]);
/* Once a period. */
void pins_update(void);
/* The limit of jerk that is asked for, units/s^3. */
double pins_jerk(int axis);
