/** \file
 * What a trajectory planner of LinuxCNC asks of Leadscrew, in C and without a header of LinuxCNC's.
 *
 *   servo thread                                    thread of planning
 *   leadscrew_tp_push() ───── ring of moves ──────▶ path and motion
 *   leadscrew_tp_cycle() ◀─── ring of chunks ────── 30 to 50 ms ahead
 *
 * Functions said to be the servo thread's neither allocate, lock, wait nor read a clock. All lengths are mm, all angles
 * degrees, all times seconds; positions are in the order X Y Z A B C U V W.
 *
 * Moves are numbered from 1 where motion was set down last, each by one more than the one before. */
#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { leadscrew_tp_axes = 9 };
/** So many moves can wait at most. */
enum { leadscrew_tp_moves = 4096 };

/** Of every axis; one whose velocity or acceleration is 0 is not there. */
struct leadscrew_tp_limits {
  double velocity[leadscrew_tp_axes];     /**< mm/s or degrees/s, ≥ 0 */
  double acceleration[leadscrew_tp_axes]; /**< mm/s² or degrees/s², ≥ 0 */
  double jerk[leadscrew_tp_axes];         /**< mm/s³ or degrees/s³, > 0 */
  double tool;                            /**< its length, mm; of a machine's kinematics */
};

/** What does not change while the module is loaded. */
struct leadscrew_tp_options {
  double tolerance; /**< mm, > 0: of G64 without P */
  double quiet;     /**< s ≥ 0 without a move until motion begins along those there are */
  const char*
      machine; /**< file of a machine with two rotary axes, which tells its kinematics and the axes' limits; NULL: poses are
                          the axes */
  double ahead; /**< s > 0 of motion that are settled ahead, where planning is in time */
};

/** How a move is joined to the next. */
enum leadscrew_tp_join {
  leadscrew_tp_stop,  /**< G61.1: rest at its end */
  leadscrew_tp_exact, /**< G61: on the path */
  leadscrew_tp_blend, /**< G64: within `tolerance` */
};

/** A line or an arc from the end of the move before. */
struct leadscrew_tp_move {
  uint32_t number;               /**< one more than that of the move before */
  int is_arc;                    /**< else a line */
  double end[leadscrew_tp_axes]; /**< mm or degrees */
  double center[3];              /**< of an arc, mm */
  int plane;                     /**< of an arc: 0, 1, 2: its normal is along Z, Y, X */
  int turns;                     /**< of an arc: turns begun, counterclockwise about that axis positive; not 0 */
  double speed;                  /**< mm/s, or degrees/s of rotary axes alone; > 0 */
  enum leadscrew_tp_join join;   /**< with the next */
  double tolerance;              /**< mm; of a blend; 0: that of the options */
  int group;                     /**< motion rests between moves of two groups */
  int waits;                     /**< motion rests before it until leadscrew_tp_wishes::passed says go */
  int is_followed;               /**< it is made by leadscrew_tp_wishes::passed's side; planning goes on from its end */
};

/** What is asked for in this period. */
struct leadscrew_tp_wishes {
  double factor;    /**< of the feed, 0 … 2; 0 holds */
  double top_speed; /**< mm/s ≥ 0, whatever the factor, of moves that are not of rotary axes alone; 0 holds */
  int abort;        /**< motion is to come to rest on the path and end */
  uint32_t passed;  /**< number of the last move in leadscrew_tp_word::gate that may begin, or was followed */
};

/** A period. */
struct leadscrew_tp_word {
  double position[leadscrew_tp_axes]; /**< mm or degrees */
  double speed;                       /**< along the path, mm/s or degrees/s */
  uint32_t number;                    /**< of the move in motion; 0 before the first */
  uint32_t finished;                  /**< motion rests at the end of this move, and of all before; 0: at none yet */
  uint32_t gate;                      /**< of the move that waits for leadscrew_tp_wishes::passed; 0 for none */
  int is_aborted;                     /**< motion that was to be aborted has come to rest */
  int has_failed;                     /**< a move cannot be made: motion comes to rest, and is to be aborted */
};

/** What has happened since it was made. */
struct leadscrew_tp_figures {
  double seconds_ahead; /**< planned and not begun, s */
  int64_t late_chunks;  /**< pieces of motion that came after what they continue had been stopped */
  int64_t starvations;  /**< ways to rest that were taken because nothing followed */
};

typedef struct leadscrew_tp leadscrew_tp;

/** Any thread's: where the axes are at a pose, with a tool so long, mm and degrees. */
void leadscrew_tp_axes_of(const leadscrew_tp* tp, const double pose[leadscrew_tp_axes], double tool,
                          double axes[leadscrew_tp_axes]);
/** Any thread's: the pose, with a tool so long, mm, of the machine's file at which each of its axes stands at this share, 0 … 1, of
 * its travel; 0 of axes that are not there. Without such a file all are 0. */
void leadscrew_tp_pose_in_travel(const leadscrew_tp* tp, const double shares[leadscrew_tp_axes], double tool,
                                 double pose[leadscrew_tp_axes]);
/** Any thread's: which axes there are by the machine's file, as bits from X, 1; 0 without such a file. */
unsigned leadscrew_tp_machine_axes(const leadscrew_tp* tp);
/** Any thread's: the limits in force where these are asked for: with a machine's file those of its axes, with no more jerk than
 * these; without, these. */
struct leadscrew_tp_limits leadscrew_tp_limits_of(const leadscrew_tp* tp, const struct leadscrew_tp_limits* limits);

/** Starts the thread of planning, of no priority. `report` gets a line for each problem, on that thread, and must outlive
 * it. NULL where there is no memory or no thread, or the machine's file has a problem, which is reported. */
leadscrew_tp* leadscrew_tp_create(const struct leadscrew_tp_options* options, void (*report)(const char* message));
/** Ends the thread. The servo thread calls nothing any more. */
void leadscrew_tp_destroy(leadscrew_tp* tp);
/** Any thread's. */
struct leadscrew_tp_figures leadscrew_tp_figures_now(const leadscrew_tp* tp);

/** The servo thread's: sets motion down at rest at `position`; all moves so far are forgotten, and numbers begin from 1.
 * `period_ns`: of the cycle, 10 000 … 20 000 000. */
void leadscrew_tp_set_down(leadscrew_tp* tp, const double position[leadscrew_tp_axes],
                           const struct leadscrew_tp_limits* limits, int64_t period_ns);
/** The servo thread's: the next move. 0, or -1 where there is no room. */
int leadscrew_tp_push(leadscrew_tp* tp, const struct leadscrew_tp_move* move);
/** The servo thread's: it has made the move at the gate itself, which ends at rest at `position`. Then it says so by
 * leadscrew_tp_wishes::passed. */
void leadscrew_tp_followed(leadscrew_tp* tp, uint32_t number, const double position[leadscrew_tp_axes]);
/** The servo thread's, once a period. */
void leadscrew_tp_cycle(leadscrew_tp* tp, const struct leadscrew_tp_wishes* wishes, struct leadscrew_tp_word* word);

#ifdef __cplusplus
}
#endif
