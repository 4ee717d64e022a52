/* SPDX-License-Identifier: GPL-2.0-only
 *
 * Moves on their way to Leadscrew, and where motion is set down. */
#include <math.h>
#include <stddef.h>

#include "agreement.h"
#include "motion_types.h"
#include "pins.h"
#include "rtapi.h"
#include "state.h"

/* LinuxCNC 2.10 also gives the greatest jerk along each move: as with velocity and acceleration, that of the axes holds. CMake
 * looks into tp.h. */
#if LEADSCREW_TP_GIVES_JERK
#define LEADSCREW_TP_JERK double ini_maxjerk __attribute__((unused)),
#else
#define LEADSCREW_TP_JERK
#endif

/* Moves in flight beyond which task is told to wait, so that those on their way find room. */
enum { nearly_full = leadscrew_tp_moves - 64 };

void position_of(const EmcPose* pose, double position[leadscrew_tp_axes]) {
  const double mm = leadscrew_state.mm;
  const double values[] = {pose->tran.x * mm, pose->tran.y * mm, pose->tran.z * mm, pose->a,     pose->b,
                           pose->c,           pose->u * mm,      pose->v * mm,      pose->w * mm};
  for (int axis = 0; axis < leadscrew_tp_axes; ++axis) position[axis] = values[axis];
}

void pose_of(const double position[leadscrew_tp_axes], EmcPose* pose) {
  const double mm = leadscrew_state.mm;
  pose->tran.x = position[0] / mm;
  pose->tran.y = position[1] / mm;
  pose->tran.z = position[2] / mm;
  pose->a = position[3];
  pose->b = position[4];
  pose->c = position[5];
  pose->u = position[6] / mm;
  pose->v = position[7] / mm;
  pose->w = position[8] / mm;
}

static struct leadscrew_tp_limits limits_now(void) {
  struct leadscrew_tp_limits limits;
  for (int axis = 0; axis < leadscrew_tp_axes; ++axis) {
    const double mm = axis >= 3 && axis < 6 ? 1 : leadscrew_state.mm;
    limits.velocity[axis] = leadscrew_state.velocity_limit(axis) * mm;
    limits.acceleration[axis] = leadscrew_state.acceleration_limit(axis) * mm;
    limits.jerk[axis] = pins_jerk(axis) * mm;
  }
  const int has_machine = leadscrew_tp_machine_axes(leadscrew_state.planning) != 0;
  limits.tool = has_machine ? leadscrew_state.status->tool_offset.tran.z * leadscrew_state.mm : 0;
  return limits;
}

int limits_changed(void) {
  const struct leadscrew_tp_limits limits = limits_now(), *const before = &leadscrew_state.limits;
  for (int axis = 0; axis < leadscrew_tp_axes; ++axis) {
    if (limits.velocity[axis] != before->velocity[axis] || limits.acceleration[axis] != before->acceleration[axis] ||
        limits.jerk[axis] != before->jerk[axis])
      return 1;
  }
  return limits.tool != before->tool;
}

void set_down(TP_STRUCT* tp) {
  struct state* state = &leadscrew_state;
  double position[leadscrew_tp_axes];
  position_of(&tp->currentPos, position);
  state->limits = limits_now();
  state->added = state->begun = state->passed = state->gate = 0;
  state->gate_cycles = 0;
  state->rests_next = 0;
  state->has_failed = 0;
  state->following = following_none;
  leadscrew_tp_set_down(state->planning, position, &state->limits, llround(tp->cycleTime * 1e9));
  tp->goalPos = tp->currentPos;
  report_rest(tp);
}

void report_rest(TP_STRUCT* tp) {
  emcmot_status_t* status = leadscrew_state.status;
  tp->done = 1;
  tp->depth = tp->activeDepth = 0;
  tp->execId = 0;
  tp->motionType = 0;
  status->current_vel = status->requested_vel = status->distance_to_go = 0;
  status->enables_queued = status->enables_new;
  status->spindleSync = 0;
  ZERO_EMC_POSE(status->dtg);
}

/* As it would be if all moves had ended where motion is. */
int tpClear(TP_STRUCT* const tp) {
  const struct state_tag_t none = {.packed_flags = 0};
  tp->nextId = 0;
  tp->execTag = none;
  tp->termCond = TC_TERM_COND_PARABOLIC;
  tp->tolerance = 0;
  tp->aborting = tp->pausing = tp->reverse_run = 0;
  tp->synchronized = 0;
  tp->uu_per_rev = 0;
  leadscrew_state.status->motionFlag |= EMCMOT_MOTION_INPOS_BIT;
  set_down(tp);
  return tpClearDIOs(tp);
}

static int is_finite(const EmcPose* pose) {
  return isfinite(pose->tran.x + pose->tran.y + pose->tran.z + pose->a + pose->b + pose->c + pose->u + pose->v +
                  pose->w);
}

static int same(const EmcPose* a, const EmcPose* b) {
  return a->tran.x == b->tran.x && a->tran.y == b->tran.y && a->tran.z == b->tran.z && a->a == b->a && a->b == b->b &&
         a->c == b->c && a->u == b->u && a->v == b->v && a->w == b->w;
}

