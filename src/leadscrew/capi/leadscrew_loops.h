/** \file
 * Of leadscrew.h: simulated loops of axes, and where their slides are.
 */
#ifndef LEADSCREW_LOOPS_H
#define LEADSCREW_LOOPS_H

#include "leadscrew_base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* C has its own style of names, and its enumerations are int. NOLINTBEGIN(readability-identifier-naming,performance-enum-size) */

typedef struct leadscrew_loops leadscrew_loops; /**< a machine's axes under simulated loops */

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

/* NOLINTEND(readability-identifier-naming,performance-enum-size) */

#ifdef __cplusplus
}
#endif
#endif
