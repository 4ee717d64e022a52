#pragma once
// What an STM32F4 does on its memory bus (FSMC, asynchronous SRAM of 16 bits), beside a model's clock.

#include <cstdint>

namespace leadscrew::hardware {

/// Picoseconds. The clocks of a model of 50 MHz are 20 000 apart.
struct FsmcTiming {
  std::int64_t clock = 20'000;
  std::int64_t address_setup = 6'000;  ///< NE, A, NBL, D to NWE or NOE falling
  std::int64_t write_low = 60'000;     ///< 3 clocks at least
  std::int64_t write_high = 40'000;    ///< from NWE rising to the next falling: 2 clocks at least
  std::int64_t data_hold = 6'000;      ///< of A, NBL, D behind NWE; ≤ write_high
  std::int64_t read_low = 130'000;     ///< 6 clocks and a little at least
  std::int64_t read_high = 60'000;     ///< from NOE rising to the next falling: 3 clocks at least
};

/// Port: a model as Clocked gives it, whose signals NE … D_in the bus drives and whose clock() it calls.
template <typename Port>
class FsmcBus {
 public:
  explicit FsmcBus(Port& port, const FsmcTiming& timing = {}) : port_(port), timing_(timing) {
    port_->NE = port_->NOE = port_->NWE = 1;
    port_->NBL = 3;
    port_->A = 0;
    port_->D_in = 0;
  }

  FsmcTiming& timing() { return timing_; }
  Port& port() { return port_; }

  /// Time passes: all clocks in it.
  void pass(std::int64_t picoseconds) {
    now_ += picoseconds;
    for (; next_clock_ <= now_; next_clock_ += timing_.clock) port_.clock();
  }

  /// Of a halfword; byte address. masked: a bit for each byte that is not written.
  void write_half(std::uint32_t address, std::uint16_t data, unsigned masked = 0) {
    select(address, masked);
    port_->D_in = data;
    pass(timing_.address_setup);
    port_->NWE = 0;
    pass(timing_.write_low);
    port_->NWE = 1;
    pass(timing_.data_hold);
    port_->NE = 1;
    port_->D_in = static_cast<std::uint16_t>(~data);
    port_->A = static_cast<std::uint8_t>(~port_->A);
    pass(timing_.write_high - timing_.data_hold - timing_.address_setup);
  }

  std::uint16_t read_half(std::uint32_t address) {
    select(address, 0);
    pass(timing_.address_setup);
    port_->NOE = 0;
    pass(timing_.read_low);
    port_->eval();
    const auto data = static_cast<std::uint16_t>(port_->D_drive ? port_->D_out : 0xDEAD);
    port_->NOE = 1;
    port_->NE = 1;
    pass(timing_.read_high - timing_.address_setup);
    return data;
  }

  void write32(std::uint32_t address, std::uint32_t data) {
    write_half(address, static_cast<std::uint16_t>(data));
    write_half(address + 2, static_cast<std::uint16_t>(data >> 16));
  }
  std::uint32_t read32(std::uint32_t address) {
    const std::uint32_t low = read_half(address);
    return low | static_cast<std::uint32_t>(read_half(address + 2)) << 16;
  }

 private:
  void select(std::uint32_t address, unsigned masked) {
    port_->NE = 0;
    port_->A = static_cast<std::uint8_t>(address >> 1);
    port_->NBL = static_cast<std::uint8_t>(masked);
  }

  Port& port_;
  FsmcTiming timing_;
  std::int64_t now_ = 0, next_clock_ = 0;
};

}  // namespace leadscrew::hardware
