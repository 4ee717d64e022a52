#pragma once
// The drive of an axis as data, for simulation: how its loops are tuned and what the mechanics do. What is not told is
// empty; servo::loops_of() says what then holds.

#include <array>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace leadscrew::machine {

/// Lengths in mm; in degrees for a rotary axis. A unit is one unit of the controller's command.
struct AxisDrive {
  /// What closes the loop.
  enum class Controller : std::uint8_t {
    cascade,  ///< position and velocity loop around a motor that is fed with a current
    pid,      ///< one PID loop around a drive with a velocity loop of its own
  };
  /// Where position is measured.
  enum class Encoder : std::uint8_t { screw, slide };

  Controller controller = Controller::cascade;  ///< which fields below count
  Encoder encoder = Encoder::screw;             ///< on the slide it sees the errors of the screw

  // Of the cascade.
  std::optional<double> position_gain;      ///< Kv, 1/s; > 0
  std::optional<double> velocity_gain;      ///< 1/s: mm/s² for 1 mm/s that is missing; > 0
  std::optional<double> velocity_integral;  ///< 1/s²; ≥ 0
  std::optional<double> acceleration;       ///< the greatest that its torque gives, mm/s²; > 0
  std::optional<double> damping;            ///< viscous friction over inertia, 1/s; ≥ 0

  // Of the PID, in the published form (servo/pid.hpp).
  std::optional<double> gain;           ///< K, mm/s a unit; > 0
  std::optional<double> time_constant;  ///< τ, ms; > 0
  std::optional<double> proportional;   ///< P, units/mm; ≥ 0
  std::optional<double> integral;       ///< I, units/(mm·s); ≥ 0
  std::optional<double> derivative;     ///< D, units/mm; ≥ 0
  std::optional<double> command_limit;  ///< of the command, units; > 0

  // Of both.
  std::optional<double> velocity_forward;      ///< share of the velocity that is fed forward, 0 … 1
  std::optional<double> acceleration_forward;  ///< share of the acceleration, 0 … 1
  std::optional<double> friction;              ///< Coulomb's, mm/s²; ≥ 0
  std::optional<double> breakaway;             ///< to move what stands, mm/s²; ≥ 0
  std::optional<double> encoder_counts;        ///< a mm; > 0

  friend bool operator==(const AxisDrive&, const AxisDrive&) = default;
};

/// One of the numbers above: what it is called, and which are sound.
struct DriveNumber {
  /// Which values are sound; a share is 0 … 1.
  enum class Range : std::uint8_t { positive, not_negative, share };

  std::string_view name;                     ///< as problems have it
  std::optional<double> AxisDrive::* value;  ///< which field
  Range range;                               ///< that it must be in
};

/// All of them.
inline constexpr std::array<DriveNumber, 16> drive_numbers = {
    {{"position gain", &AxisDrive::position_gain, DriveNumber::Range::positive},
     {"velocity gain", &AxisDrive::velocity_gain, DriveNumber::Range::positive},
     {"velocity integral", &AxisDrive::velocity_integral, DriveNumber::Range::not_negative},
     {"greatest acceleration", &AxisDrive::acceleration, DriveNumber::Range::positive},
     {"damping", &AxisDrive::damping, DriveNumber::Range::not_negative},
     {"gain", &AxisDrive::gain, DriveNumber::Range::positive},
     {"time constant", &AxisDrive::time_constant, DriveNumber::Range::positive},
     {"proportional", &AxisDrive::proportional, DriveNumber::Range::not_negative},
     {"integral", &AxisDrive::integral, DriveNumber::Range::not_negative},
     {"derivative", &AxisDrive::derivative, DriveNumber::Range::not_negative},
     {"command limit", &AxisDrive::command_limit, DriveNumber::Range::positive},
     {"velocity forward", &AxisDrive::velocity_forward, DriveNumber::Range::share},
     {"acceleration forward", &AxisDrive::acceleration_forward, DriveNumber::Range::share},
     {"friction", &AxisDrive::friction, DriveNumber::Range::not_negative},
     {"breakaway", &AxisDrive::breakaway, DriveNumber::Range::not_negative},
     {"encoder counts", &AxisDrive::encoder_counts, DriveNumber::Range::positive}}};

/// Appends every number that is out of its range. Code: `machine-drive`; messages read "axis X: drive: NAME is …".
void check_drive(base::Axis axis, const AxisDrive& drive, std::vector<base::Diagnostic>& problems);

}  // namespace leadscrew::machine
