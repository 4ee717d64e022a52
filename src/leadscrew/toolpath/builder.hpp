#pragma once
// From moves to the tool path, streaming: moves are pushed, and elements come out once nothing ahead can change them.
//
// In exact-path and exact-stop mode (G61, G61.1) every move is kept as programmed, a NURBS curve as its smooth pieces
// (geometry::smooth_pieces). Where blending is asked for (G64), moves that follow one another without a dwell or an
// event that motion rests for are smoothed together, each within its tolerance: those in X, Y and Z alone along the path of least time
// (RacingLine) where the machine asks for it, all others by blends and fits (Smoother). All other events lie where
// the move begins that follows them, or stand by themselves where motion rests before there is one.

#include <array>
#include <deque>
#include <leadscrew/base/borrowed.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <leadscrew/toolpath/racing_line.hpp>
#include <leadscrew/toolpath/smoother.hpp>
#include <leadscrew/toolpath/transformation_of_moves.hpp>
#include <memory>
#include <optional>
#include <vector>

namespace leadscrew::toolpath {

class Builder {
 public:
  /// By blends and fits.
  Builder() = default;
  /// As the machine asks for (machine::Smoothing), with what its period keeps of tolerances for chords between words. It
  /// must outlive the builder. Moves of the tool's tip need one that has a chain of rotary axes. tables: of blends and
  /// fits, by arc length.
  explicit Builder(base::Borrowed<machine::Machine> machine, const geometry::MapTolerance& tables = tables_for_motion);

  void push(const gcode::Move& move);
  /// From now on an event says where a move begins whose feed is not that of the one before (Event::programmed_feed).
  void tell_feed() { told_feed_ = -1; }
  /// The same of the tool that a move is made with, and of what its feed is counted by (Event::tool_offset, tip_control).
  void tell_tool() { told_tool_ = ToldTool(); }
  /// Motion rests where feeds per revolution begin and end, and an event says for which S they are planned
  /// (Event::feed_per_revolution).
  void tell_revolutions() { told_speed_ = 0; }
  /// No more moves will come.
  void finish();
  /// The next element that is settled, if there is one.
  std::optional<Element> pop();

 private:
  void rest(const base::AxisVector& place, double seconds, base::Line line);
  void move_along(const gcode::Move& move);
  void change_transformation(const gcode::Move& move);
  void settle_piece(Piece piece);
  Allowance allowance_of(const gcode::Move& move, const Piece& piece) const;
  double turning_allowed(const gcode::Move& move) const;
  void take_space(const gcode::Move& move);
  void blend(Leg leg);
  template <class Blending>
  void settle(std::optional<Blending>& blending);
  template <class Blending>
  void take_settled(std::optional<Blending>& blending);
  void note_feed(base::Line line, double feed);
  [[gnu::cold]] void take_revolutions(const gcode::Move& move);
  [[gnu::cold]] void note_tool(const gcode::Move& move);
  void flush();
  void settle_events(bool motion_follows);

  const machine::Machine* machine_ = nullptr;
  std::optional<RacingLine> racing_line_;
  Sampling sampling_;
  geometry::MapTolerance tables_ = tables_for_motion;
  bool seeks_least_time_ = false;  ///< by racing lines
  std::optional<Smoother> smoother_;
  /// Of the moves being pushed; none: their coordinates are the machine's axes'.
  std::shared_ptr<const kinematics::Transformation> transformation_;
  TransformationOfMoves transformations_;
  /// Of the moves being pushed; none: none of them has been rounded since coordinates have this meaning.
  std::optional<ToleranceSpace> space_;
  std::vector<EventMark> passed_;    ///< events where the next move begins
  std::optional<double> told_feed_;  ///< by the last event
  std::optional<double>
      told_speed_;  ///< revolutions per minute for which feeds per revolution are planned; 0: of others
  struct ToldTool {
    std::array<double, 3> offset{};
    bool is_of_tip = false;
  };
  std::optional<ToldTool> told_tool_;  ///< likewise
  std::deque<Element> settled_;
};

}  // namespace leadscrew::toolpath
