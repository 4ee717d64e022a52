#pragma once
// F words that no motion can keep, because an axis is slower.

#include <leadscrew/base/borrowed.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/machine/machine.hpp>
#include <optional>
#include <set>

namespace leadscrew::pipeline {

/// A feed that an axis does not keep up with somewhere in a block, mm/s; degrees/s where rotary axes alone are fed.
struct FeedExcess {
  base::Axis axis{};
  bool is_rotary = false;  ///< degrees/s
  double asked = 0;
  double possible = 0;  ///< the least of the block by velocities of axes
};

/// The warning `feed-beyond-axis`; the reader knows its place.
base::Diagnostic warning_of(const FeedExcess& excess);

class FeedCheck {
 public:
  /// The constraints must outlive this.
  explicit FeedCheck(const constraints::Constraints& constraints) : constraints_(constraints) {}

  /// Each move of a program, in order. Returns an excess of its feed by more than 0.1 %, once for each line of the
  /// program, and of no more than 50 lines.
  std::optional<FeedExcess> observe(const gcode::Move& move);

 private:
  std::optional<FeedExcess> excess_of(const gcode::Move& move) const;
  void lower(const geometry::PointJet& jet, double rate, FeedExcess& excess) const;

  const constraints::Constraints& constraints_;
  std::set<base::Line> lines_;  ///< whose excess was returned
};

}  // namespace leadscrew::pipeline
