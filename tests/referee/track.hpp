#pragma once
// Programs and motions for the referee's tests, made by plain means: each block from rest to rest by one polynomial of
// time, positions by interpolation, sine and cosine.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/referee/referee.hpp>
#include <numbers>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::referee::test {

using base::Axis;
using base::AxisVector;
using gcode::Move;
using Words = std::vector<AxisVector>;

inline double& at(AxisVector& position, Axis axis) {
  return position[base::index(axis)];
}
inline double at(const AxisVector& position, Axis axis) {
  return position[base::index(axis)];
}

/// Five axes: X Y Z in millimetres, A and C in degrees.
inline machine::Machine five_axes() {
  machine::Machine machine = machine::mill3();
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
    machine.axes[base::index(axis)]->travel_min = -2000;
    machine.axes[base::index(axis)]->travel_max = 2000;
  }
  for (const Axis axis : {Axis::A, Axis::C}) {
    machine.axes[base::index(axis)] = machine::AxisLimits{
        .travel_min = -9999, .travel_max = 9999, .velocity = 180, .acceleration = 900, .jerk = 15000, .blu = 0.001};
  }
  return machine;
}

/// A program under construction; its blocks are on lines 1, 2, 3…
struct Program {
  std::vector<Move> moves;
  AxisVector position{};
  gcode::Feed feed{gcode::Feed::Mode::rapid, 0};
  gcode::PathMode path_mode = gcode::PathMode::exact_stop;
  double tolerance = 0;

  Move& add(Move move, const AxisVector& end) {
    move.line = base::Line{static_cast<std::int64_t>(moves.size()) + 1};
    move.start = position;
    move.end = end;
    move.feed = feed;
    move.path_mode = path_mode;
    move.tolerance = tolerance;
    position = end;
    moves.push_back(move);
    return moves.back();
  }

  Program& line(const AxisVector& end) {
    add({}, end);
    return *this;
  }
  Program& line(double x, double y) {
    AxisVector end = position;
    at(end, Axis::X) = x;
    at(end, Axis::Y) = y;
    return line(end);
  }
  Program& arc(const AxisVector& end, gcode::Plane plane, double center_first, double center_second, int turns) {
    Move move;
    move.kind = Move::Kind::arc;
    move.plane = plane;
    move.center_first = center_first;
    move.center_second = center_second;
    move.turns = turns;
    add(move, end);
    return *this;
  }
  /// Whole turns in XY around a centre.
  Program& circle(double center_x, double center_y, int turns) {
    return arc(position, gcode::Plane::XY, center_x, center_y, turns);
  }
  Program& fed(double millimetres_per_second) {
    feed = {gcode::Feed::Mode::units_per_second, millimetres_per_second};
    return *this;
  }
  Program& blended(double millimetres) {
    path_mode = gcode::PathMode::blend;
    tolerance = millimetres;
    return *this;
  }
};

inline MoveSource source_of(const std::vector<Move>& moves) {
  return [&moves, next = std::size_t{0}](Move& move) mutable {
    if (next == moves.size()) return false;
    move = moves[next++];
    return true;
  };
}

inline double angle_of(const Move& move) {
  const double first = at(move.start, gcode::first_axis(move.plane)) - move.center_first;
  const double second = at(move.start, gcode::second_axis(move.plane)) - move.center_second;
  return std::atan2(second, first);
}

/// Signed angle an arc turns through.
inline double sweep_of(const Move& move) {
  const double first = at(move.end, gcode::first_axis(move.plane)) - move.center_first;
  const double second = at(move.end, gcode::second_axis(move.plane)) - move.center_second;
  const double pi = std::numbers::pi;
  double sweep = std::atan2(second, first) - angle_of(move);
  const bool closed = at(move.start, gcode::first_axis(move.plane)) == at(move.end, gcode::first_axis(move.plane)) &&
                      at(move.start, gcode::second_axis(move.plane)) == at(move.end, gcode::second_axis(move.plane));
  if (move.turns > 0) {
    while (sweep <= 0 || closed) {
      if (closed) return 2 * pi * move.turns;
      sweep += 2 * pi;
    }
    return sweep + 2 * pi * (move.turns - 1);
  }
  if (closed) return 2 * pi * move.turns;
  while (sweep >= 0) sweep -= 2 * pi;
  return sweep + 2 * pi * (move.turns + 1);
}

inline double radius_of(const Move& move) {
  return std::hypot(at(move.start, gcode::first_axis(move.plane)) - move.center_first,
                    at(move.start, gcode::second_axis(move.plane)) - move.center_second);
}

