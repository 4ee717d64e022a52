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
 * are whose simulated loops follow words, leadscrew_loops_follow(); or one line or
 * arc by an interpolator of reference pulses, every register to be seen at every clock: leadscrew_pulses_load().
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

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* C has its own style of names, and its enumerations are int. NOLINTBEGIN(readability-identifier-naming,performance-enum-size) */

/** Of the functions that the shared library shows. */
#if defined(__GNUC__)
#define LEADSCREW_API __attribute__((visibility("default")))
#else
#define LEADSCREW_API
#endif

/** X Y Z A B C U V W */
#define LEADSCREW_AXES 9

typedef struct leadscrew_machine leadscrew_machine;       /**< limits and period; never changes */
typedef struct leadscrew_motion leadscrew_motion;         /**< along one program, or along moves */
typedef struct leadscrew_trajectory leadscrew_trajectory; /**< a motion, planned to its end; never changes */
typedef struct leadscrew_pulses leadscrew_pulses;         /**< an interpolator of reference pulses along one curve */
typedef struct leadscrew_loops leadscrew_loops;           /**< a machine's axes under simulated loops */

/** What functions return. */
enum {
  LEADSCREW_OK = 0,
  LEADSCREW_REJECTED = 1, /**< a machine, a program or a move is not sound: error.code says how */
  LEADSCREW_MISUSE = 2,   /**< of this interface */
  LEADSCREW_INPUT = 3,    /**< a file cannot be read */
  LEADSCREW_FAILED = 4,   /**< motion has ended, at rest, before its path */
  LEADSCREW_OUT_OF_MEMORY = 5,
  LEADSCREW_INTERRUPTED = 6 /**< on_progress said so */
};

/** What went wrong, as a diagnostic of the command has it. */
typedef struct leadscrew_error {
  size_t size;       /**< of this structure, sizeof */
  int32_t severity;  /**< 0 note, 1 warning, 2 error */
  int32_t reserved;  /**< 0 */
  int64_t line;      /**< of the text, from 1; 0: none */
  int64_t column;    /**< of the line, in bytes, from 1; 0: none */
  char code[48];     /**< stable, such as "arc-radius" */
  char message[512]; /**< what was found */
  char hint[256];    /**< what would be right; may be empty */
  /* Here the error of the first version ended. */
  char file[256]; /**< of the text: the program's name, or a subprogram's; may be empty */
  char field[32]; /**< of what was given: the field that it is about, such as "end.x"; may be empty */
} leadscrew_error;

/** One servo period. */
typedef struct leadscrew_word {
  int64_t tick;                    /**< number of the period, from 0 */
  double position[LEADSCREW_AXES]; /**< of the axes */
  double path_length;              /**< travelled since the start */
  double speed;                    /**< along the path, units of path_length per second */
  double feed;                     /**< by the axes that feed is counted by */
  int64_t line;                    /**< of the program, or of the move */
  uint8_t state;                   /**< 0 at rest, 1 speed changes, 2 speed is constant */
  uint8_t reserved;                /**< 0 */
  uint16_t file;  /**< that the line is in: 0 the program, n the text that on_subprogram gave as the nth */
  uint32_t visit; /**< how many times the program had gone back or to another text before, modulo 2^20 */
} leadscrew_word;

/** What a program asks of the machine besides motion: "M3", "S", "T", "M6", "M8", "M49", "M67", "M101" … */
typedef struct leadscrew_event {
  size_t size;        /**< of this structure, sizeof */
  int64_t tick;       /**< of the word in whose period it happens */
  double path_length; /**< where */
  double value;   /**< speed or angle of the spindle, number of the tool, 0 or 1 of M50 to M53, L of M66, P of M100 … */
  int64_t line;   /**< of the program */
  int32_t output; /**< number of an output, input or function; direction of M19 */
  int32_t waits;  /**< does motion rest for it? */
  char code[8];   /**< as the program has it */
  int32_t file;   /**< as a word's */
  int32_t visit;  /**< as a word's */
  double q;       /**< Q of M19 and M66, s, 0: none; of M100 to M199, -1: none */
} leadscrew_event;

