#pragma once
// The programmed feed: ṡ ≤ F. It may jump from piece to piece, and infinite feed (a rapid) bounds nothing.

#include <cstddef>
#include <leadscrew/constraints/row.hpp>
#include <leadscrew/machine/machine.hpp>
#include <string_view>

namespace leadscrew::constraints {

class ProgrammedFeed {
 public:
  using Row = SpeedRow;
  static constexpr std::string_view name = "feed";
  static constexpr bool is_of_axes = false, is_proven = true, is_smooth = false;

  explicit ProgrammedFeed(const machine::Machine&) {}

  template <typename T, typename Take>
  void rows(const PlaceOf<T>& at, const Take& take) const {
    take(0, SpeedRowOf<T>{numeric::all<T>(1), at.feed});
  }
};

}  // namespace leadscrew::constraints
