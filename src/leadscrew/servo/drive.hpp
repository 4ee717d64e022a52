#pragma once
// Amplifier and motor, as the slide sees them: what one unit of command pulls, and how much of its speed the drive
// loses by itself. The command u is what leaves the controller, in units of the digital-to-analogue converter (DAC).
//
//   v′ = acceleration·u − damping·v

namespace leadscrew::servo {

struct Drive {
  double acceleration = 0;          ///< mm/s² at rest for one unit of command; > 0
  double damping = 0;               ///< 1/s; ≥ 0
  bool regulates_velocity = false;  ///< damping is what a velocity loop of its own takes back, not friction
};

/// A drive with a velocity loop of its own (amplifier, motor, tachogenerator): v′ = (K·u − v)/τ, in the long run K·u.
/// gain: K, mm/s for one unit of command; > 0. time_constant: τ, seconds; > 0.
constexpr Drive velocity_drive(double gain, double time_constant) {
  return {gain / time_constant, 1 / time_constant, true};
}

/// A motor fed with a current, and all that it turns: J·ω′ = Kt·Ka·u − b·ω.
struct CurrentMotor {
  double amplifier = 0;          ///< Ka, A for one unit of command; > 0
  double torque_constant = 0;    ///< Kt, N·m/A; > 0
  double inertia = 0;            ///< J, kg·m² at the motor's shaft: rotor, screw and slide; > 0
  double viscous_friction = 0;   ///< b, N·m·s/rad; ≥ 0
  double travel_per_radian = 0;  ///< mm: pitch × starts/2π; > 0
};

constexpr Drive current_drive(const CurrentMotor& motor) {
  return {motor.amplifier * motor.torque_constant / motor.inertia * motor.travel_per_radian,
          motor.viscous_friction / motor.inertia};
}

/// What a slide adds to the inertia of the shaft: m·(travel per radian)², kg·m² from kg and mm.
constexpr double reflected_inertia(double mass, double travel_per_radian) {
  const double metres = travel_per_radian / 1000;
  return mass * metres * metres;
}

/// What a torque at the shaft, N·m, does to a slide in mm/s²: for Coulomb friction given as a torque.
constexpr double acceleration_of(double torque, const CurrentMotor& motor) {
  return torque / motor.inertia * motor.travel_per_radian;
}

}  // namespace leadscrew::servo
