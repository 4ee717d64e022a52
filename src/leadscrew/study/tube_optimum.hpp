#pragma once
// The motion of least time inside a tube, from rest to rest: path and time law at once, nothing given but the tube.
//
// A barrier is followed (tube_barrier.hpp) while t grows sixfold until the optimum is near enough. At each t Newton's
// method runs twice. First with passing times and legs of knots that follow the motion: the problem is then not convex,
// but motion can shift from leg to leg; a step is taken where the barrier really falls. Then with both fixed, which is
// convex and always comes to its end. Where they follow no farther, a motion is found whose time no small change of
// path or passing times can shorten. Starts far apart end within 0.1 % of each other.

#include <leadscrew/study/tube_motion.hpp>

namespace leadscrew::study {

struct TubeOptions {
  std::vector<double> shares = {};  ///< of the time, for each leg, to start from; none: as the legs are long
  std::size_t intervals = 0;        ///< of the motion, ≥ 8 for each leg; 0: as many as make two a millisecond
  double gap = 1e-4;                ///< of w, which is thrice that of the time, relative
};

struct TubeOptimum {
  TubeMotion motion;
  int newton_steps = 0;
};

/// The tube has at least one leg.
TubeOptimum least_time_motion(const Tube& tube, const TubeOptions& options = {});

}  // namespace leadscrew::study