/** Called once for each event, in order. `user` is that of the options. */
typedef void (*leadscrew_event_function)(const leadscrew_event* event, void* user);
/** Called once for each diagnostic, in the order of the text. */
typedef void (*leadscrew_error_function)(const leadscrew_error* error, void* user);
/** `share`, 0 … 1: so much of the program has been read; 0 of moves. Returns 0 to go on; else work ends with
 * LEADSCREW_INTERRUPTED, motion at rest on its path. */
typedef int (*leadscrew_progress_function)(double share, void* user);
/** The text of a subprogram that the program calls and does not hold, by the name in `o<name> call`, in small letters, or
 * the number in `M98 P` and `o100 call`. Returns 0 and sets `text` and its length, which are copied before anything else is
 * called; not 0 where there is none. */
typedef int (*leadscrew_subprogram_function)(const char* name, const char** text, size_t* length, void* user);

/** How words step along curves (G5, G6.2): by arc length, or by a published rule (interpolator/parameter_steps.hpp). */
enum {
  LEADSCREW_ARC_LENGTH = 0,
  LEADSCREW_TAYLOR1 = 1,
  LEADSCREW_TAYLOR2 = 2,
  LEADSCREW_NEWTON = 3,
  LEADSCREW_UNIFORM = 4
};

/** How a motion is made. All 0 but its size, it is as if none were given. */
typedef struct leadscrew_options {
  size_t size;                            /**< of this structure, sizeof */
  double start[LEADSCREW_AXES];           /**< where motion begins */
  double slice;                           /**< no more than about so long is settled ahead; 0: 0.05 s */
  leadscrew_event_function on_event;      /**< from within leadscrew_motion_next(); may be NULL */
  leadscrew_error_function on_diagnostic; /**< of the program: notes, warnings, errors; may be NULL */
  void* user;                             /**< for all functions */
  const char* file;                       /**< the program's name, for messages; may be NULL */
  /* Here the options of the first version ended. */
  const char* tools;      /**< the tool table of a program, as LinuxCNC writes it ("T1 P1 D3.175 Z0.511"); NULL: none */
  size_t tools_length;    /**< bytes of it */
  const char* tools_file; /**< in its place, the path of a file that holds it; NULL: none */
  leadscrew_progress_function on_progress;     /**< asked every few KiB read, every few ms of planning; may be NULL */
  leadscrew_subprogram_function on_subprogram; /**< asked once for each name; NULL: there are none beside the program */
  int64_t fuel; /**< lines that a program may read in loops and subprograms, more are an error; 0: 100 million */
  int32_t
      has_probe; /**< not 0: leadscrew_motion_probe_found() ends probing moves; 0: as the machine's simulated probe does */
  int32_t has_inputs;    /**< not 0: leadscrew_motion_input_is() says what inputs are (M66); 0: they are off */
  int32_t allow_gouging; /**< not 0: surfaces (G6.5) are machined though the tool gouges where it touches; 0: error */
  int32_t
      step_rule; /**< LEADSCREW_ARC_LENGTH … LEADSCREW_UNIFORM, of leadscrew_motion_next(); a trajectory is by arc length */
} leadscrew_options;

/** Kinds of moves. */
enum { LEADSCREW_LINE = 0, LEADSCREW_ARC = 1, LEADSCREW_CURVE = 2, LEADSCREW_DWELL = 3 };
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

/** What a move has to do with a surface: nothing; to over the first pass and down to it; one pass; from it to the next; away. */
enum {
  LEADSCREW_NO_SURFACE = 0,
  LEADSCREW_APPROACH = 1,
  LEADSCREW_PASS = 2,
  LEADSCREW_LINK = 3,
  LEADSCREW_RETRACT = 4
};

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

/** A tool of a table, as a body. */
typedef struct leadscrew_tool {
  size_t size;      /**< of this structure, sizeof */
  int32_t number;   /**< T, > 0 */
  int32_t reserved; /**< 0 */
  double diameter;  /**< mm; 0: not told */
  double
      corner_radius; /**< of its round edge, mm: 0 flat, half the diameter a ball; -1: nothing is told of its shape */
  double length;     /**< from the tip to the holder, mm; 0: not told */
  double holder_diameter; /**< mm; 0: there is none */
  double holder_length;   /**< mm */
} leadscrew_tool;
/** Called once for each tool, in the order of the table. */
typedef void (*leadscrew_tool_function)(const leadscrew_tool* tool, void* user);

