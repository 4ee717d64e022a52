#include "engine.hpp"

#include <algorithm>
#include <cmath>
#include <leadscrew/moves.hpp>
#include <leadscrew/realtime.hpp>
#include <numbers>
#include <utility>

namespace leadscrew::linuxcnc {

namespace {

constexpr std::size_t chunks = 256;  // some seconds at least, after chunks that were late
constexpr double far_ahead = 5;  // times the options' `ahead`: before motion begins, and after chunks that were late
constexpr double enough_to_begin = 2;   // s, at the moves' speeds
constexpr double short_slice = 0.01;    // s, where the feeder asks for no other
constexpr double least_change = 0.005;  // of the factor: adaptive feed trembles
constexpr double to_slow_down = 0.15;   // s, before a move that is too fast, beside what is settled ahead
constexpr double travel = 1e5;          // mm or degrees

/// Of a line, and not more than that of an arc.
struct Length {
  double least;  ///< mm, or degrees of rotary axes alone
  bool is_in_degrees;
};

Length length_of(const gcode::Move& move) {
  std::array<double, 3> squares{};
  for (std::size_t i = 0; i < move.end.size(); ++i) {
    const double step = move.end[i] - move.start[i];
    squares[i / 3] += step * step;
  }
  const double chord = std::sqrt(squares[0] > 0 ? squares[0] : squares[2] > 0 ? squares[2] : squares[1]);
  if (move.kind != gcode::Move::Kind::arc) return {chord, squares[0] == 0 && squares[2] == 0};
  const double radius = std::hypot(move.start[base::index(first_axis(move.plane))] - move.center_first,
                                   move.start[base::index(second_axis(move.plane))] - move.center_second);
  return {std::max(chord, 2 * std::numbers::pi * radius * (std::abs(move.turns) - 1)), false};
}

gcode::PathMode path_mode(leadscrew_tp_join join) {
  switch (join) {
    case leadscrew_tp_stop:
      return gcode::PathMode::exact_stop;
    case leadscrew_tp_exact:
      return gcode::PathMode::exact_path;
    case leadscrew_tp_blend:
      break;
  }
  return gcode::PathMode::blend;
}

base::Result<machine::Machine> sound(const machine::Machine& machine) {
  const std::vector<base::Diagnostic> problems = machine::validate(machine);
  if (!problems.empty()) return base::failure(problems.front());
  return machine;
}

}  // namespace

std::string told(const base::Diagnostic& diagnostic) {
  std::string text = std::string(diagnostic.code) + ": " + diagnostic.message;
  return diagnostic.hint.empty() ? text : text + "; " + diagnostic.hint;
}

base::Result<machine::Machine> machine_of(const leadscrew_tp_limits& limits, const leadscrew_tp_options& options,
                                          std::int64_t period_ns, const Kinematics& kinematics) {
  machine::Machine machine = kinematics.machine().value_or(machine::Machine{});
  machine.period.nanoseconds = period_ns;
  machine.tolerance = options.tolerance;
  if (kinematics.machine()) {
    for (const base::Axis axis : base::all_axes) {
      if (!machine.has(axis)) continue;
      machine::AxisLimits& own = *machine.axes[base::index(axis)];
      own.travel_min = -travel;
      own.travel_max = travel;
      own.jerk = std::min(own.jerk, limits.jerk[base::index(axis)]);
    }
    return sound(machine);
  }
  machine.name = "LinuxCNC";
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    if (limits.velocity[i] <= 0 || limits.acceleration[i] <= 0) continue;
    machine.axes[i] = machine::AxisLimits{.travel_min = -travel,
                                          .travel_max = travel,
                                          .velocity = limits.velocity[i],
                                          .acceleration = limits.acceleration[i],
                                          .jerk = limits.jerk[i],
                                          .blu = 1e-6};
  }
  return sound(machine);
}

base::Result<gcode::Move> move_of(const leadscrew_tp_move& asked, const Position& start,
                                  const machine::Machine& machine, double tool) {
  const bool is_of_tip = machine.rotary_chain.has_value();
  const double lift = is_of_tip ? tool : 0;
  Position end;
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    end[i] = machine.has(axis) ? asked.end[i] : start[i];
  }
  end[2] -= lift;
  std::array center = std::to_array(asked.center);
  center[2] -= lift;
  gcode::Move move = host::line(end, asked.speed);
  if (asked.is_arc) {
    const gcode::Plane plane =
        std::array{gcode::Plane::XY, gcode::Plane::ZX, gcode::Plane::YZ}.at(static_cast<std::size_t>(asked.plane));
    move = host::arc(end, plane, center[base::index(first_axis(plane))], center[base::index(second_axis(plane))],
                     asked.turns, asked.speed);
  }
  move.line = base::line_at(asked.number);
  move.is_of_tip = is_of_tip;
  move.tool = {0, 0, lift};
  if (auto sound = host::put_behind(start, machine, move); !sound) return base::failure(sound.error());
  move.path_mode = path_mode(asked.join);
  if (asked.join == leadscrew_tp_blend) {
    move.tolerance = move.naive_cam_tolerance = asked.tolerance > 0 ? asked.tolerance : machine.tolerance;
    move.orientation_tolerance = is_of_tip ? machine.rotary_chain->orientation_tolerance : 0;
  }
  return move;
}

