#include <Vleadscrew_axi.h>
#include <Vleadscrew_wishbone.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <random>
#include <string>

#include "../driver/registers.hpp"
#include "chip_buses.hpp"
#include "clocked.hpp"

// What masters of AXI4-Lite and Wishbone B4 may do besides one access behind the other.

namespace leadscrew::hardware {
namespace test_chip_buses {

namespace at = driver::registers;

template <typename Model>
Clocked<Model>& reset(Clocked<Model>& port) {
  port->rst = 1;
  port.clock();
  port.clock();
  port->rst = 0;
  return port;
}

/// Both channels of an AXI master at once, each with stalls of its own.
class BothAtOnce {
 public:
  explicit BothAtOnce(int stalled) : stalls_{stalled} { reset(port_); }

  /// One clock, seen from both sides; answers behind one another as they come: 'w' or 'r'.
  void clock() {
    if (!port_->awvalid && !stalls_.now()) {
      port_->awvalid = 1;
      port_->awaddr = at::watermark;
    }
    if (!port_->wvalid && !stalls_.now()) {
      port_->wvalid = 1;
      port_->wdata = ++told_ & 31;
      port_->wstrb = 15;
    }
    if (!port_->arvalid && !stalls_.now()) {
      port_->arvalid = 1;
      // A register that never changes, and the one that is written.
      port_->araddr = static_cast<std::uint16_t>(reads_++ % 2 == 0 ? at::identification : at::watermark);
    }
    port_->bready = !stalls_.now();
    port_->rready = !stalls_.now();
    port_->eval();
    const bool takes_address = port_->awvalid && port_->awready, takes_data = port_->wvalid && port_->wready,
               takes_read = port_->arvalid && port_->arready;
    EXPECT_EQ(takes_address, takes_data);
    EXPECT_FALSE(takes_read && takes_address);
    if (takes_data) written_ = port_->wdata;
    if (takes_read) expected_.push_back(port_->araddr == at::identification ? at::identification_value : written_);
    if (port_->bvalid && port_->bready) {
      EXPECT_EQ(port_->bresp, 0);
      answers += 'w';
    }
    if (port_->rvalid && port_->rready) {
      EXPECT_EQ(port_->rresp, 0);
      ASSERT_FALSE(expected_.empty());
      EXPECT_EQ(port_->rdata, expected_.front());
      expected_.pop_front();
      answers += 'r';
    }
    port_.clock();
    if (takes_address) port_->awvalid = 0;
    if (takes_data) port_->wvalid = 0;
    if (takes_read) port_->arvalid = 0;
  }

  std::string answers;

 private:
  Clocked<Vleadscrew_axi> port_;
  Stalls stalls_;
  std::uint32_t told_ = 0, written_ = 0, reads_ = 0;
  std::deque<std::uint32_t> expected_;
};

TEST(Axi, ReadsAndWritesThatWaitTogetherTakeTurns) {
  BothAtOnce both(0);
  for (int n = 0; n < 400; ++n) both.clock();
  ASSERT_GE(both.answers.size(), 80U);
  for (std::size_t k = 1; k < both.answers.size(); ++k) ASSERT_NE(both.answers[k], both.answers[k - 1]) << k;
}

TEST(Axi, ReadsAndWritesAtOnceAreAnsweredEach) {
  BothAtOnce both(60);
  for (int n = 0; n < 20000 && !testing::Test::HasFailure(); ++n) both.clock();
  for (const char kind : {'r', 'w'}) EXPECT_GE(std::count(both.answers.begin(), both.answers.end(), kind), 500);
}

/// A cycle that its master ends before the answer is not answered, neither then nor in the next one; what it writes is written or not,
/// and nothing else is.
TEST(Wishbone, CyclesThatEndEarlyAreNotAnswered) {
  Clocked<Vleadscrew_wishbone> port;
  WishboneBus<Clocked<Vleadscrew_wishbone>> bus(reset(port));
  std::mt19937 random(7);
  std::uint32_t kept = 0, made = 0;
  for (int n = 0; n < 2000; ++n) {
    const int length = static_cast<int>(random() % 2) + 1, pause = static_cast<int>(random() % 3) + 1;
    const bool writes = random() % 2 == 0;
    const std::uint32_t told = random() % 32;
    port->adr_i = static_cast<std::uint8_t>((writes ? at::watermark : at::error) >> 2);
    port->we_i = writes;
    port->dat_i = told;
    port->sel_i = 15;
    port->cyc_i = port->stb_i = 1;
    for (int k = 0; k < length; ++k) {
      port.clock();
      ASSERT_FALSE(port->ack_o || port->err_o) << n;
    }
    port->cyc_i = port->stb_i = 0;
    for (int k = 0; k < pause; ++k) {
      port.clock();
      ASSERT_FALSE(port->ack_o || port->err_o) << n;
    }
    // The next one gets its own answer.
    ASSERT_EQ(bus.read(at::identification), at::identification_value) << n;
    const std::uint32_t found = bus.read(at::watermark).value_or(99);
    ASSERT_TRUE(found == kept || (writes && found == told)) << n << ": " << found;
    made += found != kept;
    kept = found;
    ASSERT_EQ(bus.read(at::error), 0U) << n;
  }
  EXPECT_GT(made, 0U);
}

}  // namespace test_chip_buses
}  // namespace leadscrew::hardware
