#include <leadscrew/pipeline/path_survey.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/travel.hpp>

namespace leadscrew::pipeline {

PathSurvey::PathSurvey(base::Borrowed<machine::Machine> machine, const geometry::Point& start)
    : Survey(start),
      machine_(*machine),
      constraints_(machine_),
      feeds_(constraints_),
      builder_(machine, toolpath::tables_for_times),
      bound_(machine_) {
  if (machine_.threads_follow()) builder_.tell_revolutions();
}

std::optional<FeedExcess> PathSurvey::observe(const gcode::Move& move) {
  builder_.push(move);
  settle();
  return feeds_.observe(move);
}

void PathSurvey::finish() {
  builder_.finish();
  settle();
  bound_.finish();
}

void PathSurvey::settle() {
  while (const std::optional<toolpath::Element> element = builder_.pop()) take(*element);
}

void PathSurvey::take(const toolpath::Element& element) {
  if (const auto* piece = std::get_if<toolpath::Piece>(&element))
    toolpath::widen(*piece, machine_.axis_set(), least_, greatest_);
  bound_.push(element);
}

}  // namespace leadscrew::pipeline
