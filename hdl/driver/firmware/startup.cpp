// What runs before main: the vectors, the initial values of variables.

#include <cstdint>

extern "C" {
extern std::uint32_t stack_end, data_begin, data_end, data_image, bss_begin, bss_end;
}
int main();

namespace {

[[noreturn]] void stop() {
  for (;;) asm volatile("wfi");
}

[[noreturn]] void reset() {
  const std::uint32_t* image = &data_image;
  for (std::uint32_t* at = &data_begin; at != &data_end; ++at) *at = *image++;
  for (std::uint32_t* at = &bss_begin; at != &bss_end; ++at) *at = 0;
  main();
  stop();
}

/// Of the system timer, where a program has one.
extern "C" [[gnu::weak]] void system_tick() {
  stop();
}

using Handler = void (*)();

// The Cortex-M4's own exceptions; the interrupts of peripherals are not used.
struct Vectors {
  std::uint32_t* stack;
  Handler handlers[15];
};
[[gnu::section(".vectors"), gnu::used]] const Vectors vectors = {
    &stack_end,
    {reset, stop, stop, stop, stop, stop, nullptr, nullptr, nullptr, nullptr, stop, stop, nullptr, stop, system_tick}};

}  // namespace
