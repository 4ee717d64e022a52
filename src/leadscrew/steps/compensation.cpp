#include <algorithm>
#include <cmath>
#include <leadscrew/steps/compensation.hpp>
#include <utility>

namespace leadscrew::steps {

Compensation::Screw::Screw(const std::vector<machine::PitchError>& table) : table_(table) {
  for (const machine::PitchError& entry : table_) real_.push_back(entry.position + entry.error);
}

double Compensation::Screw::command_for(double position) const {
  if (table_.empty()) return position;
  const auto above = static_cast<std::size_t>(std::ranges::upper_bound(real_, position) - real_.begin());
  if (above == 0) return position - table_.front().error;
  if (above == table_.size()) return position - table_.back().error;
  const machine::PitchError &from = table_[above - 1], &to = table_[above];
  const double share = (position - real_[above - 1]) / (real_[above] - real_[above - 1]);
  return position - (from.error + share * (to.error - from.error));
}

double Compensation::Screw::stretch() const {
  double greatest = 1;
  for (std::size_t k = 1; k < table_.size(); ++k) {
    greatest = std::max(greatest, (table_[k].position - table_[k - 1].position) / (real_[k] - real_[k - 1]));
  }
  return greatest;
}

base::Result<Compensation> Compensation::create(const machine::Machine& machine) {
  auto problems = machine::validate(machine);
  if (!problems.empty()) return base::failure(std::move(problems.front()));
  Compensation made;
  made.period_ = machine.period.seconds();
  for (const base::Axis axis : base::all_axes) {
    const machine::ScrewErrors& errors = machine.screw(axis);
    if (errors.none()) continue;
    const machine::AxisLimits& limits = machine.limits(axis);
    AxisState state;
    state.axis = axis;
    state.forward = Screw(errors.table);
    state.backward = Screw(errors.backward_table.empty() ? errors.table : errors.backward_table);
    state.backlash = errors.backlash;
    state.velocity = limits.velocity * std::max(state.forward.stretch(), state.backward.stretch());
    state.takeup_velocity = errors.takeup_velocity > 0 ? errors.takeup_velocity : limits.velocity;
    state.acceleration = limits.acceleration;
    state.band = limits.blu / 100;
    made.axes_.push_back(std::move(state));
  }
  return made;
}

/// In which direction does the axis run? Turning back by less than the band is rounding.
void Compensation::AxisState::turn(double position) {
  const double ahead = runs_backward ? farthest - position : position - farthest;
  if (ahead < -band) runs_backward = !runs_backward;
  if (ahead > 0 || ahead < -band) farthest = position;
}

/// One period of going over from one command to the other. `lost`: how far the backward command lies below the forward
/// one.
void Compensation::AxisState::go_over(double forward_command, double lost, double period) {
  const double gap = std::fabs(lost), left = target() - over;
  const double wanted = std::min(takeup_velocity, std::sqrt(2 * acceleration * std::fabs(left) * gap));
  const double most = acceleration * period;
  speed += std::clamp(std::copysign(wanted, left) - speed, -most, most);
  double next = gap > 0 ? std::clamp(over + speed * period / gap, 0.0, 1.0) : target();
  // What words leave of the axis' velocity.
  const double at_next = forward_command - next * lost;
  const double kept = std::clamp(at_next, command - velocity * period, command + velocity * period);
  if (kept != at_next && gap > 0) {
    const double share = (forward_command - kept) / lost;
    next = std::clamp(share, std::min(over, next), std::max(over, next));
  }
  speed = (next - over) * gap / period;
  over = next;
  command = forward_command - over * lost;
}

base::Word Compensation::apply(const base::Word& word) {
  base::Word commanded = word;
  for (AxisState& axis : axes_) {
    double& position = commanded.position[base::index(axis.axis)];
    const double forward = axis.forward.command_for(position);
    if (first_) {
      axis.farthest = position;
      axis.command = forward;
    } else {
      axis.turn(position);
      axis.go_over(forward, forward - axis.backward.command_for(position) + axis.backlash, period_);
    }
    axis.greatest_correction = std::max(axis.greatest_correction, std::fabs(axis.command - position));
    position = axis.command;
  }
  first_ = false;
  return commanded;
}

bool Compensation::settled() const {
  return std::ranges::all_of(axes_, [](const AxisState& axis) { return axis.over == axis.target(); });
}

base::AxisVector Compensation::greatest_corrections() const {
  base::AxisVector greatest{};
  for (const AxisState& axis : axes_) greatest[base::index(axis.axis)] = axis.greatest_correction;
  return greatest;
}

machine::Machine Compensation::stretched(const machine::Machine& machine) const {
  machine::Machine stretched = machine;
  for (const AxisState& axis : axes_) stretched.axes[base::index(axis.axis)]->velocity = axis.velocity;
  return stretched;
}

}  // namespace leadscrew::steps
