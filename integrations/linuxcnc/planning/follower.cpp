#include "follower.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace {

using Follower = leadscrew_tp_follower;

constexpr double memory = 0.016;      // s, of the estimate of the spindle: each of its three roots
constexpr double share = 0.5;         // of the limit of jerk, with which errors of speed are planned to be braked away
constexpr double place_share = 0.3;   // of both limits, with which errors of place are
constexpr double near_limit = 0.6;    // of the limits, from which on a polynomial ends the line
constexpr double most_burden = 0.92;  // of the limits: places before it are sums, and it is not
constexpr double slow = 1e-4, soft = 1;  // mm/s, mm/s²: rest
constexpr double largest_gain = 30;      // 1/s, of errors of place; four times as much of those of speed

/// y such that y·dy/dx ≤ `rate`: gain·x near 0, then the root.
double braked(double x, double rate, double gain) {
  const double distance = std::abs(x), linear = rate / (gain * gain);
  const double y = distance < linear ? gain * distance : std::sqrt(rate * (2 * distance - linear));
  return std::copysign(y, x);
}

double error_gain(const Follower& f) {
  return std::min(largest_gain, 0.125 / f.period);
}
double speed_gain(const Follower& f) {
  return 4 * error_gain(f);
}

/// The speed by which an error of place is made good, so that neither jerk nor acceleration exceed their shares: gain·e near 0;
/// then c·(e - e1/2)^⅔ with c = ∛(9/2·jerk), along which the jerk is constant; then √(c1² + 2·acceleration·(e - e2)).
double catching_up(const Follower& f, double error) {
  const double gain = error_gain(f), jerk = place_share * f.jerk, acceleration = place_share * f.acceleration;
  const double c = std::cbrt(4.5 * jerk);
  const double first = std::pow(2 * c / (3 * gain), 3);             // of e - e1/2, where both slopes are the gain
  const double second = std::pow(1.5 * acceleration / (c * c), 3);  // of it, where the acceleration is the share
  if (second <= first) return braked(error, acceleration, gain);
  const double far = std::abs(error) - first / 2;
  if (far <= first) return gain * error;
  const double root = std::cbrt(std::min(far, second)), speed = c * root * root;
  const double beyond = std::max(0.0, far - second);
  return std::copysign(std::sqrt(speed * speed + 2 * acceleration * beyond), error);
}

/// Takes a place of the spindle; Brookner, "Tracking and Kalman filtering made easy", table 1.3-1 (fading memory).
void estimate(Follower& f, double place) {
  if (!f.is_following) {
    f.place = place;
    f.speed = f.change = 0;
    f.is_following = 1;
    return;
  }
  const double t = f.period, theta = std::exp(-3 * t / memory), rest = 1 - theta;
  const double predicted = f.place + (f.speed + f.change * t / 2) * t;
  const double residual = place - predicted;
  f.place = predicted + (1 - theta * theta * theta) * residual;
  f.speed += f.change * t + 1.5 * (1 - theta * theta) * rest / t * residual;
  f.change += rest * rest * rest / (t * t) * residual;
}

/// A period with this acceleration, as far as the jerk's limit allows.
void move(Follower& f, double wanted) {
  const double t = f.period, most = f.jerk * t;
  const double next = f.a + std::clamp(std::clamp(wanted, -f.acceleration, f.acceleration) - f.a, -most, most);
  // Velocity and position are sums, so that differences of places are these very values.
  f.a = next;
  f.v += f.a * t;
  f.s += f.v * t;
}

/// The acceleration that leads to a speed.
double towards(const Follower& f, double speed) {
  return braked(speed - f.v, share * f.jerk, speed_gain(f));
}

/// The speed that sums lead to, where f.v is the mean of the last period.
double speed_now(const Follower& f) {
  return f.v + f.a * f.period / 2;
}

/// From s, v and a to rest at `end`, in this time.
std::array<double, 6> polynomial(const Follower& f, double end, double duration) {
  const double d = duration, begin = speed_now(f), x = end - f.s - (begin + f.a * d / 2) * d, v = -begin - f.a * d,
               a = -f.a;
  const double cube = d * d * d;
  return {f.s,
          begin,
          f.a / 2,
          (10 * x - 4 * v * d + a * d * d / 2) / cube,
          (-15 * x + 7 * v * d - a * d * d) / (cube * d),
          (6 * x - 3 * v * d + a * d * d / 2) / (cube * d * d)};
}

/// Its greatest share of the limits of acceleration and jerk; infinite where it turns back, is too fast, or becomes faster than
/// it begins by a quarter.
double burden(const Follower& f, const std::array<double, 6>& c, double duration) {
  double most = 0;
  for (int i = 0; i <= 8; ++i) {
    const double t = duration * i / 8;
    const double v = c[1] + t * (2 * c[2] + t * (3 * c[3] + t * (4 * c[4] + t * 5 * c[5])));
    const double a = 2 * c[2] + t * (6 * c[3] + t * (12 * c[4] + t * 20 * c[5]));
    const double j = 6 * c[3] + t * (24 * c[4] + t * 60 * c[5]);
    if (v < -slow || v > 1.25 * c[1] + slow || v > f.velocity) return std::numeric_limits<double>::infinity();
    most = std::max({most, std::abs(a) / f.acceleration, std::abs(j) / f.jerk});
  }
  return most;
}

