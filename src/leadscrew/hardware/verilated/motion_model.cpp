#include <Vmotion.h>
#include <verilated_fst_c.h>

#include <cstdio>
#include <fsmc_bus.hpp>
#include <leadscrew/hardware/motion_model.hpp>

namespace leadscrew::hardware {

namespace {

/// The model, its clock and its waveforms: a clock lasts 20 ns of them.
class Traced {
 public:
  explicit Traced(const std::optional<std::string>& waves) {
    context_.traceEverOn(waves.has_value());
    model_ = std::make_unique<Vmotion>(&context_);
    if (waves) {
      path_ = *waves;
      waves_.emplace();
      model_->trace(&*waves_, 99);
      waves_->open(part().c_str());
      has_failed_ = !waves_->isOpen();
      if (has_failed_) waves_.reset();
    }
    model_->clk = 0;
    model_->eval();
  }
  ~Traced() {
    model_->final();
    if (!waves_) return;
    waves_->close();
    std::remove(part().c_str());
  }
  Traced(const Traced&) = delete;
  Traced& operator=(const Traced&) = delete;

  Vmotion* operator->() { return model_.get(); }

  void clock() {
    model_->clk = 1;
    model_->eval();
    if (waves_) waves_->dump(static_cast<std::uint64_t>(20 * clocks_));
    model_->clk = 0;
    model_->eval();
    if (waves_) waves_->dump(static_cast<std::uint64_t>(20 * clocks_ + 10));
    ++clocks_;
  }
  std::int64_t clocks() const { return clocks_; }

  void finish() {
    if (!waves_) return;
    waves_->close();
    waves_.reset();
    has_failed_ = std::rename(part().c_str(), path_.c_str()) != 0;
  }
  bool has_failed() const { return has_failed_; }

 private:
  std::string part() const { return path_ + ".part"; }

  VerilatedContext context_;
  std::unique_ptr<Vmotion> model_;
  std::string path_;
  std::optional<VerilatedFstC> waves_;
  std::int64_t clocks_ = 0;
  bool has_failed_ = false;
};

class VerilatedModel : public MotionModel {
 public:
  explicit VerilatedModel(const std::optional<std::string>& waves) : port_(waves), bus_(port_) {
    port_->hold_pin = 1;
    port_->probe = 0;
    port_->rst = 1;
    bus_.pass(3 * bus_.timing().clock);
    port_->rst = 0;
  }

  std::uint32_t read32(std::uint32_t address) override { return bus_.read32(address); }
  void write32(std::uint32_t address, std::uint32_t data) override { bus_.write32(address, data); }

  std::size_t run(std::span<steps::StepEvent> buffer, const std::array<base::Axis, axes>& lanes) override {
    std::size_t written = 0;
    Vmotion& model = *port_.operator->();
    model.hold_pin = 0;
    model.eval();
    while (model.irq == 0 && written + axes <= buffer.size()) {
      ticks_ += model.running;
      for (unsigned steps = model.step_strobe; steps != 0; steps &= steps - 1) {
        const auto lane = static_cast<std::size_t>(__builtin_ctz(steps));
        const bool backward = (model.step_backward >> lane & 1) != 0;
        buffer[written++] = steps::StepEvent(ticks_, lanes[lane], backward ? -1 : 1);
      }
      port_.clock();
    }
    model.hold_pin = 1;
    model.eval();
    return written;
  }

  void finish_waves() override { port_.finish(); }
  bool has_failed() const override { return port_.has_failed(); }

  std::int64_t ticks() const override { return ticks_; }
  std::int64_t clocks() const override { return port_.clocks(); }

 private:
  Traced port_;
  FsmcBus<Traced> bus_;
  std::int64_t ticks_ = 0;
};

}  // namespace

std::unique_ptr<MotionModel> make_motion_model(const std::optional<std::string>& waves) {
  return std::make_unique<VerilatedModel>(waves);
}

bool has_motion_model() {
  return true;
}

}  // namespace leadscrew::hardware