/** A surface that a program machines, as quadrilaterals in the workpiece as it lies with all rotary axes at 0. */
typedef struct leadscrew_surface {
  size_t size;      /**< of this structure, sizeof */
  int32_t number;   /**< D */
  int32_t reserved; /**< 0 */
  size_t
      cells; /**< quadrilaterals; two triangles each, of corners 0 1 2 and 0 2 3, lie within the sag of the surface */
  const double* corners; /**< cells * 12: X, Y and Z of four corners, mm; valid until the function returns */
  const double* normals; /**< cells * 12: of the surface there, unit vectors; 0 0 0 where it has none; likewise */
} leadscrew_surface;
/** Called once for each surface that differs from those before. */
typedef void (*leadscrew_surface_function)(const leadscrew_surface* surface, void* user);

/** Parts of a tool. */
enum { LEADSCREW_CUTTER = 0, LEADSCREW_SHANK = 1, LEADSCREW_HOLDER = 2 };

/** Where a tool cuts more than it should of a surface that a program machines. */
typedef struct leadscrew_gouge {
  size_t size;       /**< of this structure, sizeof */
  int64_t line;      /**< of the program */
  int32_t file;      /**< as a word's */
  int32_t part;      /**< of the move: as a block's */
  int32_t pass;      /**< as a block's */
  int32_t tool_part; /**< LEADSCREW_CUTTER … LEADSCREW_HOLDER */
  int32_t surface;   /**< D of the one that is cut */
  int32_t reserved;  /**< 0 */
  double
      depth; /**< mm, of the deepest place of this block, part and pass; 0: the tool bends less than the surface that it
                          touches, and how deep it is beside is not told */
  double clearance;    /**< 1/mm, where the depth is 0: < 0, curvature of the tool less that of the surface */
  double u;            /**< its place, a parameter of the surface */
  double v;            /**< the other */
  double place[3];     /**< the same in the workpiece, mm */
  double tip[3];       /**< of the tool there, mm; of depth 0 the place */
  double direction[3]; /**< the same, a unit vector; of depth 0 all 0 */
} leadscrew_gouge;
/** Called once for each block, part and pass that gouges, in their order, and then for each block that does so where it touches. */
typedef void (*leadscrew_gouge_function)(const leadscrew_gouge* gouge, void* user);

/** One line or arc, of a circle or an ellipse, for an interpolator of reference pulses. Coordinates are whole BLU, basic length units. */
typedef struct leadscrew_pulse_task {
  size_t size;         /**< of this structure, sizeof */
  int32_t kind;        /**< LEADSCREW_LINE or LEADSCREW_ARC; an arc whose end is its start is a full circle */
  int32_t turns;       /**< of an arc: 1 counterclockwise, -1 clockwise */
  int32_t bits;        /**< of the registers, 1 ... 30; 0: as the method has them by default */
  int32_t reserved;    /**< 0 */
  int64_t start[2];    /**< |coordinate| <= 2^30 */
  int64_t end[2];      /**< the same; of an arc, off the circle by half a BLU at most, of an ellipse start and end */
  int64_t center[2];   /**< of an arc */
  int64_t capacity;    /**< q of integrators, 1 ... 2^30; 0: by the curve, or 2^bits */
  const char* method;  /**< a name of LEADSCREW_METHODS */
  const char* preload; /**< and so on; NULL or empty: the method's own */
  const char* order;   /**< of integrators of arcs */
  const char* tie;     /**< of arcs by point comparison */
  /* Here the task of the first version ended. */
  int64_t semi_axes[2]; /**< of an arc of an ellipse, along X and Y; both 0: the arc is one of a circle */
  int32_t is_free;      /**< not 0, of integrators of arcs of circles: no counters, as many clocks as the angle takes */
  int32_t
      places; /**< of integrators of arcs of circles with counters: binary places of the radius in the capacity, 1 ... 16; 0: none */
  /* Here the task of the second version ended. */
  const char*
      accumulation; /**< of arcs that run freely: how remainders take negative integrands; NULL: sign-magnitude */
} leadscrew_pulse_task;

