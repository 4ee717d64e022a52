#pragma once
// Back along the tool path: axes that came to rest behind the place where a program goes on return to it the way they
// came, not across what has been made.
//
//    goes on here ●━━━━━●━━━━━━━━━● rest      In hops from rest to rest: s falls by u³(10 − 15u + 6u²), so slowly that
//                    ◀──    ◀── s(u)          words a period apart keep every limit of every axis, and every place its
//                                             feed. A hop that would take long is made as two: one slow place, a bend
//                                             of some µm, must not slow the whole path; and at each rest it may be
//                                             ended.

#include <cstddef>
#include <leadscrew/base/word.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <optional>
#include <vector>

namespace leadscrew::pipeline {

/// A part of the tool path, from one length travelled on it to another, units of base::Word::path_length.
class PathStretch {
 public:
  /// 0 ≤ from ≤ to.
  PathStretch(double from, double to) : from_(from), to_(to) {}

  /// The path's next element, from its beginning on; what lies outside the stretch is not kept.
  void push(const toolpath::Element& element);
  /// Has all of it been pushed? Nothing can be asked about it before.
  bool is_whole() const { return !parts_.empty() && length_ >= to_ - rounded; }

  double from() const { return from_; }
  double to() const { return to_; }
  /// Where the path is at s, from ≤ s ≤ to.
  base::PathPlace at(double s) const;
  /// By programmed feed, units/s; infinite for a rapid.
  double greatest_speed(double s) const;

 private:
  struct Part {
    toolpath::Piece piece;
    double begin = 0;  ///< length of the path before it
  };
  static constexpr double rounded = 1e-6;  // lengths were, piece by piece

  const Part& part_at(double s) const;

  double from_, to_;
  double length_ = 0;  ///< of all that was pushed
  std::vector<Part> parts_;
};

/// A place for each period, from the first behind rest at the stretch's end to rest at its beginning; where it rests on
/// the path, the same place four times. No hop takes longer than `longest_hop`, s, but for what a period rounds.
/// Nothing where the machine cannot move at all.
std::optional<std::vector<base::PathPlace>> plan_return(const PathStretch& stretch, const machine::Machine& machine,
                                                        double longest_hop = 1);

}  // namespace leadscrew::pipeline
