#pragma once
// Curves: G5 and G5.1 in one block, G5.2 to G5.3 (LinuxCNC) and G6.2 (Fanuc's G06.2) in many. Each becomes one move.
//
//     G5    P0 = start, P1 = start + (I, J), P2 = end + (P, Q), P3 = end
//     G5.1  P0 = start, P1 = start + (I, J), P2 = end
//
// are Bézier curves in X and Y. All other axes go in proportion to the parameter, for which their points stand at
// thirds or in the middle between start and end.

#include <leadscrew/gcode/motion.hpp>

namespace leadscrew::gcode {

class CurveReader : Part {
 public:
  CurveReader(const Context& context, Motion& motion, Travel& travel, Outbox& outbox)
      : Part(context), motion_(motion), travel_(travel), outbox_(outbox) {}

  /// G5 and G5.1.
  void spline(const Block& block);
  /// G5.2, its first block or one behind it.
  void nurbs(const Block& block);
  /// G5.3.
  void end_nurbs(const Block& block);
  /// G6.2, any of its blocks.
  void add_to_nurbs_with_knots(const Block& block);

  /// Whether a curve has begun that has not ended.
  bool open() const { return draft_.code != Code::none; }
  /// Between the first block of a curve and the last there is nothing but its points, their feed, and remarks: reports
  /// a block that is something else.
  void check(const Block& block);
  /// Modes come back within an open curve. Error: `unfinished-curve`.
  void refuse_modes();
  /// Where the text ends: reports a curve that has not ended.
  void end();
  /// The next G5 has no curve to go on from.
  void forget_tangent() { tangent_.reset(); }

  // An error in any of its blocks, or between them, spoils a curve.
  void note_errors() { draft_.errors = reporter_.errors(); }
  void spoil_after_errors() {
    if (reporter_.errors() != draft_.errors) draft_.spoiled = true;
  }
  void spoil() { draft_.spoiled = true; }

 private:
  bool spline_offset(const Block& block, char first, char second, PlanePoint& offset);
  bool first_offset(const Block& block, PlanePoint& offset);
  bool is_of_dialect(const Block& block);
  void begin_curve(const Block& block);
  void add_to_nurbs(const Block& block);
  void begin_nurbs_with_knots(const Block& block);
  void set_order(const Block& block, char letter, int least);
  void add_point(const Block& block, const base::AxisVector& position, char weight_letter);
  void add_knot(const Block& block, bool all_points);
  void finish_curve(const Block& block);
  bool join_start(const Block& block);
  void follow_curve(const Block& block, const Feed& feed, base::Line line);
  bool is_linear_curve() const;
  void abandon_curve();
  std::string unfinished_message() const;
  std::string unfinished_hint() const;
  [[gnu::cold]] bool curve_error(std::string_view code, std::uint32_t column, std::string message, std::string hint);

  // The curve being read, block by block. Once a problem of it has been reported, it is only followed to its end.
  struct Draft {
    Code code = Code::none;  // G5.2 or G6.2; none where no curve is open
    bool spoiled = false;  // it makes no move; what else seems wrong with its shape may follow from what has been said
    bool feed_given = false;
    std::int64_t errors = 0;  // of the text, when the last of its blocks had been read
    base::Line line{};
    std::uint32_t order = 0;
    std::size_t last_knots = 0;  // G6.2: behind the last point
    base::AxisVector last_point{};
  };

  Motion& motion_;
  Travel& travel_;
  Outbox& outbox_;
  Draft draft_;
  NurbsCurve curve_;
  // Of G5, for the next one: from its end, as seen from there, mm along X and Y of the machine.
  std::optional<PlanePoint> tangent_;
  base::AxisVector tangent_at_{};  // where that curve ends
};

}  // namespace leadscrew::gcode
