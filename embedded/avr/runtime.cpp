// What clang's code for the AVR calls and avr-libc has not: GCC keeps it in its own library. Multiplications are needed
// only where a move is loaded.

#include <stdint.h>

namespace {
template <typename Number>
Number product(Number a, Number b) {
  Number sum = 0;
  for (; b != 0; b >>= 1) {
    if (b & 1) sum += a;
    a <<= 1;
  }
  return sum;
}
}  // namespace

extern "C" {
uint16_t __mulhi3(uint16_t a, uint16_t b) {
  return product(a, b);
}
uint32_t __mulsi3(uint32_t a, uint32_t b) {
  return product(a, b);
}
uint64_t __muldi3(uint64_t a, uint64_t b) {
  return product(a, b);
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
