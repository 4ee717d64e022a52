/* SPDX-License-Identifier: GPL-2.0-only
 *
 * What the functions that motmod calls keep: the moves in flight, as LinuxCNC wants to be told of them, and what has been
 * asked of Leadscrew. All of it is the servo thread's. */
#pragma once

#include "follower.h"
#include "motion.h"
#include "planning.h"
#include "tp.h"

/* A move that has been pushed and has not ended. */
struct entry {
  int id;
  int motion_type; /* EMC_MOTION_TYPE_... */
  double speed;    /* units/s, as it was asked for */
  unsigned char enables;
  char waits_for_speed; /* of the spindles */
  int indexer;          /* joint that is unlocked for it; -1: none */
  EmcPose end;
  struct state_tag_t tag;
  syncdio_t outputs; /* that are set where it begins */

  enum { free_move, paced_move, thread_move, tap_move } kind; /* in step with a spindle: by its speed; by its place */
  int spindle;
  double lead;   /* units per revolution, of a move in step */
  double pace;   /* revolutions per second for which `speed` holds, of a paced move */
  double scale;  /* of the spindle's speed on a tap's way back */
  int joins;     /* the move before is a thread too: no index is waited for */
  EmcPose start; /* of a thread or tap */
};

/* What becomes of the thread or tap at the gate. */
enum following {
  following_none,
  following_index,  /* waits for the spindle's index */
  following_in,     /* goes with the spindle */
  following_back,   /* of a tap: with the spindle, which has been told to turn back */
  following_turn,   /* of a tap: and to turn on */
  following_rest,   /* of a tap: leaves the spindle */
  following_return, /* of a tap: to where it began */
};

enum { entry_count = 2 * leadscrew_tp_moves };

struct state {
  leadscrew_tp* planning;
  double mm; /* in a unit of length of the configuration */
  emcmot_status_t* status;
  emcmot_config_t* config;
  void (*write_digital)(int, char);
  void (*write_analog)(int, double);
  void (*unlock_rotary)(int, int);
  int (*rotary_is_unlocked)(int);
  double (*velocity_limit)(int);
  double (*acceleration_limit)(int);

  struct entry entries[entry_count]; /* of move n at n % entry_count */
  uint32_t added;                    /* number of the last move that was pushed */
  uint32_t begun;                    /* of the move in motion */
  uint32_t passed;                   /* of the move that was let through the gate last */
  uint32_t gate;                     /* of the move that stands there */
  int gate_cycles;                   /* for so many cycles */
  int indexer;                       /* joint that is unlocked now; -1: none */
  int rests_next;                    /* the next move waits at the gate */
  int has_failed;
  struct leadscrew_tp_limits limits; /* that motion was set down with */

  enum following following;
  struct leadscrew_tp_follower follower; /* in mm */
  double length;                         /* of the line that is followed, mm */
  double revolutions;                    /* of the spindle where the line began, or would have */
  double revolutions_before;             /* in the cycle before */
};

extern struct state leadscrew_state;

/* Of move `number`. */
static inline struct entry* entry_of(uint32_t number) {
  return &leadscrew_state.entries[number % entry_count];
}

/* In mm and degrees. */
void position_of(const EmcPose* pose, double position[leadscrew_tp_axes]);
/* Of such a position. */
void pose_of(const double position[leadscrew_tp_axes], EmcPose* pose);
/* Forgets all moves; motion stands at currentPos. */
void set_down(TP_STRUCT* tp);
/* A cycle of the thread or tap at the gate. True once it has ended. */
int follow(TP_STRUCT* tp, const struct entry* entry);
/* The same, on the way to rest. */
int follow_to_rest(TP_STRUCT* tp, const struct entry* entry);
/* Have the limits of the axes changed since? */
int limits_changed(void);
/* Everything that lies behind the planner's state, as tpRunCycle leaves it where nothing moves. */
void report_rest(TP_STRUCT* tp);
