#pragma once
// Forms of text that are no codes and that dialects differ in: how long G4 dwells, what axis words do behind G80, what a
// program may end with. A block is rewritten into the form that LinuxCNC has for the same, before it is executed.

#include <leadscrew/gcode/lathe_offsets.hpp>
#include <leadscrew/gcode/line_source.hpp>
#include <leadscrew/gcode/part.hpp>
#include <span>

namespace leadscrew::gcode {

enum class Form : std::uint8_t {
  g80_beside_motion,
  motion_after_g80,
  zero_offset_outside_plane,
  idle_d,
  idle_g53,
  dwell_by_x,
  dwell_by_s,
  dwell_in_milliseconds,
  whole_milliseconds,
  incremental_home,
  home_by_letters,
  repeats_by_k,
  scale_in_thousandths,
  rapid_at_start,
  incremental_letters,
  tool_with_offset,
  end_of_text,
  program_name,
  checksum,
  controller_commands,
  printer_commands,
  count,
};

struct FormRow {
  Form form = Form::count;
  Dialects dialects;
  const char* summary = "";
  const char* example = "";
};

/// All forms.
std::span<const FormRow> form_rows();
bool has_form(Dialect dialect, Form form);
/// "grbl, marlin": as messages name them.
std::string names_of(Dialects dialects);

/// Rewrites blocks. All but lines of G0 and G1 pass here.
class DialectForms : Part {
 public:
  explicit DialectForms(const Context& context);

  /// `line` is the block's. May set or remove words and codes; reports nothing as an error.
  void rewrite(Block& block, const TextLine& line);

 private:
  bool has(Form form) const { return (forms_ >> static_cast<unsigned>(form)) & 1u; }
  void follow_g80(Block& block);
  void drop_idle_words(Block& block) const;
  [[gnu::cold]] void drop_idle_d(Block& block) const;
  void rewrite_dwell(Block& block, const TextLine& line) const;
  void rewrite_home(Block& block) const;
  [[gnu::cold]] void rewrite_scale(Block& block, const TextLine& line) const;
  void rewrite_cycle(Block& block, const TextLine& line) const;
  [[gnu::cold]] base::AxisVector base_of_distances(const Block& block) const;
  [[gnu::cold]] void rewrite_offset(Block& block, const LatheOffsetValues& before) const;
  void rewrite_distances(Block& block, const base::AxisVector& from) const;
  [[gnu::cold]] void rewrite_turning(Block& block, const TextLine& line) const;
  void drop_extruder(Block& block);

  std::uint32_t forms_ = 0;
  Code before_cycle_ = Code::none;  // the motion in force before the cycles
  bool told_of_extruder_ = false;
};

}  // namespace leadscrew::gcode