/** Names that leadscrew_pulse_name() lists, and options that methods have, as bits of leadscrew_pulse_uses(). */
enum {
  LEADSCREW_METHODS = 0,
  LEADSCREW_PRELOADS = 1,
  LEADSCREW_ORDERS = 2,
  LEADSCREW_TIES = 3,
  LEADSCREW_CAPACITY = 4,
  LEADSCREW_ELLIPSES = 5,
  LEADSCREW_FREE = 6,
  LEADSCREW_ACCUMULATIONS = 7,
  LEADSCREW_PLACES = 8
};

/** What is in force, with what a method has by default; empty or 0 where it has no such choice. */
typedef struct leadscrew_pulse_conventions {
  size_t size;      /**< of this structure, sizeof */
  int32_t bits;     /**< of the registers */
  int32_t reserved; /**< 0 */
  int64_t capacity; /**< q */
  double
      clocks_per_blu; /**< of the path, of integrators: with q times the feed over the length or the radius they keep it */
  char preload[24]; /**< what the remainders begin with */
  char order[24];   /**< in which the integrators of an arc are clocked */
  char tie[24];     /**< what happens where two steps are as good as one another */
  char end[32];     /**< how the end is found */
  /* Here the conventions of the first version ended. */
  int64_t
      scale; /**< of an ellipse: what integrands and capacity are taken times in the registers, so that they are whole */
  /* Here the conventions of the second version ended. */
  int32_t places;        /**< of the radius in the capacity */
  int32_t also_reserved; /**< 0 */
  char accumulation[24]; /**< how remainders take negative integrands */
} leadscrew_pulse_conventions;

/** Of the clocks until now. */
typedef struct leadscrew_pulse_figures {
  size_t size;         /**< of this structure, sizeof */
  int64_t clocks;      /**< how many */
  int64_t pulses;      /**< clocks with a step */
  int64_t position[2]; /**< BLU */
  int64_t worst[2];    /**< where the error was greatest first, BLU */
  int64_t worst_clock; /**< and when */
  double error;        /**< here, BLU: of an arc > 0 outside, of a line > 0 to its left */
  double max_error;    /**< greatest distance from the curve, BLU */
  double rms_error;    /**< over the places after each pulse, BLU */
  int32_t is_done;     /**< not 0: further clocks give nothing */
  int32_t reserved;    /**< 0 */
} leadscrew_pulse_figures;

/** What closes the loops of simulated axes. */
enum { LEADSCREW_OWN_LOOPS = 0, LEADSCREW_CASCADE = 1, LEADSCREW_PID = 2, LEADSCREW_PULSE_LOOP = 3 };
/** Where a loop measures position. */
enum { LEADSCREW_OWN_ENCODER = 0, LEADSCREW_ROTARY_ENCODER = 1, LEADSCREW_LINEAR_ENCODER = 2 };

/** Of the simulated loops of all axes. All 0 but its size, they are those of the machine's file. Members that the controller
 * does not name are not read; lengths in mm stand for degrees of rotary axes. */
typedef struct leadscrew_loop_options {
  size_t size;              /**< of this structure, sizeof */
  int32_t controller;       /**< LEADSCREW_OWN_LOOPS … LEADSCREW_PULSE_LOOP */
  int32_t encoder;          /**< LEADSCREW_OWN_ENCODER … LEADSCREW_LINEAR_ENCODER: at the screw, or on the slide */
  double proportional;      /**< P of a PID, units/mm; >= 0 */
  double integral;          /**< I of a PID, units/(mm s); >= 0 */
  double derivative;        /**< D of a PID, units/mm: of the error's difference from period to period; >= 0 */
  double drive_gain;        /**< K of a PID's drive, mm/s a unit; 0: the machine's */
  double time_constant;     /**< of a PID's drive, or of the pulse loop's motor and tachometer, s; 0: the machine's */
  double position_gain;     /**< Kv of a cascade or of the pulse loop, 1/s; 0: the machine's */
  double velocity_gain;     /**< of a cascade: mm/s2 for 1 mm/s that is missing, 1/s; 0: the machine's */
  double velocity_integral; /**< of a cascade, 1/s2; >= 0 */
  double forward;           /**< share of velocity and acceleration that a cascade or a PID feeds forward, 0 … 1 */
  double backlash;          /**< play of every screw, mm, where its own is less; >= 0; the pulse loop has none */
} leadscrew_loop_options;

