// The calls of leadscrew.h for axes under simulated loops.

#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/servo/contour_matcher.hpp>
#include <leadscrew/servo/follower.hpp>
#include <leadscrew/servo/tracking.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "handles.hpp"

using namespace leadscrew;
using namespace leadscrew::capi;

struct leadscrew_loops {
  leadscrew_loops(const machine::Machine& of, servo::Follower loops)
      : machine(of),
        follower(std::move(loops)),
        tracking(of.axis_set(), of.period),
        matcher(linear_axes(of), servo::window_of(follower.lag(), of.period)) {}

  /// Contours are told of machines without rotary axes.
  static base::AxisVector linear_axes(const machine::Machine& machine) {
    base::AxisVector scale{};
    for (const base::Axis axis : base::all_axes) {
      if (machine.has(axis) && !base::is_rotary(axis)) scale[base::index(axis)] = 1;
    }
    return scale;
  }

  void take_contour(const std::vector<servo::Contour>& settled) {
    for (const servo::Contour& each : settled) {
      greatest = std::max(greatest, each.distance);
      squares += each.distance * each.distance;
      ++count;
    }
  }

  machine::Machine machine;
  servo::Follower follower;
  servo::Tracking tracking;
  servo::ContourMatcher matcher;
  double greatest = 0, squares = 0;  ///< of what has been matched, mm and mm²
  std::int64_t count = 0, periods = 0;
};

namespace {

struct NamedGain {
  const char* name;  ///< as the structure has it
  double leadscrew_loop_options::* value;
};
constexpr std::array<NamedGain, 10> gains = {{{"proportional", &leadscrew_loop_options::proportional},
                                              {"integral", &leadscrew_loop_options::integral},
                                              {"derivative", &leadscrew_loop_options::derivative},
                                              {"drive_gain", &leadscrew_loop_options::drive_gain},
                                              {"time_constant", &leadscrew_loop_options::time_constant},
                                              {"position_gain", &leadscrew_loop_options::position_gain},
                                              {"velocity_gain", &leadscrew_loop_options::velocity_gain},
                                              {"velocity_integral", &leadscrew_loop_options::velocity_integral},
                                              {"forward", &leadscrew_loop_options::forward},
                                              {"backlash", &leadscrew_loop_options::backlash}}};

/// What is wrong with the numbers, or nothing.
std::optional<base::Diagnostic> loop_problem(const leadscrew_loop_options& options) {
  for (const NamedGain& gain : gains) {
    const double value = options.*gain.value;
    if (value >= 0 && std::isfinite(value)) continue;
    return base::problem("servo-controller", std::string(gain.name) + " is " + base::text(value, 9),
                         "a finite number, 0 or more", {.field = gain.name});
  }
  if (options.forward <= 1) return std::nullopt;
  return base::problem("servo-controller", "forward is " + base::text(options.forward, 9), "a share, 0 to 1",
                       {.field = "forward"});
}

void give(std::optional<double>& to, double value) {
  if (value > 0) to = value;
}

void put_controller(machine::AxisDrive& drive, const leadscrew_loop_options& options) {
  if (options.controller == LEADSCREW_OWN_LOOPS) return;
  const bool is_pid = options.controller == LEADSCREW_PID;
  give(drive.time_constant, options.time_constant * 1000);
  give(drive.position_gain, options.position_gain);
  if (options.controller == LEADSCREW_PULSE_LOOP) return;
  drive.velocity_forward = drive.acceleration_forward = options.forward;
  if (is_pid) {
    drive.controller = machine::AxisDrive::Controller::pid;
    drive.proportional = options.proportional;
    drive.integral = options.integral;
    drive.derivative = options.derivative;
    give(drive.gain, options.drive_gain);
    return;
  }
  drive.controller = machine::AxisDrive::Controller::cascade;
  give(drive.velocity_gain, options.velocity_gain);
  drive.velocity_integral = options.velocity_integral;
}

machine::Machine with_loops(machine::Machine machine, const leadscrew_loop_options& options) {
  using Encoder = machine::AxisDrive::Encoder;
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    machine::AxisDrive& drive = machine.drives[base::index(axis)];
    put_controller(drive, options);
    if (options.encoder == LEADSCREW_ROTARY_ENCODER) drive.encoder = Encoder::screw;
    if (options.encoder == LEADSCREW_LINEAR_ENCODER) drive.encoder = Encoder::slide;
    double& play = machine.screws[base::index(axis)].backlash;
    play = std::max(play, options.backlash);
  }
  return machine;
}

base::Word word_of(const leadscrew_word& given) {
  base::Word word;
  word.tick = base::Tick{given.tick};
  std::copy_n(given.position, LEADSCREW_AXES, word.position.begin());
  word.path_length = given.path_length;
  word.speed = given.speed;
  word.feed = given.feed;
  return word;
}

