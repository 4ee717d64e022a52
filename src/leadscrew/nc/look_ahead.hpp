#pragma once
// How fast blocks may end, where speed rises and falls: so that each of those behind can still be travelled, down to
// rest at the end of what is known.
//
// Speeds are those of the path, √Σ v² in steps a second over all axes. Where two blocks meet, an axis' velocity changes
// at once; by no more than its acceleration hides within half a step, √a/2.5, nor than a tenth of what it could change
// in the shorter block. Else the path rests there: at the speed from which it begins, a command every 2.5/√a seconds.
// Chords of one curve meet without such a limit: each keeps, at its rate, to how its curve bends.

#include <cstddef>
#include <deque>
#include <leadscrew/nc/feed_words.hpp>

namespace leadscrew::nc {

/// Blocks that are known and not yet begun.
class LookAhead {
 public:
  static constexpr std::size_t most_blocks = 64;

  explicit LookAhead(const machine::Machine& machine) : machine_(machine) {}

  std::size_t size() const { return blocks_.size(); }
  bool is_empty() const { return blocks_.empty(); }
  void push(const PlannedBlock& block) { blocks_.push_back(block); }

  struct Next {
    PlannedBlock planned;
    double entry_rate = 0, exit_rate = 0;  ///< commands/s, the greatest at its start and its end
    double rest_rate = 0;                  ///< commands/s from which it begins, and with which it ends, at rest
  };
  /// The first of them, where programmed feeds are multiplied so: none is entered faster than its own. Not when empty.
  Next pop(double feed_factor);

 private:
  double greatest_rate(const PlannedBlock& planned) const;
  double rest_rate(const PlannedBlock& planned) const;
  double junction(const PlannedBlock& before, const PlannedBlock& after) const;

  const machine::Machine& machine_;
  std::deque<PlannedBlock> blocks_;
  double feed_factor_ = 1;
  double entry_speed_ = 0;  // that the block before was allowed to end with
};

}  // namespace leadscrew::nc
