#pragma once
// What holds from block to block: the modes and numbers that a program sets.

#include <leadscrew/gcode/codes.hpp>
#include <leadscrew/gcode/move.hpp>
#include <optional>

namespace leadscrew::gcode {

enum class Distance : std::uint8_t { absolute, incremental };     // G90, G91
enum class FeedMode : std::uint8_t { per_minute, inverse_time };  // G94, G93
enum class Retract : std::uint8_t { initial_level, r_level };     // G98, G99

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
  int system = 1;           ///< the coordinate system in force: 1 … 9 for G54 … G59.3

  PathMode path_mode = PathMode::blend;       ///< of the program
  double tolerance = 0;                       ///< mm, of the program
  std::optional<double> naive_cam_tolerance;  ///< mm, of the program
  // What moves carry of it, overridden where the options say so.
  PathMode effective_mode = PathMode::blend;
  double effective_tolerance = 0;            ///< mm
  double effective_naive_cam_tolerance = 0;  ///< mm

  bool feed_known = false;
  double linear_feed = 0;    ///< mm/s
  double angular_feed = 0;   ///< degrees/s
  double feed_word = 0;      ///< F of G94, as it was written; 0 where none holds
  double spindle_speed = 0;  ///< as S says it
  Code spindle = Code::M5;   ///< M3, M4 or M5
  bool mist = false;         ///< M7
  bool flood = false;        ///< M8
  std::optional<int> selected_tool;
  int loaded_tool = 0;

  // Of the block in execution.
  Code to_do = Code::none;  ///< its motion
  base::Line line{};
};

}  // namespace leadscrew::gcode
