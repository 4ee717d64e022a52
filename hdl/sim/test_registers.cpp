#include <Vleadscrew_axi.h>
#include <Vleadscrew_fsmc.h>
#include <Vleadscrew_wishbone.h>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>

#include "../driver/registers.hpp"
#include "chip_buses.hpp"
#include "clocked.hpp"
#include "fsmc_bus.hpp"

// rtl/registers.sv and motion_core.sv behind each of the buses.

namespace leadscrew::hardware {
namespace test_registers {

namespace at = driver::registers;

constexpr int axes = 3, width = 24, feed_width = 40, depth = 16;

template <typename Model>
struct System {
  Clocked<Model> port;

  System() {
    port->rst = 1;
    port.clock();
    port.clock();
    port->rst = 0;
  }
};

/// A bus, whether it can tell errors, and its accesses alike for all.
struct Fsmc : System<Vleadscrew_fsmc> {
  static constexpr bool tells_errors = false;
  FsmcBus<Clocked<Vleadscrew_fsmc>> bus{port};

  bool write(std::uint32_t address, std::uint32_t data, unsigned strobe = 15) {
    bus.write_half(address, static_cast<std::uint16_t>(data), ~strobe & 3);
    bus.write_half(address + 2, static_cast<std::uint16_t>(data >> 16), ~strobe >> 2 & 3);
    return true;
  }
  ReadData read(std::uint32_t address) { return bus.read32(address); }
};
struct Axi : System<Vleadscrew_axi> {
  static constexpr bool tells_errors = true;
  AxiBus<Clocked<Vleadscrew_axi>> bus{port};

  Axi() { bus.stalls.per_cent = 40; }
  bool write(std::uint32_t address, std::uint32_t data, unsigned strobe = 15) {
    return bus.write(address, data, strobe);
  }
  ReadData read(std::uint32_t address) { return bus.read(address); }
};
struct Wishbone : System<Vleadscrew_wishbone> {
  static constexpr bool tells_errors = true;
  WishboneBus<Clocked<Vleadscrew_wishbone>> bus{port};

  Wishbone() { bus.stalls.per_cent = 40; }
  bool write(std::uint32_t address, std::uint32_t data, unsigned strobe = 15) {
    return bus.write(address, data, strobe);
  }
  ReadData read(std::uint32_t address) { return bus.read(address); }
};

template <typename Bus>
class Registers : public testing::Test {
 protected:
  Bus bus_;

  std::uint32_t read(std::uint32_t address) { return bus_.read(address).value_or(0xEEEEEEEE); }
  bool bit(std::uint32_t address, int number) { return (read(address) >> number & 1) != 0; }