/** Where simulated axes were at one word. */
typedef struct leadscrew_followed {
  size_t size;                     /**< of this structure, sizeof */
  int64_t tick;                    /**< of the word; -1: nothing has come of any yet */
  double position[LEADSCREW_AXES]; /**< of the slides, mm or degrees */
  double velocity[LEADSCREW_AXES]; /**< of the screws, as tachometers tell it, mm/s or degrees/s */
  double
      control[LEADSCREW_AXES]; /**< from there on: units of a PID, mm/s2 of a cascade, counts of an up-down counter */
  double current[LEADSCREW_AXES]; /**< of the motors, as the acceleration that it gives, mm/s2 or degrees/s2 */
} leadscrew_followed;

/** Of all words until now. */
typedef struct leadscrew_loop_figures {
  size_t size;                      /**< of this structure, sizeof */
  int64_t periods;                  /**< that were followed */
  double greatest[LEADSCREW_AXES];  /**< of the size of the following error, mm or degrees */
  double rms[LEADSCREW_AXES];       /**< of the following error */
  double overshoot[LEADSCREW_AXES]; /**< greatest of all stops */
  double feed_greatest;             /**< by tachometers, mm/s */
  double feed_mean;                 /**< while words ask for motion */
  double contour; /**< greatest distance from the way that words lead, in order, mm; -1 of a machine with rotary axes */
  double contour_rms; /**< the same */
} leadscrew_loop_figures;

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
/** The tools of options->tools or options->tools_file. `user` is for the function. */
LEADSCREW_API int leadscrew_tools(const leadscrew_options* options, leadscrew_tool_function on_tool, void* user,
                                  leadscrew_error* error);
/** The surfaces that a sound program machines (G6.5); triangles lie within `sag` of them, mm, > 0, or as near as a million of
 * them allow. LEADSCREW_REJECTED with the program's first error, and of more than 1000 surfaces. `options` may be NULL; `user` is
 * for the function. */
LEADSCREW_API int leadscrew_program_surfaces(const leadscrew_machine* machine, const char* text, size_t length,
                                             const leadscrew_options* options, double sag,
                                             leadscrew_surface_function on_surface, void* user, leadscrew_error* error);
/** Where a program gouges surfaces that it machines by more than `tolerance`, mm, > 0, at most 1000 of each kind: as
 * `leadscrew check --gouge` does. That gouging is allowed for the reading: it is told here. Errors as above. */
LEADSCREW_API int leadscrew_program_gouges(const leadscrew_machine* machine, const char* text, size_t length,
                                           const leadscrew_options* options, double tolerance,
                                           leadscrew_gouge_function on_gouge, void* user, leadscrew_error* error);
/** What a block means, or a code alone, in the dialect of the machine's programs: writes at most `length` bytes, the last
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
/** By what motion is held in a state that leadscrew_trajectory_at() has told of it, as leadscrew_trajectory_blocks() attributes
 * lost time: acceleration before jerk, velocity and chord error. `feed_asked`: leadscrew_block.feed_asked of the block there,
 * times the feed override; above 0, HUGE_VAL of a rapid. */
LEADSCREW_API int leadscrew_trajectory_hold(const leadscrew_trajectory* trajectory, const leadscrew_state* state,
                                            double feed_asked, leadscrew_hold* hold, leadscrew_error* error);
/** It may be NULL. */
LEADSCREW_API void leadscrew_trajectory_free(leadscrew_trajectory* trajectory);

/** Axes at rest, under loops that begin with the first word; `options` may be NULL. LEADSCREW_REJECTED where a gain is out of its
 * range, error.field says which, or a loop is not stable. */
LEADSCREW_API int leadscrew_loops_begin(const leadscrew_machine* machine, const leadscrew_loop_options* options,
                                        leadscrew_loops** loops, leadscrew_error* error);
/** The next word, `word_size` is sizeof(leadscrew_word), and what came of the word before the last; of the last under pulse
 * loops. After the last, repeat it at rest for as long as the axes should come closer. LEADSCREW_FAILED where a slide is off by
 * more than its travel. */
