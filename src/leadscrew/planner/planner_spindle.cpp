// What a planner does where the cycle follows a simulated spindle: threads and taps in step with it, feeds per revolution by
// its speed.

#include <algorithm>
#include <cmath>
#include <leadscrew/planner/piece_limits.hpp>
#include <leadscrew/planner/planner.hpp>

namespace leadscrew::planner {

namespace {

/// Of the line's length in a revolution, where the event counts some axes only.
double lead_along(const toolpath::Piece& piece, double lead) {
  return lead / piece.feed_rate(0);
}

}  // namespace

void Planner::take_lead(const base::Event& event) {
  if (!base::is_in_step(event.kind)) return;
  taps_ = event.kind == base::Event::Kind::rigid_tap || event.output == base::in_tapping_cycle;
  lead_ = event.value;
  if (lead_ > 0) return;
  turns_ = 0;
  is_in_thread_ = is_tap_begun_ = false;
}

/// So far into a piece.
void Planner::start_in_step(double s) {
  if (lead_ == 0) return;
  is_tap_begun_ = taps_ && (s > 0 || turns_ > 0);
  starts_in_step_ = s > 0 || is_tap_begun_;
}

void Planner::pass_turns(const toolpath::Piece& piece) {
  if (lead_ > 0) turns_ += piece.axes().length() / lead_along(piece, lead_);
}

/// Of the section, if nothing of it has been handed out and it is a line in step with the spindle.
std::optional<Chunk::InStep> Planner::in_step() {
  const geometry::Line* line = last_->axes().line();
  if (!follows_ || lead_ == 0 || is_tap_begun_ || look_ahead_.section().size() > 1 || closed_form_->rest() > 0 ||
      line == nullptr)
    return std::nullopt;
  Chunk::InStep step{.lead = lead_along(*last_, lead_), .waits_for_index = !is_in_thread_};
  step.limits = line_limits(*line, constraints_);
  step.tolerance = machine_.tolerance;
  if (taps_) {
    step.tap_acceleration =
        machine::tap_acceleration(*machine_.spindle, step.limits, step.lead, step.tolerance, machine_.period);
  } else {
    step.turns = std::max(turns_ - line->length() / step.lead, 0.0);
  }
  is_in_thread_ = true;
  return step;
}

double Planner::slice_in_force() const {
  return travelling_.overrides().per_revolution ? std::min(slice_, feed_slice) : slice_;
}

void Planner::spindle_turns(double speed) {
  spindle_speed_ = speed;
  take_factor();
}

/// Of all that is told the changes that are worth planning anew for.
void Planner::take_spindle() {
  const double speed = travelling_.speed_of_feed();
  if (!(speed > 0)) return;
  double share = spindle_speed_ / speed;
  if (std::abs(share - 1) < 1e-9) share = 1;
  share = std::clamp(share, least_spindle_factor, greatest_factor);
  if (share == 1 || std::abs(share - asked_.spindle) > least_spindle_change * share) asked_.spindle = share;
}

}  // namespace leadscrew::planner
