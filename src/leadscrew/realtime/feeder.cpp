#include <algorithm>
#include <leadscrew/realtime/feeder.hpp>
#include <utility>

namespace leadscrew::realtime {

using Offer = interpolator::Controller::Offer;

namespace {

constexpr double least_in_motion = 0.03;  // s of motion, in which the way to rest is planned

}  // namespace

void Feeder::request(double factor, bool stop) {
  if (stop && !stopping_ && planning_.come_to_rest) planning_.come_to_rest();
  stopping_ = stop;
  const double asked = stop ? 0 : factor;
  if (asked == factor_) return;
  factor_ = asked;
  planning_.override_feed(factor_);
}

bool Feeder::step() {
  if (stopping_ && !in_motion_) last_ = accepted_;
  if (last_ || !wants_more()) return false;
  if (!held_.empty() && (!is_held_back() || has_ended_ || held_seconds_ >= held_back())) return hand_over();
  return take_next();
}

/// Motion that is held is planned to its rest, and no further.
bool Feeder::wants_more() const {
  return (!is_held() || in_motion_) && controller_.seconds_ahead() < std::max(look_ahead_.seconds(), patience_);
}

bool Feeder::is_held() const {
  return planning_.is_held ? stopping_ || planning_.is_held() : factor_ == 0;
}

/// s of motion that are planned before any of it begins, from rest.
double Feeder::held_back() const {
  return planning_.drought ? std::max(patience_, planning_.enough_to_begin) : patience_;
}

/// False where it must go on waiting.
bool Feeder::wait_for_moves(const Drought& drought) {
  ahead_before_.reset();  // it is not the planner that is slow
  const bool waits =
      in_motion_ ? controller_.seconds_ahead() >= least_in_motion : drought.quiet < planning_.quiet_to_begin;
  if (!drought.is_open || waits) return false;
  planning_.end_for_now();
  return true;
}

/// A quarter of what is planned ahead, so that a change waits for no long chunk; longer ones take less work.
void Feeder::set_slice() {
  constexpr double shortest = 0.01, longest = 0.02;  // s
  const double wanted = std::clamp(look_ahead_.seconds() / 4, shortest, longest);
  if (!planning_.slice || wanted == slice_) return;
  slice_ = wanted;
  planning_.slice(wanted);
}

/// Takes a chunk. False where there is none.
bool Feeder::take_next() {
  std::optional<planner::Chunk> chunk = std::exchange(after_, std::nullopt);
  if (!chunk) {
    if (!ahead_before_) ahead_before_ = controller_.seconds_ahead();
    set_slice();
    if (planning_.spindle_turns) planning_.spindle_turns(controller_.spindle_speed());
    chunk = planning_.next();
  }
  if (!chunk) {
    const std::optional<Drought> drought = planning_.drought ? planning_.drought() : std::nullopt;
    if (drought && drought->is_open) return wait_for_moves(*drought);
    if (!held_.empty()) return has_ended_ = true;
    if (drought) return false;
    in_motion_ = false;
    if (!is_held()) last_ = accepted_;
    return false;
  }
  if (!held_.empty() && chunk->begins_at_rest()) {
    after_ = std::move(chunk);
    return has_ended_ = true;
  }
  if (planning_.took && !held_.empty() && !in_motion_) look_ahead_.planned_at_rest(planning_.took());
  held_seconds_ += chunk->duration.value();
  has_ended_ = chunk->stop_tail.empty() || held_.size() + 2 >= controller_.capacity() / 2;
  held_.push_back(std::move(*chunk));
  return true;
}

/// False where it must wait.
bool Feeder::hand_over() {
  if (planning_.lets && held_.front().begins_at_rest() && !planning_.lets(held_.front())) return false;
  const bool ends_in_motion = !held_.back().stop_tail.empty();
  const bool goes_on = !held_.front().begins_at_rest();
  const auto count = static_cast<std::int64_t>(held_.size());
  const double ahead_after = controller_.seconds_ahead();
  switch (controller_.offer(held_)) {
    case Offer::accepted:
      accepted_ += count;
      in_motion_ = ends_in_motion;
      since_late_ += held_seconds_;
      if (!goes_on) look_ahead_.begins();
      if (goes_on && ahead_before_) look_ahead_.accepted(held_seconds_, *ahead_before_, ahead_after);
      break;
    case Offer::late:
      ++late_chunks_;
      look_ahead_.late();
      planning_.refuse();
      in_motion_ = false;
      since_late_ = 0;
      patience_ = std::min(std::max(farthest_look_ahead_, 2 * patience_), farthest);
      break;
    case Offer::full:
      return false;
    case Offer::unchecked:  // the cycle rests by the tail of what it has
      failure_ = base::problem("travel-unchecked", "a part of the path was not checked to lie inside travel",
                               "check_travel() does, before a piece is planned");
      last_ = accepted_;
      return false;
  }
  held_.clear();
  held_seconds_ = 0;
  ahead_before_.reset();
  has_ended_ = false;
  settle_patience();
  return true;
}

/// A planner that has kept up for long is trusted again.
void Feeder::settle_patience() {
  constexpr double times = 8;
  if (patience_ == 0 || since_late_ < times * patience_) return;
  patience_ = patience_ > farthest_look_ahead_ ? patience_ / 2 : 0;
  since_late_ = 0;
}

}  // namespace leadscrew::realtime
