#pragma once
// The processor's half: takes moves, keeps the command FIFO full, tells where the machine is.
//
//   moves ─take()─▶ Cutter ─commands─▶ registers ─▶ FIFO of motion_core.sv        service(): from the interrupt, or polled
//
//   leadscrew::driver::Driver driver(bus);          // bus.read32(address), bus.write32(address, data)
//   driver.begin();
//   driver.set_watermark(8);
//   while (more_to_do()) {
//     if (driver.ready()) driver.take(next_move());
//     driver.service();
//   }

#include "cutter.hpp"
#include "registers.hpp"

namespace leadscrew::driver {

/// The registers of hdl/registers/registers.toml; byte addresses. A bus of 16 bits writes and reads the low half first.
template <typename B>
concept Bus = requires(B& bus, std::uint32_t address, std::uint32_t data) {
  { bus.read32(address) } -> std::same_as<std::uint32_t>;
  bus.write32(address, data);
};

/// Clocks of the core; see the registers STEP_TIMES and DIRECTION_TIMES.
struct StepTimes {
  std::uint16_t length = 1, space = 0, setup = 0, hold = 0;
};

template <Bus B>
class Driver {
 public:
  explicit Driver(B& bus) : bus_(bus) {}

  /// False where what answers is no core of this register map. Its queue is empty then, its errors are cleared.
  bool begin() {
    if (bus_.read32(registers::identification) != registers::identification_value) return false;
    if (bus_.read32(registers::version) >> 16 != registers::version_value >> 16) return false;
    const std::uint32_t built = bus_.read32(registers::parameters);
    core_.axes = field(built, registers::parameters_axes_bit, registers::parameters_axes_bits);
    core_.width = field(built, registers::parameters_width_bit, registers::parameters_width_bits);
    core_.feed_width = field(built, registers::parameters_feed_width_bit, registers::parameters_feed_width_bits);
    core_.depth = 1 << field(built, registers::parameters_depth_log2_bit, registers::parameters_depth_log2_bits);
    cutter_.set(core_);
    abort();
    clear_errors(~std::uint32_t{0});
    written_ = {};
    for (std::uint32_t i = 0; i < registers_of_a_command; ++i) bus_.write32(address_of(i), 0);
    return true;
  }
  const CoreParameters& core() const { return core_; }

  void set_times(int axis, const StepTimes& times) {
    bus_.write32(registers::axis, static_cast<std::uint32_t>(axis));
    bus_.write32(registers::step_times, times.length | static_cast<std::uint32_t>(times.space) << 16);
    bus_.write32(registers::direction_times, times.setup | static_cast<std::uint32_t>(times.hold) << 16);
  }
  /// Clocks a tick of the feed, 1 … 65536.
  void set_clocks_a_tick(std::uint32_t clocks) { bus_.write32(registers::prescale, clocks - 1); }
  /// The interrupt comes while so many commands are queued, or fewer; bits of INTERRUPT_ENABLE.
  void set_watermark(std::uint32_t commands) { bus_.write32(registers::watermark, commands); }
  void enable_interrupts(std::uint32_t bits) { bus_.write32(registers::interrupt_enable, bits); }
  /// Clocks; 0: none. From then on kick() must come sooner than that.
  void set_watchdog(std::uint32_t clocks) { bus_.write32(registers::watchdog_period, clocks); }
  void kick() { trigger(registers::trigger_watchdog_kick_bit); }

  /// May a move be taken?
  bool ready() const { return cutter_.done(); }
  Refusal take(const Move& move) { return cutter_.take(move); }
  /// Queues commands of the move that was taken, until the FIFO is full: is there room left?
  bool service() {
    auto level = static_cast<int>(bus_.read32(registers::fifo_level));
    for (; level < core_.depth && !cutter_.done(); ++level) push(cutter_.next());
    return level < core_.depth;
  }

  void hold() { control(std::uint32_t{1} << registers::control_hold_bit); }
  void resume() { control(0); }
  /// Drops what is queued, being made and being cut.
  void abort() {
    cutter_.drop();
    trigger(registers::trigger_abort_bit);
  }

  /// Has all that was taken been made?
  bool idle() const { return cutter_.done() && (status() >> registers::status_busy_bit & 1) == 0; }
  std::uint32_t status() const { return bus_.read32(registers::status); }
  /// Of the move that is made.
  std::uint16_t tag() const { return static_cast<std::uint16_t>(status() >> registers::status_tag_bit); }
  std::uint32_t errors() const { return bus_.read32(registers::error); }
  void clear_errors(std::uint32_t bits) { bus_.write32(registers::error, bits); }

  /// Steps, of one axis now; of all axes at the same clock: latch(), then latched() of each.
  std::int32_t position(int axis) const { return signed_at(registers::position, axis); }
  void latch() { trigger(registers::trigger_latch_bit); }
  std::int32_t latched(int axis) const { return signed_at(registers::latched, axis); }
  void set_position(int axis, std::int32_t steps) {
    bus_.write32(registers::position_value, static_cast<std::uint32_t>(steps));
    bus_.write32(registers::position_set, std::uint32_t{1} << axis);
  }

 private:
  // Those that are written only where they change: count, feeds, sources, and E, S, D of each unit.
  static constexpr std::uint32_t plain_registers = 6, registers_of_a_command = plain_registers + 3 * most_units;
  struct Written {
    std::uint32_t of[registers_of_a_command] = {};
  };

  static constexpr std::uint32_t address_of(std::uint32_t index) {
    return index < plain_registers ? registers::command_count + 4 * index
                                   : registers::unit_decision + 4 * (index - plain_registers);
  }
  static constexpr int field(std::uint32_t value, int bit, int bits) {
    return static_cast<int>(value >> bit & ((std::uint32_t{1} << bits) - 1));
  }

  void trigger(int bit) { bus_.write32(registers::trigger, std::uint32_t{1} << bit); }
  void control(std::uint32_t value) { bus_.write32(registers::control, value); }
  std::int32_t signed_at(std::uint32_t first, int axis) const {
    return static_cast<std::int32_t>(bus_.read32(first + 4 * static_cast<std::uint32_t>(axis)));
  }

  void set(std::uint32_t index, std::uint32_t value) {
    if (written_.of[index] == value) return;
    written_.of[index] = value;
    bus_.write32(address_of(index), value);
  }

  void push(const Command& command) {
    set(0, command.count);
    set(1, static_cast<std::uint32_t>(command.feed));
    set(2, static_cast<std::uint32_t>(command.feed >> 32));
    set(3, static_cast<std::uint32_t>(command.straight_feed));
    set(4, static_cast<std::uint32_t>(command.straight_feed >> 32));
    set(5, command.source);
    for (std::uint32_t unit = 0; unit + 1 < static_cast<std::uint32_t>(core_.axes); ++unit) {
      set(plain_registers + 3 * unit, static_cast<std::uint32_t>(command.decision[unit]));
      set(plain_registers + 3 * unit + 1, static_cast<std::uint32_t>(command.straight[unit]));
      set(plain_registers + 3 * unit + 2, static_cast<std::uint32_t>(command.diagonal[unit]));
    }
    bus_.write32(registers::command_push, command.push);
  }

  static_assert(address_of(5) == registers::command_source);
  static_assert(registers::unit_decision_stride == 12 && registers::unit_diagonal == registers::unit_decision + 8);

  B& bus_;
  CoreParameters core_{};
  Cutter cutter_;
  Written written_{};
};

}  // namespace leadscrew::driver
