#pragma once
// Random part programs, as text, on random machines: those of campaign/, drawn by RapidCheck, which makes them smaller.

#include <cstdio>
#include <initializer_list>
#include <leadscrew/campaign/draws.hpp>
#include <leadscrew/campaign/five_axis_program.hpp>
#include <leadscrew/campaign/random_machines.hpp>
#include <leadscrew/campaign/random_program.hpp>
#include <leadscrew/campaign/tilted_program.hpp>
#include <leadscrew/campaign/vector_program.hpp>
#include <leadscrew/machine/machine.hpp>
#include <optional>
#include <random_numbers.hpp>
#include <string>
#include <vector>

namespace leadscrew::testing_support {

/// What campaign/ draws its programs from, the same on every computer.
struct RapidDraws {
  template <typename Whole>
  Whole any(Whole low, Whole high) const {
    return testing_support::any(low, high);
  }
  bool once_in(int times) const { return any(0, times) == 0; }
  bool either() const { return *rc::gen::arbitrary<bool>(); }
  double between(double least, double greatest) const { return testing_support::between(least, greatest); }
  double logarithmic(double low, double high) const { return campaign::by_magnitude(low, high, any(0, 1000001)); }
  template <typename Value>
  Value one_of(std::initializer_list<Value> values) const {
    return *rc::gen::elementOf(std::vector<Value>(values));
  }
};

inline RapidDraws rapid_draws;

inline machine::Machine random_machine() {
  return campaign::random_machine(rapid_draws);
}
inline machine::Machine five_axes() {
  return campaign::five_axes(rapid_draws);
}
inline machine::Machine tilting_machine() {
  return campaign::tilting_machine(rapid_draws);
}

struct RandomProgram {
  static std::string make(int most_blocks = 24) {
    return campaign::RandomProgram(rapid_draws, std::nullopt).make(most_blocks);
  }
};

struct FiveAxisProgram : campaign::FiveAxisProgram<RapidDraws> {
  explicit FiveAxisProgram(const machine::Machine& machine)
      : campaign::FiveAxisProgram<RapidDraws>(rapid_draws, machine) {}
};

struct VectorProgram : campaign::VectorProgram<RapidDraws> {
  explicit VectorProgram(const machine::Machine& machine) : campaign::VectorProgram<RapidDraws>(rapid_draws, machine) {}
};

struct TiltedProgram : campaign::TiltedProgram<RapidDraws> {
  TiltedProgram() : campaign::TiltedProgram<RapidDraws>(rapid_draws) {}
};

/// Velocity, acceleration and jerk of its axes, a line for each: what it takes to build it again.
inline std::string limits_of(const machine::Machine& machine) {
  std::string text;
  for (const auto& axis : machine.axes) {
    if (!axis) continue;
    char line[80];
    std::snprintf(line, sizeof line, "(%.17g %.17g %.17g)\n", axis->velocity, axis->acceleration, axis->jerk);
    text += line;
  }
  return text;
}

}  // namespace leadscrew::testing_support
