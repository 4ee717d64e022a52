#pragma once
// Which limit is worth buying: by how much the time of all programs changes with each, planned anew, not estimated.

#include <leadscrew/json/json.hpp>
#include <leadscrew/sweep/archive.hpp>
#include <map>
#include <string>
#include <vector>

namespace leadscrew::sweep {

/// Less and more of each limit, and of the tolerance, by this share.
inline constexpr double changed_by = 0.05;

/// For each of the parameters: itself, and with each limit of each axis that one of the machines has, and the tolerance, less and
/// more.
std::vector<Parameters> with_changes(const std::vector<Parameters>& parameters,
                                     const std::vector<NamedMachine>& machines);

struct Sensitivity {
  std::string machine, limit;  ///< "acceleration X", "tolerance"
  double time_s = 0;           ///< of the programs that all variants could run
  double time_less_s = 0;      ///< with 5 % less of the limit
  double time_more_s = 0;      ///< with 5 % more

  /// Per cent of time for one per cent of the limit: below 0 where more of it makes motion shorter.
  double elasticity() const { return (time_more_s - time_less_s) / (2 * changed_by * time_s); }
};

class Sensitivities {
 public:
  void observe(const json::Json& row);
  /// After the last row, what saves most first.
  std::vector<Sensitivity> found() const;

 private:
  struct Times {
    std::map<double, double> by_factor;  ///< s; 1: unchanged
  };
  struct Place {
    std::string program, machine, parameters;
    auto operator<=>(const Place&) const = default;
  };
  std::map<Place, std::map<std::string, Times>> programs_;  ///< of each limit; "" unchanged
};

json::Json json_of(const Sensitivity& sensitivity);
/// Bars of the elasticities, and what 5 % more of each limit saves.
std::string sensitivity_picture(const std::vector<Sensitivity>& found);

}  // namespace leadscrew::sweep
