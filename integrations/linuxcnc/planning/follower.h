/** \file
 * Motion along a line in step with a spindle, within limits of velocity, acceleration and jerk.
 *
 * What the spindle asks for is a place on the line, p = revolutions · lead, known each period and no earlier. Its speed and
 * acceleration are estimated from the last places (a filter of third order, critically damped: a steady spindle is
 * followed without lag). The wanted speed is the spindle's and what makes good the error e:
 *
 *   v = w + f(e),   f(e) = k·e near 0, then the power 2/3 of it by which e can be braked away with a constant jerk, then the root
 *   a = dw/dt + g(v - speed),  likewise for speed by jerk
 *
 * Behind the run-in, as long as the spindle's own jerk is below the limit, the error is that of the estimate. A line ends by
 * a polynomial of fifth degree to rest at its very end, once its jerk comes near the limit. */
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

/** mm and s; of degrees where the line is told in degrees. */
struct leadscrew_tp_follower {
  double velocity;     /**< limit, > 0 */
  double acceleration; /**< the same */
  double jerk;         /**< the same */
  double period;       /**< s, > 0 */

  double s; /**< on the line, mm */
  double v; /**< mm/s */
  double a; /**< mm/s² */

  double place, speed, change; /**< of the spindle along the line, as estimated: mm, mm/s, mm/s² */
  int is_following;            /**< have these been begun? */

  double polynomial[6]; /**< of s by the time since its beginning, s */
  double elapsed;       /**< s of it */
  double duration;      /**< s; 0: there is none */
};

/** At rest at s = 0. The limits and the period are > 0. */
void leadscrew_tp_follower_begin(struct leadscrew_tp_follower* follower, double velocity, double acceleration,
                                 double jerk, double period);
/** A period in step with a spindle that asks for `place`, mm; motion ends at rest at `end` where it comes there, infinite
 * for nowhere. Returns whether it has. */
int leadscrew_tp_follower_follow(struct leadscrew_tp_follower* follower, double place, double end);
/** A period on the way to rest. Returns whether it rests. */
int leadscrew_tp_follower_stop(struct leadscrew_tp_follower* follower);
/** From rest to rest at `end`, a period. Returns whether it rests there. */
int leadscrew_tp_follower_go(struct leadscrew_tp_follower* follower, double end);

#ifdef __cplusplus
}
#endif
