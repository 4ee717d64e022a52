#pragma once
// Commands of printers (Marlin) that say nothing of how axes move: heaters, fans, messages, settings. Their lines are
// passed over, and so is text behind M0 and M1.

#include <leadscrew/gcode/line_source.hpp>
#include <leadscrew/gcode/reporter.hpp>
#include <set>
#include <span>

namespace leadscrew::gcode {

struct PrinterCommand {
  char letter = 'M';
  int first = 0, last = 0;   ///< its numbers
  bool is_hardware = false;  ///< asks something of hardware that a machine tool lacks: told once, as a warning
  const char* summary = "";
};

/// All that are passed over. Source: Marlin's documentation, "G-code index".
std::span<const PrinterCommand> printer_commands();

class PrinterCommands {
 public:
  explicit PrinterCommands(Reporter& reporter) : reporter_(reporter) {}

  /// Whether the line has been passed over. A line that says with text or bare letters what words say becomes those
  /// words.
  bool take(TextLine& line);

 private:
  bool pass_over(const PrinterCommand& command, int number, const char* at);
  void give(TextLine& line, std::string_view text);

  Reporter& reporter_;
  std::set<std::pair<char, int>> told_;
  std::string copy_;
};

}  // namespace leadscrew::gcode
