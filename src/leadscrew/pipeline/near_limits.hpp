#pragma once
// By which limit motion is held: of those that it is near to, the one at work.

#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/machine/machine.hpp>
#include <optional>
#include <string>

namespace leadscrew::pipeline {

/// What motion waits for, or is held by.
struct Cause {
  enum class Kind : std::uint8_t { velocity, acceleration, jerk, chord_error, stop, dwell };

  Kind kind = Kind::stop;
  base::Axis axis = base::Axis::X;  ///< of the first three

  friend auto operator<=>(const Cause&, const Cause&) = default;
};
/// "velocity X", "acceleration Z", "jerk X", "chord", "stop", "dwell".
std::string name(const Cause& cause);

/// Of each kind of limit the greatest value over limit, ≥ 0, and which axis has it.
struct NearLimits {
  struct Ratio {
    double value = 0;
    base::Axis axis{};

    void raise(double ratio, base::Axis of) {
      if (ratio > value) value = ratio, axis = of;
    }
  };
  Ratio acceleration, jerk, velocity;
  double chord = 0;  ///< of the chord error

  /// The first of acceleration, jerk, velocity and chord that is at 97 % or above; none where none is.
  std::optional<Cause> at_work() const;
  /// That, or the nearest.
  Cause nearest() const;
};

/// While the axes of the machine move so: mm or degrees, and seconds.
NearLimits near_limits(const machine::Machine& machine, const base::AxisVector& velocity,
                       const base::AxisVector& acceleration, const base::AxisVector& jerk);

/// What holds motion at an instant.
struct Hold {
  enum class Kind : std::uint8_t {
    feed,          ///< it has the feed that is asked for
    velocity,      ///< of `axis`, as the next two
    acceleration,  ///< as above
    jerk,          ///< as above
    rest,          ///< it stands still
    what_comes,    ///< none of them: it makes ready for what follows
    chord_error,   ///< between words
  };
  Kind kind = Kind::rest;
  base::Axis axis{};  ///< of velocity, acceleration and jerk
};

/// Of motion at `feed` where `feed_asked` is asked for, of any one unit; infinite of a rapid.
Hold hold_of(const NearLimits& limits, double feed, double feed_asked);

}  // namespace leadscrew::pipeline
