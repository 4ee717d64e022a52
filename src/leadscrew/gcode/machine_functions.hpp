#pragma once
// Overrides, orientation of the spindle, inputs, functions of the machine's builder (LinuxCNC manual, M Codes): each
// is an event, and its mode is kept.

#include <leadscrew/gcode/outbox.hpp>

namespace leadscrew::gcode {

class MachineFunctions : Part {
 public:
  MachineFunctions(const Context& context, Outbox& outbox) : Part(context), outbox_(outbox) {}

  /// M48 … M53.
  void set_overrides(const Block& block);
  /// M61: the tool in the spindle has this number; nothing moves.
  void set_tool_number(const Block& block);
  /// T of Fanuc's lathes: the tool is in place at once, with its offset.
  [[gnu::cold]] void turn_turret(const Block& block);
  /// M19.
  void orient_spindle(const Block& block);
  /// M66: #5399 becomes what an input that is always off gives: 0, or -1 where the wait for another ends by its timeout.
  void wait_for_input(const Block& block);
  /// What M66 has found, in place of that.
  void set_input(double value);
  /// M100 … M199, and with Fanuc and Haas what else has no meaning here.
  void call_builder(const Block& block);

 private:
  Outbox& outbox_;
  bool told_of_table_ = false;
};

}  // namespace leadscrew::gcode