int tpSetPos(TP_STRUCT* const tp, EmcPose const* const pose) {
  if (!tp || !is_finite(pose)) return TP_ERR_FAIL;
  const int stands_there = same(&tp->currentPos, pose) && tp->done && !limits_changed();
  tp->currentPos = *pose;
  if (!stands_there) set_down(tp);
  tp->goalPos = *pose;
  return TP_ERR_OK;
}

/* Also on the way to rest of an abort: what task has to do next waits until motion is set down. */
int tcqFull(TC_QUEUE_STRUCT const* const queue) {
  const TP_STRUCT* tp = (const TP_STRUCT*)((const char*)queue - offsetof(TP_STRUCT, queue));
  return tp->aborting || leadscrew_state.added - leadscrew_state.begun >= nearly_full;
}

static double distance(const EmcPose* a, const EmcPose* b) {
  const double linear =
      sqrt(pow(a->tran.x - b->tran.x, 2) + pow(a->tran.y - b->tran.y, 2) + pow(a->tran.z - b->tran.z, 2));
  if (linear > TP_POS_EPSILON) return linear;
  const double second = sqrt(pow(a->u - b->u, 2) + pow(a->v - b->v, 2) + pow(a->w - b->w, 2));
  return second > TP_POS_EPSILON ? second : sqrt(pow(a->a - b->a, 2) + pow(a->b - b->b, 2) + pow(a->c - b->c, 2));
}

/* Is it a move of rotary axes alone? Their speeds are in degrees. */
static int turns_alone(const EmcPose* start, const EmcPose* end) {
  EmcPose linear = *end;
  linear.a = start->a;
  linear.b = start->b;
  linear.c = start->c;
  return same(&linear, start);
}

/* A thread's or tap's turns are counted along X, Y and Z. */
static int is_thread_without_length(const struct entry* entry) {
  if (entry->kind < thread_move) return 0;
  const double x = entry->end.tran.x - entry->start.tran.x, y = entry->end.tran.y - entry->start.tran.y,
               z = entry->end.tran.z - entry->start.tran.z;
  if (sqrt(x * x + y * y + z * z) >= TP_POS_EPSILON) return 0;
  rtapi_print_msg(RTAPI_MSG_ERR,
                  "leadscrew_tp: a thread or tap (G33, G76, G33.1) that moves neither X, Y nor Z; its lead is along "
                  "these: give one of them\n");
  return 1;
}

/* In step with a spindle, as tpSetSpindleSync has said. */
static void synchronize(const TP_STRUCT* tp, struct entry* entry) {
  const struct state* state = &leadscrew_state;
  const spindle_status_t* spindle = &state->status->spindle_status[tp->spindle.spindle_num];
  entry->spindle = tp->spindle.spindle_num;
  entry->lead = fabs(tp->uu_per_rev);
  entry->start = tp->goalPos;
  if (tp->synchronized == TC_SYNC_VELOCITY) {
    entry->kind = paced_move;
    entry->pace = fabs(spindle->speed) / 60;
    if (entry->pace > 0) entry->speed = entry->pace * entry->lead;
  } else if (tp->synchronized == TC_SYNC_POSITION) {
    const struct entry* before = entry_of(state->added);
    entry->kind = thread_move;
    entry->joins = !tp->done && before->kind == thread_move && before->lead == entry->lead;
    entry->waits_for_speed = 1;
  }
}

/* With kinematics of rotary axes the others would leave their lines, and keep no limits. */
static int is_turning_thread(const struct entry* entry) {
  const EmcPose *start = &entry->start, *end = &entry->end;
  if (entry->kind < thread_move || leadscrew_tp_machine_axes(leadscrew_state.planning) == 0) return 0;
  if (start->a == end->a && start->b == end->b && start->c == end->c) return 0;
  rtapi_print_msg(RTAPI_MSG_ERR,
                  "leadscrew_tp: a thread or tap that moves rotary axes which make the kinematics; set them before it\n");
  return 1;
}

static enum leadscrew_tp_join join_of(int condition) {
  if (condition == TC_TERM_COND_STOP) return leadscrew_tp_stop;
  return condition == TC_TERM_COND_EXACT ? leadscrew_tp_exact : leadscrew_tp_blend;
}

/* The move itself, by what has been set for it. */
static void fill(const TP_STRUCT* tp, struct leadscrew_tp_move* move, const struct entry* entry, double ini_maxvel) {
  const double scale = !move->is_arc && turns_alone(&tp->goalPos, &entry->end) ? 1 : leadscrew_state.mm;
  position_of(&entry->end, move->end);
  move->speed = (entry->speed > 0 ? entry->speed : ini_maxvel) * scale;
  move->join = join_of(tp->termCond);
  move->tolerance = tp->tolerance * leadscrew_state.mm;
  move->group = entry->kind == paced_move ? 2 : entry->motion_type == EMC_MOTION_TYPE_TRAVERSE;
  move->is_followed = entry->kind == thread_move || entry->kind == tap_move;
  move->waits = entry->waits_for_speed || entry->indexer >= 0 || leadscrew_state.rests_next;
}