/// Where a move is after a share 0…1 of its length.
inline AxisVector position_on(const Move& move, double share) {
  AxisVector result{};
  for (std::size_t i = 0; i < base::axis_count; ++i) {
    result[i] = share < 0.5 ? move.start[i] + share * (move.end[i] - move.start[i])
                            : move.end[i] - (1 - share) * (move.end[i] - move.start[i]);
  }
  if (move.kind != Move::Kind::arc) return result;
  if (share <= 0) return move.start;
  if (share >= 1) return move.end;
  const double angle = angle_of(move) + share * sweep_of(move);
  at(result, gcode::first_axis(move.plane)) = move.center_first + radius_of(move) * std::cos(angle);
  at(result, gcode::second_axis(move.plane)) = move.center_second + radius_of(move) * std::sin(angle);
  return result;
}

/// Length over all axes, mm and degrees alike; of arcs with the arc.
inline double length_of(const Move& move) {
  double sum = 0;
  for (const Axis axis : base::all_axes) {
    const bool in_plane = move.kind == Move::Kind::arc &&
                          (axis == gcode::first_axis(move.plane) || axis == gcode::second_axis(move.plane));
    const double step = at(move.end, axis) - at(move.start, axis);
    if (!in_plane) sum += step * step;
  }
  if (move.kind == Move::Kind::arc) sum += std::pow(radius_of(move) * sweep_of(move), 2);
  return std::sqrt(sum);
}

// The time law: share of the length after a share τ of the time, at rest with no acceleration and no jerk at both ends.
inline double law(double tau) {
  return tau <= 0 ? 0 : tau >= 1 ? 1 : tau * tau * tau * tau * (35 + tau * (-84 + tau * (70 - 20 * tau)));
}
constexpr double law_velocity = 2.1875, law_acceleration = 7.5132, law_jerk = 52.5;  // largest derivatives

/// A duration in which the law keeps `share` of every limit of the machine and of the programmed feed.
inline double duration_of(const Move& move, const machine::Machine& machine, double share = 0.9) {
  const double length = length_of(move);
  if (length == 0) return 0;
  machine::AxisLimits least{.velocity = 1e9, .acceleration = 1e9, .jerk = 1e9};
  for (const auto& axis : machine.axes) {
    if (!axis) continue;
    least.velocity = std::min(least.velocity, axis->velocity);
    least.acceleration = std::min(least.acceleration, axis->acceleration);
    least.jerk = std::min(least.jerk, axis->jerk);
  }
  double feed = 1e9;
  if (move.feed.mode == gcode::Feed::Mode::units_per_second) feed = move.feed.value;
  const double curvature = move.kind == Move::Kind::arc ? 1 / radius_of(move) : 0;
  const auto fits = [&](double duration) {
    const double v = law_velocity * length / duration;
    const double a = law_acceleration * length / duration / duration;
    const double j = law_jerk * length / duration / duration / duration;
    return v <= share * std::min(feed, least.velocity) && a + v * v * curvature <= share * least.acceleration &&
           j + 3 * v * a * curvature + v * v * v * curvature * curvature <= share * least.jerk;
  };
  double low = 0, high = 1e-6;
  while (!fits(high)) high *= 2;
  for (int i = 0; i < 60; ++i) (fits((low + high) / 2) ? high : low) = (low + high) / 2;
  return high;
}

/// Words of the moves one after the other, each from rest to rest in its duration, beginning a fraction of a tick after
/// 0.
inline Words sample(const std::vector<Move>& moves, const std::vector<double>& durations, base::Period period,
                    double delay = 0.3e-3) {
  Words words;
  double begins = delay;
  std::size_t i = 0;
  if (moves.empty()) return words;
  const double T = period.seconds();
  while (true) {
    const double t = static_cast<double>(words.size()) * T;
    while (i + 1 < moves.size() && t >= begins + durations[i]) begins += durations[i++];
    const double tau = durations[i] > 0 ? (t - begins) / durations[i] : (t >= begins ? 1.0 : 0.0);
    words.push_back(position_on(moves[i], law(tau)));
    if (i + 1 == moves.size() && t >= begins + durations[i]) return words;
  }
}

inline std::vector<double> durations_of(const std::vector<Move>& moves, const machine::Machine& machine) {
  std::vector<double> durations;
  for (const Move& move : moves) durations.push_back(duration_of(move, machine));
  return durations;
}

