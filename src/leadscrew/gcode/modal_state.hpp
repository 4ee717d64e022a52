#pragma once
// What holds from block to block: the modes and numbers that a program sets.

#include <leadscrew/gcode/codes.hpp>
#include <leadscrew/gcode/move.hpp>
#include <limits>
#include <optional>

namespace leadscrew::gcode {

enum class Distance : std::uint8_t { absolute, incremental };                     // G90, G91
enum class FeedMode : std::uint8_t { per_minute, inverse_time, per_revolution };  // G94, G93, G95
enum class Retract : std::uint8_t { initial_level, r_level };                     // G98, G99

inline constexpr double seconds_per_minute = 60;

struct ModalState {
  Code motion = Code::G80;
  Plane plane = Plane::XY;
  Distance distance = Distance::absolute;
  Distance arc_distance = Distance::incremental;
  FeedMode feed_mode = FeedMode::per_minute;
  Retract retract = Retract::initial_level;
  bool polar = false;       ///< G16: axis words of the plane are a radius and an angle
  double polar_radius = 0;  ///< the last ones, as they were written
  double polar_angle = 0;   ///< degrees
  bool diameters = false;   ///< G7: X is a diameter
  bool tip_by_m = false;    ///< M428: tool centre point control stays on whatever the tool length
  int system = 1;           ///< the coordinate system in force: 1 … 9 for G54 … G59.3, 10 … for G54.1 P1 …

  PathMode path_mode = PathMode::blend;       ///< of the program
  double tolerance = 0;                       ///< mm, of the program
  std::optional<double> naive_cam_tolerance;  ///< mm, of the program
  double orientation_tolerance = 0;           ///< degrees, of the program or the machine
  // What moves carry of it, overridden where the options say so.
  PathMode effective_mode = PathMode::blend;
  double effective_tolerance = 0;            ///< mm
  double effective_naive_cam_tolerance = 0;  ///< mm

  bool feed_known = false;
  double linear_feed = 0;               ///< mm/s; of G95, at one revolution a minute
  double angular_feed = 0;              ///< degrees/s; likewise
  double feed_word = 0;                 ///< F of G94, as it was written; 0 where none holds
  double spindle_speed = 0;             ///< revolutions per minute, ≥ 0
  bool constant_surface_speed = false;  ///< G96
  double surface_speed = 0;             ///< mm/min, what S says in G96
  double surface_speed_word = 0;        ///< S of G96, as it was written
  base::Line surface_speed_line{};      ///< where it was written
  double most_spindle_speed = std::numeric_limits<double>::infinity();  ///< revolutions per minute, in G96
  Code spindle = Code::M5;                                              ///< M3, M4 or M5
  bool mist = false;                                                    ///< M7
  bool flood = false;                                                   ///< M8
  bool feed_override = true;                                            ///< M48 … M53: whether the machine obeys it
  bool speed_override = true;                                           ///< likewise
  bool adaptive_feed = false;
  bool feed_hold = true;
  std::optional<int> selected_tool;
  int loaded_tool = 0;
  std::optional<double> cutter;  ///< the D given last, as it was written
  Code cutter_side = Code::G40;  ///< G40, G41 or G42: on which side of the contour the tool is compensated
  bool tool_is_aside = false;    ///< behind G40: the tool is yet to go to where the program stands

  // The calls under way, and the fewest that were since a block was executed last.
  std::size_t calls = 0;
  std::size_t fewest_calls = 0;
  bool calls_macro = false;  ///< G66: a macro is called behind each block that moves
  bool in_profile = false;   ///< the block is one of the contour of Fanuc's G70 to G73
  bool is_plain = true;      ///< no mode asks for more than what axis words and F say: no G7, G96, M73, G66

  base::Line in_machine{};  ///< of G53: the block that had it last

  // Of the block in execution.
  Code to_do = Code::none;  ///< its motion
  base::Line line{};
};

}  // namespace leadscrew::gcode
