#pragma once
// What blocks mean: the modal state of the program, and the moves and events each block makes of it, in the order of
// execution of NIST IR 6556, 3.8:
//
//     feed mode · F · S · T · M62 … M65 M67 M68 · M6 · M3 M4 M5 · M7 M8 M9 · G4 · plane · units · tool length · coordinate system · path
//     control · distance mode · retract mode · G10 G28 G30 G92 · motion · M0 M1 M2 M30
//
// So an F word is read in the units that held before its block.

#include <array>
#include <cstdint>
#include <leadscrew/gcode/arc.hpp>
#include <leadscrew/gcode/block.hpp>
#include <leadscrew/gcode/drill_cycle.hpp>
#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/gcode/reporter.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::gcode {

inline constexpr double seconds_per_minute = 60;

class Interpreter {
 public:
  Interpreter(const machine::Machine& machine, const machine::ToolTable& tools, const ReaderOptions& options,
              Parameters& parameters, Frame& frame, Reporter& reporter);

  /// What became of a block that execute_plain() was given.
  enum class Plain { no, no_move, move };

  /// Executes, more quickly than execute() does, what nearly all blocks are: axis words and F, with G0 or G1 or
  /// neither. `no`: the block is something else and has not been executed. The caller passes a block without problems.
  Plain execute_plain(const Block& block, base::Line line, Move& move);

  /// Executes any block. If it or its reading had a problem it makes no move, but what is known of it takes effect, so
  /// that one problem does not make others of the blocks behind it.
  void execute(const Block& block, base::Line line);

  /// The next move of the block executed last; false after its last.
  bool next(Move& move);

  /// The program ends here, without saying so.
  void end(base::Line line);
  bool ended() const { return ended_; }

  /// A G code that is read.
  struct Code {
    GCode code = 0;
    Group group = Group::unknown;
    Letters words = "";        ///< letters it takes, but for axes and F
    Letters repeated_by = "";  ///< a motion: while it is in force these letters repeat it, without axis words
    bool takes_axes = false;   ///< other than a motion: the axis words of its block are its own
    void (Interpreter::*execute)(const Block&) = nullptr;
  };
  struct CodeTable;  // codes.cpp

  /// The circle of an arc, and its turns as in Move.
  struct ArcPlan {
    ArcCircle circle;
    int turns = 1;
  };

 private:
  enum class Distance : std::uint8_t { absolute, incremental };
  enum class FeedMode : std::uint8_t { per_minute, inverse_time };
  enum class Retract : std::uint8_t { initial_level, r_level };  // G98, G99

  // codes.cpp
  /// The row of a code that is read.
  static const Code& row_of(GCode code);
  /// "P belongs to G2, G3 and G4"
  static std::string users_of(char letter);

  // check.cpp: what can be said of a block before any of it is executed.
  void check(const Block& block);
  GCode motion_of(const Block& block);
  bool repeats_motion(const Block& block) const;
  void check_curve(const Block& block);
  std::uint32_t motion_words(const Block& block) const;
  void check_words(const Block& block);
  void check_axes(const Block& block);
  void check_presence(const Block& block);
  Plane plane_after(const Block& block) const;
  Distance distance_after(const Block& block) const;

  // interpreter.cpp: modes and events.
  void set_feed(const Block& block);
  void assume_feed();
  void set_spindle_and_tool(const Block& block);
  void set_outputs(const Block& block);
  void set_coolant(const Block& block);
  void dwell(const Block& block);
  void set_modes(const Block& block);
  void set_path_control(const Block& block);
  void stop(const Block& block);
  void emit_event(base::Event::Kind kind, double value = 0, std::int32_t output = 0);
  Move& emit(Move::Kind kind);
  void prepare(Move& move, Move::Kind kind, base::Line line) const;

  // offsets.cpp: where the program's coordinates lie.
  void set_tool_length(const Block& block);
  void select_system(int number);
  void set_system(const Block& block);
  void set_shift(const Block& block);
  void go_home(const Block& block);
  void set_home(const Block& block);

  // motion.cpp
  void execute_nonmodal(const Block& block);
  void execute_motion(const Block& block);
  void straight(const Block& block);
  /// Where the axis words lead, seen from a place: the coordinates of that place where there is none.
  base::AxisVector target_of(const Block& block, const base::AxisVector& from) const;
  base::AxisVector target_of(const Block& block) const { return target_of(block, frame_.position); }
  bool is_linear(const base::AxisVector& target) const;
  void line_to(const Block& block, const base::AxisVector& target, const Feed& feed);
  /// The feed of a move of linear axes, or of rotary ones only; `given`: its F word has been read.
  bool feed_of(const Block& block, bool linear, bool given, Feed& feed);
  std::uint32_t motion_column(const Block& block) const;

  // arc_motion.cpp
  void arc(const Block& block);
  bool arc_center(const Block& block, PlanePoint start, PlanePoint& center);
  bool report_circle(const Block& block, const ArcCircle& circle);
  bool plan_arc(const Block& block, PlanePoint start, PlanePoint end, ArcPlan& plan);
  void arc_inside(const Block& block, PlanePoint start, const ArcPlan& plan);

