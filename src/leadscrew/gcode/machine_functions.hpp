#pragma once
// What a block asks of the machine that no event carries to it: overrides, orientation of the spindle, inputs, functions
// of the machine's builder (LinuxCNC manual, M Codes). They are checked and their modes kept; that the machine is told
// nothing of them is said once of each.

#include <bitset>
#include <leadscrew/gcode/outbox.hpp>

namespace leadscrew::gcode {

class MachineFunctions : Part {
 public:
  explicit MachineFunctions(const Context& context) : Part(context) {}

  /// M48 … M53.
  void set_overrides(const Block& block);
  /// M61: the tool in the spindle has this number; nothing moves.
  void set_tool_number(const Block& block);
  /// M19.
  void orient_spindle(const Block& block);
  /// M66: #5399 becomes what an input that is off gives: 0, or -1 where the wait for it to be on ends by its timeout.
  void wait_for_input(const Block& block);
  /// M100 … M199, and with Fanuc and Haas what else has no meaning here.
  void call_builder(const Block& block);

 private:
  void note_untold(int number, std::uint32_t column, const char* what);

  std::bitset<detail::most_m> noted_;
};

}  // namespace leadscrew::gcode
