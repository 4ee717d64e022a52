/* SPDX-License-Identifier: GPL-2.0-only */
#pragma once

/* Looks for the kinematics that motmod calls; before motion, not in the servo thread. */
void kinematics_find(void);
/* How far these and those of the machine's file are known to say the same of joints. */
enum agreement {
  agreement_unknown, /* at some poses; before the first, 0 of them */
  agreement_found,   /* at all, or there is no file */
  agreement_broken,  /* they do not, which was told */
};
/* They are to be compared anew, at 20 poses inside the travel of the file's axes, for pins may have changed. */
void kinematics_doubt(void);
/* In a cycle: compares them at one pose, where they are in doubt. The joints are the file's axes in the order X Y Z A B C U V W. */
enum agreement kinematics_compare(void);
