#pragma once
// Remarks that ask for something: MSG, DEBUG, PRINT, LOG, LOGOPEN, LOGAPPEND, LOGCLOSE, PROBEOPEN, PROBECLOSE, ABORT
// (LinuxCNC manual, "Comments"). Of several in one line the last is read.
//
//     #5  #<name>            in DEBUG, PRINT, LOG and ABORT: the value; ###### of a name that has none
//     %d  %f  %.0f … %.9f    how the values behind it are written: whole, with 4 decimals, with so many; else with 6

#include <leadscrew/gcode/predefined.hpp>
#include <leadscrew/gcode/remark.hpp>
#include <string_view>

namespace leadscrew::gcode {

class Remarks : Part {
 public:
  /// Both must outlive it.
  Remarks(const Context& context, const Predefined& predefined) : Part(context), predefined_(predefined) {}

  /// Whether a remark may ask for something, by its first letter.
  static bool may_ask(const char* text);

  /// Does what a remark asks for; `text` is what stands between the brackets, or behind ';'. Error: `program-abort`,
  /// behind which nothing is read. Warnings: `unsupported-remark`, `bad-log`.
  void execute(std::string_view text);
  /// Shows a message that stands in that column, as (MSG,text) does.
  void show(std::string text, std::int64_t column) const { send(Remark::Kind::message, std::move(text), column); }

 private:
  struct Row;

  bool open_log(const Row& row, std::string_view name, std::int64_t column, std::string_view example);
  void log(std::string_view text, std::int64_t column);
  void abort(std::string_view text, std::int64_t column);
  void send(Remark::Kind kind, std::string text, std::int64_t column) const;

  /// The text with the values of its parameters.
  std::string expanded(std::string_view text) const;
  std::string value_of(std::string_view& rest, int decimals) const;

  const Predefined& predefined_;
  bool log_is_open_ = false;
  bool told_unopened_ = false;
};

}  // namespace leadscrew::gcode