void begin_polynomial(Follower& f, const std::array<double, 6>& c, double duration) {
  std::copy(c.begin(), c.end(), f.polynomial);
  f.elapsed = 0;
  f.duration = duration;
}

/// The speed from which a polynomial ends the line with this share of the limits.
double ending_speed(const Follower& f, double end) {
  constexpr double wanted = (near_limit + most_burden) / 2;
  // From speed v in a time d, v·d/2 far: accelerations up to 3/2·v/d, jerks up to 6·v/d².
  const double left = end - f.s - 1.5 * std::max(f.a, 0.0) * std::max(f.v, 0.0) / f.jerk;
  const double far = std::abs(left);
  const double v =
      std::min(std::cbrt(wanted * f.jerk * far * far * 2 / 3), std::sqrt(wanted * f.acceleration * far * 4 / 3));
  return std::copysign(v, left);
}

/// A period of the polynomial. Has it ended?
bool go_on(Follower& f, double end) {
  const double* c = f.polynomial;
  f.elapsed += f.period;
  if (f.elapsed >= f.duration - f.period / 2) {
    f.s = end;
    f.v = f.a = f.duration = 0;
    return true;
  }
  const double t = f.elapsed;
  f.s = c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5]))));
  f.v = c[1] + t * (2 * c[2] + t * (3 * c[3] + t * (4 * c[4] + t * 5 * c[5])));
  f.a = 2 * c[2] + t * (6 * c[3] + t * (12 * c[4] + t * 20 * c[5]));
  return false;
}

/// Begins the polynomial to rest at `end` where it is time.
void end_line(Follower& f, double end) {
  const double left = end - f.s;
  if (left <= 0 || f.v <= slow) return;
  const double duration = std::ceil(2 * left / speed_now(f) / f.period) * f.period;
  const std::array<double, 6> c = polynomial(f, end, duration);
  const double share_of_limits = burden(f, c, duration);
  if (share_of_limits >= near_limit && share_of_limits <= most_burden) begin_polynomial(f, c, duration);
}

}  // namespace

void leadscrew_tp_follower_begin(leadscrew_tp_follower* follower, double velocity, double acceleration, double jerk,
                                 double period) {
  *follower = {};
  follower->velocity = velocity;
  follower->acceleration = acceleration;
  follower->jerk = jerk;
  follower->period = period;
}

int leadscrew_tp_follower_follow(leadscrew_tp_follower* follower, double place, double end) {
  Follower& f = *follower;
  if (f.duration == 0) end_line(f, end);
  if (f.duration > 0) return go_on(f, end);
  estimate(f, place);
  // In the middle and at the end of this period, as the sums of move() have it.
  const double spindle_speed = f.speed + f.change * f.period / 2;
  const double error = f.place + spindle_speed * f.period - (f.s + (f.v + f.change * f.period) * f.period);
  const double wanted = spindle_speed + catching_up(f, error);
  const double most = std::isfinite(end) ? std::min(f.velocity, ending_speed(f, end)) : f.velocity;
  const double speed = std::clamp(wanted, -f.velocity, most);
  move(f, wanted <= most ? f.change + towards(f, speed - f.change * f.period) : towards(f, speed));
  const bool has_ended = std::isfinite(end) && std::abs(end - f.s) < 1e-7 && std::abs(f.v) < slow;
  if (has_ended) f.s = end;
  return has_ended;
}

int leadscrew_tp_follower_stop(leadscrew_tp_follower* follower) {
  Follower& f = *follower;
  f.duration = 0;
  if (std::abs(f.v) < slow && std::abs(f.a) < soft) {
    f.v = f.a = 0;
    return 1;
  }
  move(f, towards(f, 0));
  return 0;
}

int leadscrew_tp_follower_go(leadscrew_tp_follower* follower, double end) {
  Follower& f = *follower;
  if (f.duration == 0) {
    const double d = std::abs(end - f.s);
    if (d == 0) return 1;
    constexpr double margin = 1.02;
    // Of the polynomial from rest to rest: 15/8·d/t, 10/√3·d/t², 60·d/t³.
    const double duration = margin * std::max({1.875 * d / f.velocity, std::sqrt(5.7735 * d / f.acceleration),
                                               std::cbrt(60 * d / f.jerk), 2 * f.period});
    const double whole = std::ceil(duration / f.period) * f.period;
    f.v = f.a = 0;
    begin_polynomial(f, polynomial(f, end, whole), whole);
  }
  return go_on(f, end);
}
