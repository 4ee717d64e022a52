#pragma once
// Where the program's coordinates lie: coordinate systems, shifts, tool lengths, and the places to go home to.

#include <leadscrew/gcode/motion.hpp>

namespace leadscrew::gcode {

class Offsets : Part {
 public:
  Offsets(const Context& context, Motion& motion) : Part(context), motion_(motion) {}

  /// What parameters say where a program begins: the coordinate system in force, and G92.
  void begin();
  /// G43, G43.1, G43.2, G49.
  void set_tool_length(const Block& block);
  /// G54 … G59.3, by their numbers 1 … 9.
  void select_system(int number);
  /// G10.
  void set_system(const Block& block);
  /// G92, G92.1, G92.2, G92.3.
  void set_shift(const Block& block);
  /// G28, G30.
  void go_home(const Block& block);
  /// G28.1, G30.1.
  void set_home(const Block& block);

 private:
  void note_missing_table(const Block& block);

  Motion& motion_;
  bool told_of_table_ = false;
};

}  // namespace leadscrew::gcode
