#pragma once
// Where the program's coordinates lie: coordinate systems, shifts, tool lengths, and the places to go home to.

#include <leadscrew/gcode/motion.hpp>

namespace leadscrew::gcode {

/// The number of the coordinate system that G10 L2 or L20 with P sets, as Offsets::select_system() takes it; P0 is the one in
/// force. std::nullopt where P is none.
std::optional<int> system_set_by(const Block& block, Dialect dialect, int in_force);
/// Whether it is G10 L2 P0 of Fanuc's and Haas' dialects, which sets what shifts all coordinate systems.
bool sets_shift_of_all(const Block& block, Dialect dialect);

class Offsets : Part {
 public:
  Offsets(const Context& context, Motion& motion) : Part(context), motion_(motion) {}

  /// What parameters say where a program begins: the coordinate system in force, and G92.
  void begin();
  /// G43, G43.1, G43.2, G49.
  void set_tool_length(const Block& block);
  /// M428, M429.
  [[gnu::cold]] void switch_tip_control(const Block& block);
  /// G54 … G59.3, G54.1 P1 … P300, G154 P1 … P99.
  void select_system(const Block& block);
  /// By their numbers: 1 … 9 for G54 … G59.3, 10 … for G54.1 P1 ….
  void select_system(int number);
  /// G10.
  void set_system(const Block& block);
  /// G52: the shift is what the axis words say.
  void set_local(const Block& block);
  /// G92, G92.1, G92.2, G92.3.
  void set_shift(const Block& block);
  /// Whether those two are in force.
  bool are_shifted() const { return parameters_.get(Parameters::g92_active).value_or(0) != 0; }
  /// As G92.3 and G92.2 do.
  void put_shift_in_force(bool is_in_force);
  /// G28, G30.
  void go_home(const Block& block);
  /// G28.1, G30.1.
  void set_home(const Block& block);

 private:
  /// Calls f(axis, value of its word in mm or degrees) for each axis word.
  template <class F>
  void for_each_axis_word(const Block& block, F&& f) const {
    for (const base::Axis axis : base::all_axes) {
      const char letter = base::letter(axis);
      if (block.has(letter)) f(axis, block[letter] * frame_.unit(axis));
    }
  }
  void note_missing_table(const Block& block);
  void begin_tip_control(std::uint32_t column);
  bool fails_under_tip_control(const Block& block);
  const machine::Tool* tool_of(const Block& block, bool& known);
  void set_tool(const Block& block, int kind);
  bool is_of_tool(int kind) const;
  bool has_registers() const;
  double set_by_g10(double held, double given) const;
  machine::Tool tool_to_set(int number) const;
  bool set_shape(const Block& block, machine::Tool& tool);
  bool set_orientation(const Block& block, machine::Tool& tool);
  bool set_register(const Block& block, int kind, machine::Tool& tool);
  void set_lathe_offset(const Block& block);
  bool takes_only(const Block& block, Letters words, const std::string& hint);
  base::AxisVector offset_to_reach(const Block& block, int kind, const base::AxisVector& before) const;
  std::optional<int> system_of(const Block& block, int kind);
  CoordinateSystem shifted_system(int number) const;
  void set_shift_of_all(const Block& block);
  void put_local(const base::AxisVector& shift);

  Motion& motion_;
  bool told_of_table_ = false;
};

}  // namespace leadscrew::gcode
