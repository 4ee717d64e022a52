#pragma once
// How far words and lines of five axes leave the tip and the tool's direction from where they should be.

#include <leadscrew/study/surface_pass.hpp>
#include <vector>

namespace leadscrew::study {

/// Greatest of both.
struct PoseError {
  double tip = 0;        ///< mm
  double direction = 0;  ///< degrees
};

/// Of lines whose ends are these poses: the tip off the straight line through the ends of each (which it may leave
/// lengthwise as well), the tool off the great circle that leads evenly from one direction to the next. `places` in each
/// line are looked at, as well as its ends. All axes go straight, or the tip and the rotary axes do.
enum class Straight : std::uint8_t { axes, tip };
PoseError error_of_lines(const kinematics::Chain& chain, const std::vector<TipAndRotary>& ends, Straight straight,
                         int places);

/// Of a curve: the tip off the pass, the tool off its normal there. `places` of it are looked at.
PoseError error_of_spline(const kinematics::Chain& chain, const SurfacePass& pass,
                          const std::vector<TipAndRotary>& control_points, int places);

/// The lines' places with others between, so many that the tip is within the tolerance, mm, of the straight line while all
/// axes go straight.
std::vector<double> subdivided(const kinematics::Chain& chain, const SurfacePass& pass,
                               const std::vector<double>& places, double tolerance);

/// One word in motion.
struct PoseSample {
  double tip = 0;        ///< off the pass, mm
  double direction = 0;  ///< off its normal there, degrees
  double feed = 0;       ///< of the tip, mm/s
  double turning = 0;    ///< of C, degrees/s
};

/// Each word of a program's motion; none where it has an error.
std::vector<PoseSample> pose_samples(const PartProgram& program, const machine::Machine& machine,
                                     const SurfacePass& pass);

}  // namespace leadscrew::study
