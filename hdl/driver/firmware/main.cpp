// A part on an STM32F407 with the interpolators on its memory bus: a square, a circle, a dwell; then again.

#include "../driver.hpp"

namespace {

/// Bank 1 of the FSMC, 16 bits wide: a register is two halfwords, the low one first.
class MemoryBus {
 public:
  std::uint32_t read32(std::uint32_t address) {
    const std::uint32_t low = *half(address);
    return low | static_cast<std::uint32_t>(*half(address + 2)) << 16;
  }
  void write32(std::uint32_t address, std::uint32_t data) {
    *half(address) = static_cast<std::uint16_t>(data);
    *half(address + 2) = static_cast<std::uint16_t>(data >> 16);
  }

 private:
  static volatile std::uint16_t* half(std::uint32_t address) {
    constexpr std::uint32_t bank_1 = 0x6000'0000;
    return reinterpret_cast<volatile std::uint16_t*>(bank_1 + address);
  }
};

using leadscrew::driver::Move;

Move line(std::int32_t x, std::int32_t y) {
  Move move;
  move.delta[0] = x;
  move.delta[1] = y;
  return move;
}

Move circle(std::int32_t radius) {
  Move move;
  move.kind = Move::Kind::arc;
  move.arc = {{-radius, 0}, {-radius, 0}, leadscrew::pulse::Direction::counterclockwise};
  return move;
}

Move dwell(std::uint64_t ticks) {
  Move move;
  move.kind = Move::Kind::dwell;
  move.ticks = ticks;
  return move;
}

constexpr int moves = 6;

Move move_of(int number) {
  switch (number) {
    case 0:
      return line(10'000, 0);
    case 1:
      return line(0, 10'000);
    case 2:
      return line(-10'000, 0);
    case 3:
      return line(0, -10'000);
    case 4:
      return circle(5'000);
    default:
      return dwell(1'000'000);
  }
}

}  // namespace

std::int32_t reached[2];  // for a debugger to look at

int main() {
  MemoryBus bus;
  leadscrew::driver::Driver driver(bus);
  if (!driver.begin()) return 1;
  for (int axis = 0; axis < driver.core().axes; ++axis) driver.set_times(axis, {100, 100, 250, 250});
  driver.set_clocks_a_tick(50);  // of 50 MHz: a microsecond
  driver.set_watermark(8);
  for (int number = 0;; number = (number + 1) % moves) {
    Move move = move_of(number);
    move.is_last = number == moves - 1;
    move.speed = Move::Speed::even_path;
    move.feed = (std::uint64_t{1} << driver.core().feed_width) / 100;  // 10 000 steps a second
    if (driver.take(move) != leadscrew::driver::Refusal::none) return 2;
    while (!driver.ready()) driver.service();
    for (int axis = 0; axis < 2; ++axis) reached[axis] = driver.position(axis);
  }
}
