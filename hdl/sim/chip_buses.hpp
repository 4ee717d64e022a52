#pragma once
// Masters of AXI4-Lite and Wishbone B4, with stalls at random.

#include <cstdint>
#include <optional>
#include <random>

namespace leadscrew::hardware {

/// So many of a hundred clocks each side waits.
struct Stalls {
  int per_cent = 0;
  std::mt19937 random{1};

  bool now() { return std::uniform_int_distribution<int>(0, 99)(random) < per_cent; }
};

/// What a read gave; nothing where the bus told an error.
using ReadData = std::optional<std::uint32_t>;

template <typename Port>
class AxiBus {
 public:
  explicit AxiBus(Port& port) : port_(port) {}
  Stalls stalls;

  bool write(std::uint32_t address, std::uint32_t data, unsigned strobe = 15) {
    bool has_address = false, has_data = false;  // which the slave has taken
    while (!has_address || !has_data) {
      // Once it is valid it stays so until it is taken.
      if (!has_address && !stalls.now()) port_->awvalid = 1;
      if (!has_data && !stalls.now()) port_->wvalid = 1;
      port_->awaddr = static_cast<std::uint16_t>(address);
      port_->wdata = data;
      port_->wstrb = static_cast<std::uint8_t>(strobe);
      port_->eval();
      const bool takes_address = port_->awvalid && port_->awready, takes_data = port_->wvalid && port_->wready;
      port_.clock();
      if (takes_address) port_->awvalid = 0;
      if (takes_data) port_->wvalid = 0;
      has_address |= takes_address;
      has_data |= takes_data;
    }
    return answer(port_->bvalid, port_->bready, port_->bresp) == 0;
  }

  ReadData read(std::uint32_t address) {
    while (stalls.now()) port_.clock();
    port_->arvalid = 1;
    port_->araddr = static_cast<std::uint16_t>(address);
    port_->eval();
    while (!port_->arready) port_.clock();
    port_.clock();
    port_->arvalid = 0;
    const int response = answer(port_->rvalid, port_->rready, port_->rresp);
    return response == 0 ? ReadData(data_) : std::nullopt;
  }

 private:
  template <typename Signal>
  int answer(const Signal& valid, Signal& ready, const Signal& response) {
    for (;; port_.clock()) {
      ready = !stalls.now();
      port_->eval();
      if (valid && ready) break;
    }
    const int told = response;
    data_ = port_->rdata;
    port_.clock();
    ready = 0;
    return told;
  }

  Port& port_;
  std::uint32_t data_ = 0;
};

template <typename Port>
class WishboneBus {
 public:
  explicit WishboneBus(Port& port) : port_(port) {}
  Stalls stalls;

  bool write(std::uint32_t address, std::uint32_t data, unsigned strobe = 15) {
    port_->we_i = 1;
    port_->dat_i = data;
    port_->sel_i = static_cast<std::uint8_t>(strobe);
    return cycle(address).has_value();
  }
  ReadData read(std::uint32_t address) {
    port_->we_i = 0;
    port_->sel_i = 15;
    return cycle(address);
  }

 private:
  ReadData cycle(std::uint32_t address) {
    port_->adr_i = static_cast<std::uint8_t>(address >> 2);
    port_->cyc_i = 1;
    while (stalls.now()) port_.clock();  // a cycle without a strobe
    port_->stb_i = 1;
    port_->eval();
    while (!port_->ack_o && !port_->err_o) port_.clock();
    const bool is_error = port_->err_o;
    const std::uint32_t data = port_->dat_o;
    port_.clock();
    port_->stb_i = 0;
    if (stalls.now()) port_->cyc_i = 0;
    while (stalls.now()) port_.clock();
    return is_error ? std::nullopt : ReadData(data);
  }

  Port& port_;
};

}  // namespace leadscrew::hardware
