#include <leadscrew/servo/servo.hpp>
#include <string>
#include <utility>

namespace leadscrew::servo {

namespace {

base::Result<Controller> controller_of(const PidOptions& options, double period) {
  return Pid::create(options, period).map([](const Pid& made) { return Controller(made); });
}

base::Result<Controller> controller_of(const CascadeOptions& options, double period) {
  return Cascade::create(options, period).map([](const Cascade& made) { return Controller(made); });
}

base::Result<AxisLoop> loop_of(const LoopOptions& options, double period) {
  auto axis = SimulatedAxis::create(options.axis);
  if (!axis) return base::failure(std::move(axis.error()));
  auto controller = std::visit([&](const auto& of_kind) { return controller_of(of_kind, period); }, options.controller);
  if (!controller) return base::failure(std::move(controller.error()));
  return AxisLoop(std::move(*axis), std::move(*controller), period);
}

}  // namespace

base::Result<Servo> Servo::create(const ServoOptions& options, base::Period period) {
  Servo made(period.seconds());
  for (const base::Axis axis : base::all_axes) {
    const auto& of_axis = options[base::index(axis)];
    if (!of_axis) continue;
    auto loop = loop_of(*of_axis, made.period_);
    if (!loop) {
      loop.error().message.insert(0, std::string("axis ") + base::letter(axis) + ": ");
      loop.error().subject.axis = axis;
      return base::failure(std::move(loop.error()));
    }
    made.loops_[base::index(axis)] = std::move(*loop);
  }
  return made;
}

std::optional<Followed> Servo::follow(const base::Word& word) {
  if (!due_ || !next_) {
    if (!due_) origin_ = word.position;
    (due_ ? next_ : due_) = word;
    return std::nullopt;
  }
  Followed followed{*due_, due_->position};
  for (std::size_t k = 0; k < base::axis_count; ++k) {
    Setpoint setpoint = setpoint_of(due_->position[k], next_->position[k], word.position[k], period_);
    followed.velocity[k] = setpoint.velocity;
    if (!loops_[k]) continue;
    followed.position[k] = origin_[k] + loops_[k]->axis().slide();
    followed.velocity[k] = loops_[k]->axis().screw().velocity;
    setpoint.position -= origin_[k];
    loops_[k]->follow(setpoint);
    followed.control[k] = loops_[k]->command();
    followed.current[k] = loops_[k]->current();
  }
  due_ = next_;
  next_ = word;
  return followed;
}

}  // namespace leadscrew::servo
