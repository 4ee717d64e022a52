/** \file
 * Leadscrew for C, and for whatever calls C: part programs or moves in, reference words out.
 *
 *   leadscrew_machine *machine;  leadscrew_motion *motion;  leadscrew_error error = {sizeof error};
 *   if (leadscrew_machine_builtin("mill3", &machine, &error)) …
 *   if (leadscrew_motion_of_program(machine, text, length, NULL, &motion, &error)) …
 *   while (!leadscrew_motion_next(motion, words, sizeof *words, 1000, &count, &error) && count > 0) …
 *   leadscrew_motion_free(motion);  leadscrew_machine_free(machine);
 *
 * or all of it planned at once, leadscrew_motion_plan(): its duration, and where its axes are at any time; or where slides
 * are whose simulated loops follow words, leadscrew_loops_follow(); or how far words are from their program,
 * leadscrew_referee_observe(); or one line or arc by an interpolator of reference pulses, every register to be seen at every clock: leadscrew_pulses_load().
 *
 * Lengths are mm, angles degrees, times seconds. Axes stand in the order X Y Z A B C U V W.
 *
 * Every function that can fail returns 0, or a code below; then nothing else has changed, and `error`, unless it is NULL,
 * says what was found. Structures begin with their size, `sizeof` as the caller was compiled with. One of an earlier
 * version is shorter: what it lacks counts as 0. One of a later version is longer, and is understood as long as what this
 * version does not know of it is 0; of a longer structure that is filled, only the known part is. Handles are used by one
 * thread at a time, and not by the functions that they call; a machine and a trajectory never change and may be shared. A
 * NULL handle or pointer, where it is not said that it may be NULL, is LEADSCREW_MISUSE, and so is a size that no version
 * had. Functions that are called must not throw. Text is UTF-8.
 */
#ifndef LEADSCREW_H
#define LEADSCREW_H

#include "leadscrew_base.h"
#include "leadscrew_loops.h"
#include "leadscrew_modes.h"
#include "leadscrew_pulses.h"
#include "leadscrew_referee.h"
#include "leadscrew_surfaces.h"

