#pragma once
// What a block asks of the machine besides motion: spindle, tool, outputs, coolant, dwell.

#include <leadscrew/gcode/machine_functions.hpp>

namespace leadscrew::gcode {

class MachineEvents : Part {
 public:
  MachineEvents(const Context& context, Outbox& outbox) : Part(context), functions_(context, outbox), outbox_(outbox) {}

  /// S, T, M62 … M68, M6, M61, M3 … M5, M19, M7 … M9, M48 … M53, M100 … M199 and G4, in this order.
  void execute(const Block& block);
  /// G96: the spindle's speed where the tool stands now, if that is another.
  void follow_surface();
  /// What the M66 handed out last has found.
  void set_input(double value) { functions_.set_input(value); }

 private:
  void set_spindle_mode(const Block& block);
  void set_speed(const Block& block);
  void select_tool(const Block& block);
  void set_output(const Block& block);
  void change_tool(const Block& block);
  void turn_spindle(const Block& block);
  void set_coolant(const Block& block);
  double speed_on_surface() const;
  void dwell(const Block& block);

  MachineFunctions functions_;
  Outbox& outbox_;
};

}  // namespace leadscrew::gcode
