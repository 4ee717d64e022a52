#pragma once
// One interpolator at work, clock by clock, with every register to be seen: tables, dumps and pictures of it all come
// from here.

#include <leadscrew/nc/method_traits.hpp>

namespace leadscrew::nc {

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

  /// What the visitor says of the interpolator as it stands.
  template <class Visitor>
  decltype(auto) look_at(const Visitor& visitor) const {
    return std::visit(visitor, state_);
  }

 private:
  template <class>
  struct OfRows;
  template <class... Rows>
  struct OfRows<TypeList<Rows...>> {
    using Interpolators = Joined<typename Rows::Curves...>;
  };
  using State = OfRows<MethodRows>::Interpolators::Variant;

  PulseMethod method_;
  PulseConventions conventions_;
  State state_;
  pulse::Point origin_, at_;
  std::int64_t clock_ = 0;
  pulse::Pulse<2> last_;
};

}  // namespace leadscrew::nc
