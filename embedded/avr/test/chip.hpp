#pragma once
// An ATmega328P at 16 MHz in simavr, seen from outside: its serial port, port D, and how long interrupts take.

extern "C" {
#include <simavr/avr_ioport.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
}

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "../../step_port.hpp"

namespace leadscrew::embedded {

using Cycles = std::uint64_t;

/// An interrupt of the timer, from its response to the end of its RETI.
struct Interrupt {
  Cycles cycles = 0;
  pulse::Pulse<2> pulse;  ///< rising edges of the step pins
  bool is_rare = false;   ///< it called the function for borders and ends
};

class Chip {
 public:
  /// rare: addresses, in bytes, of functions whose call is told apart.
  Chip(const std::string& firmware, std::span<const std::uint32_t> rare) : rare_(rare) {
    elf_firmware_t read{};
    if (elf_read_firmware(firmware.c_str(), &read) != 0) throw std::runtime_error("cannot read " + firmware);
    avr_ = avr_make_mcu_by_name("atmega328p");
    if (avr_ == nullptr) throw std::runtime_error("simavr has no atmega328p");
    avr_init(avr_);
    avr_->frequency = 16'000'000;
    avr_load_firmware(avr_, &read);
    avr_->log = LOG_ERROR;
    avr_->sleep = [](avr_t*, avr_cycle_count_t) {};  // not in real time
    std::uint32_t flags = 0;
    avr_ioctl(avr_, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    avr_irq_register_notify(
        avr_io_getirq(avr_, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT),
        [](avr_irq_t*, std::uint32_t byte, void* chip) { static_cast<Chip*>(chip)->said_ = static_cast<char>(byte); },
        this);
    input_ = avr_io_getirq(avr_, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT);
  }

  void send(std::uint8_t byte) { avr_raise_irq(input_, byte); }

  /// Runs until the firmware says something; each interrupt of the timer is taken down.
  template <typename Take>
  char run(const Take& take) {
    const Cycles begin = avr_->cycle;
    said_ = {};
    while (!said_) {
      run_one();
      if (at_vector()) take(run_interrupt());
      if (avr_->cycle - begin > 1'000'000'000) throw std::runtime_error("the firmware says nothing");
    }
    return *said_;
  }

  Cycles shortest_pulse() const { return shortest_pulse_; }  ///< cycles that a step pin was high
  Cycles least_set_up() const { return least_set_up_; }      ///< from a change of direction pins to a step
  Cycles least_hold() const { return least_hold_; }          ///< from a step's beginning to the next such change
  Cycles cycle() const { return avr_->cycle; }

 private:
  // What simavr 1.6 does not count: the four cycles from the request to the vector (data sheet, 7.7).
  static constexpr Cycles response = 4;
  static constexpr std::uint32_t compare_a = 11 * 4, compare_b = 12 * 4;  // vectors of timer 1
  static constexpr std::size_t port_d = 0x2B, stack_low = 0x5D, stack_high = 0x5E;

  bool at_vector() const { return avr_->pc == compare_a || avr_->pc == compare_b; }
  int stack() const { return avr_->data[stack_low] | avr_->data[stack_high] << 8; }

  void run_one() {
    const int state = avr_run(avr_);
    if (state == cpu_Done || state == cpu_Crashed) throw std::runtime_error("the firmware has stopped");
    if (avr_->data[port_d] != port_) see_port();
  }

  Interrupt run_interrupt() {
    const int inside = stack();
    const Cycles begin = avr_->cycle;
    Interrupt interrupt;
    risen_ = {};
    while (stack() <= inside) {
      run_one();
      for (const std::uint32_t address : rare_) interrupt.is_rare |= avr_->pc == address;
    }
    interrupt.cycles = avr_->cycle - begin + response;
    interrupt.pulse = risen_;
    return interrupt;
  }

  void see_port() {
    const std::uint8_t now = avr_->data[port_d];
    const auto risen = static_cast<std::uint8_t>(now & ~port_ & step_pins);
    const auto fallen = static_cast<std::uint8_t>(port_ & ~now & step_pins);
    const Cycles at = avr_->cycle;
    if (((now ^ port_) & direction_pins) != 0) {
      if (any_step_) least_hold_ = std::min(least_hold_, at - last_step_);
      last_direction_ = at;
    }
    if (risen != 0) {
      least_set_up_ = std::min(least_set_up_, at - last_direction_);
      risen_ = pulse_of(static_cast<std::uint8_t>(risen | (now & direction_pins)));
      last_step_ = at;
      any_step_ = true;
    }
    if (fallen != 0) shortest_pulse_ = std::min(shortest_pulse_, at - last_step_);
    port_ = now;
  }

  avr_t* avr_;
  avr_irq_t* input_;
  std::span<const std::uint32_t> rare_;
  std::optional<char> said_;
  std::uint8_t port_ = 0;
  pulse::Pulse<2> risen_;
  Cycles last_direction_ = 0, last_step_ = 0;
  bool any_step_ = false;
  Cycles shortest_pulse_ = ~Cycles{0}, least_set_up_ = ~Cycles{0}, least_hold_ = ~Cycles{0};
};

}  // namespace leadscrew::embedded
