#pragma once
// A model that Verilator has made, and its clock.

#include <verilated.h>

#include <cstdint>
#include <memory>

namespace leadscrew::hardware {

/// A model with an input `clk`. Set its inputs, clock(), read its outputs; eval() first where outputs follow inputs
/// without a clock.
template <typename Model>
class Clocked {
 public:
  Clocked() : model_(std::make_unique<Model>(&context_)) {
    model_->clk = 0;
    model_->eval();
  }
  ~Clocked() { model_->final(); }
  Clocked(const Clocked&) = delete;
  Clocked& operator=(const Clocked&) = delete;

  Model* operator->() { return model_.get(); }
  const Model* operator->() const { return model_.get(); }

  /// One rising edge, with the inputs as they are now.
  void clock() {
    model_->eval();
    model_->clk = 1;
    model_->eval();
    model_->clk = 0;
    model_->eval();
    ++clocks_;
  }
  std::int64_t clocks() const { return clocks_; }

 private:
  VerilatedContext context_;
  std::unique_ptr<Model> model_;
  std::int64_t clocks_ = 0;
};

/// A signed value of so many bits, as the unsigned integer in which a model keeps it.
constexpr std::int64_t signed_of(std::uint64_t value, int bits) {
  const std::uint64_t sign = std::uint64_t{1} << (bits - 1);
  const std::uint64_t kept = value & ((sign << 1) - 1);
  return static_cast<std::int64_t>(kept ^ sign) - static_cast<std::int64_t>(sign);
}
constexpr std::uint64_t bits_of(std::int64_t value, int bits) {
  return static_cast<std::uint64_t>(value) & ((std::uint64_t{2} << (bits - 1)) - 1);
}

}  // namespace leadscrew::hardware
