#pragma once
// The single cuts of Fanuc's lathes, G-code system A (Fanuc 0i operator's manual, "Canned Cycle"): G90 along Z, G94 along
// X, G92 in step with the spindle. Each begins and ends where the tool stands; while it is in force a block with axis words
// makes another cut, of the words that have changed.
//
//     G90, G92   start ◀─ rapid ─╮          G94    ╭─ rapid ──▶ start
//                │ rapid         │                 │              │ rapid
//                ▼               │ out             │ out          ▼
//       X, taper R ─── cut ──▶ X Z                X Z ◀─ cut ── Z, taper R

#include <leadscrew/gcode/threading.hpp>

namespace leadscrew::gcode {

class TurningCycles : Part {
 public:
  TurningCycles(const Context& context, Motion& motion, Threading& threading, Outbox& outbox)
      : Part(context), motion_(motion), threading_(threading), outbox_(outbox) {}

  /// G90, G92 or G94, in this block or before.
  [[gnu::cold]] void cut(const Block& block);

 private:
  bool plan(const Block& block);

  Motion& motion_;
  Threading& threading_;
  Outbox& outbox_;
  // What the blocks since the cycle came into force have said.
  Code code_ = Code::none;
  double x_ = 0, z_ = 0;  // machine coordinates, mm
  double taper_ = 0;      // in the program's units
};

}  // namespace leadscrew::gcode
