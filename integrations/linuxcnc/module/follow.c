/* SPDX-License-Identifier: GPL-2.0-only
 *
 * Threads and taps: lines in step with a spindle's place (G33, G76, G33.1), along which feed override and pause do not count. A
 * thread begins at the spindle's index and runs in: behind that, place = revolutions * lead. It ends at rest; one that joins it
 * begins from there and runs in again, without an index. */
#include <math.h>

#include "rtapi.h"
#include "state.h"

/* Revolutions beyond a tap's depth at which it is given up: the spindle does not turn back. */
static const double most_overrun = 10;

static double revolutions_of(const struct entry* entry) {
  const spindle_status_t* spindle = &leadscrew_state.status->spindle_status[entry->spindle];
  return spindle->direction < 0 ? -spindle->spindleRevs : spindle->spindleRevs;
}

/* Where the line has come to, in the configuration's units. */
static void go_to(TP_STRUCT* tp, const struct entry* entry) {
  const struct state* state = &leadscrew_state;
  double start[leadscrew_tp_axes], end[leadscrew_tp_axes];
  position_of(&entry->start, start);
  position_of(&entry->end, end);
  const double share = state->follower.s / state->length;
  if (share == 1) {
    tp->currentPos = entry->end;
    return;
  }
  for (int axis = 0; axis < leadscrew_tp_axes; ++axis) start[axis] += share * (end[axis] - start[axis]);
  pose_of(start, &tp->currentPos);
}

/* Of the axes, along the line. */
static void begin_line(TP_STRUCT* tp, const struct entry* entry) {
  struct state* state = &leadscrew_state;
  const struct leadscrew_tp_limits limits = leadscrew_tp_limits_of(state->planning, &state->limits);
  double start[leadscrew_tp_axes], end[leadscrew_tp_axes], first[leadscrew_tp_axes], last[leadscrew_tp_axes];
  double velocity = HUGE_VAL, acceleration = HUGE_VAL, jerk = HUGE_VAL, square = 0;
  position_of(&entry->start, start);
  position_of(&entry->end, end);
  for (int axis = 0; axis < 3; ++axis) square += (end[axis] - start[axis]) * (end[axis] - start[axis]);
  state->length = sqrt(square);
  /* Where no rotary axis moves, a machine's axes go along lines too. */
  leadscrew_tp_axes_of(state->planning, start, limits.tool, first);
  leadscrew_tp_axes_of(state->planning, end, limits.tool, last);
  for (int axis = 0; axis < leadscrew_tp_axes; ++axis) {
    const double share = fabs(last[axis] - first[axis]) / state->length;
    if (share < 1e-12) continue;
    velocity = fmin(velocity, limits.velocity[axis] / share);
    acceleration = fmin(acceleration, limits.acceleration[axis] / share);
    jerk = fmin(jerk, limits.jerk[axis] / share);
  }
  leadscrew_tp_follower_begin(&state->follower, velocity, acceleration, jerk, tp->cycleTime);
}

/* The spindle's place on the line, mm. */
static double place_of(const struct entry* entry) {
  const struct state* state = &leadscrew_state;
  return (revolutions_of(entry) - state->revolutions) * entry->lead * state->mm;
}

/* True once the thread may begin. */
static int wait_for_index(TP_STRUCT* tp, const struct entry* entry) {
  struct state* state = &leadscrew_state;
  spindle_status_t* spindle = &state->status->spindle_status[entry->spindle];
  if (state->following == following_none) {
    begin_line(tp, entry);
    state->following = following_index;
    if (entry->joins) {
      /* The thread before ended so much behind its beginning. */
      const struct entry* before = entry_of(state->gate - 1);
      double start[leadscrew_tp_axes], end[leadscrew_tp_axes], square = 0;
      position_of(&before->start, start);
      position_of(&before->end, end);
      for (int axis = 0; axis < 3; ++axis) square += (end[axis] - start[axis]) * (end[axis] - start[axis]);
      state->revolutions += sqrt(square) / (entry->lead * state->mm);
      return 1;
    }
    spindle->spindle_index_enable = 1;
    return 0;
  }
  if (spindle->spindle_index_enable) return 0;
  state->revolutions = 0;
  return 1;
}

/* A cycle of a tap's way with the spindle. */
static void turn(TP_STRUCT* tp, const struct entry* entry) {
  struct state* state = &leadscrew_state;
  spindle_status_t* spindle = &state->status->spindle_status[entry->spindle];
  const double s = state->follower.s, now = revolutions_of(entry);
  const int goes_on = now > state->revolutions_before;
  state->revolutions_before = now;
  if (state->following == following_in && s >= state->length) {
    spindle->speed *= -entry->scale;
    state->following = following_back;
  } else if (state->following == following_back && s <= 0) {
    spindle->speed *= -1 / entry->scale;
    state->following = following_turn;
  } else if (state->following == following_turn && goes_on) {
    state->following = following_rest;
  }
  const double overrun = most_overrun * entry->lead * state->mm;
  if (s <= state->length + overrun && s >= -overrun) return;
  rtapi_print_msg(RTAPI_MSG_ERR, "leadscrew_tp: the spindle has not turned back within %g turns of a tap's end\n",
                  most_overrun);
  state->status->motionFlag |= EMCMOT_MOTION_ERROR_BIT;
  tpAbort(tp);
}

int follow(TP_STRUCT* tp, const struct entry* entry) {
  struct state* state = &leadscrew_state;
  int has_ended = 0;
  if (state->following <= following_index) {
    if (!wait_for_index(tp, entry)) return 0;
    state->following = following_in;
    state->revolutions_before = revolutions_of(entry);
  }
  state->status->spindleSync = 1;
  if (entry->kind == thread_move) {
    has_ended = leadscrew_tp_follower_follow(&state->follower, place_of(entry), state->length);
  } else if (state->following == following_rest) {
    if (leadscrew_tp_follower_stop(&state->follower)) state->following = following_return;
  } else if (state->following == following_return) {
    has_ended = leadscrew_tp_follower_go(&state->follower, 0);
  } else {
    leadscrew_tp_follower_follow(&state->follower, place_of(entry), HUGE_VAL);
    turn(tp, entry);
  }
  go_to(tp, entry);
  if (has_ended) {
    state->status->spindleSync = 0;
    state->following = following_none;
  }
  return has_ended;
}

int follow_to_rest(TP_STRUCT* tp, const struct entry* entry) {
  struct state* state = &leadscrew_state;
  state->status->spindle_status[entry->spindle].spindle_index_enable = 0;
  if (state->following > following_index && !leadscrew_tp_follower_stop(&state->follower)) {
    go_to(tp, entry);
    return 0;
  }
  state->status->spindleSync = 0;
  return 1;
}
