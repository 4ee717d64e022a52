/** \file
 * Of leadscrew.h: the modes of a program that are in force along its path.
 */
#ifndef LEADSCREW_MODES_H
#define LEADSCREW_MODES_H

#include "leadscrew_base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* C has its own style of names, and its enumerations are int. NOLINTBEGIN(readability-identifier-naming,performance-enum-size) */

/** What a program has in force from a block on: a code of each modal group, as the program would say it. */
typedef struct leadscrew_modes {
  size_t size;          /**< of this structure, sizeof */
  int64_t line;         /**< of the block */
  int32_t file;         /**< as a word's */
  int32_t visit;        /**< as a word's */
  int64_t block;        /**< how many leadscrew_trajectory_blocks() tells before it */
  char motion[8];       /**< "G0", "G1", "G2", "G81" …; "G80": none */
  char plane[8];        /**< "G17" … "G19.1" */
  char units[8];        /**< "G20" or "G21" */
  char distance[8];     /**< "G90" or "G91" */
  char arc_distance[8]; /**< of centres: "G90.1" or "G91.1" */
  char feed_mode[8];    /**< "G93", "G94" or "G95" */
  char path_mode[8];    /**< "G61", "G61.1" or "G64" */
  char retract[8];      /**< of cycles: "G98" or "G99" */
  char compensation[8]; /**< of the cutter's radius: "G40", "G41" or "G42" */
  char tool_length[8];  /**< "G49": of no offset; "G43" of one; "G43.4" or "G43.5" under tool centre point control */
  char spindle[8];      /**< "M3", "M4" or "M5" */
  char coolant[8];      /**< "M9", "M7", "M8" or "M7 M8" */
  char system[16];      /**< "G54" … "G59.3", "G54.1 P1" … */
  double tolerance;     /**< P of G64 or the machine's, mm; 0 of others */
  double naive_cam;     /**< Q of G64, or P; mm; 0 of others */
  double feed;          /**< F: mm/s under G94, mm a revolution under G95; 0: none is known, and under G93 */
  double spindle_speed; /**< S: 1/min */
  double offset[LEADSCREW_AXES]; /**< of the coordinate system with G92, without the tool's: mm or degrees */
  int32_t tool;                  /**< number of the tool in the spindle; 0: the program has changed none in */
  int32_t selected_tool;         /**< T; -1: none */
} leadscrew_modes;
/** Called for the first block that moves or dwells, and for each that has other modes than the one before. */
typedef void (*leadscrew_modes_function)(const leadscrew_modes* modes, void* user);

/** The modes of a sound program, in the order of motion: what a path mode or a tolerance of the options stands in place of is what is
 * told. LEADSCREW_REJECTED with the program's first error. `options` may be NULL; `user` is for the function. */
LEADSCREW_API int leadscrew_program_modes(const leadscrew_machine* machine, const char* text, size_t length,
                                          const leadscrew_options* options, leadscrew_modes_function on_modes,
                                          void* user, leadscrew_error* error);

/* NOLINTEND(readability-identifier-naming,performance-enum-size) */

#ifdef __cplusplus
}
#endif
#endif
