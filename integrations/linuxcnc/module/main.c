/* SPDX-License-Identifier: GPL-2.0-only
 *
 * The module: loadrt leadscrew_tp jerk=20000. It is loaded before motmod, which looks for the functions of tp.c. */
#include <malloc.h>
#include <stdlib.h>
#include <string.h>

#include "hal.h"
#include "pins.h"
#include "rtapi.h"
#include "rtapi_app.h"
#include "state.h"

MODULE_LICENSE("GPL");
MODULE_DESCRIPTION("Trajectory planner with limits of jerk, by Leadscrew");

static char* jerk = NULL;
RTAPI_MP_STRING(jerk,
                "limit of jerk, units/s^3: of linear axes; or of linear,rotary axes; or of all of X,Y,Z,A,B,C,U,V,W")
static char* tolerance = NULL;
RTAPI_MP_STRING(tolerance, "units: of G64 without P; 0.01 mm if not given")
static char* machine = NULL;
RTAPI_MP_STRING(machine,
                "file of a machine with two rotary axes, whose kinematics are those of the module that motmod calls")
static int quiet_ms = 100;
RTAPI_MP_INT(quiet_ms, "milliseconds without a move until motion begins along those there are")
static int ahead_ms = 40;
RTAPI_MP_INT(ahead_ms, "milliseconds of motion that are settled ahead, where planning is in time")
static int inch = 0;
RTAPI_MP_INT(inch, "1 where [TRAJ]LINEAR_UNITS is inch")

struct state leadscrew_state;
static int component = -1;

static void report(const char* message) {
  rtapi_print_msg(RTAPI_MSG_ERR, "leadscrew_tp: %s\n", message);
}

/* Numbers with commas between; how many there are, -1 where one is not above 0. */
static int numbers_of(const char* text, double numbers[leadscrew_tp_axes]) {
  for (int count = 0; text && count < leadscrew_tp_axes;) {
    char* end;
    numbers[count] = strtod(text, &end);
    if (end == text || !(numbers[count] > 0)) return -1;
    ++count;
    if (*end == 0) return count;
    if (*end != ',') return -1;
    text = end + 1;
  }
  return -1;
}

/* Of the module's parameters; 0 where they are sound. */
static int read_options(struct leadscrew_tp_options* options, double limits[leadscrew_tp_axes], double mm) {
  double given[leadscrew_tp_axes];
  const int count = numbers_of(jerk, given);
  if (count != 1 && count != 2 && count != leadscrew_tp_axes) {
    rtapi_print_msg(RTAPI_MSG_ERR, "leadscrew_tp: jerk=%s; give 1, 2 or 9 numbers above 0, such as jerk=20000,100000\n",
                    jerk ? jerk : "");
    return -1;
  }
  for (int axis = 0; axis < leadscrew_tp_axes; ++axis) {
    const int rotary = axis >= 3 && axis < 6;
    limits[axis] = count == leadscrew_tp_axes ? given[axis] : given[rotary && count == 2];
  }
  options->tolerance = 0.01;
  if (tolerance) {
    if (numbers_of(tolerance, given) != 1) {
      rtapi_print_msg(RTAPI_MSG_ERR, "leadscrew_tp: tolerance=%s; give a number above 0\n", tolerance);
      return -1;
    }
    options->tolerance = given[0] * mm;
  }
  if (quiet_ms < 0 || ahead_ms < 10 || ahead_ms > 1000) {
    rtapi_print_msg(RTAPI_MSG_ERR, "leadscrew_tp: quiet_ms=%d ahead_ms=%d; 0 or more, and 10 to 1000\n", quiet_ms,
                    ahead_ms);
    return -1;
  }
  options->machine = machine;
  options->quiet = 1e-3 * quiet_ms;
  options->ahead = 1e-3 * ahead_ms;
  return 0;
}

int rtapi_app_main(void) {
  struct leadscrew_tp_options options;
  double limits[leadscrew_tp_axes];
  leadscrew_state.mm = inch ? 25.4 : 1;
  if (read_options(&options, limits, leadscrew_state.mm) != 0) return -1;
#ifdef __GLIBC__
  /* The thread of planning shares the heap that rtapi_app never gives back: one of its own would grow and shrink, and each change
   * of this process' pages interrupts the servo thread on its processor. */
  mallopt(M_ARENA_MAX, 1);
#endif
  /* So that the system gives this memory now, not to the servo thread, where it is not locked. */
  memset(leadscrew_state.entries, 0, sizeof leadscrew_state.entries);
  component = hal_init("leadscrew_tp");
  if (component < 0) return component;
  if (pins_create(component, limits) != 0 || !(leadscrew_state.planning = leadscrew_tp_create(&options, report))) {
    report("there is no memory or no thread");
    hal_exit(component);
    return -1;
  }
  hal_ready(component);
  return 0;
}

void rtapi_app_exit(void) {
  leadscrew_tp_destroy(leadscrew_state.planning);
  leadscrew_state.planning = NULL;
  hal_exit(component);
}