Engine::Engine(machine::Machine machine, const Kinematics& kinematics, const Position& pose, double tool,
               const leadscrew_tp_options& options, std::function<bool()> ends)
    : machine_(std::move(machine)),
      tool_(tool),
      options_(options),
      moves_(machine_, kinematics.tip_of(pose, tool)),
      source_([this](gcode::Move& move) { return give(move); }, machine_, kinematics.axes_of(pose, tool)),
      controller_(machine_.period, kinematics.axes_of(pose, tool), chunks),
      planning_(planning()),
      feeder_(planning_, controller_, far_ahead * options.ahead, options.ahead) {
  source_.planner().slice(short_slice);
  source_.stop_when(std::move(ends));
}

realtime::Planning Engine::planning() {
  return {.next =
              [this] {
                const std::int64_t began = realtime::now();
                auto chunk = source_.next();
                took_ = 1e-9 * static_cast<double>(realtime::now() - began);
                return chunk;
              },
          .refuse = [this] { source_.planner().refuse(); },
          .override_feed = [this](double factor) { source_.planner().override_feed(factor); },
          .slice = [this](double seconds) { source_.planner().slice(seconds); },
          .drought = [this]() -> std::optional<realtime::Drought> {
            if (!source_.wants_moves()) return std::nullopt;
            return realtime::Drought{is_open_, quiet()};
          },
          .end_for_now = [this] { end_for_now(); },
          .come_to_rest = [this] { source_.planner().come_to_rest(); },
          .took = [this] { return took_; },
          .quiet_to_begin = options_.quiet,
          .enough_to_begin = far_ahead* options_.ahead};
}

/// s since the last move came.
double Engine::quiet() const {
  return 1e-9 * static_cast<double>(realtime::now() - last_came_);
}

pipeline::Supply Engine::give(gcode::Move& move) {
  has_begun_ = has_begun_ || !is_open_ || waiting_ >= enough_to_begin || quiet() >= options_.quiet;
  return has_begun_ ? moves_.give(move) : pipeline::Supply::later;
}

base::Result<void> Engine::push(const leadscrew_tp_move& asked) {
  auto move = move_of(asked, moves_.end(), machine_, tool_);
  if (!move) return base::failure(move.error());
  if (!is_open_) {
    has_begun_ = false;
    waiting_ = 0;
  }
  const Length length = length_of(*move);
  const double seconds = length.least / asked.speed;
  speeds_.add(asked.number, length.is_in_degrees ? 0 : asked.speed, seconds);
  waiting_ += seconds;
  moves_.append(std::move(*move));
  last_came_ = realtime::now();
  is_open_ = true;
  return {};
}

void Engine::end_for_now() {
  moves_.end_for_now();
  is_open_ = false;
}

bool Engine::step(const Wanted& wanted, bool abort) {
  speeds_.come_to(wanted.in_motion);
  const double asked = std::clamp(wanted.factor, 0.0, 2.0);
  const double speed = speeds_.greatest(feeder_.look_ahead() + to_slow_down);
  const bool is_too_fast = asked * speed > wanted.top_speed;
  const double factor = is_too_fast ? wanted.top_speed / speed : asked;
  const bool counts = factor == 0 || factor == 1 || factor_ == 0 || std::abs(factor - factor_) >= least_change;
  if (counts || (is_too_fast && factor < factor_)) factor_ = factor;
  feeder_.request(factor_, abort);
  return feeder_.step();
}

bool Engine::is_settled() const {
  return !is_open_ && moves_.waiting().empty() && (source_.wants_moves() || !moves_.has_given()) &&
         !feeder_.holds_chunks() && controller_.idle();
}

std::string Engine::failure() const {
  if (source_.failure()) return told(*source_.failure());
  if (feeder_.failure()) return told(*feeder_.failure());
  return {};
}

}  // namespace leadscrew::linuxcnc
