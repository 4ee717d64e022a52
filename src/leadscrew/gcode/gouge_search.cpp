#include <algorithm>
#include <leadscrew/gcode/gouge_search.hpp>
#include <leadscrew/gcode/pocket_region.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <numbers>
#include <optional>
#include <utility>

namespace leadscrew::gcode {

namespace {

constexpr std::size_t most_in_group = 64;
constexpr std::size_t most_groups = 32;
constexpr std::size_t most_found = 1000;  // of a run, lead-ins among them
constexpr double closing = 0.01;          // mm; by as much the end of a contour may miss its beginning

PlaneBox around(const ContourPiece& piece, double margin) {
  PlaneBox box{{std::min(piece.start.first, piece.end.first), std::min(piece.start.second, piece.end.second)},
               {std::max(piece.start.first, piece.end.first), std::max(piece.start.second, piece.end.second)}};
  if (piece.is_arc()) {  // the whole circle, which needs no angles
    const double radius = span_of(piece.start, piece.center);
    box = {{piece.center.first - radius, piece.center.second - radius},
           {piece.center.first + radius, piece.center.second + radius}};
  }
  return {{box.low.first - margin, box.low.second - margin}, {box.high.first + margin, box.high.second + margin}};
}

PlaneBox both(const PlaneBox& a, const PlaneBox& b) {
  return {{std::min(a.low.first, b.low.first), std::min(a.low.second, b.low.second)},
          {std::max(a.high.first, b.high.first), std::max(a.high.second, b.high.second)}};
}

bool overlap(const PlaneBox& a, const PlaneBox& b) {
  return a.low.first <= b.high.first && b.low.first <= a.high.first && a.low.second <= b.high.second &&
         b.low.second <= a.high.second;
}

}  // namespace

bool is_long_arc(const ContourPiece& contour) {
  return contour.is_arc() && sweep(contour.start, contour.end, contour.center, contour.turn) > std::numbers::pi;
}

void GougeSearch::forget() {
  groups_.clear();
  found_.clear();
  count_ = 0;
  is_closed_ = false;
}

void GougeSearch::compare(const Entry& before, const Entry& entry, double radius) {
  const auto are_seen = [](const Entry& way, const Entry& contour) {
    const std::size_t low = std::min(way.number, contour.number), high = std::max(way.number, contour.number);
    if (way.is_corner ? contour.number > way.number || contour.number + 1 < way.number : high > low + 1) return true;
    const bool are_long = is_long_arc(way.piece.contour) || is_long_arc(contour.piece.contour);
    return are_long && (way.is_corner || way.number != contour.number);
  };
  for (const Entry* const cut : {&before, &entry}) {
    const Entry& way = cut == &before ? entry : before;
    const ContourPiece& contour = cut->piece.contour;
    if (cut->is_corner || found_.size() == most_found || !overlap(way.way, cut->contour) || !are_seen(way, *cut))
      continue;
    if (keeps_clear(way.piece, contour, radius)) continue;
    found_.push_back({way.number, cut->number, !keeps_clear(way.piece, contour, radius - closing),
                      way.is_corner && way.number == 0, way.piece, contour, radius, before.place, entry.place});
  }
}

// A whole turn closes by itself.
void GougeSearch::look_for_end(const Entry& entry) {
  const ContourPiece& contour = entry.piece.contour;
  const PlaneBox reach = around(contour, closing);
  double gap = 0;
  const auto passes = [&](const Entry& before) {
    if (before.is_corner || before.number >= entry.number) return false;
    const PlanePoint start = before.piece.contour.start;
    if (before.number + 1 == entry.number) {
      gap = span_of(start, contour.end);
    } else {
      gap = overlap(reach, {start, start}) ? distance(start, contour) : 2 * closing;
    }
    return gap <= closing;
  };
  if (contour.is_arc() && span_of(contour.start, contour.end) <= closing) {
    is_closed_ = true;
    closed_from_ = closed_to_ = entry.number;
    gap_ = span_of(contour.start, contour.end);
    return;
  }
  for (const Group& group : groups_) {
    if (!overlap(group.contours, reach)) continue;
    for (const Entry& before : group.entries) {
      if (!passes(before)) continue;
      is_closed_ = true;
      closed_from_ = before.number;
      closed_to_ = entry.number;
      gap_ = gap;
    }
  }
}

void GougeSearch::keep(Entry entry) {
  if (groups_.empty() || groups_.back().entries.size() == most_in_group) {
    if (groups_.size() == most_groups) groups_.pop_front();
    groups_.push_back({{}, entry.contour, entry.way});
    groups_.back().entries.reserve(most_in_group);
  }
  Group& group = groups_.back();
  group.contours = both(group.contours, entry.contour);
  group.ways = both(group.ways, entry.way);
  group.entries.push_back(std::move(entry));
}

void GougeSearch::add(const OffsetPiece& piece, double radius, const KeptPlace& place) {
  Entry entry{piece, place, count_++, false, around(piece.contour, 0), around(piece.way, radius)};
  for (const Group& group : groups_) {
    if (!overlap(group.contours, entry.way) && !overlap(group.ways, entry.contour)) continue;
    for (const Entry& before : group.entries) compare(before, entry, radius);
  }
  if (!is_closed_) look_for_end(entry);
  keep(std::move(entry));
}

void GougeSearch::add_corner(const OffsetPiece& corner, double radius, const KeptPlace& place) {
  Entry entry{corner, place, count_, true, around(corner.way, 0), around(corner.way, radius)};
  for (const Group& group : groups_) {
    if (!overlap(group.contours, entry.way)) continue;
    for (const Entry& before : group.entries) compare(before, entry, radius);
  }
  keep(std::move(entry));
}

bool GougeSearch::is_gouge(const Gouge& gouge) const {
  const std::size_t low = std::min(gouge.way, gouge.contour), high = std::max(gouge.way, gouge.contour);
  if (!is_closed_) {
    const bool is_beside = high <= low + 1 && !gouge.is_on_way_in;
    return is_beside || (gouge.contour > 0 && gouge.contour + 1 < count_);
  }
  if (gouge.contour < closed_from_ || gouge.contour > closed_to_) return false;
  const bool is_inside = low >= closed_from_ && high <= closed_to_;
  return gouge.is_deep || (is_inside && (low > closed_from_ || high < closed_to_));
}

/// Of those that are none: by more than the contour does not close, along what closes it?
bool GougeSearch::is_slight(const Gouge& gouge) const {
  if (!is_closed_ || gouge.is_deep) return false;
  const std::size_t low = std::min(gouge.way, gouge.contour), high = std::max(gouge.way, gouge.contour);
  constexpr double rounding = 2e-6;  // mm
  return low >= closed_from_ && high <= closed_to_ &&
         !keeps_clear(gouge.cutting, gouge.cut, gouge.radius - gap_ - rounding);
}

void GougeSearch::end_run(const Report& report) {
  std::optional<base::Line> told;
  for (const Gouge& gouge : found_) {
    const bool is_whole = is_gouge(gouge);
    if (told == gouge.second.line || (!is_whole && !is_slight(gouge))) continue;
    told = gouge.second.line;
    report(gouge.first, gouge.second, is_whole ? Depth::usual : Depth::slight);
  }
  forget();
}

}  // namespace leadscrew::gcode
