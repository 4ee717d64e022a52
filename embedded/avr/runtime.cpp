// What clang's code for the AVR calls and avr-libc has not: GCC keeps it in its own library. Multiplications are needed
// only where a move is loaded or leaves a quadrant.

#include <stdint.h>

namespace {
/// Two cycles by the multiplier, whose product is in r1 and r0; r1 is 0 for everyone else.
[[gnu::always_inline]] inline uint16_t product(uint8_t a, uint8_t b) {
  uint16_t both;
  asm("mul %1, %2\n\tmovw %0, r0\n\tclr r1" : "=&r"(both) : "r"(a), "r"(b) : "r0");
  return both;
}
}  // namespace

extern "C" {
uint16_t __mulhi3(uint16_t a, uint16_t b) {
  const auto a0 = static_cast<uint8_t>(a), a1 = static_cast<uint8_t>(a >> 8);
  const auto b0 = static_cast<uint8_t>(b), b1 = static_cast<uint8_t>(b >> 8);
  const auto high = static_cast<uint8_t>(product(a0, b1) + product(a1, b0));
  return static_cast<uint16_t>(product(a0, b0) + static_cast<uint16_t>(high << 8));
}
uint32_t __mulsi3(uint32_t a, uint32_t b) {
  const auto a0 = static_cast<uint16_t>(a), a1 = static_cast<uint16_t>(a >> 16);
  const auto b0 = static_cast<uint16_t>(b), b1 = static_cast<uint16_t>(b >> 16);
  const auto high = static_cast<uint16_t>(__mulhi3(a0, b1) + __mulhi3(a1, b0));
  const auto a00 = static_cast<uint8_t>(a0), a01 = static_cast<uint8_t>(a0 >> 8);
  const auto b00 = static_cast<uint8_t>(b0), b01 = static_cast<uint8_t>(b0 >> 8);
  uint32_t low = product(a00, b00);
  low += static_cast<uint32_t>(product(a00, b01)) << 8;
  low += static_cast<uint32_t>(product(a01, b00)) << 8;
  low += static_cast<uint32_t>(product(a01, b01)) << 16;
  return low + (static_cast<uint32_t>(high) << 16);
}
uint64_t __muldi3(uint64_t a, uint64_t b) {
  uint64_t sum = 0;
  for (; b != 0; b >>= 1) {
    if (b & 1) sum += a;
    a <<= 1;
  }
  return sum;
}

/// main() does not return.
[[noreturn]] void _exit(int) {
  for (;;) {
  }
}

// Called by nobody: the start-up file falls through these, in the sections .init4, on its way to main().
extern uint8_t __data_start[], __data_end[], __bss_start[], __bss_end[];
extern const uint8_t __data_load_start[];

[[gnu::naked, gnu::used, gnu::section(".init4")]] void __do_copy_data() {
  asm volatile(
      "ldi r17, hi8(__data_end)\n\t"
      "ldi r26, lo8(__data_start)\n\t"
      "ldi r27, hi8(__data_start)\n\t"
      "ldi r30, lo8(__data_load_start)\n\t"
      "ldi r31, hi8(__data_load_start)\n\t"
      "rjmp 2f\n"
      "1:\tlpm r0, Z+\n\t"
      "st X+, r0\n"
      "2:\tcpi r26, lo8(__data_end)\n\t"
      "cpc r27, r17\n\t"
      "brne 1b");
}
[[gnu::naked, gnu::used, gnu::section(".init4")]] void __do_clear_bss() {
  asm volatile(
      "ldi r18, hi8(__bss_end)\n\t"
      "ldi r26, lo8(__bss_start)\n\t"
      "ldi r27, hi8(__bss_start)\n\t"
      "rjmp 2f\n"
      "1:\tst X+, r1\n"
      "2:\tcpi r26, lo8(__bss_end)\n\t"
      "cpc r27, r18\n\t"
      "brne 1b");
}
}
