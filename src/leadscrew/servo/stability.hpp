#pragma once
// Whether loops settle, told before anything moves: by the step response of each loop alone, without what is not linear
// in it (limits, friction, play, counts), which can hold a loop that is not stable within a limit cycle that looks like
// a small error.

#include <leadscrew/base/result.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/servo/servo.hpp>

namespace leadscrew::servo {

/// Is the error in the last quarter of 10 s, or of 40000 periods if they are longer, no greater than in the first, in
/// every loop? What swings wider so slowly that it is not seen by then passes. Codes:
/// `servo-unstable`, whose message names the axis, and those of Servo::create().
base::Result<void> check_stable(const ServoOptions& options, base::Period period);

}  // namespace leadscrew::servo