/* Takes the move on its way. */
static int add(TP_STRUCT* tp, struct leadscrew_tp_move* move, struct entry* entry, double ini_maxvel) {
  struct state* state = &leadscrew_state;
  /* It would be forgotten: where motion has failed, all is; else tcqFull has said to wait. */
  if (tp->aborting) return state->has_failed ? TP_ERR_OK : TP_ERR_FAIL;
  if (state->has_failed || !(ini_maxvel > 0)) return TP_ERR_FAIL;
  if (tp->done && limits_changed()) set_down(tp);
  if (tp->done) kinematics_doubt();
  if (state->added - state->begun >= leadscrew_tp_moves) return TP_ERR_FAIL;
  if (entry->kind == free_move) synchronize(tp, entry);
  if (move->is_arc && entry->kind == thread_move) return TP_ERR_FAIL;
  if (is_thread_without_length(entry) || is_turning_thread(entry)) return TP_ERR_FAIL;
  fill(tp, move, entry, ini_maxvel);
  move->number = state->added + 1;
  entry->id = tp->nextId;
  entry->outputs = tp->syncdio;
  *entry_of(move->number) = *entry;
  if (entry->kind == tap_move) position_of(&entry->start, move->end);
  if (leadscrew_tp_push(state->planning, move) != 0) return TP_ERR_FAIL;
  tpClearDIOs(tp);
  state->added = move->number;
  state->rests_next = entry->indexer >= 0;
  ++tp->nextId;
  if (entry->kind != tap_move) tp->goalPos = entry->end;
  tp->done = 0;
  tp->depth = (int)(state->added - state->begun);
  return TP_ERR_OK;
}

int tpAddLine(TP_STRUCT* const tp, EmcPose end, int canon_motion_type, double vel, double ini_maxvel, double acc,
              LEADSCREW_TP_JERK unsigned char enables, char atspeed, int indexer, struct state_tag_t tag) {
  (void)acc; /* along the line; that of the axes holds */
  if (!tp || !is_finite(&end)) return TP_ERR_FAIL;
  if (distance(&tp->goalPos, &end) < TP_POS_EPSILON) return TP_ERR_ZERO_LENGTH;
  struct leadscrew_tp_move move = {0};
  struct entry entry = {.motion_type = canon_motion_type,
                        .speed = vel,
                        .enables = enables,
                        .waits_for_speed = atspeed,
                        .indexer = indexer,
                        .end = end,
                        .tag = tag};
  return add(tp, &move, &entry, ini_maxvel);
}

int tpAddCircle(TP_STRUCT* const tp, EmcPose end, PmCartesian center, PmCartesian normal, int turn,
                int canon_motion_type, double vel, double ini_maxvel, double acc,
                LEADSCREW_TP_JERK unsigned char enables, char atspeed, struct state_tag_t tag) {
  (void)acc;
  if (!tp || !is_finite(&end)) return TP_ERR_FAIL;
  const double along[] = {normal.z, normal.y, normal.x};
  const double length = sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
  int plane = 0;
  while (plane < 3 && fabs(along[plane]) < (1 - 1e-12) * length) ++plane;
  if (plane == 3 || length == 0) {
    rtapi_print_msg(RTAPI_MSG_ERR, "leadscrew_tp: an arc in a plane that lies along no two axes; write it as lines\n");
    return TP_ERR_GEOM;
  }
  const int counterclockwise = turn >= 0 ? turn + 1 : turn; /* turns begun: 1, 2 ... or -1, -2 ... */
  const double mm = leadscrew_state.mm;
  struct leadscrew_tp_move move = {.is_arc = 1,
                                   .center = {center.x * mm, center.y * mm, center.z * mm},
                                   .plane = plane,
                                   .turns = along[plane] > 0 ? counterclockwise : -counterclockwise};
  struct entry entry = {.motion_type = canon_motion_type,
                        .speed = vel,
                        .enables = enables,
                        .waits_for_speed = atspeed,
                        .indexer = -1,
                        .end = end,
                        .tag = tag};
  return add(tp, &move, &entry, ini_maxvel);
}

/* It ends where it begins. */
int tpAddRigidTap(TP_STRUCT* const tp, EmcPose end, double vel, double ini_maxvel, double acc,
                  LEADSCREW_TP_JERK unsigned char enables, double scale, struct state_tag_t tag) {
  (void)acc;
  if (!tp || !is_finite(&end) || tp->synchronized == TC_SYNC_NONE || !(scale > 0)) return TP_ERR_FAIL;
  if (distance(&tp->goalPos, &end) < TP_POS_EPSILON) return TP_ERR_ZERO_LENGTH;
  const EmcPose start = tp->goalPos;
  struct leadscrew_tp_move move = {0};
  struct entry entry = {.speed = vel,
                        .enables = enables,
                        .waits_for_speed = 1,
                        .indexer = -1,
                        .end = end,
                        .tag = tag,
                        .kind = tap_move,
                        .spindle = tp->spindle.spindle_num,
                        .lead = fabs(tp->uu_per_rev),
                        .scale = scale,
                        .start = start};
  return add(tp, &move, &entry, ini_maxvel);
}
