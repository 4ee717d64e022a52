#include <algorithm>
#include <charconv>
#include <cmath>
#include <leadscrew/stepping/compensation.hpp>
#include <string>
#include <utility>

namespace leadscrew::stepping {

namespace {

std::string text(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, end.ptr};
}

bool is_empty(const ScrewErrors& errors) {
  return errors.table.empty() && errors.backward_table.empty() && errors.backlash == 0;
}

class Checker {
 public:
  explicit Checker(std::vector<base::Diagnostic>& problems) : problems_(problems) {}

  void check(base::Axis axis, const ScrewErrors& errors) {
    name_ = std::string("axis ") + base::letter(axis);
    check_table("", errors.table);
    check_table("backward ", errors.backward_table);
    if (!(errors.backlash >= 0 && std::isfinite(errors.backlash))) {
      add("backlash", name_ + ": a backlash of " + text(errors.backlash), "0 or more");
    }
    if (!(errors.takeup_velocity >= 0 && std::isfinite(errors.takeup_velocity))) {
      add("backlash", name_ + ": backlash taken up at " + text(errors.takeup_velocity), "0 or more, units a second");
    }
  }

  void add(std::string_view code, std::string message, std::string hint) {
    problems_.push_back({base::Severity::error, code, std::move(message), std::move(hint), {}, {}});
  }

 private:
  void check_table(const char* which, const std::vector<PitchError>& table) {
    for (std::size_t k = 0; k < table.size(); ++k) {
      const std::string entry = name_ + ": " + which + "pitch entry " + std::to_string(k + 1);
      if (!std::isfinite(table[k].position) || !std::isfinite(table[k].error)) {
        add("pitch-value", entry + " is " + text(table[k].position) + " " + text(table[k].error), "finite numbers");
        return;
      }
      if (k > 0) check_step(entry, table[k - 1], table[k]);
    }
  }

  void check_step(const std::string& entry, const PitchError& before, const PitchError& now) {
    const double way = now.position - before.position, change = now.error - before.error;
    if (!(way > 0)) {
      add("pitch-order", entry + " is at " + text(now.position) + ", the one before at " + text(before.position),
          "positions that rise from entry to entry");
    } else if (std::fabs(change) > greatest_pitch_slope * way) {
      add("pitch-slope", entry + ": the error changes by " + text(change) + " along " + text(way),
          "at most a tenth of the way; are errors in the same unit as positions?");
    }
  }

  std::vector<base::Diagnostic>& problems_;
  std::string name_;
};

}  // namespace

std::vector<base::Diagnostic> validate(const MachineErrors& errors, const machine::Machine& machine) {
  std::vector<base::Diagnostic> problems;
  Checker checker(problems);
  for (const base::Axis axis : base::all_axes) {
    const ScrewErrors& of_axis = errors[base::index(axis)];
    checker.check(axis, of_axis);
    if (machine.has(axis) || is_empty(of_axis)) continue;
    checker.add("pitch-axis", std::string("errors are given for axis ") + base::letter(axis) + ", which is not there",
                "axes of the machine");
  }
  return problems;
}

Compensation::Screw::Screw(const std::vector<PitchError>& table) : table_(table) {
  for (const PitchError& entry : table_) real_.push_back(entry.position + entry.error);
}

double Compensation::Screw::command_for(double position) const {
  if (table_.empty()) return position;
  const auto above = static_cast<std::size_t>(std::ranges::upper_bound(real_, position) - real_.begin());
  if (above == 0) return position - table_.front().error;
  if (above == table_.size()) return position - table_.back().error;
  const PitchError &from = table_[above - 1], &to = table_[above];
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

base::Result<Compensation> Compensation::create(const MachineErrors& errors, const machine::Machine& machine) {
  auto problems = validate(errors, machine);
  if (!problems.empty()) return base::failure(std::move(problems.front()));
  Compensation made;
  made.period_ = machine.period.seconds();
  for (const base::Axis axis : base::all_axes) {
    const ScrewErrors& of_axis = errors[base::index(axis)];
    if (is_empty(of_axis)) continue;
    const machine::AxisLimits& limits = machine.limits(axis);
    AxisState state;
    state.axis = axis;
    state.forward = Screw(of_axis.table);
    state.backward = Screw(of_axis.backward_table.empty() ? of_axis.table : of_axis.backward_table);
    state.backlash = of_axis.backlash;
    state.velocity = limits.velocity * std::max(state.forward.stretch(), state.backward.stretch());
    state.takeup_velocity = of_axis.takeup_velocity > 0 ? of_axis.takeup_velocity : limits.velocity;
    state.acceleration = limits.acceleration;
    state.band = limits.blu / 100;
    made.axes_.push_back(std::move(state));
  }
  return made;
}

/// Which way does the axis run? A way back within the band is rounding.
void Compensation::AxisState::turn(double position) {
  const double ahead = runs_backward ? farthest - position : position - farthest;
  if (ahead < -band) runs_backward = !runs_backward;
  if (ahead > 0 || ahead < -band) farthest = position;
}

/// A period's way from one command to the other. `lost`: how far the backward command lies below the forward one.
void Compensation::AxisState::go_over(double forward_command, double lost, double period) {
  const double way = std::fabs(lost), left = target() - over;
  const double wanted = std::min(takeup_velocity, std::sqrt(2 * acceleration * std::fabs(left) * way));
  const double most = acceleration * period;
  speed += std::clamp(std::copysign(wanted, left) - speed, -most, most);
  double next = way > 0 ? std::clamp(over + speed * period / way, 0.0, 1.0) : target();
  // What words leave of the axis' velocity.
  const double at_next = forward_command - next * lost;
  const double kept = std::clamp(at_next, command - velocity * period, command + velocity * period);
  if (kept != at_next && way > 0) {
    const double room = (forward_command - kept) / lost;
    next = std::clamp(room, std::min(over, next), std::max(over, next));
  }
  speed = (next - over) * way / period;
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
    position = axis.command;
  }
  first_ = false;
  return commanded;
}

bool Compensation::settled() const {
  return std::ranges::all_of(axes_, [](const AxisState& axis) { return axis.over == axis.target(); });
}

machine::Machine Compensation::stretched(const machine::Machine& machine) const {
  machine::Machine stretched = machine;
  for (const AxisState& axis : axes_) stretched.axes[base::index(axis.axis)]->velocity = axis.velocity;
  return stretched;
}

}  // namespace leadscrew::stepping
