#include <driver.hpp>
#include <leadscrew/hardware/block_moves.hpp>
#include <leadscrew/hardware/model_program.hpp>
#include <utility>

namespace leadscrew::hardware {

namespace {

base::Diagnostic unwritable(const std::string& path) {
  return base::problem("io-open", "cannot write " + path, "name a file in a folder that exists and may be written");
}

}  // namespace

class ModelProgram::Work {
 public:
  Work(gcode::ByteSource source, const machine::Machine& machine, const machine::ToolTable& tools,
       const gcode::ReaderOptions& reading, const nc::PulseOptions& options, gcode::DiagnosticSink sink,
       const std::optional<std::string>& waves)
      : reader_(std::move(source), machine, tools, reading, std::move(sink)),
        maker_(machine, options, reading.start),
        lanes_(machine),
        model_(make_motion_model(waves)),
        driver_(*model_) {
    if (model_->has_failed()) failure_ = unwritable(*waves);
    driver_.begin();
    driver_.set_watermark(static_cast<std::uint32_t>(driver_.core().depth / 2));
    look_ahead();
  }

  std::span<const steps::StepEvent> next(std::span<steps::StepEvent> buffer) {
    while (!is_over_ && !failure_) {
      feed();
      const std::size_t made = model_->run(buffer, lanes_.axes());
      is_over_ = made == 0 && !move_ && driver_.idle();
      if (is_over_) model_->finish_waves();
      if (made > 0) return buffer.first(made);
    }
    return {};
  }

  const MotionModel& model() const { return *model_; }
  const std::optional<base::Diagnostic>& failure() const { return failure_ ? failure_ : reader_.source_failure(); }

 private:
  /// Moves to the driver, until the FIFO is full or the program at its end.
  void feed() {
    bool has_room = true;
    while (has_room && (move_ || !driver_.ready())) {
      if (driver_.ready()) {
        driver::Move move = *move_;
        look_ahead();
        move.is_last = !move_;
        driver_.take(move);
      }
      has_room = driver_.service();
    }
    const bool goes_on = move_ || !driver_.ready();
    const std::uint32_t waits_for = 1U << (goes_on ? driver::registers::interrupt_enable_fifo_low_bit
                                                   : driver::registers::interrupt_enable_idle_bit);
    if (std::exchange(waits_for_, waits_for) != waits_for) driver_.enable_interrupts(waits_for);
  }

  /// The program's next move, or none.
  void look_ahead() {
    move_.reset();
    while (!move_) {
      auto planned = maker_.next();
      if (planned && *planned) {
        move_ = move_of((*planned)->block, lanes_).move;
      } else if (planned) {
        reader_.reject(read_, std::move(planned->error()));
        return;
      } else if (reader_.errors() > 0 || !reader_.next(read_)) {
        return;
      } else {
        maker_.load(read_);
      }
    }
  }

  gcode::Reader reader_;
  nc::BlockMaker maker_;
  Lanes lanes_;
  std::unique_ptr<MotionModel> model_;
  driver::Driver<MotionModel> driver_;
  gcode::Move read_;
  std::optional<driver::Move> move_;
  std::optional<base::Diagnostic> failure_;
  std::uint32_t waits_for_ = 0;
  bool is_over_ = false;
};

ModelProgram::ModelProgram(gcode::ByteSource source, const machine::Machine& machine, const machine::ToolTable& tools,
                           const gcode::ReaderOptions& reading, const nc::PulseOptions& options,
                           gcode::DiagnosticSink sink, const std::optional<std::string>& waves)
    : work_(std::make_unique<Work>(std::move(source), machine, tools, reading, options, std::move(sink), waves)) {}

ModelProgram::~ModelProgram() = default;

std::span<const steps::StepEvent> ModelProgram::next(std::span<steps::StepEvent> buffer) {
  return work_->next(buffer);
}

std::int64_t ModelProgram::ticks() const {
  return work_->model().ticks();
}

std::int64_t ModelProgram::clocks() const {
  return work_->model().clocks();
}

const std::optional<base::Diagnostic>& ModelProgram::source_failure() const {
  return work_->failure();
}

}  // namespace leadscrew::hardware
