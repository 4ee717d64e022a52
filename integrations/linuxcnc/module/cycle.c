/* SPDX-License-Identifier: GPL-2.0-only
 *
 * What happens each servo period. */
#include <math.h>

#include "agreement.h"
#include "pins.h"
#include "rtapi.h"
#include "state.h"

int tpPause(TP_STRUCT* const tp) {
  if (!tp) return TP_ERR_FAIL;
  tp->pausing = 1;
  return TP_ERR_OK;
}

int tpResume(TP_STRUCT* const tp) {
  if (!tp) return TP_ERR_FAIL;
  tp->pausing = 0;
  return TP_ERR_OK;
}

int tpAbort(TP_STRUCT* const tp) {
  if (!tp) return TP_ERR_FAIL;
  if (!tp->aborting && !tp->done) tp->aborting = tp->pausing = 1;
  return tpClearDIOs(tp);
}

/* The move by which the feed is scaled: the one in motion, or that which may begin from rest. */
static const struct entry* scaled_entry(void) {
  const struct state* state = &leadscrew_state;
  return entry_of(state->passed > state->begun ? state->passed : state->begun);
}

/* Of the feed, as far as LinuxCNC and Leadscrew allow. */
static double factor_of(const TP_STRUCT* tp) {
  const struct state* state = &leadscrew_state;
  if (tp->pausing || tp->aborting) return 0;
  const double most = state->config->maxFeedScale > 0 ? fmin(2, state->config->maxFeedScale) : 2;
  double scale = state->status->net_feed_scale;
  const struct entry* entry = scaled_entry();
  if (state->passed > 0 && entry->kind == paced_move && entry->pace > 0)
    scale *= fabs(state->status->spindle_status[entry->spindle].spindleSpeedIn) / entry->pace;
  return fmin(fmax(scale, 0), fmax(most, 1));
}

static void set_outputs(const syncdio_t* outputs) {
  const struct state* state = &leadscrew_state;
  if (!outputs->anychanged) return;
  for (int i = 0; i < state->config->numDIO; ++i) {
    if (outputs->dio_mask >> i & 1) state->write_digital(i, outputs->dios[i] > 0);
  }
  for (int i = 0; i < state->config->numAIO; ++i) {
    if (outputs->aio_mask >> i & 1) state->write_analog(i, outputs->aios[i]);
  }
}

/* Motion has come to this move: outputs are set of all that began since. */
static void begin(TP_STRUCT* tp, uint32_t number) {
  struct state* state = &leadscrew_state;
  while (state->begun < number) set_outputs(&entry_of(++state->begun)->outputs);
  if (state->passed > 0) {
    tp->motionType = scaled_entry()->motion_type;
    state->status->enables_queued = scaled_entry()->enables;
    state->status->requested_vel = scaled_entry()->speed;
  }
  if (number == 0) return;
  tp->execId = entry_of(number)->id;
  tp->execTag = entry_of(number)->tag;
}

static int spindles_are_at_speed(void) {
  for (int i = 0; i < leadscrew_state.config->numSpindles; ++i) {
    if (!leadscrew_state.status->spindle_status[i].at_speed) return 0;
  }
  return 1;
}

/* Locks the axis that was unlocked for the move before; true once it is. */
static int lock_indexer(void) {
  struct state* state = &leadscrew_state;
  if (state->indexer < 0) return 1;
  state->unlock_rotary(state->indexer, 0);
  if (state->rotary_is_unlocked(state->indexer)) return 0;
  state->indexer = -1;
  return 1;
}

/* May the move begin? A period must have passed in which motmod scaled the feed as this move is scaled. */
static int may_begin(uint32_t number) {
  struct state* state = &leadscrew_state;
  const struct entry* entry = entry_of(number);
  state->gate_cycles = number == state->gate ? state->gate_cycles + 1 : 0;
  state->gate = number;
  state->status->enables_queued = entry->enables;
  if (state->gate_cycles == 0) return 0;
  if (entry->waits_for_speed && !spindles_are_at_speed()) return 0;
  if (entry->indexer < 0) return lock_indexer();
  state->indexer = entry->indexer;
  state->unlock_rotary(entry->indexer, 1);
  return state->rotary_is_unlocked(entry->indexer);
}

