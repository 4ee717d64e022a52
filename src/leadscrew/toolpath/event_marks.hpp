#pragma once
// Events on pieces of path as these are trimmed, blended and fitted: each stays at the place that stands for the joint
// at which it was programmed, and none is lost or told twice.

#include <leadscrew/toolpath/path.hpp>
#include <span>
#include <vector>

namespace leadscrew::toolpath {

inline std::span<const EventMark> events_of(const Piece& piece) {
  return piece.events ? std::span<const EventMark>(*piece.events) : std::span<const EventMark>();
}
void set_events(Piece& piece, std::vector<EventMark> events);

/// A part of what is `length` long, from ≤ s < to; where it reaches to the end, that counts as well.
struct PathPart {
  double from = 0, to = 0, length = 0;

  bool has(double s) const { return s >= from && (s < to || to >= length); }
};

/// Those on the part, told from its beginning by what stands for it and is so much longer.
std::vector<EventMark> events_on(const PathPart& part, std::span<const EventMark> events, double longer = 1);

/// Appends them, told from `begin` on.
void append_events(std::vector<EventMark>& to, std::span<const EventMark> events, double begin);

/// The piece gets those that `carried` holds at its beginning, and gives those at its end or behind it for the next.
void carry_events(Piece& piece, std::vector<EventMark>& carried);

}  // namespace leadscrew::toolpath
