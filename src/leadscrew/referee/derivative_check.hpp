#pragma once
// Velocity, acceleration and jerk of each axis, from differences of words:
//
//     |Δᵏq|/Tᵏ is the k-th derivative averaged over k periods (a B-spline's weight), so that it never exceeds the
//     largest value of a motion, and a motion that stands still outside the trace is judged at both ends by words that
//     stand still.
//
// Words are rounded. A k-th difference of positions rounded to half a unit in the last place is off by at most 2ᵏ/2
// such units; the referee allows 8, of the largest position of that axis in the trace.

#include <array>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/referee/violation_log.hpp>

namespace leadscrew::referee {

/// The rounding bound of a difference of positions up to `largest`, mm or degrees: 8·ulp.
double rounding_of(double largest);

class DerivativeCheck {
 public:
  DerivativeCheck(const machine::Machine& machine, base::Period period);

  void observe(const base::AxisVector& position, base::Line line);
  /// After the last word, of this line: appends violations to the log and fills in the ratios.
  void conclude(base::Line line, Verdict& verdict, ViolationLog& log);

 private:
  static constexpr std::size_t orders = 3;
  static constexpr int levels = 128;        // of rounding bounds
  static constexpr int finest_level = -96;  // their binary exponents

  struct Limit {
    double value = 0;          // mm/s^k or degrees/s^k
    double power = 0;          // T^k
    double objectionable = 0;  // difference beyond which a trace without rounding is in violation
    double greatest = 0;       // |Δᵏq| so far
    double bound = 0;          // beyond which a violation is possible: objectionable + rounding so far
    /// How many differences remain violations up to a rounding bound of 2^level, for each level: the bound that counts
    /// is known only at the end.
    std::array<std::int64_t, levels> violations{};
  };

  struct Track {
    base::Axis axis{};
    double last = 0, first_difference = 0, second_difference = 0;
    double largest = 0;
    double rounding = 0;
    std::array<Limit, orders> limits;
  };

  struct Suspect {
    std::size_t track = 0, order = 0;
    double t = 0;
    base::Line line{};
    double difference = 0;
  };

  void difference(Track& track, double position, base::Line line);
  void widen(Track& track, double magnitude);
  void suspect(Track& track, std::size_t order, double difference, base::Line line);
  static std::size_t level_of(double excess);
  static std::int64_t count(const Limit& limit, double rounding);

  double period_;
  std::int64_t words_ = 0;
  std::size_t track_count_ = 0;
  std::array<Track, base::axis_count> tracks_;
  std::vector<Suspect> suspects_;
};

}  // namespace leadscrew::referee
