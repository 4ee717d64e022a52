#include "planning.h"

#include <algorithm>
#include <leadscrew/files.hpp>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include "link.hpp"
#include "planning_thread.hpp"

namespace {

using leadscrew::interpolator::Controller;
using leadscrew::linuxcnc::Kinematics;
using leadscrew::linuxcnc::Link;
using leadscrew::linuxcnc::PlanningThread;
using leadscrew::linuxcnc::Position;
using leadscrew::linuxcnc::Request;

}  // namespace

/// The link, the thread at its other end, and what the servo thread keeps.
struct leadscrew_tp {
  leadscrew_tp(Kinematics of_machine, const leadscrew_tp_options& options, void (*report)(const char*))
      : kinematics(std::move(of_machine)), thread(link, kinematics, options, report) {}

  const Kinematics kinematics;
  Link link;
  PlanningThread thread;

  // The servo thread's.
  std::uint32_t set_down = 0;        ///< number of the last setting down
  Controller* controller = nullptr;  ///< none yet, or while a move is followed
  std::uint32_t followed = 0;        ///< number of the move that was followed last
  Position position{};
  double speed = 0;
  std::uint32_t number = 0;
  Request where;           ///< motion was set down last
  bool is_unsaid = false;  ///< there was no room for that in the ring
};

namespace {

/// Of the machine's file; none where it has a problem, which is reported.
std::optional<Kinematics> kinematics_of(const char* file, void (*report)(const char*)) {
  if (!file) return Kinematics();
  auto machine = leadscrew::config::load_machine(file);
  if (!machine) {
    for (const leadscrew::base::Diagnostic& problem : machine.error())
      report((std::string(file) + ": " + leadscrew::linuxcnc::told(problem)).c_str());
    return std::nullopt;
  }
  if (!machine->rotary_chain) {
    report((std::string(file) + " tells no kinematics of two rotary axes; leave machine= out").c_str());
    return std::nullopt;
  }
  return Kinematics(std::move(*machine));
}

}  // namespace

void leadscrew_tp_axes_of(const leadscrew_tp* tp, const double pose[leadscrew_tp_axes], double tool,
                          double axes[leadscrew_tp_axes]) {
  Position place;
  std::copy_n(pose, leadscrew_tp_axes, place.begin());
  const Position found = tp->kinematics.axes_of(place, tool);
  std::copy(found.begin(), found.end(), axes);
}

void leadscrew_tp_pose_in_travel(const leadscrew_tp* tp, const double shares[leadscrew_tp_axes], double tool,
                                 double pose[leadscrew_tp_axes]) {
  Position axes{};
  for (const leadscrew::base::Axis axis : leadscrew::base::all_axes) {
    const std::size_t i = leadscrew::base::index(axis);
    if (!tp->kinematics.machine() || !tp->kinematics.machine()->has(axis)) continue;
    const leadscrew::machine::AxisLimits& limits = *tp->kinematics.machine()->axes[i];
    axes[i] = limits.travel_min + shares[i] * (limits.travel_max - limits.travel_min);
  }
  const Position found = tp->kinematics.pose_of(axes, tool);
  std::copy(found.begin(), found.end(), pose);
}

unsigned leadscrew_tp_machine_axes(const leadscrew_tp* tp) {
  unsigned axes = 0;
  if (!tp->kinematics.machine()) return axes;
  for (const leadscrew::base::Axis axis : leadscrew::base::all_axes)
    axes |= unsigned{tp->kinematics.machine()->has(axis)} << leadscrew::base::index(axis);
  return axes;
}

struct leadscrew_tp_limits leadscrew_tp_limits_of(const leadscrew_tp* tp, const struct leadscrew_tp_limits* limits) {
  struct leadscrew_tp_limits found = *limits;
  if (!tp->kinematics.machine()) return found;
  for (const leadscrew::base::Axis axis : leadscrew::base::all_axes) {
    const std::size_t i = leadscrew::base::index(axis);
    const auto& own = tp->kinematics.machine()->axes[i];
    found.velocity[i] = own ? own->velocity : 0;
    found.acceleration[i] = own ? own->acceleration : 0;
    if (own) found.jerk[i] = std::min(found.jerk[i], own->jerk);
  }
  return found;
}

