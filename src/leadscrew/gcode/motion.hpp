#pragma once
// Moves of one block: where its axis words lead, at which feed; lines (motion.cpp) and arcs (arc_motion.cpp).

#include <leadscrew/gcode/arc.hpp>
#include <leadscrew/gcode/outbox.hpp>
#include <leadscrew/gcode/travel.hpp>
#include <optional>

namespace leadscrew::gcode {

class Motion : Part {
 public:
  Motion(const Context& context, Travel& travel, Outbox& outbox) : Part(context), travel_(travel), outbox_(outbox) {}

  /// G0 and G1.
  void straight(const Block& block);
  /// G2 and G3.
  void arc(const Block& block);
  /// Of one of them where nothing but offsets lies between the program's coordinates and the machine's: the circle that
  /// leads to the target in a turn at most and stays inside travel all round. Nothing where there is none, or it needs a
  /// closer look, which is for arc() to take.
  std::optional<ArcCircle> plain_circle(const Block& block, Code motion, const base::AxisVector& target) const;

  /// The feed mode and F of the block.
  void set_feed(const Block& block);
  /// Said once that there is no feed, what follows is read as if there were one.
  void assume_feed();
  /// The feed of a move of linear axes, or of rotary ones only; `given`: its F word has been read. False where there is
  /// none, which is reported.
  bool feed_of(const Block& block, bool linear, bool given, Feed& feed);

  /// Where the axis words lead, seen from a place: the coordinates of that place where there is none. Machine
  /// coordinates, mm and degrees.
  base::AxisVector target_of(const Block& block, const base::AxisVector& from) const;
  base::AxisVector target_of(const Block& block) const { return target_of(block, frame_.position); }
  /// Whether a linear axis moves on the way to the target.
  bool is_linear(const base::AxisVector& target) const;
  void line_to(const Block& block, const base::AxisVector& target, const Feed& feed);

 private:
  /// The circle of an arc, and its turns as in Move.
  struct ArcPlan {
    ArcCircle circle;
    int turns = 1;
    bool closes = false;   // ends where it begins, but for rounding
    bool reaches = false;  // ends where the block says
  };

  bool feed_per_revolution(const Block& block, Feed& feed);
  void tell_standing(const Block& block);
  bool bulges_outside(const ArcCircle& circle) const;
  bool arc_center(const Block& block, PlanePoint start, PlanePoint& center);
  bool report_circle(const Block& block, const ArcCircle& circle);
  bool plan_arc(const Block& block, PlanePoint start, PlanePoint end, ArcPlan& plan);
  void arc_inside(const Block& block, PlanePoint start, const ArcPlan& plan);
  void tip_arc_inside(const Block& block, PlanePoint start, const ArcPlan& plan, const base::AxisVector& target);
  bool place_circle(ArcPlan& plan) const;
  bool plan_closing_arc(const Block& block, PlanePoint start, PlanePoint end, ArcPlan& plan);
  bool plan_turned_arc(const Block& block, const base::AxisVector& target, ArcPlan& plan);
  void arc_as_curve(const Block& block, const ArcPlan& plan, const base::AxisVector& target, const Feed& feed);
  static double arc_length(PlanePoint start, const ArcPlan& plan, const Move& arc);

  Travel& travel_;
  Outbox& outbox_;
  bool told_standing_ = false;  // of the feed per revolution in force, that the spindle stands
};

}  // namespace leadscrew::gcode
