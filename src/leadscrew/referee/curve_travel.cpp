#include <algorithm>
#include <leadscrew/referee/curve_travel.hpp>
#include <leadscrew/referee/tuning.hpp>
#include <limits>

namespace leadscrew::referee {

namespace {

using namespace tuning::travel;

constexpr double same_length = 1e-9;  // mm

}  // namespace

/// Those places from which the distance to the word grows forwards and backwards, within a nanometre.
void CurveTravel::find_places(CandidateSet& candidates, std::size_t last) {
  now_.clear();
  for (std::size_t i = 0; i <= last && now_.size() <= most_places; ++i) {
    const CandidateSet::Slot& here = candidates.slot(i);
    if (!here.next.alive) continue;
    Nearest nearest{here.next.place, here.next.distance};
    if (here.next.held) nearest = nearest_on(metric_, here.piece, candidates.word());
    if (!(nearest.distance <= nanometre)) continue;
    const std::int64_t serial = candidates.front_serial() + static_cast<std::int64_t>(i);
    if (!now_.empty() && now_.back().serial == serial - 1) {
      if (nearest.place <= 0) continue;
      if (now_.back().place >= 1) now_.pop_back();
    }
    now_.push_back({serial, nearest.place, nearest.distance});
  }
}

double CurveTravel::observe(CandidateSet& candidates, std::size_t last) {
  find_places(candidates, last);
  double result = 1;
  double least = std::numeric_limits<double>::infinity();
  const bool few = std::max(before_.size(), now_.size()) <= most_places;
  for (std::size_t i = 0, next = 0; few && i < now_.size(); ++i) {
    const Place& to = now_[i];
    const auto not_after = [&to](const Place& from) {
      return from.serial < to.serial || (from.serial == to.serial && from.place <= to.place);
    };
    while (next < before_.size() && not_after(before_[next])) ++next;
    if (next == 0 || before_[next - 1].serial < candidates.front_serial()) continue;
    double length = 0;
    const double found = stretch(candidates, before_[next - 1], to, length);
    if (length < least - same_length) {
      least = length;
      result = found;
    }
  }
  std::swap(before_, now_);
  return result;
}

double CurveTravel::stretch(CandidateSet& candidates, const Place& from, const Place& to, double& length) const {
  const auto piece = [&](std::int64_t serial) -> const Piece& {
    return candidates.slot(static_cast<std::size_t>(serial - candidates.front_serial())).piece;
  };
  const auto part_of = [&](std::int64_t serial) {
    return part(metric_, piece(serial).segment, serial == from.serial ? from.place : 0,
                serial == to.serial ? to.place : 1);
  };
  const Coordinates coordinates = coordinates_of(metric_, piece(to.serial).feed.axes);
  length = 0;
  for (std::int64_t serial = from.serial; serial <= to.serial; ++serial) {
    length += length_in(metric_, coordinates, part_of(serial));
  }
  const double chord = distance_in(metric_, coordinates, point_at(metric_, piece(from.serial), from.place),
                                   point_at(metric_, piece(to.serial), to.place));
  if (!(length > chord) || length > greatest_stretch * chord) return 1;
  if (length - chord > hidden_share * length) {
    Turning turning(metric_, coordinates);
    for (std::int64_t serial = from.serial; serial <= to.serial; ++serial) turning.add(part_of(serial));
    if (from.distance + to.distance + nanometre * turning.sum() > hidden_share * length) return 1;
  }
  return length / chord;
}

}  // namespace leadscrew::referee
