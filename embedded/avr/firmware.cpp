// Lines and arcs on an ATmega328P (Arduino Uno, 16 MHz): a timer interrupt is one step of an interpolator of pulse/.
//
//   serial port ──▶ main(): a move ──▶ circle or line ──timer 1──▶ interrupt ──▶ port D: step and direction pins
//
// An interrupt shows the pulse that the one before has calculated, so that it comes at the same cycle whatever the
// calculation takes; the step pins are high as long as that takes, which is longer than a driver needs; and the
// direction pins have the time until the next interrupt to settle.
//
// Arcs are stepped by compare match A of the timer, lines by B, so that neither interrupt asks which it is. What is
// rare, a border of quadrants or the end of a move, is done by a function with an interrupt's prologue that saves
// whatever it uses: the compiler does not see the call, and the interrupt saves only what the steps inside a quadrant
// need.
//
// A move is a frame of 1 + 4n + 2 bytes for registers of n bytes, the least first, sent when the firmware has said '.':
//   kind       'l' line, '+' arc counterclockwise, '-' arc clockwise
//   start x y  of an arc from its centre, BLU; 0 0 for a line
//   end x y    of an arc from its centre; of a line from where the machine stands
//   period     cycles from step to step, at least least_period<Register>
// It is answered by '!' instead where it is refused: coordinates above greatest_coordinate_of, an end of an arc at the
// centre, a period too short. 1 000 000 baud, 8N1.

#include <avr/interrupt.h>
#include <avr/io.h>

#include "../methods.hpp"
#include "../step_port.hpp"

#ifndef METHOD
#define METHOD improved
#endif
#ifndef REGISTER_BITS
#define REGISTER_BITS 32
#endif

namespace leadscrew::embedded {
namespace {

using Method = METHOD<RegisterOf<REGISTER_BITS>::Type>;
using Register = Method::Register;
using Place = pulse::BasicPoint<Register>;

constinit Method::Circle circle = Method::circle({});
constinit Method::Line line = Method::line({});
volatile bool is_running = false;

/// What the port is to show at the next step. One of the registers that an instruction can read by itself.
#define NEXT_PORT GPIOR0

void stop() {
  TIMSK1 = 0;
  is_running = false;
}

// ---------------------------------------------------------------------------------------------------------------------

std::uint8_t receive() {
  while ((UCSR0A & (1 << RXC0)) == 0) {
  }
  return UDR0;
}
void send(char byte) {
  while ((UCSR0A & (1 << UDRE0)) == 0) {
  }
  UDR0 = static_cast<std::uint8_t>(byte);
}
template <typename Number>
Number receive_number() {
  std::uint8_t bytes[sizeof(Number)];
  for (std::uint8_t& byte : bytes) byte = receive();
  Number number = 0;
  for (std::uint8_t i = sizeof(Number); i > 0; --i)
    number = static_cast<Number>(static_cast<Number>(number << 8) | bytes[i - 1]);
  return number;
}

bool is_within(Place at) {
  constexpr Register greatest = pulse::greatest_coordinate_of<Register>;
  return at.x >= -greatest && at.x <= greatest && at.y >= -greatest && at.y <= greatest;
}

/// Loads a move; which interrupt steps it, 0 where it is refused.
std::uint8_t load(std::uint8_t kind, Place start, Place end) {
  if (!is_within(start) || !is_within(end)) return 0;
  if (kind == 'l') {
    line = Method::line({static_cast<Register>(end.x), static_cast<Register>(end.y)});
    return 1 << OCIE1B;
  }
  if ((kind != '+' && kind != '-') || start == Place{} || end == Place{}) return 0;
  circle = Method::circle({start, end, kind == '+' ? pulse::Direction::counterclockwise : pulse::Direction::clockwise});
  return 1 << OCIE1A;
}

/// Until the last step has been shown.
void run(std::uint8_t interrupt, std::uint16_t period) {
  NEXT_PORT = 0;
  is_running = true;
  TCCR1B = 1 << WGM12;  // the timer stands
  TCNT1 = 0;
  OCR1A = static_cast<std::uint16_t>(period - 1);
  OCR1B = static_cast<std::uint16_t>(period - 1);
  TIFR1 = 1 << OCF1A | 1 << OCF1B;
  TIMSK1 = interrupt;
  TCCR1B = 1 << WGM12 | 1 << CS10;  // it counts cycles up to OCR1A
  for (;;) {
    cli();
    if (!is_running) break;
    // The instruction after SEI is executed before any interrupt: none can come between the look and the sleep.
    asm volatile("sei\n\tsleep" ::: "memory");
  }
  sei();
}

}  // namespace

// ---------------------------------------------------------------------------------------------------------------------

/// A step that leaves a quadrant, or the end.
extern "C" [[gnu::signal, gnu::used]] void step_arc_over_border() {
  circle.settle();
  if (circle.done()) {
    NEXT_PORT = 0;
    return stop();
  }
  NEXT_PORT = port_of(circle.step());
}
extern "C" [[gnu::signal, gnu::used]] void end_line() {
  NEXT_PORT = 0;
  stop();
}

extern "C" [[gnu::signal, gnu::used]] void TIMER1_COMPA_vect() {
  PORTD = NEXT_PORT;
  auto& registers = circle.registers();
  if (registers.goes_on()) [[likely]] {
    NEXT_PORT = port_of(registers.step());
  } else {
    asm volatile("call step_arc_over_border" ::: "memory");
  }
  PORTD = NEXT_PORT & direction_pins;
}

extern "C" [[gnu::signal, gnu::used]] void TIMER1_COMPB_vect() {
  PORTD = NEXT_PORT;
  if (!line.done()) [[likely]] {
    NEXT_PORT = port_of(line.step());
  } else {
    asm volatile("call end_line" ::: "memory");
  }
  PORTD = NEXT_PORT & direction_pins;
}

}  // namespace leadscrew::embedded

int main() {
  using namespace leadscrew::embedded;
  DDRD = step_pins | direction_pins;
  UBRR0 = 1;  // 1 000 000 baud at double speed
  UCSR0A = 1 << U2X0;
  UCSR0B = 1 << RXEN0 | 1 << TXEN0;
  SMCR = 1 << SE;  // sleep is idle
  sei();
  send('.');
  for (;;) {
    const std::uint8_t kind = receive();
    const auto start_x = receive_number<Register>(), start_y = receive_number<Register>();
    const auto end_x = receive_number<Register>(), end_y = receive_number<Register>();
    const auto period = receive_number<std::uint16_t>();
    const std::uint8_t interrupt = load(kind, {start_x, start_y}, {end_x, end_y});
    const bool is_taken = interrupt != 0 && period >= least_period<Register>;
    if (is_taken) run(interrupt, period);
    send(is_taken ? '.' : '!');
  }
}
