#pragma once
// What a task changes of its program and its machine.

#include <leadscrew/base/time.hpp>
#include <leadscrew/json/json.hpp>
#include <leadscrew/machine/machine.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::sweep {

/// One limit of one axis, times a factor.
struct ChangedLimit {
  /// Which: of the first derivative, the second or the third.
  enum class Order { velocity, acceleration, jerk };

  base::Axis axis = base::Axis::X;
  Order order = Order::velocity;
  double factor = 1;  ///< > 0
};
/// "velocity X".
std::string name(const ChangedLimit& limit);

struct Parameters {
  std::optional<double> tolerance{};            ///< mm, in place of P of G64 and of the machine's; ≥ 0
  double override_factor = 1;                   ///< of the programmed feed, 0.01 … 2
  std::optional<base::Period> period{};         ///< in place of the machine's
  double velocity = 1;                          ///< of every axis' limit, > 0
  double acceleration = 1;                      ///< the same
  double jerk = 1;                              ///< the same
  double tolerance_factor = 1;                  ///< of every tolerance, the program's and the machine's; > 0
  std::optional<ChangedLimit> changed_limit{};  ///< one limit more

  /// The machine as it then is.
  machine::Machine applied_to(machine::Machine machine) const;
};

/// Members of a row: each that is a parameter, as it is.
std::vector<json::Json::Member> members_of(const Parameters& parameters);

/// Values of each parameter, of which a sweep takes every combination; empty: as the program and the machine have it.
struct Grid {
  std::vector<double> tolerances{}, overrides{}, velocities{}, accelerations{}, jerks{};
  std::vector<base::Period> periods{};

  /// In the order of the lists, the last of them the fastest: tolerance, override, period, velocity, acceleration, jerk.
  std::vector<Parameters> combinations() const;
};

}  // namespace leadscrew::sweep
