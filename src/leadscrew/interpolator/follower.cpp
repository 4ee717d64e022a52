#include <algorithm>
#include <cmath>
#include <leadscrew/interpolator/follower.hpp>
#include <leadscrew/numeric/functions.hpp>

namespace leadscrew::interpolator {

namespace {

constexpr double share = 0.5;            // of the limits, with which errors are planned to be braked away
constexpr double within_limits = 0.999;  // of them is used, for rounding
constexpr int halvings = 60;

struct Stop {
  double peak = 0;      ///< of the acceleration, units/s²; of the sign of the motion that is braked
  double hold = 0;      ///< s at it
  double distance = 0;  ///< units, signed
  double sign = 1;      ///< of that motion
};

/// From v and a to rest as soon as jerk and acceleration allow: down to −peak, on, and back to 0,
///
///     v + a²/2J = peak²/J + peak·hold,   peak ≤ A
Stop stop_from(double v, double a, double acceleration, double jerk) {
  Stop stop;
  if (v + a * std::abs(a) / (2 * jerk) < 0) {
    stop.sign = -1;
    v = -v;
    a = -a;
  }
  stop.peak = std::sqrt(std::max(jerk * v + a * a / 2, 0.0));
  if (stop.peak > acceleration) {
    stop.peak = acceleration;
    stop.hold = (v + a * a / (2 * jerk)) / acceleration - acceleration / jerk;
  }
  const double down = std::max((a + stop.peak) / jerk, 0.0), up = stop.peak / jerk;
  const double held = v + (a - jerk * down / 2) * down;  // speed as the peak is reached
  stop.distance = stop.sign * ((v + (a / 2 - jerk * down / 6) * down) * down +
                               (held - stop.peak * stop.hold / 2) * stop.hold + stop.peak * up * up / 6);
  return stop;
}

/// y such that y·dy/dx ≤ `rate`: gain·x near 0, then the root.
double braked(double x, double rate, double gain) {
  const double distance = std::abs(x), linear = rate / (gain * gain);
  const double y = distance < linear ? gain * distance : std::sqrt(rate * (2 * distance - linear));
  return std::copysign(y, x);
}

}  // namespace

Follower::Follower(const machine::Derivatives& limits, double period, double tolerance, double memory)
    : limits_{limits.velocity * within_limits, limits.acceleration * within_limits, limits.jerk * within_limits},
      period_(period),
      tolerance_(tolerance),
      memory_(std::max(memory, 4 * period)) {}

/// Takes a place of the spindle; Brookner, "Tracking and Kalman filtering made easy", table 1.3-1 (fading memory).
void Follower::estimate(double place) {
  const double t = period_;
  if (places_ < 2) {
    speed_ = places_ == 0 ? 0 : (place - place_) / t;
    place_ = place;
    change_ = 0;
    ++places_;
    return;
  }
  const double theta = 1 / (1 + 3 * t / memory_), rest = 1 - theta;
  const double predicted = place_ + (speed_ + change_ * t / 2) * t, residual = place - predicted;
  place_ = predicted + (1 - theta * theta * theta) * residual;
  speed_ += change_ * t + 1.5 * (1 - theta * theta) * rest / t * residual;
  change_ += rest * rest * rest / (t * t) * residual;
}

/// At the end of the period.
double Follower::wanted_acceleration() const {
  constexpr double gain_by_period = 0.1, between_loops = 4;
  const double t = period_, gain = std::min(limits_.jerk / limits_.acceleration, gain_by_period / t);
  const double error = place_ + (speed_ + change_ * t / 2) * t - (s_ + (v_ + a_ * t / 2) * t);
  const double most = limits_.velocity;
  const double speed =
      std::clamp(speed_ + change_ * t + braked(error, share * limits_.acceleration, gain), -most, most);
  const double wanted = change_ + braked(speed - (v_ + a_ * t), share * limits_.jerk, between_loops * gain);
  return std::clamp(wanted, -limits_.acceleration, limits_.acceleration);
}

/// Does the stop from where this jerk leads keep the velocity and the end, and turn back only if it may?
bool Follower::may_take(double jerk, Back back, double end) const {
  const double t = period_, a = a_ + jerk * t, v = v_ + (a_ + jerk * t / 2) * t;
  if (std::abs(v) > limits_.velocity || std::abs(v + a * std::abs(a) / (2 * limits_.jerk)) > limits_.velocity)
    return false;
  const double s = s_ + (v_ + (a_ / 2 + jerk * t / 6) * t) * t;
  const Stop stop = stop_from(v, a, limits_.acceleration, limits_.jerk);
  if (back == Back::never && (v < 0 || stop.sign < 0)) return false;
  if (s + stop.distance > end) return false;
  if (!(v > 0 && stop.sign < 0)) return true;
  // It turns back before it rests.
  const double j = limits_.jerk, turn = (-a - std::sqrt(std::max(a * a - 2 * j * v, 0.0))) / j;
  return s + (v + (a / 2 + j * turn / 6) * turn) * turn <= end;
}

void Follower::move(double jerk) {
  const double t = period_;
  s_ += (v_ + (a_ / 2 + jerk * t / 6) * t) * t;
  v_ += (a_ + jerk * t / 2) * t;
  a_ += jerk * t;
}

void Follower::begin(Task task, const std::array<Phase, 3>& phases, double end) {
  task_ = task;
  manoeuvre_ = {phases, s_, v_, a_, 0, end};
}

/// The stop from here, with so much jerk.
void Follower::begin_braking(Task task, double jerk, double end) {
  const Stop stop = stop_from(v_, a_, limits_.acceleration, jerk);
  const double down = std::max((stop.sign * a_ + stop.peak) / jerk, 0.0);
  begin(task, {{{-stop.sign * jerk, down}, {0, stop.hold}, {stop.sign * jerk, stop.peak / jerk}}}, end);
}

/// To rest at the very end: jerk is what makes the stop so long. False where no jerk does.
bool Follower::end_at(double end) {
  if (v_ <= 0) return false;
  const double braking = a_ < 0 ? v_ : limits_.velocity - v_;
  const double least = braking > 0 ? a_ * a_ / (2 * limits_.jerk * braking) : 1;
  double low = std::max(least, 1e-9), high = 1;
  const auto distance = [&](double part) {
    return stop_from(v_, a_, limits_.acceleration, part * limits_.jerk).distance;
  };
  if (!(low < 1) || distance(low) < end - s_ || distance(high) > end - s_) return false;
  for (int k = 0; k < halvings; ++k) {
    const double middle = (low + high) / 2;
    (distance(middle) > end - s_ ? low : high) = middle;
  }
  begin_braking(Task::ending, high * limits_.jerk, end);
  return true;
}

void Follower::begin_stop(Task task) {
  begin_braking(task, limits_.jerk, s_ + stop_from(v_, a_, limits_.acceleration, limits_.jerk).distance);
}

/// A period of the manoeuvre. Has it ended?
bool Follower::go_on() {
  Manoeuvre& m = manoeuvre_;
  m.elapsed += period_;
  double left = m.elapsed;
  s_ = m.s;
  v_ = m.v;
  a_ = m.a;
  for (const Phase& phase : m.phases) {
    const double t = std::min(left, phase.duration);
    s_ += (v_ + (a_ / 2 + phase.jerk * t / 6) * t) * t;
    v_ += (a_ + phase.jerk * t / 2) * t;
    a_ += phase.jerk * t;
    left -= t;
  }
  if (left <= 0) return false;
  s_ = m.end;
  v_ = a_ = 0;
  task_ = Task::none;
  return true;
}

/// Of a manoeuvre that leads to the end, or to rest before it: on from there.
void Follower::go_on_to(double end) {
  if (!go_on()) return;
  if (s_ == end || !std::isfinite(end)) {
    rests_ = true;
  } else {
    begin_line(Task::approaching, end);
  }
}

/// As much of this jerk as keeps the velocity: the hardest braking does.
double Follower::within_velocity(double jerk) const {
  if (may_take(jerk, Back::with_spindle, HUGE_VAL)) return jerk;
  const double brake = std::min(limits_.jerk, (limits_.acceleration + (v_ > 0 ? a_ : -a_)) / period_);
  double low = v_ > 0 ? -brake : brake, high = jerk;
  for (int k = 0; k < halvings / 2; ++k) {
    const double middle = (low + high) / 2;
    (may_take(middle, Back::with_spindle, HUGE_VAL) ? low : high) = middle;
  }
  return low;
}

void Follower::follow(double place, double end, Back back) {
  if (is_stopped_) return stop();
  if (task_ == Task::pausing) {
    estimate(place);
    go_on();
    return;
  }
  if (task_ != Task::none) return go_on_to(end);
  if (rests_ && s_ == end) return;
  rests_ = false;
  in_step_ = std::abs(s_ - place) <= tolerance_;
  if (!in_step_) run_in_ = std::max(run_in_, s_);
  estimate(place);
  const double wanted = (wanted_acceleration() - a_) / period_;
  const double jerk = within_velocity(std::clamp(wanted, -limits_.jerk, limits_.jerk));
  if (may_take(jerk, back, end)) return move(jerk);
  if (may_take(jerk, Back::with_spindle, end)) {
    begin_stop(Task::pausing);
    go_on();
    return;
  }
  if (!end_at(end)) begin_stop(Task::stopping);
  go_on_to(end);
}

void Follower::stop() {
  is_stopped_ = true;
  if (rests_) return;
  if (task_ != Task::stopping) begin_stop(Task::stopping);
  rests_ = go_on();
}

void Follower::go(double end) {
  if ((task_ == Task::ending || task_ == Task::approaching) && manoeuvre_.end == end) return go_on_to(end);
  if (task_ != Task::going && task_ != Task::stopping) {
    rests_ = s_ == end && v_ == 0 && a_ == 0;
    if (rests_) return;
    v_ == 0 && a_ == 0 ? begin_line(Task::going, end) : begin_stop(Task::stopping);
  }
  rests_ = go_on() && s_ == end;
}

/// From rest to rest by jerks j, −j, −j, j for t each: 2jt³ far, jt² fast, accelerations jt.
void Follower::begin_line(Task task, double end) {
  const double d = end - s_, far = std::abs(d);
  const double t = std::max({numeric::cbrt(far / (2 * limits_.jerk)), std::sqrt(far / (2 * limits_.acceleration)),
                             far / (2 * limits_.velocity)});
  const double jerk = d / (2 * t * t * t);
  begin(task, {{{jerk, t}, {-jerk, 2 * t}, {jerk, t}}}, end);
}

}  // namespace leadscrew::interpolator
