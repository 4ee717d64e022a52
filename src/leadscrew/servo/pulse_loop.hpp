#pragma once
// The pulse-driven position loop of one axis, event by event.
//
//   interpolator ──▶ & ──▶ + ┌─────┐   ┌─────┐   ┌───┐   ┌───────┐
//       pulse        ▲       │ UDC ├──▶│ DAC ├──▶│ A ├──▶│ M · T ├──▶ screw
//                 PDC > 0  − └──▲──┘   └─────┘   └───┘   └───┬───┘
//                               └──────── encoder ◀──────────┘
//
// The position down-counter PDC holds how many pulses are still to come; the gate lets them pass while it is not 0.
// Each that passes counts the up-down counter UDC up (or down, where the axis is to run back), and each pulse of the
// encoder counts it in the other direction: UDC is the following error in whole pulses, and it drives the motor,
//
//   ω′ = (Km·Ka·Kdac·UDC − ω)/τ,   in encoder pulses:   v′ = (Kv·UDC − v)/τ,   Kv = Kdac·Ka·Km·holes.
//
// In the steady state UDC = f/Kv, where f is the rate of pulses: the encoder gives as many as the interpolator. Between
// two pulses of either kind the drive is constant and the motion is known in closed form. The next encoder pulse is
// found in it to the last digits, so that nothing depends on a step of simulation.
// Source: A. Roy Choudhury, "Computer Numerical Control of Machine Tools and Processes", lecture 12, problem 13.1.

#include <cstdint>
#include <leadscrew/base/result.hpp>
#include <leadscrew/servo/motion.hpp>

namespace leadscrew::servo {

struct PulseLoopOptions {
  double converter = 0;      ///< Kdac, V a count of UDC; > 0
  double amplifier = 0;      ///< Ka, V/V; > 0
  double motor = 0;          ///< Km, revolutions a second for 1 V, tachogenerator's loop closed; > 0
  double holes = 0;          ///< of the encoder: pulses a revolution; > 0
  double time_constant = 0;  ///< τ of motor and tachogenerator, seconds; > 0
  int counter_bits = 16;     ///< of UDC, its sign among them; 2 … 32
  double start = 0;          ///< of the screw, pulses past the encoder's last edge; 0 … 1

  /// Kv, 1/s
  constexpr double gain() const { return converter * amplifier * motor * holes; }
};

class PulseLoop {
 public:
  /// At rest, all counters 0. Code: `servo-pulse-loop`.
  static base::Result<PulseLoop> create(const PulseLoopOptions& options);

  /// Puts PDC to so many pulses, ≥ 0.
  void load(std::int64_t pulses) { to_come_ = pulses; }

  /// An interpolator pulse, now; direction +1 or −1. Does it pass the gate?
  bool pulse(int direction);

  struct Passed {
    double seconds = 0;
    int encoder_pulse = 0;  ///< +1 or −1 at the end of these seconds; 0: none came
  };
  /// To the next encoder pulse, or for `at_most` seconds (finite, ≥ 0) if none comes until then.
  Passed run(double at_most);

  /// For so many seconds, through every encoder pulse.
  void run_through(double seconds) {
    for (double left = seconds; left > 0;) {
      const Passed passed = run(left);
      if (passed.encoder_pulse == 0) return;
      left -= passed.seconds;
    }
  }

  std::int64_t to_come() const { return to_come_; }             ///< PDC
  std::int64_t following_error() const { return difference_; }  ///< UDC
  std::int64_t commanded() const { return commanded_; }         ///< passed the gate, + less −
  std::int64_t commanded_gross() const { return passed_; }      ///< passed the gate, of either sign
  std::int64_t encoder_count() const { return count_; }         ///< pulses of the encoder, forward + backward −
  std::int64_t encoder_gross() const { return edges_; }         ///< pulses of the encoder, of either sign

  /// Pulses that would have taken UDC out of its range, since the beginning; above 0, gain, bits or rate do not fit.
  /// UDC stays at its end meanwhile, and from then on position and command differ for good.
  std::int64_t overflows() const { return overflows_; }
  /// commanded() − encoder_count() − following_error(): what overflows have cost so far.
  std::int64_t lost() const { return commanded_ - count_ - difference_; }

  /// Of the screw, encoder pulses from the start's edge.
  double position() const { return static_cast<double>(count_) + motion_.position; }
  double velocity() const { return motion_.velocity; }  ///< pulses/s
  /// pulses/s²: what the motor's current gives.
  double acceleration() const { return damping_ * (gain_ * static_cast<double>(difference_) - motion_.velocity); }

  /// UDC is 0 and the screw runs out before the next edge: no more encoder pulses come, unless the interpolator's do.
  bool comes_to_rest() const;

 private:
  explicit PulseLoop(const PulseLoopOptions& options);
  void count(int step);
  Passed run_one_direction(double at_most);

  double gain_, damping_;      // Kv and 1/τ
  std::int64_t least_, most_;  // of UDC
  std::int64_t to_come_ = 0, difference_ = 0, commanded_ = 0, passed_ = 0, count_ = 0, edges_ = 0, overflows_ = 0;
  Motion motion_;  // position past the edge that was counted last, 0 … 1: as exact after 10⁹ pulses as after one
};

}  // namespace leadscrew::servo