inline Words exact_motion(const Program& program, const machine::Machine& machine, base::Period period) {
  return sample(program.moves, durations_of(program.moves, machine), period);
}

inline Verdict judge(const std::vector<Move>& moves, const Words& words, const machine::Machine& machine,
                     base::Period period) {
  Referee referee(source_of(moves), machine, period);
  for (const AxisVector& word : words) referee.observe(word);
  return referee.conclude();
}

inline bool has(const Verdict& verdict, std::string_view what, std::int64_t line = -1) {
  return std::any_of(verdict.violations.begin(), verdict.violations.end(), [&](const Violation& violation) {
    return violation.what == what && (line < 0 || base::number(violation.line) == line);
  });
}

inline bool has_only(const Verdict& verdict, std::string_view what) {
  return verdict.objects() && std::all_of(verdict.violations.begin(), verdict.violations.end(),
                                          [&](const Violation& violation) { return violation.what == what; });
}

inline std::string describe(const Verdict& verdict) {
  std::string text = "deviation " + std::to_string(verdict.deviation_mm * 1e6) + " nm, " +
                     std::to_string(verdict.violation_count) + " violations";
  for (std::size_t i = 0; i < std::min<std::size_t>(verdict.violations.size(), 12); ++i) {
    const Violation& violation = verdict.violations[i];
    text += "\n  " + std::to_string(violation.t) + " s, line " + std::to_string(base::number(violation.line)) + ": " +
            violation.what + " " + std::to_string(violation.value) + " of " + std::to_string(violation.limit);
  }
  return text;
}

/// Lines and arcs in every plane, helices, whole circles, retraced lines, tiny blocks and rotary moves.
inline Program random_program(std::mt19937_64& random, int blocks, double size, double offset) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto chance = [&](double probability) { return uniform(0, 1) < probability; };
  Program program;
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) at(program.position, axis) = offset + uniform(-size, size);
  AxisVector before = program.position;
  while (static_cast<int>(program.moves.size()) < blocks) {
    if (chance(0.7))
      program.fed(std::exp(uniform(0, 5)));
    else
      program.feed = {gcode::Feed::Mode::rapid, 0};
    const AxisVector here = program.position;
    AxisVector end = here;
    const double reach = chance(0.3) ? std::exp(uniform(-14, 0)) : size;
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) {
      if (chance(0.7)) at(end, axis) += uniform(-reach, reach);
    }
    if (chance(0.2)) at(end, Axis::A) += uniform(-90, 90);
    if (chance(0.2)) at(end, Axis::C) += uniform(-90, 90);
    if (chance(0.35)) {
      const auto plane = static_cast<gcode::Plane>(random() % 3);
      const Axis first = gcode::first_axis(plane), second = gcode::second_axis(plane),
                 normal = gcode::normal_axis(plane);
      const double radius = chance(0.2) ? std::exp(uniform(-7, 0)) : uniform(0.1 * size, size);
      const double angle = uniform(0, 2 * std::numbers::pi);
      const double center_first = at(here, first) + radius * std::cos(angle);
      const double center_second = at(here, second) + radius * std::sin(angle);
      const double true_radius = std::hypot(at(here, first) - center_first, at(here, second) - center_second);
      const double end_angle = uniform(0, 2 * std::numbers::pi);
      AxisVector arc_end = here;
      if (chance(0.6)) {
        at(arc_end, first) = center_first + true_radius * std::cos(end_angle);
        at(arc_end, second) = center_second + true_radius * std::sin(end_angle);
      }
      if (chance(0.4)) at(arc_end, normal) += uniform(-size, size);
      if (chance(0.2)) at(arc_end, Axis::C) += uniform(-90, 90);
      int turns = 1 + static_cast<int>(chance(0.3) ? random() % 3 : 0);
      program.arc(arc_end, plane, center_first, center_second, chance(0.5) ? turns : -turns);
    } else if (chance(0.3)) {
      program.line(before);  // exactly back
    } else if (chance(0.1)) {
      for (int i = 0; i < 20; ++i) {
        AxisVector tiny = program.position;
        at(tiny, Axis::X) += uniform(-1e-4, 1e-4) * std::exp(uniform(-5, 0));
        at(tiny, Axis::Y) += uniform(-1e-4, 1e-4) * std::exp(uniform(-5, 0));
        program.line(tiny);
      }
    } else {
      program.line(end);
    }
    before = here;
  }
  return program;
}

}  // namespace leadscrew::referee::test
