#pragma once
// One interpolator at work, clock by clock, with every register to be seen: tables, dumps and pictures of it all come
// from here.

#include <leadscrew/nc/pulse_method.hpp>
#include <leadscrew/pulse/linear.hpp>
#include <span>
#include <variant>

namespace leadscrew::nc {

/// Names as the papers have them: x y are coordinates from the centre, or from a line's start; Jx Jy the integrands of
/// a line, rx ry the remainders, nx ny the steps that are left, q the capacity, F the deviation.
struct Register {
  std::string_view name;
  std::int64_t value = 0;
};

class Registers {
 public:
  void add(std::string_view name, std::int64_t value) { all_[count_++] = {name, value}; }
  std::span<const Register> all() const { return {all_.data(), count_}; }

 private:
  std::array<Register, 9> all_{};
  std::size_t count_ = 0;
};

class PulseRun {
 public:
  /// A curve and options that problems_of() and capacity_problem() find nothing wrong with.
  PulseRun(PulseMethod method, const PulseCurve& curve, const MethodOptions& options = {});

  PulseMethod method() const { return method_; }
  const PulseConventions& conventions() const { return conventions_; }

  bool done() const;
  /// One clock.
  pulse::Pulse<2> step();

  std::int64_t clock() const { return clock_; }   ///< how many there were
  pulse::Pulse<2> last() const { return last_; }  ///< what the last one gave
  pulse::Point at() const { return at_; }         ///< in the curve's coordinates
  Registers registers() const;                    ///< the same ones in the same order at every clock

 private:
  template <pulse::Search method, pulse::OnCircle tie = pulse::OnCircle::outward>
  using Search = pulse::CircularSearch<method, tie>;
  using State =
      std::variant<Search<pulse::Search::point_comparison>,
                   Search<pulse::Search::point_comparison, pulse::OnCircle::inward>, Search<pulse::Search::least_error>,
                   Search<pulse::Search::improved_least_error>, pulse::CircularDda, pulse::LinearDda<2>,
                   pulse::LinearPointComparison<2>, pulse::LinearBresenham>;

  static State load(PulseMethod method, const PulseCurve& curve, const PulseConventions& conventions,
                    const MethodOptions& options);

  PulseMethod method_;
  PulseConventions conventions_;
  State state_;
  pulse::Point origin_, at_;
  std::int64_t clock_ = 0;
  pulse::Pulse<2> last_;
};

}  // namespace leadscrew::nc
