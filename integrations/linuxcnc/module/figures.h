/* SPDX-License-Identifier: GPL-2.0-only
 *
 * Pins that tell how planning keeps up:
 *   leadscrew-tp.seconds-ahead  s of motion that are planned and not begun
 *   leadscrew-tp.late           pieces of motion that came after what they continue had been stopped
 *   leadscrew-tp.starvations    ways to rest that were taken because nothing followed */
#pragma once

/* Makes them. 0, or what HAL says against it. */
int figures_create(int component);
/* Once a period. */
void figures_update(void);
