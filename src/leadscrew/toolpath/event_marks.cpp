#include <algorithm>
#include <leadscrew/toolpath/event_marks.hpp>
#include <utility>

namespace leadscrew::toolpath {

void set_events(Piece& piece, std::vector<EventMark> events) {
  piece.events = events.empty() ? nullptr : std::make_shared<const std::vector<EventMark>>(std::move(events));
}

std::vector<EventMark> events_on(const PathPart& part, std::span<const EventMark> events, double longer) {
  std::vector<EventMark> found;
  for (const EventMark& mark : events) {
    if (!part.has(mark.s)) continue;
    found.push_back(mark);
    found.back().s = longer * (mark.s - part.from);
  }
  return found;
}

void append_events(std::vector<EventMark>& to, std::span<const EventMark> events, double begin) {
  for (const EventMark& mark : events) {
    to.push_back(mark);
    to.back().s += begin;
  }
}

void carry_events(Piece& piece, std::vector<EventMark>& carried) {
  if (carried.empty() && !piece.events) return;
  std::vector<EventMark> events = std::exchange(carried, {});
  for (EventMark& mark : events) mark.s = 0;
  append_events(events, events_of(piece), 0);
  const auto behind = std::find_if(events.begin(), events.end(),
                                   [&](const EventMark& mark) { return mark.s >= geometry::length(piece.curve); });
  carried.assign(behind, events.end());
  events.erase(behind, events.end());
  set_events(piece, std::move(events));
}

}  // namespace leadscrew::toolpath
