/** \file
 * Of leadscrew.h: one line or arc by an interpolator of reference pulses, every register to be seen at every clock; and places of a
 * circle by integration.
 */
#ifndef LEADSCREW_PULSES_H
#define LEADSCREW_PULSES_H

#include "leadscrew_base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* C has its own style of names, and its enumerations are int. NOLINTBEGIN(readability-identifier-naming,performance-enum-size) */

typedef struct leadscrew_pulses leadscrew_pulses; /**< an interpolator of reference pulses along one curve */

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

/** Rules by which reference words of a circle are integrated, a step a period: "Interpolator for a computer numerical control
 * system", x' = -y, y' = x, with the step T in radians. */
enum {
  LEADSCREW_EULER = 0,       /**< x - T y, y + T x (eq. 26) */
  LEADSCREW_HEUN = 1,        /**< improved Euler: (1 - T^2/2) x - T y and so on (eq. 23), Taylor's of second order */
  LEADSCREW_TUSTIN = 2,      /**< the bilinear rule (eqs. 24 and 25): the radius stays what it is */
  LEADSCREW_X_FIRST = 3,     /**< x - T y, then y + T times the new x (eq. 27) */
  LEADSCREW_RUNGE_KUTTA = 4, /**< the classical rule of fourth order */
  LEADSCREW_STATE_TRANSITION = 5 /**< x cos T - y sin T and so on (eq. 22): exact but for rounding */
};

/** Places around (0, 0) by a rule, LEADSCREW_EULER … LEADSCREW_STATE_TRANSITION, a step of `angle` each: finite, radians, > 0
 * counterclockwise. Writes `count` of them, > 0, two numbers each, mm, the first of which is `start`. */
LEADSCREW_API int leadscrew_circle_places(int rule, double angle, const double* start, double* places, size_t count,
                                          leadscrew_error* error);

/* NOLINTEND(readability-identifier-naming,performance-enum-size) */

#ifdef __cplusplus
}
#endif
#endif
