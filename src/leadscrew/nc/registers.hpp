#pragma once
// The registers of an interpolator, as they are shown.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace leadscrew::nc {

/// Names as the papers have them: x y are coordinates from the centre, or from a line's start; Jx Jy the integrands of
/// a line, rx ry the remainders, nx ny the steps that are left, n the clocks that are, q the capacity, F the deviation.
struct Register {
  std::string_view name;
  std::int64_t value = 0;
};

class Registers {
 public:
  void add(std::string_view name, std::int64_t value) { all_[count_++] = {name, value}; }
  std::span<const Register> all() const { return {all_.data(), count_}; }

 private:
  std::array<Register, 9> all_{};
  std::size_t count_ = 0;
};

/// A register's name here, or that of the pulse "dx" or "dy", and its name in a paper.
struct PaperName {
  std::string_view ours, paper;
};

}  // namespace leadscrew::nc
