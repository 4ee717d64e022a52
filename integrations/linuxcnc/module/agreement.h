/* SPDX-License-Identifier: GPL-2.0-only */
#pragma once

/* Looks for the kinematics that motmod calls; before motion, not in the servo thread. */
void kinematics_find(void);
/* Do these and those of the machine's file say the same of joints at 20 poses? What differs is told. Always true without a file.
 * The joints are the file's axes in the order X Y Z A B C U V W. */
int kinematics_agree(void);
