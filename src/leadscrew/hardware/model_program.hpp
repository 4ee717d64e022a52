#pragma once
// A part program through the hardware: the same blocks as nc::PulseProgram makes of it, by method bresenham at constant
// feed, taken by hdl/driver and made by the model of hdl/rtl.
//
//   text ─gcode::Reader─▶ moves ─nc::BlockMaker─▶ blocks ─driver::Driver─▶ bus ─▶ registers, motion_core ─▶ steps
//
// A tick of nc::PulseProgram's clock is a tick of the core's feed, so that each step has the same one.

#include <leadscrew/hardware/motion_model.hpp>
#include <leadscrew/nc/pulse_program.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace leadscrew::hardware {

/// `hardware-model`: the command was built without it.
std::optional<base::Diagnostic> missing_model();

/// For nc::check_pulses(): the blocks that the core cannot make. `hardware-helix` an arc with axes beside its plane,
/// `hardware-register` more steps than its counters hold, `hardware-axes` an axis beyond its last one.
nc::BlockCheck model_check(const machine::Machine& machine);

class ModelProgram {
 public:
  /// A program that nc::check_pulses() with model_check() finds nothing wrong with, where there is no missing_model().
  /// The machine and the tool table must outlive it. waves: see make_motion_model().
  ModelProgram(gcode::ByteSource source, const machine::Machine& machine, const machine::ToolTable& tools,
               const gcode::ReaderOptions& reading, const nc::PulseOptions& options, gcode::DiagnosticSink sink,
               const std::optional<std::string>& waves);
  ~ModelProgram();

  /// The next steps in order, all those of the last tick too; none at the program's end, and at its first problem. The
  /// buffer is for base::axis_count or more.
  std::span<const steps::StepEvent> next(std::span<steps::StepEvent> buffer);

  std::int64_t ticks() const;
  std::int64_t clocks() const;  ///< of the model, those of its bus among them
  const std::optional<base::Diagnostic>& source_failure() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace leadscrew::hardware