LEADSCREW_API int leadscrew_loops_follow(leadscrew_loops* loops, const leadscrew_word* word, size_t word_size,
                                         leadscrew_followed* followed, leadscrew_error* error);
/** Of all words until now, as `leadscrew simulate` measures them. */
LEADSCREW_API int leadscrew_loops_figures(const leadscrew_loops* loops, leadscrew_loop_figures* figures,
                                          leadscrew_error* error);
/** It may be NULL. */
LEADSCREW_API void leadscrew_loops_free(leadscrew_loops* loops);

/** Of LEADSCREW_METHODS ... LEADSCREW_TIES, or of LEADSCREW_ACCUMULATIONS, the name with this number, from 0; NULL where there are not so many. */
LEADSCREW_API const char* leadscrew_pulse_name(int what, size_t number);
/** Which options a method has, and whether it draws ellipses: 1 << LEADSCREW_PRELOADS and so on, together; 0 of a name that is none. */
LEADSCREW_API int leadscrew_pulse_uses(const char* method);
/** LEADSCREW_REJECTED and the problem with this number, from 0, that a curve has: a line of no length, an arc of radius 0,
 * an end off the circle or the ellipse, a register that does not hold a coordinate, a method that draws no ellipse. LEADSCREW_OK where there are not so many. */
LEADSCREW_API int leadscrew_pulses_problem(const leadscrew_pulse_task* task, size_t number, leadscrew_error* problem);
/** Loads the registers; LEADSCREW_REJECTED with the first problem. An option that the method does not have, and bits
 * beside a capacity, are LEADSCREW_MISUSE. */
LEADSCREW_API int leadscrew_pulses_load(const leadscrew_pulse_task* task, leadscrew_pulses** pulses,
                                        leadscrew_error* error);
/** Another one that stands at the same clock: the way to come back to it. */
LEADSCREW_API int leadscrew_pulses_copy(const leadscrew_pulses* pulses, leadscrew_pulses** copy,
                                        leadscrew_error* error);
/** It may be NULL. */
LEADSCREW_API void leadscrew_pulses_free(leadscrew_pulses* pulses);
/** What is in force. */
LEADSCREW_API int leadscrew_pulses_conventions(const leadscrew_pulses* pulses, leadscrew_pulse_conventions* conventions,
                                               leadscrew_error* error);
/** Of the clocks until now; what further ones bring is not known to it. */
LEADSCREW_API int leadscrew_pulses_figures(const leadscrew_pulses* pulses, leadscrew_pulse_figures* figures,
                                           leadscrew_error* error);
/** The name of a number of each row, from 0; NULL where there are not so many. First "clock", the pulse "dx" and "dy" (-1,
 * 0, 1) and the place "X" and "Y" of the task's coordinates, then what `leadscrew pulse --table` shows: the place from the
 * centre or a line's start "x" and "y", and the method's registers. Behind these, of an arc the "quadrant" (0 ... 3) from
 * which it goes on, and of integrators how the last clock added: of an arc "Jx" and "Jy", then the sums "Sx" and "Sy" and
 * whether they overflowed, "ox" and "oy". */
LEADSCREW_API const char* leadscrew_pulses_column(const leadscrew_pulses* pulses, size_t number);
/** The row as it stands: as many numbers as there are columns. */
LEADSCREW_API int leadscrew_pulses_row(const leadscrew_pulses* pulses, int64_t* row, leadscrew_error* error);
/** The next clocks, a row each, at most `capacity`; fewer only at the end. `rows` may be NULL: then they are made and not
 * shown. */
LEADSCREW_API int leadscrew_pulses_next(leadscrew_pulses* pulses, int64_t* rows, size_t capacity, size_t* count,
                                        leadscrew_error* error);
/** Why the last clock gave what it did, in a line or two, with the numbers that decided: writes at most `length` bytes, the
 * last one 0, and returns how many all of it has, without that. Empty before the first clock. */
LEADSCREW_API size_t leadscrew_pulses_why(const leadscrew_pulses* pulses, char* text, size_t length);

/* NOLINTEND(readability-identifier-naming,performance-enum-size) */

#ifdef __cplusplus
}
#endif
#endif