static double length_of(const PmCartesian* v) {
  return sqrt(v->x * v->x + v->y * v->y + v->z * v->z);
}

static void report_motion(TP_STRUCT* tp, const struct leadscrew_tp_word* word) {
  struct state* state = &leadscrew_state;
  emcmot_status_t* status = state->status;
  const EmcPose *end = &entry_of(state->begun)->end, *at = &tp->currentPos;
  tp->depth = (int)(state->added - (state->begun > 0 ? state->begun - 1 : 0));
  tp->activeDepth = 1;
  status->current_vel = word->speed / state->mm;
  if (state->begun == 0) return;
  status->dtg.tran.x = end->tran.x - at->tran.x;
  status->dtg.tran.y = end->tran.y - at->tran.y;
  status->dtg.tran.z = end->tran.z - at->tran.z;
  status->dtg.a = end->a - at->a;
  status->dtg.b = end->b - at->b;
  status->dtg.c = end->c - at->c;
  status->dtg.u = end->u - at->u;
  status->dtg.v = end->v - at->v;
  status->dtg.w = end->w - at->w;
  status->distance_to_go = length_of(&status->dtg.tran);
}

static void end_abort(TP_STRUCT* tp) {
  tp->aborting = tp->pausing = 0;
  tp->synchronized = TC_SYNC_NONE;
  tp->reverse_run = TC_DIR_FORWARD;
  if (leadscrew_state.indexer >= 0) leadscrew_state.unlock_rotary(leadscrew_state.indexer, 0);
  leadscrew_state.indexer = -1;
  set_down(tp);
}

/* A cycle of what stands at the gate. True while nothing else is to be done. */
static int stand_at_gate(TP_STRUCT* tp, uint32_t number) {
  struct state* state = &leadscrew_state;
  const struct entry* entry = entry_of(number);
  tp->motionType = entry->motion_type;
  if (state->following == following_none && !may_begin(number)) return 1;
  if (entry->kind == thread_move || entry->kind == tap_move) {
    begin(tp, number);
    const int has_ended = follow(tp, entry);
    state->status->current_vel = fabs(state->follower.v) / state->mm;
    if (!has_ended) return 1;
    double end[leadscrew_tp_axes];
    position_of(&tp->currentPos, end);
    leadscrew_tp_followed(state->planning, number, end);
  }
  state->passed = number;
  return 1;
}

int tpRunCycle(TP_STRUCT* const tp, long period) {
  (void)period;
  struct state* state = &leadscrew_state;
  if (tp->aborting && state->following != following_none && follow_to_rest(tp, entry_of(state->gate)))
    state->following = following_none;
  const int follows = state->following != following_none;
  struct leadscrew_tp_wishes wishes = {factor_of(tp), tp->vLimit * state->mm, tp->aborting && !follows, state->passed};
  struct leadscrew_tp_word word;
  state->status->tcqlen = state->added - state->begun;
  leadscrew_tp_cycle(state->planning, &wishes, &word);
  pins_update();
  if (tp->done) return TP_ERR_WAITING;
  const int keeps_place =
      follows || (tp->aborting && entry_of(state->gate)->kind >= thread_move && state->gate > state->passed);
  if (!keeps_place) pose_of(word.position, &tp->currentPos);
  const enum agreement agreement = tp->aborting ? agreement_unknown : kinematics_compare();
  if ((word.has_failed || agreement == agreement_broken) && !state->has_failed) {
    state->has_failed = 1;
    state->status->motionFlag |= EMCMOT_MOTION_ERROR_BIT;
    tpAbort(tp);
  }
  if (word.is_aborted) {
    end_abort(tp);
    return TP_ERR_STOPPED;
  }
  const uint32_t number = word.number > word.finished ? word.number : word.finished;
  begin(tp, number);
  report_motion(tp, &word);
  const int may_pass = !tp->aborting && agreement == agreement_found;
  if (word.gate > state->passed && may_pass && stand_at_gate(tp, word.gate)) return TP_ERR_WAITING;
  if (word.finished == state->added && !tp->aborting && lock_indexer()) report_rest(tp);
  return TP_ERR_OK;
}
