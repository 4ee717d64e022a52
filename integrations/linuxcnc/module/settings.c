/* SPDX-License-Identifier: GPL-2.0-only
 *
 * Functions that motmod calls to set what holds for the moves that follow, and to ask what it is told each period. */
#include "agreement.h"
#include "rtapi.h"
#include "state.h"

void tpMotFunctions(void (*write_digital)(int, char), void (*write_analog)(int, double),
                    void (*unlock_rotary)(int, int), int (*rotary_is_unlocked)(int), double (*velocity_limit)(int),
                    double (*acceleration_limit)(int)) {
  struct state* state = &leadscrew_state;
  state->write_digital = write_digital;
  state->write_analog = write_analog;
  state->unlock_rotary = unlock_rotary;
  state->rotary_is_unlocked = rotary_is_unlocked;
  state->velocity_limit = velocity_limit;
  state->acceleration_limit = acceleration_limit;
}

void tpMotData(emcmot_status_t* status, emcmot_config_t* config) {
  leadscrew_state.status = status;
  leadscrew_state.config = config;
}

int tpCreate(TP_STRUCT* const tp, int queue_size, int id) {
  (void)queue_size;
  (void)id;
  if (!tp || !leadscrew_state.planning || !leadscrew_state.status) return TP_ERR_FAIL;
  tp->spindle.waiting_for_index = MOTION_INVALID_ID;
  tp->spindle.waiting_for_atspeed = MOTION_INVALID_ID;
  leadscrew_state.indexer = -1;
  kinematics_find();
  ZERO_EMC_POSE(tp->currentPos);
  return tpClear(tp);
}

int tpSetCycleTime(TP_STRUCT* const tp, double seconds) {
  if (!tp || seconds <= 0) return TP_ERR_FAIL;
  tp->cycleTime = seconds;
  return TP_ERR_OK;
}

int tpSetVmax(TP_STRUCT* const tp, double velocity, double ini_maxvel) {
  if (!tp || velocity <= 0 || ini_maxvel <= 0) return TP_ERR_FAIL;
  tp->vMax = velocity;
  tp->ini_maxvel = ini_maxvel;
  return TP_ERR_OK;
}

int tpSetVlimit(TP_STRUCT* const tp, double limit) {
  if (!tp) return TP_ERR_FAIL;
  tp->vLimit = limit > 0 ? limit : 0;
  return TP_ERR_OK;
}

int tpSetAmax(TP_STRUCT* const tp, double acceleration) {
  if (!tp || acceleration <= 0) return TP_ERR_FAIL;
  tp->aMax = acceleration;
  return TP_ERR_OK;
}

int tpSetId(TP_STRUCT* const tp, int id) {
  if (!tp || !MOTION_ID_VALID(id)) return TP_ERR_FAIL;
  tp->nextId = id;
  return TP_ERR_OK;
}

int tpSetTermCond(TP_STRUCT* const tp, int condition, double tolerance) {
  if (!tp || condition < TC_TERM_COND_STOP || condition > TC_TERM_COND_TANGENT) return TP_ERR_FAIL;
  tp->termCond = condition;
  tp->tolerance = tolerance;
  return TP_ERR_OK;
}

int tpSetSpindleSync(TP_STRUCT* const tp, int spindle, double units_per_revolution, int by_velocity) {
  if (!tp) return TP_ERR_FAIL;
  tp->synchronized = units_per_revolution == 0 ? TC_SYNC_NONE : by_velocity ? TC_SYNC_VELOCITY : TC_SYNC_POSITION;
  if (tp->synchronized == TC_SYNC_NONE) return TP_ERR_OK;
  tp->uu_per_rev = units_per_revolution;
  tp->spindle.spindle_num = spindle;
  return TP_ERR_OK;
}

/* Motion goes forward alone. */
int tpSetRunDir(TP_STRUCT* const tp, tc_direction_t direction) {
  return tp && direction == TC_DIR_FORWARD ? TP_ERR_OK : TP_ERR_FAIL;
}

int tpClearDIOs(TP_STRUCT* const tp) {
  const syncdio_t none = {0};
  tp->syncdio = none;
  return TP_ERR_OK;
}

int tpSetAout(TP_STRUCT* const tp, unsigned char index, double start, double end) {
  (void)end;
  if (!tp || index >= EMCMOT_MAX_AIO) return TP_ERR_FAIL;
  tp->syncdio.anychanged = 1;
  tp->syncdio.aio_mask |= (iomask_t)1 << index;
  tp->syncdio.aios[index] = start;
  return TP_ERR_OK;
}

int tpSetDout(TP_STRUCT* const tp, int index, unsigned char start, unsigned char end) {
  (void)end;
  if (!tp || index < 0 || index >= EMCMOT_MAX_DIO) return TP_ERR_FAIL;
  tp->syncdio.anychanged = 1;
  tp->syncdio.dio_mask |= (iomask_t)1 << index;
  tp->syncdio.dios[index] = start > 0 ? 1 : -1;
  return TP_ERR_OK;
}

int tpGetPos(TP_STRUCT const* const tp, EmcPose* const pose) {
  if (!tp) {
    ZERO_EMC_POSE((*pose));
    return TP_ERR_FAIL;
  }
  *pose = tp->currentPos;
  return TP_ERR_OK;
}

struct state_tag_t tpGetExecTag(TP_STRUCT* const tp) {
  const struct state_tag_t none = {.packed_flags = 0};
  return tp ? tp->execTag : none;
}

int tpGetExecId(TP_STRUCT* const tp) {
  return tp ? tp->execId : TP_ERR_FAIL;
}
int tpGetMotionType(TP_STRUCT* const tp) {
  return tp->motionType;
}
int tpIsDone(TP_STRUCT* const tp) {
  return tp ? tp->done : TP_ERR_OK;
}
int tpQueueDepth(TP_STRUCT* const tp) {
  return tp ? tp->depth : TP_ERR_OK;
}
int tpActiveDepth(TP_STRUCT* const tp) {
  return tp ? tp->activeDepth : TP_ERR_OK;
}