leadscrew_followed structure_of(const servo::Followed& from) {
  leadscrew_followed to{};
  to.tick = base::count(from.word.tick);
  std::copy(from.position.begin(), from.position.end(), to.position);
  std::copy(from.velocity.begin(), from.velocity.end(), to.velocity);
  std::copy(from.control.begin(), from.control.end(), to.control);
  std::copy(from.current.begin(), from.current.end(), to.current);
  return to;
}

leadscrew_loop_figures figures_of(const leadscrew_loops& loops) {
  leadscrew_loop_figures figures{};
  figures.periods = loops.periods;
  for (const base::Axis axis : base::all_axes) {
    if (!loops.machine.has(axis)) continue;
    const servo::AxisTracking of = loops.tracking.axis(axis);
    const std::size_t i = base::index(axis);
    figures.greatest[i] = of.greatest;
    figures.rms[i] = of.rms;
    figures.overshoot[i] = of.overshoot;
  }
  figures.feed_greatest = loops.tracking.feed().measured_max;
  figures.feed_mean = loops.tracking.feed().measured_mean;
  figures.contour = figures.contour_rms = -1;
  if (loops.machine.rotary_chain) return figures;
  leadscrew_loops ended = loops;
  ended.matcher.finish();
  ended.take_contour(ended.matcher.take());
  figures.contour = ended.greatest;
  figures.contour_rms = std::sqrt(ended.squares / static_cast<double>(std::max<std::int64_t>(1, ended.count)));
  return figures;
}

}  // namespace

int leadscrew_loops_begin(const leadscrew_machine* machine, const leadscrew_loop_options* options,
                          leadscrew_loops** loops, leadscrew_error* error) {
  if (machine == nullptr || loops == nullptr) return misuse(error, "the machine or the place for the loops is NULL");
  leadscrew_loop_options asked{};
  if (options != nullptr) {
    const auto given = known(options);
    if (!given)
      return misuse(error, "the size of the options is none that a version had, or they ask for what is not known");
    asked = *given;
  }
  if (asked.controller < LEADSCREW_OWN_LOOPS || asked.controller > LEADSCREW_PULSE_LOOP ||
      asked.encoder < LEADSCREW_OWN_ENCODER || asked.encoder > LEADSCREW_LINEAR_ENCODER)
    return misuse(error, "the controller or the encoder is none of those that there are");
  return guarded(error, [&] {
    if (const auto problem = loop_problem(asked)) return rejected(error, *problem);
    const machine::Machine with = with_loops(machine->machine, asked);
    if (const auto problems = machine::validate(with); !problems.empty()) return rejected(error, problems.front());
    const bool is_pulses = asked.controller == LEADSCREW_PULSE_LOOP;
    auto made = servo::Follower::create(with, is_pulses ? servo::LoopKind::pulses : servo::LoopKind::words);
    if (!made) return rejected(error, made.error());
    *loops = new leadscrew_loops(with, std::move(*made));
    return static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_loops_follow(leadscrew_loops* loops, const leadscrew_word* word, size_t word_size,
                           leadscrew_followed* followed, leadscrew_error* error) {
  if (loops == nullptr) return misuse(error, "the loops are NULL");
  if (word == nullptr || word_size < sizeof(leadscrew_word))
    return misuse(error, "the word is NULL, or its size is none that a version had");
  return guarded(error, [&] {
    const std::optional<servo::Followed> came = loops->follower.follow(word_of(*word));
    leadscrew_followed found{};
    found.tick = -1;
    if (came) {
      if (auto stable = servo::check_followed(*came, loops->machine); !stable) {
        tell(error, stable.error());
        return static_cast<int>(LEADSCREW_FAILED);
      }
      loops->tracking.observe(*came);
      ++loops->periods;
      if (!loops->machine.rotary_chain) {
        loops->matcher.observe(came->word.position, came->position);
        loops->take_contour(loops->matcher.take());
      }
      found = structure_of(*came);
    }
    if (fill(followed, found)) return static_cast<int>(LEADSCREW_OK);
    return misuse(error, "the place for what came is NULL, or its size is none that a version had");
  });
}

int leadscrew_loops_figures(const leadscrew_loops* loops, leadscrew_loop_figures* figures, leadscrew_error* error) {
  if (loops == nullptr) return misuse(error, "the loops are NULL");
  return guarded(error, [&] {
    if (fill(figures, figures_of(*loops))) return static_cast<int>(LEADSCREW_OK);
    return misuse(error, "the figures are NULL, or their size is none that a version had");
  });
}

void leadscrew_loops_free(leadscrew_loops* loops) {
  delete loops;
}
