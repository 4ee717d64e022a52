#pragma once
// Moves along a path of the tip and its direction, a curve at a time, each inside travel.

#include <leadscrew/gcode/outbox.hpp>
#include <leadscrew/gcode/pose_path.hpp>
#include <leadscrew/gcode/travel.hpp>

namespace leadscrew::gcode {

class PoseMoves : Part {
 public:
  PoseMoves(const Context& context, Travel& travel, Outbox& outbox) : Part(context), travel_(travel), outbox_(outbox) {}

  PosePath& path() { return path_; }
  const PosePath& path() const { return path_; }

  /// The next move, of this line: there is any. Exact, since a path that is smooth needs no rounding. False where it leaves travel, which is reported
  /// as of the block.
  bool take(const Block& block, base::Line line, const Feed& feed, bool at_contact, Move& move);

 private:
  bool is_inside(const Block& block, const NurbsCurve& curve);

  Travel& travel_;
  Outbox& outbox_;
  PosePath path_;
};

}  // namespace leadscrew::gcode