leadscrew_tp* leadscrew_tp_create(const leadscrew_tp_options* options, void (*report)(const char*)) {
  try {
    const std::optional<Kinematics> kinematics = kinematics_of(options->machine, report);
    if (!kinematics) return nullptr;
    auto tp = std::make_unique<leadscrew_tp>(*kinematics, *options, report);
    return tp->thread.start() ? tp.release() : nullptr;
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

void leadscrew_tp_destroy(leadscrew_tp* tp) {
  delete tp;
}

struct leadscrew_tp_figures leadscrew_tp_figures_now(const leadscrew_tp* tp) {
  const Link& link = tp->link;
  return {link.seconds_ahead.load(std::memory_order_relaxed), link.late_chunks.load(std::memory_order_relaxed),
          link.starvations.load(std::memory_order_relaxed)};
}

namespace {

/// Tells the thread of planning where motion was set down, as soon as there is room; true once it is told.
bool say_where(leadscrew_tp& tp) {
  if (!tp.is_unsaid) return true;
  if (!tp.link.requests.push(tp.where)) return false;
  tp.is_unsaid = false;
  tp.link.set_down.store(tp.set_down, std::memory_order_release);
  return true;
}

}  // namespace

void leadscrew_tp_set_down(leadscrew_tp* tp, const double position[leadscrew_tp_axes],
                           const leadscrew_tp_limits* limits, std::int64_t period_ns) {
  tp->controller = nullptr;
  tp->followed = 0;
  tp->number = 0;
  tp->speed = 0;
  std::copy_n(position, leadscrew_tp_axes, tp->position.begin());
  Request request;
  request.set_down = ++tp->set_down;
  request.position = tp->position;
  request.limits = *limits;
  request.period_ns = period_ns;
  tp->link.passed.store(0, std::memory_order_relaxed);
  tp->link.in_motion.store(0, std::memory_order_relaxed);
  tp->where = request;
  tp->is_unsaid = true;
  say_where(*tp);
}

int leadscrew_tp_push(leadscrew_tp* tp, const leadscrew_tp_move* move) {
  if (!say_where(*tp) || tp->link.requests.size() >= leadscrew_tp_moves) return -1;
  Request request;
  request.move = *move;
  return tp->link.requests.push(request) ? 0 : -1;
}

void leadscrew_tp_followed(leadscrew_tp* tp, std::uint32_t number, const double position[leadscrew_tp_axes]) {
  tp->controller = nullptr;
  tp->followed = tp->number = number;
  tp->speed = 0;
  std::copy_n(position, leadscrew_tp_axes, tp->position.begin());
}

namespace {

/// Takes the controller that has been made for where motion was set down, or behind a move that was followed.
void take_controller(leadscrew_tp& tp) {
  const bool is_made = tp.link.made.load(std::memory_order_acquire) == tp.set_down;
  if (tp.controller || !is_made) return;
  if (tp.followed != 0 && tp.link.rejoined.load(std::memory_order_acquire) != tp.followed) return;
  tp.controller = tp.link.controller.load(std::memory_order_acquire);
}

}  // namespace

void leadscrew_tp_cycle(leadscrew_tp* tp, const leadscrew_tp_wishes* wishes, leadscrew_tp_word* word) {
  Link& link = tp->link;
  say_where(*tp);
  link.factor.store(wishes->factor, std::memory_order_relaxed);
  link.top_speed.store(wishes->top_speed, std::memory_order_relaxed);
  if (wishes->abort) link.aborts.store(tp->set_down, std::memory_order_release);
  link.passed.store(wishes->passed, std::memory_order_release);
  take_controller(*tp);
  const bool is_made = link.made.load(std::memory_order_acquire) == tp->set_down;
  if (tp->controller) {
    const leadscrew::base::Word next = tp->controller->next();
    tp->position = tp->kinematics.pose_of(next.position, tp->where.limits.tool);
    tp->speed = next.speed;
    tp->number = std::max(tp->number, static_cast<std::uint32_t>(leadscrew::base::number(next.line)));
  }
  link.in_motion.store(tp->number, std::memory_order_relaxed);
  std::copy(tp->position.begin(), tp->position.end(), word->position);
  word->speed = tp->speed;
  word->number = tp->number;
  word->finished = is_made ? link.finished.load(std::memory_order_acquire) : 0;
  word->gate = is_made ? link.gate.load(std::memory_order_acquire) : 0;
  word->has_failed = is_made && link.has_failed.load(std::memory_order_acquire);
  // What is planned behind the place of rest is not waited for: whoever sets down lets go of the controller.
  word->is_aborted = wishes->abort && (!tp->controller || tp->controller->stands());
}
