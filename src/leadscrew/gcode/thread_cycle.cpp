#include <cmath>
#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/thread_cycle.hpp>
#include <leadscrew/numeric/functions.hpp>

namespace leadscrew::gcode {

// On a taper, K goes along E: the tool goes √(E² + K²) while Z advances by E.
ThreadCycle::ThreadCycle(const Plan& plan) : plan_(plan), phase_(Phase::back) {
  side_ = plan.crest > 0 ? 1 : -1;
  direction_ = plan.end_z > plan.start_z ? 1 : -1;
  slide_ = -direction_ * sine_of_degrees(plan.slide_angle) / cosine_of_degrees(plan.slide_angle);
  if (plan.tapers_entry || plan.tapers_exit) {
    taper_lead_ = plan.pitch * numeric::hypot(plan.taper, plan.full_depth) / plan.taper;
  }
  begin_pass();
}

// The least n of J·n^(1/R) ≥ K, and the spring passes.
double ThreadCycle::passes(const Plan& plan) {
  return std::ceil(std::pow(plan.full_depth / plan.first_depth, plan.degression)) + plan.spring_passes;
}

// The crest counts in the comparison, so that its rounding is that of the levels.
void ThreadCycle::begin_pass() {
  const double crest = std::fabs(plan_.crest), whole = plan_.full_depth + crest;
  double level = whole;
  if (springs_ == 0) {
    ++pass_;
    level = pass_ == 1 ? crest + plan_.first_depth : crest + plan_.first_depth * std::pow(pass_, 1 / plan_.degression);
  }
  if (!(level < whole)) {
    ++springs_;
    level = whole;
  }
  depth_ = level - crest;
  x_ = plan_.drive_x + side_ * level;
  crest_x_ = plan_.drive_x + side_ * (level - plan_.full_depth);
  clear_x_ = plan_.drive_x + side_ * (level - whole);
  start_z_ = plan_.start_z - depth_ * slide_;
  end_z_ = plan_.end_z + (plan_.full_depth - depth_) * slide_;
}

void ThreadCycle::end_pass() {
  phase_ = springs_ > plan_.spring_passes ? Phase::done : Phase::back;
  if (active()) begin_pass();
}

ThreadCycle::Step ThreadCycle::next() {
  using Kind = Step::Kind;
  const double taper = direction_ * plan_.taper;
  switch (phase_) {
    case Phase::back:
      phase_ = plan_.tapers_entry ? Phase::set_entry_lead : Phase::in;
      return at(Kind::rapid, clear_x_, start_z_);
    case Phase::set_entry_lead:
      phase_ = Phase::to_crest;
      return {Kind::lead, 0, 0, taper_lead_};
    case Phase::to_crest:
      phase_ = Phase::taper_in;
      return at(Kind::thread, crest_x_, start_z_);
    case Phase::taper_in:
      phase_ = Phase::set_lead;
      return at(Kind::thread, x_, start_z_ + taper);
    case Phase::in:
      phase_ = Phase::set_lead;
      return at(Kind::rapid, x_, start_z_);
    case Phase::set_lead:
      phase_ = Phase::cut;
      return {Kind::lead, 0, 0, plan_.pitch};
    case Phase::cut:
      phase_ = behind_cut();
      return at(Kind::thread, x_, plan_.tapers_exit ? end_z_ - taper : end_z_);
    case Phase::set_exit_lead:
      phase_ = Phase::taper_out;
      return {Kind::lead, 0, 0, taper_lead_};
    case Phase::taper_out:
      phase_ = Phase::release;
      return at(Kind::thread, crest_x_, end_z_);
    case Phase::release:
      phase_ = Phase::out;
      return {Kind::free, 0, 0, 0};
    case Phase::out: {
      const Step step = at(Kind::rapid, clear_x_, end_z_);
      end_pass();
      return step;
    }
    case Phase::done:
      break;
  }
  return {};
}

}  // namespace leadscrew::gcode
