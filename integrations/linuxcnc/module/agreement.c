/* SPDX-License-Identifier: GPL-2.0-only
 *
 * Pins of a kinematics module (points, offsets, the tool's length, directions) may be set wrong, or otherwise than a machine's file
 * has them. Then motion that is planned within the limits of its axes would be another's. So both are asked, whenever motion
 * begins, for pins can be changed at any time: at one pose in each cycle, while its first moves are planned. */
#include "agreement.h"

#include <dlfcn.h>
#include <math.h>

#include "kinematics.h"
#include "rtapi.h"
#include "state.h"

enum { poses = 20 };
static const double most_difference = 1e-6; /* mm or degrees */

static int compared; /* at so many poses */
static int (*inverse)(const struct EmcPose*, double*, const KINEMATICS_INVERSE_FLAGS*, KINEMATICS_FORWARD_FLAGS*);

void kinematics_find(void) {
  inverse = (__typeof__(inverse))dlsym(RTLD_DEFAULT, "kinematicsInverse");
}

/* Pose n, spread over the travel of each axis of the machine's file. */
static void pose_at(int n, double tool, double pose[leadscrew_tp_axes]) {
  static const int primes[leadscrew_tp_axes] = {2, 3, 5, 7, 11, 13, 17, 19, 23}; /* no root of which is whole */
  double shares[leadscrew_tp_axes];
  for (int axis = 0; axis < leadscrew_tp_axes; ++axis) shares[axis] = fmod((n + 1) * sqrt(primes[axis]), 1);
  leadscrew_tp_pose_in_travel(leadscrew_state.planning, shares, tool, pose);
}

static int agree_at(const double place[leadscrew_tp_axes], unsigned axes, double tool) {
  double joints[EMCMOT_MAX_JOINTS] = {0}, own[leadscrew_tp_axes];
  KINEMATICS_INVERSE_FLAGS inverse_flags = 0;
  KINEMATICS_FORWARD_FLAGS forward_flags = 0;
  EmcPose pose;
  pose_of(place, &pose);
  leadscrew_tp_axes_of(leadscrew_state.planning, place, tool, own);
  if (inverse(&pose, joints, &inverse_flags, &forward_flags) != 0) {
    rtapi_print_msg(
        RTAPI_MSG_ERR,
        "leadscrew_tp: their kinematics module has no joints for X%g Y%g Z%g A%g B%g C%g, which lies inside the "
        "travel of the machine's file; make pins and file the same\n",
        place[0], place[1], place[2], place[3], place[4], place[5]);
    return 0;
  }
  for (int axis = 0, joint = 0; axis < leadscrew_tp_axes; ++axis) {
    if (!(axes >> axis & 1)) continue;
    const double theirs = joints[joint] * (axis >= 3 && axis < 6 ? 1 : leadscrew_state.mm);
    if (fabs(theirs - own[axis]) > most_difference) {
      rtapi_print_msg(
          RTAPI_MSG_ERR,
          "leadscrew_tp: kinematics differ: joint %d at X%g Y%g Z%g A%g B%g C%g is %.6f by their module, %.6f by the "
          "machine's file; make pins and file the same\n",
          joint, place[0], place[1], place[2], place[3], place[4], place[5], theirs, own[axis]);
      return 0;
    }
    ++joint;
  }
  return 1;
}

void kinematics_doubt(void) {
  compared = 0;
}

enum agreement kinematics_compare(void) {
  const unsigned axes = leadscrew_tp_machine_axes(leadscrew_state.planning);
  if (axes == 0 || compared == poses) return agreement_found;
  if (!inverse) {
    rtapi_print_msg(RTAPI_MSG_ERR, "leadscrew_tp: there is no kinematics module to compare the machine's file with\n");
    return agreement_broken;
  }
  double pose[leadscrew_tp_axes];
  pose_at(compared, leadscrew_state.limits.tool, pose);
  if (!agree_at(pose, axes, leadscrew_state.limits.tool)) return agreement_broken;
  return ++compared == poses ? agreement_found : agreement_unknown;
}
