#pragma once
// A program as the canonical machining functions of NIST IR 6556, chapter 4, one line a call, in the form in which
// LinuxCNC's `rs274 -g` prints them:
//
//     1 N..... USE_LENGTH_UNITS(CANON_UNITS_MM)
//     7 N..... STRAIGHT_FEED(4.0000, 0.0000, -6.0000, 3.0000, 0.0000, 0.0000)
//
// Coordinates are the program's, in its units, along X Y Z A B C, and U V W where the machine has one of them. What holds
// for more than one call (units, offsets, rotation, plane, feed, path control) is printed where a call first depends on
// it: not where a block sets it, and not where nothing moves by it. A block that leads where the tool stands makes no
// call. What the machine is to make of the spindle is printed as the program says it: F of G95 under SET_FEED_MODE(0, 1)
// in units per revolution, S of G96 under SET_SPINDLE_MODE(0 D) in metres or feet per minute.

#include <cstdint>
#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/modal_state.hpp>
#include <leadscrew/gcode/move.hpp>
#include <string>
#include <string_view>

namespace leadscrew::gcode {

class CanonWriter {
 public:
  /// Of a machine with these axes.
  explicit CanonWriter(base::AxisSet axes);

  /// Adds what stands at the head of every program: units, offsets and rotation of none.
  void begin(std::string& text);
  /// Adds the calls of a move. `frame`, `system` (1 … 9: G54 … G59.3) and `modal` are those that held for its block.
  void write(const Move& move, const Frame& frame, int system, const ModalState& modal, std::string& text);

 private:
  /// Of a rigid tap, which is one call: its way in comes next, or its way back.
  enum class Tap : std::uint8_t { no, in, back };

  /// What was printed last: mm, degrees, and as each name says.
  struct Printed {
    double unit = 1;  ///< mm
    int system = 1;
    base::AxisVector origin{}, shift{}, tool{};
    double rotation = 0;  ///< degrees
    Plane plane = Plane::XY;
    PathMode path_mode = PathMode::blend;
    double tolerance = 0, naive_cam_tolerance = 0;  ///< mm
    bool path_known = false;
    double feed = 0;       ///< mm or degrees a minute, or a revolution
    bool in_step = false;  ///< with the spindle
    Tap tap = Tap::no;
    bool per_revolution = false;
    bool surface_speed = false;  ///< what S says, and at most how many revolutions a minute
    double surface_speed_word = 0, most_spindle_speed = 0;
  };

  void write_frame(const Frame& frame, int system, std::string& text);
  void write_path(const Move& move, std::string& text);
  void write_feed(const Move& move, std::string& text);
  void write_feed_mode(bool per_revolution, std::string& text);
  void write_spindle_mode(const ModalState& modal, bool may_tell_speed, std::string& text);
  bool is_untold(const Move& move, const Frame& frame);
  void write_arc(const Move& move, const Frame& frame, std::string& text);
  void write_event(const base::Event& event, std::string& text);
  void write_function(const base::Event& event, std::string& text);
  /// Of motion in step with the spindle; false where the move is not of it.
  bool write_in_step(const Move& move, const Frame& frame, int system, std::string& text);
  void write_straight(const Move& move, const Frame& frame, std::string& text);

  void call(std::string_view name, std::string& text);
  void number(double value, std::string& text);
  void axes(const base::AxisVector& value, std::size_t first, std::size_t count, std::string& text);
  void coordinates(const base::AxisVector& value, std::string& text);

  Printed printed_;
  bool has_uvw_;
  bool first_argument_ = true;
  std::int64_t calls_ = 0;
};

}  // namespace leadscrew::gcode
