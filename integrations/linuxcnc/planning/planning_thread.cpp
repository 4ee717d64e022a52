#include "planning_thread.hpp"

#include <array>
#include <cstdio>
#include <exception>
#include <leadscrew/realtime.hpp>
#include <utility>

namespace leadscrew::linuxcnc {

namespace {

constexpr std::int64_t nap = 500'000;            // ns
constexpr std::size_t stack_size = 1024 * 1024;  // bytes: all of it is locked

}  // namespace

PlanningThread::~PlanningThread() {
  ends_.store(true, std::memory_order_release);
  if (thread_) pthread_join(*thread_, nullptr);
}

bool PlanningThread::start() {
  pthread_attr_t attributes;
  if (pthread_attr_init(&attributes) != 0) return false;
  const sched_param priority{};
  pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);
  pthread_attr_setschedpolicy(&attributes, SCHED_OTHER);
  pthread_attr_setschedparam(&attributes, &priority);
  pthread_attr_setstacksize(&attributes, stack_size);
  pthread_t thread;
  const auto body = [](void* self) -> void* {
    static_cast<PlanningThread*>(self)->run();
    return nullptr;
  };
  const bool started = pthread_create(&thread, &attributes, body, this) == 0;
  pthread_attr_destroy(&attributes);
  if (started) thread_ = thread;
  return started;
}

void PlanningThread::run() {
  while (!ends_.load(std::memory_order_acquire)) {
    if (!step_or_break()) realtime::sleep_until(realtime::now() + nap);
  }
}

/// A step; whatever is thrown in it ends motion where it stands when what has been handed over is over.
bool PlanningThread::step_or_break() noexcept {
  try {
    return step();
  } catch (const std::exception& error) {
    break_off(error.what());
  } catch (...) {
    break_off("of no known kind");
  }
  return false;
}

/// No motion follows until it is set down anew.
void PlanningThread::break_off(const char* what) noexcept {
  std::array<char, 200> why{};
  std::snprintf(why.data(), why.size(), "planning has failed (%s): motion ends; run the program again from its start",
                what);
  report_(why.data());
  is_broken_ = has_failed_ = true;
  link_.has_failed.store(true, std::memory_order_release);
  link_.made.store(set_down_, std::memory_order_release);
}

/// False where there is nothing to do but wait.
bool PlanningThread::step() {
  if (link_.set_down.load(std::memory_order_acquire) != set_down_) set_down();
  if (is_broken_) return false;
  if (!engine_) return refuse_moves();
  const bool aborts = has_failed_ || link_.aborts.load(std::memory_order_acquire) == set_down_;
  if (!aborts) take_moves();
  if (!engine_) {
    link_.has_failed.store(true, std::memory_order_release);
    return false;
  }
  const bool has_gone_on =
      engine_->step({link_.factor.load(std::memory_order_relaxed), link_.top_speed.load(std::memory_order_relaxed),
                     link_.in_motion.load(std::memory_order_relaxed)},
                    aborts);
  tell();
  return has_gone_on;
}

/// The next request; a place where motion is set down is kept apart. False where there is no move.
bool PlanningThread::pop(leadscrew_tp_move& move) {
  Request request;
  if (!link_.requests.pop(request)) return false;
  if (request.set_down == 0) {
    move = request.move;
    return true;
  }
  where_ = request;
  return false;
}

/// Forgets all before the place where motion was set down last.
void PlanningThread::set_down() {
  const std::uint32_t wanted = link_.set_down.load(std::memory_order_acquire);
  for (leadscrew_tp_move forgotten; where_.set_down != wanted;) pop(forgotten);
  set_down_ = wanted;
  engine_.reset();
  next_.reset();
  pushed_ = 0;
  has_failed_ = is_broken_ = false;
  link_.finished.store(0, std::memory_order_relaxed);
  link_.gate.store(0, std::memory_order_relaxed);
  link_.rejoined.store(0, std::memory_order_relaxed);
  link_.has_failed.store(false, std::memory_order_relaxed);
  make_engine(where_.position);
  link_.made.store(set_down_, std::memory_order_release);
}

void PlanningThread::make_engine(const Position& position) {
  link_.controller.store(nullptr, std::memory_order_relaxed);
  auto machine = machine_of(where_.limits, options_, where_.period_ns, kinematics_);
  if (!machine) {  // LinuxCNC has not told its limits yet
    problem_ = told(machine.error());
    return;
  }
  const auto is_over = [this] {
    return ends_.load(std::memory_order_acquire) || link_.set_down.load(std::memory_order_acquire) != set_down_;
  };
  engine_ = std::make_unique<Engine>(std::move(*machine), kinematics_, position, where_.limits.tool, options_, is_over);
  link_.controller.store(&engine_->controller(), std::memory_order_release);
}

/// There is no machine to move.
bool PlanningThread::refuse_moves() {
  leadscrew_tp_move move;
  if (where_.set_down != set_down_ || !pop(move)) return false;
  if (!has_failed_) fail(problem_);
  link_.has_failed.store(true, std::memory_order_release);
  return true;
}

void PlanningThread::take_moves() {
  for (;;) {
    if (!next_) {
      leadscrew_tp_move move;
      if (where_.set_down != set_down_ || !pop(move)) return;
      next_ = move;
    }
    if (!may_begin(*next_)) return;
    const leadscrew_tp_move move = *std::exchange(next_, std::nullopt);
    pushed_ = move.number;
    group_ = move.group;
    if (move.is_followed) {
      Position end;
      std::copy(std::begin(move.end), std::end(move.end), end.begin());
      engine_.reset();
      make_engine(end);
      if (!engine_) return fail(problem_);
      link_.rejoined.store(move.number, std::memory_order_release);
    } else if (auto pushed = engine_->push(move); !pushed) {
      return fail(told(pushed.error()));
    }
  }
}

/// Motion goes on with it, or rests before it and may begin.
bool PlanningThread::may_begin(const leadscrew_tp_move& move) {
  const bool goes_on = engine_->is_open() && move.group == group_ && !move.waits && !move.is_followed;
  if (goes_on) return true;
  if (engine_->is_open()) engine_->end_for_now();
  if (!engine_->is_settled()) return false;
  link_.finished.store(pushed_, std::memory_order_release);
  link_.gate.store(move.number, std::memory_order_release);
  return link_.passed.load(std::memory_order_acquire) == move.number;
}

void PlanningThread::fail(const std::string& why) {
  has_failed_ = true;
  report_(why.c_str());
}

void PlanningThread::tell() {
  // Where motion is set down, planning is broken off, which is no failure.
  const bool goes_on =
      link_.set_down.load(std::memory_order_acquire) == set_down_ && !ends_.load(std::memory_order_acquire);
  if (!has_failed_ && goes_on && !engine_->failure().empty()) fail(engine_->failure());
  link_.has_failed.store(has_failed_, std::memory_order_release);
  if (!has_failed_ && engine_->is_settled()) link_.finished.store(pushed_, std::memory_order_release);
  link_.seconds_ahead.store(engine_->controller().seconds_ahead(), std::memory_order_relaxed);
  link_.late_chunks.store(engine_->late_chunks(), std::memory_order_relaxed);
  link_.starvations.store(engine_->controller().starvations(), std::memory_order_relaxed);
}

}  // namespace leadscrew::linuxcnc
