/** \file
 * What all calls of leadscrew.h have in common: axes, codes, errors, words, events, and how a motion is made.
 */
#ifndef LEADSCREW_BASE_H
#define LEADSCREW_BASE_H

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

/** What a program asks of the machine besides motion: "M3", "S", "T", "M6", "M8", "M49", "M67", "M101" … "M6" stops the
 *  spindle; "T" of a Fanuc lathe, for which motion rests, says that the turret has another tool at the work. */
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
/** Called with the next piece of a text. Returns 0 to go on. */
typedef int (*leadscrew_text_function)(const char* text, size_t length, void* user);
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

/** How the moves of a program are joined. */
enum {
  LEADSCREW_AS_PROGRAMMED = 0, /**< by G61, G61.1 and G64 */
  LEADSCREW_EXACT_STOP = 1,    /**< each ends at rest, as under G61.1 */
  LEADSCREW_BLEND = 2          /**< within the tolerance, as under G64 */
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
  int32_t allow_gouging; /**< not 0: the tool may gouge, where it touches surfaces (G6.5) and in contours; 0: error */
  int32_t
      step_rule; /**< LEADSCREW_ARC_LENGTH … LEADSCREW_UNIFORM, of leadscrew_motion_next(); a trajectory is by arc length */
  int32_t path_mode;     /**< of a program: LEADSCREW_AS_PROGRAMMED … LEADSCREW_BLEND */
  int32_t has_tolerance; /**< not 0: the tolerance stands in place of P of G64 */
  double tolerance;      /**< mm, >= 0; not read where it is not had */
} leadscrew_options;

/** Kinds of moves. */
enum { LEADSCREW_LINE = 0, LEADSCREW_ARC = 1, LEADSCREW_CURVE = 2, LEADSCREW_DWELL = 3 };

/** What a move has to do with a surface: nothing; to over the first pass and down to it; one pass; from it to the next; away. */
enum {
  LEADSCREW_NO_SURFACE = 0,
  LEADSCREW_APPROACH = 1,
  LEADSCREW_PASS = 2,
  LEADSCREW_LINK = 3,
  LEADSCREW_RETRACT = 4
};

/* NOLINTEND(readability-identifier-naming,performance-enum-size) */

#ifdef __cplusplus
}
#endif
#endif
