#pragma once
// Modes that a program keeps and brings back: M70 … M73 (LinuxCNC manual, M Codes).
//
// Each call has modes of its own to keep, once: M70 and M73 keep them, M72 brings them back, M71 forgets them. What M73
// has kept comes back where the call ends, however it ends. Units, plane, distance and feed modes, F, S, tool length, the coordinate
// system, path control, retract mode, diameters, spindle, coolant and overrides are kept, whether G92 and G52 are in force,
// and that cutter compensation is off; the motion in force is not, nor how far G92 shifts.

#include <leadscrew/gcode/cutter_compensation.hpp>
#include <leadscrew/gcode/offsets.hpp>
#include <vector>

namespace leadscrew::gcode {

class SavedModes : Part {
 public:
  SavedModes(const Context& context, Outbox& outbox, Offsets& offsets, CutterCompensation& compensation)
      : Part(context), outbox_(outbox), offsets_(offsets), compensation_(compensation) {}

  /// M70 … M73; whether modes came back. Errors: `missing-modes` where M72 has none to bring back, `cutter-compensation`.
  bool execute(const Block& block);
  /// Whether M73 has kept modes in calls that have ended.
  bool leaves_calls() const { return !kept_.empty() && kept_.back().calls > modal_.fewest_calls; }
  /// They come back, before the next line is read; whether any did. Errors: `cutter-compensation`, `tilted-plane`.
  bool leave_calls();
  /// Whether any do.
  bool leaving_brings_back() const;
  // Whether cutter compensation ends with them, if it is on.
  bool ends_compensation(const Block& block) const;
  bool leaving_ends_compensation() const;
  /// Whether any are kept.
  bool any() const { return !kept_.empty(); }

 private:
  struct Kept {
    std::size_t calls = 0;  ///< how many were under way
    bool comes_back = false;
    ModalState modal;
    double length_unit = 1;
    base::AxisVector tool_length{};
    bool has_tip_control = false;  ///< by G43.4 or G43.5
    bool takes_vectors = false;
    bool is_shifted = false;  ///< by G92 or G52
  };

  void keep(bool comes_back);
  bool bring_back(const Kept& kept, std::uint32_t column);
  void bring_back_tool(const Kept& kept);
  void bring_back_machine(const ModalState& before);
  void bring_back_overrides(const ModalState& before);

  Outbox& outbox_;
  Offsets& offsets_;
  CutterCompensation& compensation_;
  std::vector<Kept> kept_;  // by calls, ascending
};

}  // namespace leadscrew::gcode
