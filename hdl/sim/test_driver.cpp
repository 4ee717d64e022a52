#include <Vleadscrew_fsmc.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "../driver/driver.hpp"
#include "clocked.hpp"
#include "fsmc_bus.hpp"

// hdl/driver on the model of leadscrew_fsmc: what whole programs do not ask of it.

namespace leadscrew::hardware {
namespace test_driver {

using driver::Move;
using driver::Refusal;
using Port = Clocked<Vleadscrew_fsmc>;
using Bus = FsmcBus<Port>;

class Driver : public testing::Test {
 protected:
  Port port_;
  Bus bus_{port_};
  driver::Driver<Bus> driver_{bus_};

  Driver() {
    port_->rst = 1;
    bus_.pass(60'000);
    port_->rst = 0;
    EXPECT_TRUE(driver_.begin());
  }

  /// A step every so many ticks.
  std::uint64_t every(std::uint64_t ticks) const { return (std::uint64_t{1} << driver_.core().feed_width) / ticks; }
  Move line(std::int32_t x, std::int32_t y, bool is_last = true) const {
    Move move;
    move.delta[0] = x;
    move.delta[1] = y;
    move.feed = every(10);
    move.is_last = is_last;
    return move;
  }
  void finish() {
    for (int n = 0; n < 100'000 && !driver_.idle(); ++n) {
      driver_.service();
      bus_.pass(20'000LL * 50);
    }
    ASSERT_TRUE(driver_.idle());
  }
};

TEST_F(Driver, LearnsHowTheCoreWasBuilt) {
  EXPECT_EQ(driver_.core().axes, 3);
  EXPECT_EQ(driver_.core().width, 24);
  EXPECT_EQ(driver_.core().feed_width, 40);
  EXPECT_EQ(driver_.core().depth, 16);
}

TEST_F(Driver, RefusesWhatTheCoreCannotMake) {
  Move move = line(1 << 24, 0);
  EXPECT_EQ(driver_.take(move), Refusal::too_long);
  move = line(-(1 << 24), 0);
  EXPECT_EQ(driver_.take(move), Refusal::too_long);
  move = line(1, 1);
  move.delta[3] = 1;
  EXPECT_EQ(driver_.take(move), Refusal::axis);
  move = line(1, 1);
  move.feed = 0;
  EXPECT_EQ(driver_.take(move), Refusal::feed);
  move.feed = every(1) + 1;
  EXPECT_EQ(driver_.take(move), Refusal::feed);
  move = line(1, 1);
  move.kind = Move::Kind::arc;
  EXPECT_EQ(driver_.take(move), Refusal::no_arc);
  move.arc = {{1 << 23, 0}, {0, 1 << 23}};
  EXPECT_EQ(driver_.take(move), Refusal::too_long);
  move.arc = {{5, 0}, {0, 5}};
  move.second_axis = 0;
  EXPECT_EQ(driver_.take(move), Refusal::axis);
  EXPECT_TRUE(driver_.idle());
  EXPECT_EQ(driver_.take(line(3, 2)), Refusal::none);
  EXPECT_EQ(driver_.take(line(3, 2)), Refusal::busy);
  finish();
  EXPECT_EQ(driver_.position(0), 3);
  EXPECT_EQ(driver_.position(1), 2);
  EXPECT_EQ(driver_.errors(), 0);
}

TEST_F(Driver, HoldsAndResumesWithoutLoss) {
  driver_.take(line(5000, -1234));
  driver_.service();
  for (int n = 0; n < 20; ++n) {
    bus_.pass(20'000LL * 777);
    driver_.hold();
    const std::array<std::int32_t, 2> held = {driver_.position(0), driver_.position(1)};
    bus_.pass(20'000LL * 500);
    ASSERT_EQ(driver_.position(0), held[0]);
    ASSERT_EQ(driver_.position(1), held[1]);
    driver_.resume();
  }
  EXPECT_GT(driver_.position(0), 1000);
  finish();
  EXPECT_EQ(driver_.position(0), 5000);
  EXPECT_EQ(driver_.position(1), -1234);
  EXPECT_EQ(driver_.errors(), 0);
}

TEST_F(Driver, AbortsAndGoesOnFromWhereItIs) {
  driver_.take(line(5000, 5000));
  driver_.service();
  bus_.pass(20'000LL * 10'000);
  driver_.abort();
  EXPECT_TRUE(driver_.idle());
  const std::int32_t x = driver_.position(0);
  EXPECT_GT(x, 500);
  EXPECT_LT(x, 2000);
  driver_.set_position(1, 0);
  driver_.take(line(-x, 70));
  finish();
  EXPECT_EQ(driver_.position(0), 0);
  EXPECT_EQ(driver_.position(1), 70);
  EXPECT_EQ(driver_.errors(), 0);
}

/// More moves than the FIFO holds; the tag tells which is made.
TEST_F(Driver, KeepsTheQueueFull) {
  driver_.set_watermark(8);
  driver_.enable_interrupts(1U << driver::registers::interrupt_enable_fifo_low_bit);
  int taken = 0;
  std::int64_t clocks = 0;
  while (taken < 100 || !driver_.ready()) {
    for (bool has_room = true; has_room && (taken < 100 || !driver_.ready());) {
      if (driver_.ready()) {
        Move move = line(7, 3, taken == 99);
        move.tag = static_cast<std::uint16_t>(taken++);
        ASSERT_EQ(driver_.take(move), Refusal::none);
      }
      has_room = driver_.service();
    }
    for (; port_->irq == 0 && clocks < 1'000'000; ++clocks) bus_.pass(20'000);
  }
  finish();
  EXPECT_EQ(driver_.tag(), 99);
  EXPECT_EQ(driver_.position(0), 700);
  EXPECT_EQ(driver_.position(1), 300);
  EXPECT_EQ(driver_.errors(), 0);
}

/// Clocks from the first to the last step of a move.
std::int64_t duration(Port& port, Bus& bus, driver::Driver<Bus>& driver, const Move& move) {
  EXPECT_EQ(driver.take(move), Refusal::none);
  port->hold_pin = 1;
  driver.service();
  port->hold_pin = 0;
  const std::int64_t begin = port.clocks();
  std::int64_t last = begin;
  while (port.clocks() < begin + 200'000) {
    if (port->step_strobe != 0) last = port.clocks();
    bus.pass(20'000);
    if (!driver.ready()) driver.service();
  }
  return last - begin;
}

/// As long as the path is, at a step of its length each ten ticks.
TEST_F(Driver, KeepsTheSpeedAlongThePathEven) {
  Move move = line(1000, 1000);
  EXPECT_NEAR(static_cast<double>(duration(port_, bus_, driver_, move)), 10'000, 20);
  move.speed = Move::Speed::even_path;
  EXPECT_NEAR(static_cast<double>(duration(port_, bus_, driver_, move)), 10'000 * std::sqrt(2.0), 20);
  move = line(1000, 999);
  move.delta[2] = -400;
  move.speed = Move::Speed::even_path;
  EXPECT_NEAR(static_cast<double>(duration(port_, bus_, driver_, move)), 10 * std::sqrt(1e6 + 999 * 999 + 160'000), 20);
  move = line(0, -1000);
  move.speed = Move::Speed::even_path;
  EXPECT_NEAR(static_cast<double>(duration(port_, bus_, driver_, move)), 10'000, 20);
  move = line(0, 0);
  move.kind = Move::Kind::arc;
  move.arc = {{1000, 0}, {1000, 0}};
  const auto uneven = static_cast<double>(duration(port_, bus_, driver_, move));
  EXPECT_NEAR(uneven, 10 * 8 * 1000 / std::sqrt(2.0), 100);
  move.speed = Move::Speed::even_path;
  const auto even = static_cast<double>(duration(port_, bus_, driver_, move));
  const double expected = 10 * 2 * 1000 * std::acos(-1.0);
  EXPECT_GE(even, 0.9999 * expected);
  EXPECT_LE(even, 1.0006 * expected);
}

/// Beyond a step a tick there is none: feeds of arcs that would ask for one are cut off, and slower.
TEST_F(Driver, NeverAsksForMoreThanAStepATick) {
  Move move = line(0, 0);
  move.kind = Move::Kind::arc;
  move.arc = {{1000, 0}, {0, 1000}};
  move.speed = Move::Speed::even_path;
  move.feed = every(1);
  const auto clocks = static_cast<double>(duration(port_, bus_, driver_, move));
  EXPECT_EQ(driver_.position(0), -1000);
  EXPECT_EQ(driver_.position(1), 1000);
  EXPECT_EQ(driver_.errors(), 0);
  EXPECT_GT(clocks, 500 * std::acos(-1.0));
  EXPECT_LT(clocks, 500 * std::acos(-1.0) * 1.3);
}

}  // namespace test_driver
}  // namespace leadscrew::hardware
