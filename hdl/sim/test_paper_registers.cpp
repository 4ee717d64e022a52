#include <Vleadscrew_paper.h>
#include <gtest/gtest.h>

#include <leadscrew/pulse/pulse.hpp>

#include "../driver/registers.hpp"
#include "clocked.hpp"
#include "fsmc_bus.hpp"

// The paper's interpolators by their registers: start, end, method, start, busy, position.

namespace leadscrew::hardware {
namespace test_paper_registers {

namespace at = driver::registers;

class PaperRegisters : public testing::Test {
 protected:
  Clocked<Vleadscrew_paper> port_;
  FsmcBus<Clocked<Vleadscrew_paper>> bus_{port_};

  PaperRegisters() {
    port_->rst = 1;
    bus_.pass(60'000);
    port_->rst = 0;
  }

  void make(std::uint32_t method, pulse::Point from, pulse::Point to, bool clockwise) {
    bus_.write32(at::paper_start_x, static_cast<std::uint32_t>(from.x));
    bus_.write32(at::paper_start_z, static_cast<std::uint32_t>(from.y));
    bus_.write32(at::paper_end_x, static_cast<std::uint32_t>(to.x));
    bus_.write32(at::paper_end_z, static_cast<std::uint32_t>(to.y));
    bus_.write32(at::paper_method, method | std::uint32_t{clockwise} << at::paper_method_clockwise_bit);
    bus_.write32(at::paper_start, 1);
  }
  std::int32_t position(std::uint32_t address) { return static_cast<std::int32_t>(bus_.read32(address)); }
  bool is_busy() { return (bus_.read32(at::paper_status) >> at::paper_status_busy_bit & 1) != 0; }
};

TEST_F(PaperRegisters, MakeTheArcThatIsSelected) {
  EXPECT_EQ(bus_.read32(at::parameters) >> at::parameters_paper_width_bit, 16);
  for (std::uint32_t method = 0; method < 4; ++method) {
    for (const bool clockwise : {false, true}) {
      make(method, {3000, 0}, {0, 3000}, clockwise);
      EXPECT_TRUE(is_busy());
      bus_.pass(20'000LL * 100);
      const std::int32_t x = position(at::paper_x), z = position(at::paper_z);
      EXPECT_GT(x, 2800);
      EXPECT_TRUE(clockwise ? z < -20 : z > 20) << method << ' ' << z;
      for (int n = 0; n < 200 && is_busy(); ++n) bus_.pass(20'000LL * 200);
      EXPECT_FALSE(is_busy());
      EXPECT_EQ(position(at::paper_x), 0) << method;
      EXPECT_EQ(position(at::paper_z), 3000) << method;
    }
  }
  EXPECT_EQ(bus_.read32(at::error), 0);
}

TEST_F(PaperRegisters, SayThatThereIsNoArc) {
  make(2, {0, 0}, {5, 0}, false);
  bus_.pass(20'000LL * 100);
  EXPECT_EQ(bus_.read32(at::paper_status), 1U << at::paper_status_refused_bit);
}

}  // namespace test_paper_registers
}  // namespace leadscrew::hardware
