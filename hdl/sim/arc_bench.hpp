#pragma once
// The four circular cores of rtl/paper beside the interpolators of pulse/ that they are.

#include <array>
#include <cmath>
#include <leadscrew/pulse/circular_dda.hpp>
#include <leadscrew/pulse/circular_search.hpp>
#include <sstream>
#include <string>

#include "clocked.hpp"

namespace leadscrew::hardware {

/// What pulse/ and a core both show of themselves: F, or the two remainders.
using Registers = std::array<std::int64_t, 2>;

template <pulse::Search method>
struct SearchReference : pulse::CircularSearch<method> {
  using pulse::CircularSearch<method>::CircularSearch;
  Registers registers() const { return {this->deviation(), 0}; }
};
using PointComparisonReference = SearchReference<pulse::Search::point_comparison>;
using LeastErrorReference = SearchReference<pulse::Search::least_error>;
using ImprovedLeastErrorReference = SearchReference<pulse::Search::improved_least_error>;

struct DdaReference : pulse::CircularDda {
  explicit DdaReference(const pulse::Arc& arc)
      : pulse::CircularDda(arc, {pulse::Order::parallel, pulse::Preload::half_lagging}) {}
  Registers registers() const { return {x().remainder(), y().remainder()}; }
};

template <typename Model>
Registers registers_of(const Model& model, int width) {
  if constexpr (requires { model.Val_f; }) {
    return {signed_of(model.Val_f, width + 3), 0};
  } else {
    return {model.Sum_X, model.Sum_Z};
  }
}

/// Is it an arc of pulse/, with a circle that fits registers of so many bits?
inline bool is_accepted(const pulse::Arc& arc, int width) {
  const auto square = [](pulse::Point at) { return at.x * at.x + at.y * at.y; };
  const std::int64_t greatest = (std::int64_t{1} << (width - 1)) - 3;
  const std::int64_t m = square(arc.start), n = square(arc.end);
  // Half a BLU is never met exactly: √n = √m ± ½ has no solution in whole numbers.
  return m > 0 && n > 0 && m <= greatest * greatest &&
         std::abs(std::sqrt(static_cast<long double>(n)) - std::sqrt(static_cast<long double>(m))) < 0.5L;
}

template <typename Model, typename Reference>
class ArcBench {
 public:
  explicit ArcBench(int width) : width_(width) {
    core_->Syn = 0;
    core_->rst = 1;
    core_.clock();
    core_->rst = 0;
  }

  void start(const pulse::Arc& arc) {
    const auto bits = [this](std::int64_t value) { return static_cast<std::uint32_t>(bits_of(value, width_)); };
    set(core_->Start_X0, bits(arc.start.x));
    set(core_->Start_Z0, bits(arc.start.y));
    set(core_->End_X1, bits(arc.end.x));
    set(core_->End_Z1, bits(arc.end.y));
    core_->Cw = !arc.is_counterclockwise();
    core_->Syn = 1;
    core_.clock();
    core_->Syn = 0;
  }

  /// Along the arc, clock by clock: "" where both are the same, else what is different.
  std::string follow(const pulse::Arc& arc) {
    Reference reference(arc);
    const std::int64_t most_clocks = 40 * pulse::root(arc.squared_radius(), 0) + 100;
    start(arc);
    pulse::Pulse<2> expected;
    for (std::int64_t clock = 0;; ++clock) {
      if (!is_as(reference, expected)) return told(arc, clock, "differs from pulse/");
      if (reference.done()) break;
      if (clock == most_clocks) return told(arc, clock, "has not ended");
      expected = reference.step();
      core_.clock();
    }
    core_.clock();
    if (core_->Busy || core_->X_Pwm_Out || core_->Z_Pwm_Out || at() != arc.end) return told(arc, 0, "does not rest");
    return "";
  }

  /// What is no arc is told, and nothing moves.
  std::string refuse(const pulse::Arc& arc) {
    start(arc);
    if (!core_->Err || core_->Busy) return told(arc, 0, "is not refused");
    core_.clock();
    if (!core_->Err || core_->Busy || core_->X_Pwm_Out || core_->Z_Pwm_Out) return told(arc, 1, "moves though refused");
    return "";
  }

  pulse::Point at() const { return {signed_of(core_->Val_x, width_), signed_of(core_->Val_z, width_)}; }
  Clocked<Model>& core() { return core_; }

 private:
  template <typename Port>
  static void set(Port& port, std::uint32_t bits) {
    port = static_cast<Port>(bits);
  }

  bool is_as(const Reference& reference, pulse::Pulse<2> pulse) const {
    const auto steps = [](bool has_stepped, bool up) {
      return static_cast<std::int8_t>(has_stepped ? (up ? 1 : -1) : 0);
    };
    return core_->Busy && !core_->Err && steps(core_->X_Pwm_Out, core_->X_Dir) == pulse.step[0] &&
           steps(core_->Z_Pwm_Out, core_->Z_Dir) == pulse.step[1] && at() == reference.at() &&
           registers_of(*core_.operator->(), width_) == reference.registers();
  }

  std::string told(const pulse::Arc& arc, std::int64_t clock, const char* what) const {
    std::ostringstream text;
    const Registers registers = registers_of(*core_.operator->(), width_);
    text << '(' << arc.start.x << ", " << arc.start.y << ") to (" << arc.end.x << ", " << arc.end.y << ") "
         << (arc.is_counterclockwise() ? "ccw" : "cw") << ": " << what << " at clock " << clock << ": (" << at().x
         << ", " << at().y << "), " << registers[0] << ' ' << registers[1] << ", busy " << int{core_->Busy} << ", err "
         << int{core_->Err};
    return text.str();
  }

  int width_;
  Clocked<Model> core_;
};

}  // namespace leadscrew::hardware
