#include <Vleadscrew_fsmc.h>
#include <gtest/gtest.h>

#include <random>

#include "../driver/registers.hpp"
#include "clocked.hpp"
#include "fsmc_bus.hpp"

// rtl/bus/fsmc.sv at the limits of its times, and beyond.

namespace leadscrew::hardware {
namespace test_fsmc {

namespace at = driver::registers;
using Port = Clocked<Vleadscrew_fsmc>;

class Fsmc : public testing::Test {
 protected:
  Port port_;
  FsmcBus<Port> bus_{port_};

  Fsmc() {
    port_->rst = 1;
    bus_.pass(60'000);
    port_->rst = 0;
  }
  void expect_untouched(std::uint32_t watermark) {
    EXPECT_EQ(bus_.read32(at::watermark), watermark);
    EXPECT_EQ(bus_.read32(at::error), 0);
  }
};

/// Writes as fast as they may come, wherever they fall between the model's clocks.
TEST_F(Fsmc, TakesWritesBackToBack) {
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    bus_.pass(std::uniform_int_distribution<std::int64_t>(0, 19'999)(random));
    bus_.timing().data_hold = std::uniform_int_distribution<std::int64_t>(0, 6'000)(random);
    const auto value = static_cast<std::uint32_t>(random()), mark = static_cast<std::uint32_t>(round & 31);
    bus_.write32(at::position_value, value);
    bus_.write32(at::watermark, mark);
    bus_.write32(at::prescale, ~value & 0xFFFF);
    ASSERT_EQ(bus_.read32(at::position_value), value) << round;
    ASSERT_EQ(bus_.read32(at::watermark), mark) << round;
    ASSERT_EQ(bus_.read32(at::prescale), ~value & 0xFFFF) << round;
  }
  EXPECT_EQ(bus_.read32(at::error), 0);
}

TEST_F(Fsmc, IgnoresChipSelectAlone) {
  bus_.write32(at::watermark, 7);
  std::mt19937 random(4);
  for (int glitch = 0; glitch < 200; ++glitch) {
    port_->NE = 0;
    port_->A = static_cast<std::uint8_t>(at::watermark >> 1 | (glitch & 1));
    port_->D_in = static_cast<std::uint16_t>(random());
    port_->NBL = 0;
    bus_.pass(std::uniform_int_distribution<std::int64_t>(1'000, 90'000)(random));
    port_->NE = 1;
    bus_.pass(std::uniform_int_distribution<std::int64_t>(1'000, 90'000)(random));
  }
  expect_untouched(7);
}

TEST_F(Fsmc, IgnoresWriteStrobesOfOthers) {
  bus_.write32(at::watermark, 7);
  for (int n = 0; n < 8; ++n) {
    port_->A = static_cast<std::uint8_t>(at::watermark >> 1 | (n & 1));
    port_->D_in = 3;
    port_->NBL = 0;
    port_->NWE = 0;
    bus_.pass(80'000);
    port_->NWE = 1;
    bus_.pass(80'000);
  }
  expect_untouched(7);
}

/// Shorter than two clocks: none or one of them sees it.
TEST_F(Fsmc, IgnoresGlitchesOfTheWriteStrobe) {
  bus_.write32(at::watermark, 7);
  std::mt19937 random(5);
  for (int glitch = 0; glitch < 200; ++glitch) {
    port_->NE = 0;
    port_->A = static_cast<std::uint8_t>(at::watermark >> 1 | (glitch & 1));
    port_->D_in = 3;
    port_->NBL = 0;
    bus_.pass(std::uniform_int_distribution<std::int64_t>(1'000, 40'000)(random));
    port_->NWE = 0;
    bus_.pass(std::uniform_int_distribution<std::int64_t>(1'000, 19'000)(random));
    port_->NWE = 1;
    bus_.pass(50'000);
    port_->NE = 1;
    bus_.pass(50'000);
  }
  expect_untouched(7);
}

TEST_F(Fsmc, RefusesAHighHalfWithoutItsLowOne) {
  bus_.write32(at::watermark, 7);
  bus_.write_half(at::watermark + 2, 0);
  EXPECT_EQ(bus_.read32(at::watermark), 7);
  EXPECT_EQ(bus_.read32(at::error), 1U << at::error_partial_bit);
  bus_.write32(at::error, 1U << at::error_partial_bit);
  // The low one of another register
  bus_.write_half(at::prescale, 9);
  bus_.write_half(at::watermark + 2, 0);
  EXPECT_EQ(bus_.read32(at::watermark), 7);
  EXPECT_EQ(bus_.read32(at::prescale), 0);
  EXPECT_EQ(bus_.read32(at::error), 1U << at::error_partial_bit);
}

TEST_F(Fsmc, ALowHalfAloneChangesNothing) {
  bus_.write32(at::watermark, 7);
  bus_.write_half(at::watermark, 3);
  expect_untouched(7);
  bus_.write_half(at::watermark + 2, 0);  // reads do not come between the halves
  EXPECT_EQ(bus_.read32(at::watermark), 3);
}

/// Both halves of one instant, though the position goes on between them.
TEST_F(Fsmc, ReadsBothHalvesAtOnce) {
  bus_.write32(at::position_value, 0xFFF0);
  bus_.write32(at::position_set, 1);
  bus_.write32(at::command_count, 2000);
  bus_.write32(at::command_feed_high, 1U << 8);
  bus_.write32(at::command_straight_feed_high, 1U << 8);
  bus_.write32(at::command_source, 1);
  bus_.write32(at::command_push, 1U << at::command_push_final_bit);
  std::uint32_t last = 0xFFF0;
  for (int n = 0; n < 50; ++n) {
    const std::uint32_t now = bus_.read32(at::position);
    ASSERT_GE(now, last);
    ASSERT_LE(now, last + 30);
    last = now;
  }
  EXPECT_GT(last, 0x10000);
}

TEST_F(Fsmc, HoldsTheProcessorUntilDataAreThere) {
  std::mt19937 random(6);
  for (int n = 0; n < 100; ++n) {
    bus_.pass(std::uniform_int_distribution<std::int64_t>(0, 19'999)(random));
    port_->NE = 0;
    port_->A = static_cast<std::uint8_t>(at::identification >> 1 | (n & 1));
    bus_.pass(3'000);
    port_->NOE = 0;
    port_->eval();
    ASSERT_EQ(port_->NWAIT, 0);
    int clocks = 0;
    for (; clocks < 10 && port_->NWAIT == 0; ++clocks) bus_.pass(20'000);
    ASSERT_LE(clocks, 6);
    ASSERT_EQ(port_->D_out, at::identification_value >> 16 * (n & 1) & 0xFFFF);
    ASSERT_EQ(port_->D_drive, 1);
    port_->NOE = port_->NE = 1;
    port_->eval();
    ASSERT_EQ(port_->D_drive, 0);
    bus_.pass(60'000);
  }
}

}  // namespace test_fsmc
}  // namespace leadscrew::hardware
