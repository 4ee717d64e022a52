#pragma once
// hdl/rtl/leadscrew_fsmc.sv as Verilator has made a program of it: the motion core behind its memory bus, with a clock.

#include <array>
#include <cstdint>
#include <leadscrew/steps/step_event.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace leadscrew::hardware {

class MotionModel {
 public:
  static constexpr std::size_t axes = 6;

  virtual ~MotionModel() = default;

  /// A register, over the bus: both halfwords, at the bus' fastest; byte address. No tick of the feed passes meanwhile, as if
  /// the processor took no time.
  virtual std::uint32_t read32(std::uint32_t address) = 0;
  virtual void write32(std::uint32_t address, std::uint32_t data) = 0;

  /// A tick a clock until the interrupt line is high, or there is no space for the steps of one more tick. How many steps
  /// were written to the buffer, of ≥ axes: their ticks are counted from the start of the first command on; lanes says
  /// which axis each of the core's is.
  virtual std::size_t run(std::span<steps::StepEvent> buffer, const std::array<base::Axis, axes>& lanes) = 0;

  /// The waveforms' file gets its name; without, what was written of it is removed.
  virtual void finish_waves() = 0;
  virtual bool has_failed() const = 0;  ///< that file could not be made

  virtual std::int64_t ticks() const = 0;
  virtual std::int64_t clocks() const = 0;  ///< those of the bus among them
};

/// Waveforms of all signals go to a file, FST, if one is named. Null where the program was built without the model.
std::unique_ptr<MotionModel> make_motion_model(const std::optional<std::string>& waves);

/// Was it built with the model?
bool has_motion_model();

}  // namespace leadscrew::hardware
