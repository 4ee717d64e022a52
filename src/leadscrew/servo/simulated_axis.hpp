#pragma once
// One axis of a machine, simulated: amplifier, motor, lead screw, slide, encoder.
//
//   command u ─▶ limit ─▶ Drive ─▶ screw ──▶ play ──▶ slide
//                           ▲        │                  │
//                        friction    └──── encoder ─────┘   reading, of one or the other
//
// The command is held between two calls (zero-order hold) and motion is exact: no step of integration, but closed forms
// from one stop of the screw to the next. While it moves in one direction, Coulomb friction is a constant pull against
// the motion; where it stops it stays, unless the drive pulls harder than the friction at rest. Under a constant
// command it stops once at the most.
//
// Within the play (backlash) the slide stands, for it moves only where a flank pushes it. Its mass is taken to belong
// to the drive all the time.

#include <leadscrew/base/result.hpp>
#include <leadscrew/servo/drive.hpp>
#include <leadscrew/servo/motion.hpp>
#include <limits>

namespace leadscrew::servo {

enum class EncoderPlace { screw, slide };

/// Lengths in mm; in degrees for a rotary axis.
struct AxisOptions {
  Drive drive;
  double command_limit = std::numeric_limits<double>::infinity();  ///< of |u|: the amplifier's, or that of torque; > 0
  double friction = 0;            ///< Coulomb's, mm/s² that it takes from a moving slide; ≥ 0
  double breakaway = 0;           ///< mm/s² that the drive must pull to move what stands; below friction: the same
  double backlash = 0;            ///< mm, from flank to flank; ≥ 0
  double encoder_resolution = 0;  ///< mm a count; 0: exact; ≥ 0
  EncoderPlace encoder_place = EncoderPlace::screw;
};

class SimulatedAxis {
 public:
  /// At rest at 0, the slide midway between the flanks. Code: `servo-axis`.
  static base::Result<SimulatedAxis> create(const AxisOptions& options);

  /// Holds a command for so many seconds. Both finite, seconds ≥ 0.
  void advance(double command, double seconds);

  /// Of the screw, in mm of the slide.
  const Motion& screw() const { return screw_; }
  /// Where the slide is, mm.
  double slide() const { return slide_; }
  /// What the motor's current gives now, under a command: the acceleration that its torque would give without friction,
  /// mm/s². Amperes: times J/(Kt·travel per radian).
  double current(double command) const;
  /// What the encoder says, mm. Its edges lie halfway between the multiples of its resolution.
  double reading() const;

  const AxisOptions& options() const { return options_; }

 private:
  explicit SimulatedAxis(const AxisOptions& options) : options_(options) {}
  double travel(double pull, double at_most);

  AxisOptions options_;
  Motion screw_;
  double slide_ = 0;
};

}  // namespace leadscrew::servo
