// The same interpolators on a Cortex-M: a tick of the system timer is one step. STEP_PORT shows pulses as the AVR's port D
// does (../step_port.hpp); the direction pins turn while the step pins are low, one tick before the step.
//
// It goes round a circle and along a line and back, again and again: what a board's own program asks for comes here
// instead.

#include "../methods.hpp"
#include "../step_port.hpp"

#ifndef METHOD
#define METHOD improved
#endif

namespace leadscrew::embedded {
namespace {

using Method = METHOD<std::int32_t>;
using Place = pulse::BasicPoint<std::int32_t>;

// The STM32F407's: output data of GPIO port A, and the system timer of every Cortex-M.
volatile std::uint32_t& port() {
  return *reinterpret_cast<volatile std::uint32_t*>(0x4002'0014);
}
volatile std::uint32_t* system_timer() {
  return reinterpret_cast<volatile std::uint32_t*>(0xE000'E010);
}

constinit Method::Circle circle = Method::circle({});
constinit Method::Line line = Method::line({});
volatile bool is_running = false, is_line = false;
std::uint8_t next = 0;  // what the port is to show

template <typename State>
[[gnu::always_inline]] inline void step(State& state) {
  port() = next;
  if (state.done()) {
    next = 0;
    is_running = false;
  } else {
    next = port_of(state.step());
  }
  port() = next & direction_pins;
}

void run(bool line_next) {
  is_line = line_next;
  is_running = true;
  while (is_running) asm volatile("wfi");
}

}  // namespace

extern "C" [[gnu::used]] void step_of_arc() {
  step(circle);
}
extern "C" [[gnu::used]] void step_of_line() {
  step(line);
}

}  // namespace leadscrew::embedded

extern "C" void system_tick() {
  if (!leadscrew::embedded::is_running) return;
  leadscrew::embedded::is_line ? leadscrew::embedded::step_of_line() : leadscrew::embedded::step_of_arc();
}

int main() {
  using namespace leadscrew::embedded;
  constexpr std::uint32_t clocks_a_step = 1680;  // 100 000 steps a second at 168 MHz
  system_timer()[1] = clocks_a_step - 1;
  system_timer()[2] = 0;
  system_timer()[0] = 0b111;  // runs on the processor's clock, and interrupts
  for (;;) {
    circle = Method::circle({{5000, 0}, {5000, 0}, leadscrew::pulse::Direction::counterclockwise});
    run(false);
    for (const std::int32_t way : {1, -1}) {
      line = Method::line({way * 5000, way * 1234});
      run(true);
    }
  }
}