  // cycles.cpp
  void drill(const Block& block);
  bool can_drill(const Block& block);
  void plan_repeats(const Block& block, DrillCycle::Plan& plan);
  void plan_dwell(const Block& block, DrillCycle::Plan& plan);
  void plan_pecks(const Block& block, DrillCycle::Plan& plan);
  bool plan_levels(const Block& block, DrillCycle::Plan& plan);

  // travel.cpp
  bool inside_travel(const Block& block, const base::AxisVector& target);
  /// Finds the axes that are outside, where the position was changed without a check.
  void note_outside();
  /// Whether the block fails because an axis is outside; says so unless that has been said.
  bool fails_outside(const Block& block);
  bool axis_inside(base::Axis axis, double value, std::uint32_t column);
  bool bulge_inside(const Block& block, base::Axis axis, double low, double high);
  void report_travel(base::Axis axis, double value, std::uint32_t column);

  // curves.cpp
  void spline(const Block& block);
  bool spline_offset(const Block& block, char first, char second, PlanePoint& offset);
  bool first_offset(const Block& block, PlanePoint& offset);
  void begin_curve(const Block& block);
  void add_to_nurbs(const Block& block);
  void nurbs(const Block& block);
  void end_nurbs(const Block& block);
  void begin_nurbs_with_knots(const Block& block);
  void add_to_nurbs_with_knots(const Block& block);
  void set_order(const Block& block, char letter, int least);
  void add_point(const Block& block, const base::AxisVector& position, char weight_letter);
  void add_knot(const Block& block, bool all_points);
  void finish_curve(const Block& block);
  bool join_start(const Block& block);
  void follow_curve(const Block& block, const Feed& feed, base::Line line);
  bool is_linear_curve() const;
  void curve_inside(const Block& block);
  void abandon_curve();
  std::string unfinished_message() const;
  std::string unfinished_hint() const;
  [[gnu::cold]] bool curve_error(std::string_view code, std::uint32_t column, std::string message, std::string hint);
  [[gnu::cold]] bool error(std::string_view code, std::uint32_t column, std::string message, std::string hint) {
    return reporter_.error(code, column, std::move(message), std::move(hint));
  }

  const machine::Machine& machine_;
  const machine::ToolTable& tools_;
  const ReaderOptions& options_;
  Parameters& parameters_;
  Frame& frame_;
  Reporter& reporter_;

  // Modal state.
  GCode motion_ = 800;
  Plane plane_ = Plane::XY;
  Distance distance_ = Distance::absolute;
  Distance arc_distance_ = Distance::incremental;
  FeedMode feed_mode_ = FeedMode::per_minute;
  Retract retract_ = Retract::initial_level;
  PathMode path_mode_ = PathMode::blend;  // of the program
  double tolerance_ = 0;                  // mm, of the program
  std::optional<double> naive_cam_tolerance_;
  bool feed_known_ = false;
  double linear_feed_ = 0;   // mm/s
  double angular_feed_ = 0;  // degrees/s
  double spindle_speed_ = 0;
  std::optional<int> selected_tool_;
  int loaded_tool_ = 0;
  int system_ = 1;
  // What holds for the canned cycles since the last other motion: mm, dwell in seconds.
  struct CycleSeries {
    int code = 0;
    double initial_level = 0;
    std::optional<double> r, bottom, dwell, peck;
  };
  std::optional<CycleSeries> series_;

  // The curve being read, block by block. Once a problem of it has been reported, it is only followed to its end.
  struct Draft {
    GCode code = -1;       // G5.2 or G6.2; −1 where no curve is open
    bool spoiled = false;  // it makes no move; what else seems wrong with its shape may follow from what has been said
    bool feed_given = false;
    std::int64_t errors = 0;  // of the text, when the last of its blocks had been read
    base::Line line{};
    std::uint32_t order = 0;
    std::size_t last_knots = 0;  // G6.2: behind the last point
    base::AxisVector last_point{};
  };
  Draft draft_;
  NurbsCurve curve_;
  // Of G5, for the next one: from its end, as seen from there, mm along X and Y of the machine.
  std::optional<PlanePoint> tangent_;

  // What moves carry of it, overridden where the options say so.
  PathMode effective_mode_ = PathMode::blend;
  double effective_tolerance_ = 0;
  double effective_naive_cam_tolerance_ = 0;

  // Travel, with a margin for the rounding of inches; unlimited for an axis that the machine lacks.
  base::AxisVector travel_low_{};
  base::AxisVector travel_high_{};
  base::AxisSet outside_;           // axes whose position is outside
  base::AxisSet reported_outside_;  // those of them that have been reported
  base::AxisSet reported_lacking_;
  std::uint32_t machine_letters_ = 0;

  // The block in execution.
  GCode to_do_ = -1;  // its motion; −1 for none
  base::Line line_{};
  std::array<Move, 16> outbox_;
  std::size_t outbox_size_ = 0;
  std::size_t outbox_next_ = 0;
  DrillCycle cycle_;
  Feed cycle_feed_;
  std::optional<base::Event::Kind> stop_;
  bool ended_ = false;
};

}  // namespace leadscrew::gcode