  /// A line of axis 0 alone, a step a tick.
  void push_line(std::uint32_t count, std::uint32_t tag, bool is_final) {
    bus_.write(at::command_count, count);
    bus_.write(at::command_feed_high, 1U << (feed_width - 32));
    bus_.write(at::command_straight_feed_high, 1U << (feed_width - 32));
    bus_.write(at::command_source, 1);
    bus_.write(at::command_push,
               tag << at::command_push_tag_bit | std::uint32_t{is_final} << at::command_push_final_bit);
  }
};
using Buses = testing::Types<Fsmc, Axi, Wishbone>;
TYPED_TEST_SUITE(Registers, Buses);

TYPED_TEST(Registers, SayWhatTheyAre) {
  EXPECT_EQ(this->read(at::identification), at::identification_value);
  EXPECT_EQ(this->read(at::version), at::version_value);
  EXPECT_EQ(this->read(at::parameters), axes << at::parameters_axes_bit | 4U << at::parameters_depth_log2_bit |
                                            std::uint32_t{width} << at::parameters_width_bit |
                                            std::uint32_t{feed_width} << at::parameters_feed_width_bit);
  EXPECT_EQ(this->read(at::error), 0);
}

/// Which bits of them exist.
const std::map<std::uint32_t, std::uint32_t> kept_bits = {
    {at::control, 3}, {at::interrupt_enable, 15}, {at::watermark, 31}, {at::prescale, 0xFFFF}, {at::watchdog_period, 0},
    {at::axis, 7},    {at::position_value, ~0U}};

TYPED_TEST(Registers, KeepWhatIsWritten) {
  std::mt19937 random(5);
  std::map<std::uint32_t, std::uint32_t> written;
  for (int n = 0; n < 200; ++n) {
    auto of = kept_bits.begin();
    std::advance(of, std::uniform_int_distribution<int>(0, static_cast<int>(kept_bits.size()) - 1)(random));
    const auto [address, bits] = *of;
    if (bits == 0) continue;  // the watchdog would bite
    const auto data = static_cast<std::uint32_t>(random());
    EXPECT_TRUE(this->bus_.write(address, data));
    written[address] = data & bits;
    for (const auto& [other, value] : written) ASSERT_EQ(this->read(other), value) << std::hex << other;
  }
  EXPECT_EQ(this->read(at::error), 0);
}

TYPED_TEST(Registers, KeepTimesOfEachAxis) {
  for (std::uint32_t axis = 0; axis < axes; ++axis) {
    this->bus_.write(at::axis, axis);
    this->bus_.write(at::step_times, 0x00020001 + 0x01000010 * axis);
    this->bus_.write(at::direction_times, 0x00040003 + 0x01000010 * axis);
  }
  for (std::uint32_t axis = 0; axis < axes; ++axis) {
    this->bus_.write(at::axis, axis);
    EXPECT_EQ(this->read(at::step_times), 0x00020001 + 0x01000010 * axis);
    EXPECT_EQ(this->read(at::direction_times), 0x00040003 + 0x01000010 * axis);
  }
}

TYPED_TEST(Registers, RefusePartialWrites) {
  EXPECT_TRUE(this->bus_.write(at::watermark, 5));
  for (unsigned strobe = 0; strobe < 15; ++strobe) {
    EXPECT_EQ(this->bus_.write(at::watermark, 9, strobe), !TypeParam::tells_errors);
    EXPECT_EQ(this->read(at::watermark), 5) << strobe;
    EXPECT_EQ(this->read(at::error), 1U << at::error_partial_bit);
    this->bus_.write(at::error, 1U << at::error_partial_bit);
    EXPECT_EQ(this->read(at::error), 0);
  }
}

TYPED_TEST(Registers, RefuseWritesOfWhatIsOnlyRead) {
  for (const std::uint32_t address : {at::identification, at::status, at::fifo_level, at::position, at::latched + 8}) {
    const std::uint32_t before = this->read(address);
    EXPECT_EQ(this->bus_.write(address, ~before), !TypeParam::tells_errors);
    EXPECT_EQ(this->read(address), before);
    EXPECT_EQ(this->read(at::error), 1U << at::error_partial_bit);
    this->bus_.write(at::error, 1U << at::error_partial_bit);
  }
}

TYPED_TEST(Registers, TellWrongAddresses) {
  for (const std::uint32_t address : {0x050U - 4 + 0x20, 0x09CU, 0x0BCU, 0x108U, 0x140U, 0x1FCU}) {
    EXPECT_EQ(this->bus_.write(address, 1), !TypeParam::tells_errors) << std::hex << address;
    EXPECT_EQ(this->read(at::error), 1U << at::error_address_bit) << std::hex << address;
    this->bus_.write(at::error, 1U << at::error_address_bit);
    EXPECT_EQ(this->read(at::error), 0);
    EXPECT_EQ(this->bus_.read(address).value_or(0), 0);
    EXPECT_EQ(this->bus_.read(address).has_value(), !TypeParam::tells_errors);
    EXPECT_EQ(this->read(at::error), 1U << at::error_address_bit);
    this->bus_.write(at::error, 1U << at::error_address_bit);
  }
  this->bus_.write(at::interrupt_enable, 1U << at::interrupt_enable_error_bit);
  EXPECT_EQ(this->bus_.port->irq, 0);
  this->bus_.read(0x1F0);
  this->bus_.port.clock();
  EXPECT_EQ(this->bus_.port->irq, 1);
}

TYPED_TEST(Registers, QueueMoreThanFitsAndLoseNothing) {
  this->bus_.write(at::control, 1U << at::control_hold_bit);
  for (std::uint32_t n = 0; n < depth + 8; ++n) {
    this->push_line(10 + n, n, n == depth - 1);
    if (this->bit(at::status, at::status_fifo_full_bit) && this->bit(at::error, at::error_overflow_bit)) break;
  }
  EXPECT_TRUE(this->bit(at::error, at::error_overflow_bit));
  const std::uint32_t level = this->read(at::fifo_level);
  EXPECT_EQ(level, depth);
  std::uint32_t steps = 0;
  for (std::uint32_t n = 0; n < level; ++n) steps += 10 + n;
  this->bus_.write(at::control, 0);
  for (std::uint32_t n = 0; n < 2 * steps && this->bit(at::status, at::status_busy_bit); ++n) this->bus_.port.clock();
  EXPECT_EQ(this->read(at::position), steps);
  EXPECT_EQ(this->read(at::commands_done), level);
  EXPECT_EQ(this->read(at::error), 1U << at::error_overflow_bit);  // and no underflow: the last one was final
  this->bus_.write(at::error, 1U << at::error_overflow_bit);
  EXPECT_EQ(this->read(at::error), 0);
}

TYPED_TEST(Registers, RunEmptyAndGoOn) {
  this->push_line(5, 1, false);
  for (int n = 0; n < 40; ++n) this->bus_.port.clock();
  EXPECT_EQ(this->read(at::error), 1U << at::error_underflow_bit);
  EXPECT_EQ(this->read(at::position), 5);
  this->push_line(7, 2, true);
  for (int n = 0; n < 40; ++n) this->bus_.port.clock();
  EXPECT_EQ(this->read(at::position), 12);
  EXPECT_EQ(this->read(at::error), 1U << at::error_underflow_bit);
  EXPECT_EQ(this->read(at::status) >> at::status_tag_bit, 2);
}

TYPED_TEST(Registers, RefuseACommandWithoutSteps) {
  this->push_line(0, 1, true);
  EXPECT_EQ(this->read(at::error), 1U << at::error_empty_bit);
  EXPECT_EQ(this->read(at::fifo_level), 0);
}

TYPED_TEST(Registers, HoldAndLatch) {
  this->bus_.write(at::prescale, 99);
  this->push_line(1000, 1, true);
  for (int n = 0; n < 5000; ++n) this->bus_.port.clock();
  this->bus_.write(at::trigger, 1U << at::trigger_latch_bit);
  const std::uint32_t latched = this->read(at::latched);
  EXPECT_GT(latched, 40);
  EXPECT_LE(latched, this->read(at::position));
  EXPECT_TRUE(this->bit(at::status, at::status_latched_bit));
  this->bus_.write(at::control, 1U << at::control_hold_bit);
  const std::uint32_t held = this->read(at::position);
  for (int n = 0; n < 5000; ++n) this->bus_.port.clock();
  EXPECT_EQ(this->read(at::position), held);
  EXPECT_TRUE(this->bit(at::status, at::status_held_bit));
  EXPECT_EQ(this->read(at::latched), latched);
  this->bus_.write(at::prescale, 0);
  this->bus_.write(at::control, 0);
  for (int n = 0; n < 2000; ++n) this->bus_.port.clock();
  EXPECT_EQ(this->read(at::position), 1000);
}

TYPED_TEST(Registers, AbortDropsWhatIsQueuedAndSetsPositions) {
  this->bus_.write(at::prescale, 999);
  this->push_line(1000, 1, true);
  this->push_line(1000, 2, true);
  this->bus_.write(at::trigger, 1U << at::trigger_abort_bit);
  EXPECT_EQ(this->read(at::fifo_level), 0);
  EXPECT_FALSE(this->bit(at::status, at::status_running_bit));
  this->bus_.write(at::position_value, static_cast<std::uint32_t>(-123456));
  this->bus_.write(at::position_set, 1U << 2);
  EXPECT_EQ(this->read(at::position + 8), static_cast<std::uint32_t>(-123456));
  EXPECT_NE(this->read(at::position), static_cast<std::uint32_t>(-123456));
}

TYPED_TEST(Registers, InterruptAtTheWatermark) {
  this->bus_.write(at::watermark, 2);
  this->bus_.write(at::control, 1U << at::control_hold_bit);
  for (std::uint32_t n = 0; n < 4; ++n) this->push_line(50, n, n == 3);
  this->bus_.write(at::interrupt_enable, 1U << at::interrupt_enable_fifo_low_bit);
  EXPECT_EQ(this->bus_.port->irq, 0);
  this->bus_.write(at::control, 0);
  int clocks = 0;
  for (; clocks < 1000 && this->bus_.port->irq == 0; ++clocks) this->bus_.port.clock();
  EXPECT_LT(clocks, 100);
  EXPECT_LE(this->read(at::fifo_level), 2);
}

}  // namespace test_registers
}  // namespace leadscrew::hardware