#ifdef __cplusplus
extern "C" {
#endif

/* C has its own style of names, and its enumerations are int. NOLINTBEGIN(readability-identifier-naming,performance-enum-size) */

/** Planes of arcs. */
enum { LEADSCREW_XY = 0, LEADSCREW_ZX = 1, LEADSCREW_YZ = 2 };

/** From where the move before ends. Fields that a kind does not name are not read. */
typedef struct leadscrew_move {
  size_t size;                /**< of this structure, sizeof */
  int32_t kind;               /**< LEADSCREW_LINE … LEADSCREW_DWELL */
  int32_t plane;              /**< of an arc: LEADSCREW_XY … LEADSCREW_YZ */
  int64_t line;               /**< words along it have this number; >= 0 */
  double end[LEADSCREW_AXES]; /**< of a line or an arc */
  double feed;                /**< mm/s, > 0; HUGE_VAL: as fast as the axes allow */
  double center[2];           /**< of an arc, along the first and second axis of its plane */
  int32_t turns;              /**< of an arc: 1 counterclockwise, -1 clockwise; 2, -2, … a whole turn more */
  int32_t degree;             /**< of a curve, 1 … 5 */
  size_t points;              /**< of a curve: how many control points; the first is where the move before ends */
  const double* positions;    /**< points * LEADSCREW_AXES */
  const double* weights;      /**< points; NULL: all 1 */
  const double* knots;        /**< points + degree + 1; NULL: uniform, clamped */
  double seconds;             /**< of a dwell, 0 … 1e6 */
} leadscrew_move;

/** Why leadscrew_motion_next() gave less than it was asked for. */
enum {
  LEADSCREW_MOVING = 0,
  LEADSCREW_WANTS_MOVES = 1,
  LEADSCREW_HELD = 2,
  LEADSCREW_ENDED = 3,
  LEADSCREW_WANTS_INPUT = 4
};

/** What a probing move looks for: contact, or its loss. */
enum { LEADSCREW_NO_PROBING = 0, LEADSCREW_CONTACT = 1, LEADSCREW_LOSS = 2 };

/** Axes at one instant, mm or degrees and seconds. Where acceleration or jerk step, the value behind the step. */
typedef struct leadscrew_state {
  size_t size;                         /**< of this structure, sizeof */
  double position[LEADSCREW_AXES];     /**< mm or degrees */
  double velocity[LEADSCREW_AXES];     /**< the same per s */
  double acceleration[LEADSCREW_AXES]; /**< per s2 */
  double jerk[LEADSCREW_AXES];         /**< per s3 */
  double path_length;                  /**< this and what follows: as in a word */
  double speed;                        /**< along the path */
  double feed;                         /**< by the axes that feed is counted by */
  int64_t line;                        /**< of the program, or of the move */
  int32_t state;                       /**< 0 at rest, 1 speed changes, 2 speed is constant */
  int32_t file;                        /**< as a word's */
  int32_t visit;                       /**< as a word's */
  int32_t reserved;                    /**< 0 */
} leadscrew_state;

/** Of a machine. Axes that it lacks have 0. */
typedef struct leadscrew_limits {
  size_t size;                         /**< of this structure, sizeof */
  double least[LEADSCREW_AXES];        /**< of travel, machine coordinates, mm or degrees */
  double greatest[LEADSCREW_AXES];     /**< the same; greater */
  double velocity[LEADSCREW_AXES];     /**< mm/s or degrees/s; > 0 */
  double acceleration[LEADSCREW_AXES]; /**< per s2; > 0 */
  double jerk[LEADSCREW_AXES];         /**< per s3; > 0 */
  double tolerance;                    /**< of G64 without P, mm; >= 0 */
  double chord_error;                  /**< between words, mm; > 0 */
  int32_t axes;                        /**< that it has: 1 << 0 for X and so on, together */
  int32_t reserved;                    /**< 0 */
  /* Here the limits of the first version ended. */
  double period; /**< of the servo, s, 10e-6 … 20e-3, rounded to a nanosecond; 0 of limits that are given: stays */
} leadscrew_limits;

/** Of a program that was read and not moved. */
typedef struct leadscrew_checked {
  size_t size;                     /**< of this structure, sizeof */
  int64_t blocks;                  /**< lines that hold at least one word */
  int64_t moves;                   /**< lines, arcs and curves */
  double bound;                    /**< s, at least: as leadscrew_figures.bound */
  double least[LEADSCREW_AXES];    /**< coordinates of the path, its start included, mm or degrees */
  double greatest[LEADSCREW_AXES]; /**< the same */
} leadscrew_checked;

/** Of all of a motion. */
typedef struct leadscrew_figures {
  size_t size;                         /**< of this structure, sizeof */
  double time;                         /**< of its last word, s */
  double bound;                        /**< the least that this path takes within velocity, acceleration and feed, s */
  double dwell;                        /**< of it at rest as G4 asks, s */
  double length;                       /**< as path_length of the last word */
  double feed_programmed;              /**< the greatest, mm/s; 0 where there are only rapids */
  double tolerance;                    /**< the largest that applied, mm */
  double velocity[LEADSCREW_AXES];     /**< the plan's greatest over the limit of the axis, from its polynomials */
  double acceleration[LEADSCREW_AXES]; /**< the same */
  double jerk[LEADSCREW_AXES];         /**< the same */
  int64_t words;                       /**< behind the first, which is at rest at time 0 */
  int64_t blocks;                      /**< read, of a program */
  int64_t moves;                       /**< travelled: lines, arcs and curves */
} leadscrew_figures;

/** What one move of a block took, and what it waited for. */
typedef struct leadscrew_block {
  size_t size;                   /**< of this structure, sizeof */
  int64_t line;                  /**< of the program, or of the move */
  int32_t file;                  /**< as a word's */
  int32_t visit;                 /**< as a word's */
  double begin;                  /**< s, of the motion */
  double seconds;                /**< that it took */
  double least_seconds;          /**< at the feed asked for; of a rapid, at the velocity of its axes */
  double length;                 /**< travelled, as feed is counted */
  double feed_asked;             /**< mm/s or degrees/s; HUGE_VAL of a rapid; 0 of a dwell */
  double feed_reached;           /**< the greatest */
  double middle[LEADSCREW_AXES]; /**< halfway along it */
  char cause[24]; /**< of most of the difference: "acceleration X", "jerk Z", "velocity Y", "chord", "stop", "dwell" */
  /* Here the block of the first version ended. */
  int32_t part; /**< of a surface that is machined: LEADSCREW_NO_SURFACE … LEADSCREW_RETRACT */
  int32_t pass; /**< number of the pass, from 0; of a link, that of the pass before it */
} leadscrew_block;

/** Called once for each block, in order. */
typedef void (*leadscrew_block_function)(const leadscrew_block* block, void* user);

/** Where a tool is, in the workpiece as it lies with all rotary axes at 0. */
typedef struct leadscrew_pose {
  size_t size;   /**< of this structure, sizeof */
  double tip[3]; /**< mm */
  double direction
      [3]; /**< a unit vector, from the tip to the spindle; 0 0 1 of a machine without a chain of rotary axes */
  double
      pole_angle; /**< degrees between the direction and the nearest at which the first rotary axis may stand anywhere;
                          HUGE_VAL: there is none */
  double offset[3]; /**< of the tool, as the program has it in force, mm */
  int32_t tool;     /**< number of the tool in the spindle; 0: the program has changed none in */
  int32_t reserved; /**< 0 */
} leadscrew_pose;

/** Kinds of leadscrew_hold. */
enum {
  LEADSCREW_HELD_BY_FEED = 0,         /**< it has the feed that is asked for */
  LEADSCREW_HELD_BY_VELOCITY = 1,     /**< an axis is at 97 % of its limit or above */
  LEADSCREW_HELD_BY_ACCELERATION = 2, /**< the same of acceleration, of several the first axis */
  LEADSCREW_HELD_BY_JERK = 3,         /**< the same of jerk */
  LEADSCREW_HELD_AT_REST = 4,         /**< it stands still */
  LEADSCREW_HELD_BY_WHAT_COMES = 5,   /**< none of the others: it makes ready for what follows */
  LEADSCREW_HELD_BY_CHORD = 6         /**< the chord error between words */
};
/** By what motion is held at an instant. */
typedef struct leadscrew_hold {
  size_t size;  /**< of this structure, sizeof */
  int32_t kind; /**< LEADSCREW_HELD_... */
  int32_t axis; /**< 0 for X ... 8 for W, of velocity, acceleration and jerk; else 0 */
} leadscrew_hold;

/** Such as "0.1.0". */
LEADSCREW_API const char* leadscrew_version(void);

/** The only built-in machine is "mill3". */
LEADSCREW_API int leadscrew_machine_builtin(const char* name, leadscrew_machine** machine, leadscrew_error* error);
/** Of a machine file's text: TOML, as `leadscrew run --machine` reads it. */
LEADSCREW_API int leadscrew_machine_of_text(const char* text, size_t length, leadscrew_machine** machine,
                                            leadscrew_error* error);
/** The same of the file at a path. */
LEADSCREW_API int leadscrew_machine_of_file(const char* path, leadscrew_machine** machine, leadscrew_error* error);
/** The servo period, s; 0 of NULL. */
LEADSCREW_API double leadscrew_machine_period(const leadscrew_machine* machine);
/** What it can do. */
LEADSCREW_API int leadscrew_machine_limits(const leadscrew_machine* machine, leadscrew_limits* limits,
                                           leadscrew_error* error);
/** Another machine, which has these limits and the same axes, and is otherwise the same. LEADSCREW_REJECTED where they are
 * not sound: error.field says which, such as "jerk.x". */
LEADSCREW_API int leadscrew_machine_limited(const leadscrew_machine* machine, const leadscrew_limits* limits,
                                            leadscrew_machine** limited, leadscrew_error* error);
/** Motions go on without it. It may be NULL. */
LEADSCREW_API void leadscrew_machine_free(leadscrew_machine* machine);

/** Reads a program and tells what is wrong with it, options->on_diagnostic, as `leadscrew check --json` does. One with an
 * error is LEADSCREW_REJECTED: of `checked`, which may be NULL, it has blocks and moves, and else 0. `options` may be NULL. */
LEADSCREW_API int leadscrew_program_check(const leadscrew_machine* machine, const char* text, size_t length,
                                          const leadscrew_options* options, leadscrew_checked* checked,
                                          leadscrew_error* error);
/** What a block means, a code alone, in the dialect of the machine's programs, or a diagnostic by its code: writes at most `length` bytes, the last
 * one 0, and returns how many all of it has, without that. 0 where nothing of it is known. */
LEADSCREW_API size_t leadscrew_explain(const leadscrew_machine* machine, const char* block, char* text, size_t length);

/** The program is read whole first: one with an error is LEADSCREW_REJECTED and makes no motion. `options` may be NULL. */
LEADSCREW_API int leadscrew_motion_of_program(const leadscrew_machine* machine, const char* text, size_t length,
                                              const leadscrew_options* options, leadscrew_motion** motion,
                                              leadscrew_error* error);
/** Along moves, which leadscrew_motion_push() gives; smoothed within the machine's tolerance. */
LEADSCREW_API int leadscrew_motion_of_moves(const leadscrew_machine* machine, const leadscrew_options* options,
                                            leadscrew_motion** motion, leadscrew_error* error);
/** It may be NULL. From within its own functions it does nothing. */
LEADSCREW_API void leadscrew_motion_free(leadscrew_motion* motion);

/** How moves from now on are joined: within so many mm of them, or exactly (0). */
LEADSCREW_API int leadscrew_motion_smooth(leadscrew_motion* motion, double tolerance, leadscrew_error* error);
/** The next move, behind the one before. One that is refused changes nothing. */
LEADSCREW_API int leadscrew_motion_push(leadscrew_motion* motion, const leadscrew_move* move, leadscrew_error* error);
/** Motion comes to rest where the moves so far end; more may follow. */
LEADSCREW_API int leadscrew_motion_end_for_now(leadscrew_motion* motion);
/** No more moves will come. */
LEADSCREW_API int leadscrew_motion_finish(leadscrew_motion* motion);

/** The next words, at most `capacity`; `word_size` is sizeof(leadscrew_word). Fewer come only where
 * leadscrew_motion_progress() says why. LEADSCREW_FAILED once motion has failed and its last words, down to rest, have
 * been given. Time is not bounded: it plans. */
LEADSCREW_API int leadscrew_motion_next(leadscrew_motion* motion, leadscrew_word* words, size_t word_size,
                                        size_t capacity, size_t* count, leadscrew_error* error);
/** LEADSCREW_MOVING … LEADSCREW_WANTS_INPUT; LEADSCREW_ENDED of NULL. */
LEADSCREW_API int leadscrew_motion_progress(const leadscrew_motion* motion);

/** Feed, but that of rapids, is multiplied by 0 … 2; 0 holds, until it is more. As far as the program allows (M48 to M50,
 * M53): what it does not is remembered, and counts when it does. */
LEADSCREW_API int leadscrew_motion_override(leadscrew_motion* motion, double factor, leadscrew_error* error);
/** A second factor, 0 … 1, where the program asks for it by M52. */
LEADSCREW_API int leadscrew_motion_adapt(leadscrew_motion* motion, double factor, leadscrew_error* error);
/** At LEADSCREW_WANTS_INPUT: what the input is that the last event, M66, asks for, 0 or 1 of a digital one; -1: the time
 * for it is over. Motion goes on as the program does. */
LEADSCREW_API int leadscrew_motion_input_is(leadscrew_motion* motion, double value, leadscrew_error* error);
/** What the probing move looks for (G38.2 to G38.5, G31) along which the last word lies, of a motion that has_probe:
 * LEADSCREW_NO_PROBING … LEADSCREW_LOSS. */
LEADSCREW_API int leadscrew_motion_probing(const leadscrew_motion* motion);
/** The probe has found that, at this position, or at that of the last word (NULL): motion comes to rest as soon as limits
 * and slice allow, and goes on from there as the program does. Words that have been given belong to it: ask for few at a
 * time while probing. The first call counts; at the first word along the move, at rest, it says that this is so before the
 * move begins, which is an error of G38.2 and G38.4. LEADSCREW_REJECTED where nothing is being probed. */
LEADSCREW_API int leadscrew_motion_probe_found(leadscrew_motion* motion, const double* position,
                                               leadscrew_error* error);
/** Motion ends, at rest on its path, as soon as limits and slice allow; moves behind that are forgotten. */
LEADSCREW_API int leadscrew_motion_abort(leadscrew_motion* motion);
/** At LEADSCREW_ENDED: stands here and waits for moves; ticks count from 0 again. */
LEADSCREW_API int leadscrew_motion_reset(leadscrew_motion* motion, const double* position, leadscrew_error* error);

/** All of a motion, planned from its beginning to its end as if nobody intervened, by the feed override as it stands: of its program, or of the moves that were
 * pushed so far, before leadscrew_motion_next() has taken one. Its words stay those that they are. */
LEADSCREW_API int leadscrew_motion_plan(leadscrew_motion* motion, leadscrew_trajectory** trajectory,
                                        leadscrew_error* error);
/** The same while somebody turns the feed override: from times[i] on, s of the motion as it is with the changes before, in their
 * order, it is factors[i], 0 … 2. 0 holds: motion brakes within its limits, stands, and goes on with the next change; without
 * one it ends there. As far as the program allows, as of leadscrew_motion_override(). Arrays of `count` may be NULL where it is 0. */
LEADSCREW_API int leadscrew_motion_plan_changed(leadscrew_motion* motion, const double* times, const double* factors,
                                                size_t count, leadscrew_trajectory** trajectory,
                                                leadscrew_error* error);
/** From its first instant to rest at its end, s; 0 of NULL. */
LEADSCREW_API double leadscrew_trajectory_duration(const leadscrew_trajectory* trajectory);
/** Of all of it. */
LEADSCREW_API int leadscrew_trajectory_figures(const leadscrew_trajectory* trajectory, leadscrew_figures* figures,
                                               leadscrew_error* error);
/** What each block took and what it waited for, from all words of it; `user` is for the function. */
LEADSCREW_API int leadscrew_trajectory_blocks(const leadscrew_trajectory* trajectory, leadscrew_block_function on_block,
                                              void* user, leadscrew_error* error);
/** At `time`: before 0 as at 0, at rest behind the duration. Where it is n times the period, positions are those of word n,
 * bit for bit. */
LEADSCREW_API int leadscrew_trajectory_at(const leadscrew_trajectory* trajectory, double time, leadscrew_state* state,
                                          leadscrew_error* error);
/** Where the tool is at `time`, by position of the axes and the tool that is in force. */
LEADSCREW_API int leadscrew_trajectory_pose(const leadscrew_trajectory* trajectory, double time, leadscrew_pose* pose,
                                            leadscrew_error* error);
/** Both at many times that rise, s, bit for bit as the two calls above tell them, and much faster: states[0 … count), of `state_size` bytes each,
 * sizeof(leadscrew_state), and poses[0 … count), of `pose_size`, sizeof(leadscrew_pose), which may be NULL. Times that do not rise are
 * answered too, as slowly as one by one; where one is no number, nothing is (LEADSCREW_MISUSE). */
LEADSCREW_API int leadscrew_trajectory_sample(const leadscrew_trajectory* trajectory, const double* times, size_t count,
                                              leadscrew_state* states, size_t state_size, leadscrew_pose* poses,
                                              size_t pose_size, leadscrew_error* error);
/** By what motion is held in a state that leadscrew_trajectory_at() has told of it, as leadscrew_trajectory_blocks() attributes
 * lost time: acceleration before jerk, velocity and chord error. `feed_asked`: leadscrew_block.feed_asked of the block there,
 * times the feed override; above 0, HUGE_VAL of a rapid. */
LEADSCREW_API int leadscrew_trajectory_hold(const leadscrew_trajectory* trajectory, const leadscrew_state* state,
                                            double feed_asked, leadscrew_hold* hold, leadscrew_error* error);
/** Step and direction of every axis as drives get them, a value-change dump (VCD) as `leadscrew run --pulses FILE.vcd` writes it, on a
 * clock of `clock_hz`, 10000 … 10000000. LEADSCREW_REJECTED where an axis is faster than that gives steps; LEADSCREW_INTERRUPTED where
 * the function said so. `user` is for the function. */
LEADSCREW_API int leadscrew_trajectory_steps(const leadscrew_trajectory* trajectory, int64_t clock_hz,
                                             leadscrew_text_function on_text, void* user, leadscrew_error* error);
/** It may be NULL. */
LEADSCREW_API void leadscrew_trajectory_free(leadscrew_trajectory* trajectory);

/* NOLINTEND(readability-identifier-naming,performance-enum-size) */

#ifdef __cplusplus
}
#endif
#endif
