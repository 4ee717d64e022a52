#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/pocket_path.hpp>

namespace leadscrew::gcode {

namespace {

constexpr double most_lines = 10'000;
constexpr double most_work = 2e7;  // lines × pieces², of which each takes some hundred nanoseconds

}  // namespace

PocketPath::PocketPath(const Contour& contour, double aside, PlanePoint start, double step)
    : contour_(contour), aside_(aside), start_(start), step_(step), tool_(start) {}

// Line 0 goes through the start.
bool PocketPath::find_parts() {
  double low = start_.second, high = start_.second;
  for (const ContourPiece& piece : contour_) {
    PlaneBox box{piece.start, piece.start};
    if (piece.is_arc()) box = arc_extent(piece.start, piece.end, piece.center, piece.turn);
    low = std::min(low, box.low.second);
    high = std::max(high, box.high.second);
  }
  const double pieces = static_cast<double>(contour_.size()), lines = (high - low) / step_ + 1;
  if (!(lines <= most_lines) || lines * pieces * pieces > most_work) {
    outcome_ = Outcome::too_many;
    return false;
  }
  const int first = -static_cast<int>(std::floor((start_.second - low) / step_));
  const int last = static_cast<int>(std::floor((high - start_.second) / step_));
  std::vector<std::size_t> before;
  for (int line = first; line <= last; ++line) {
    const double y = start_.second + line * step_;
    std::vector<std::size_t> here;
    for (const Span& span : clear_spans(contour_, aside_, y)) {
      here.push_back(parts_.size());
      parts_.push_back({span, y, false, {}});
      for (const std::size_t other : before) {
        double x = 0;
        if (!find_link(parts_.back(), parts_[other], span.low, x)) continue;
        parts_.back().neighbours.push_back(other);
        parts_[other].neighbours.push_back(here.back());
      }
    }
    before = std::move(here);
  }
  return true;
}

bool PocketPath::is_clear(PlanePoint from, PlanePoint to) const {
  return distance(ContourPiece{from, to, {}, 0}, contour_) >= aside_ - pocket_rounding;
}

// Where the tool goes straight over, as near to a place as may be.
bool PocketPath::find_link(const Part& from, const Part& to, double near, double& x) const {
  const double low = std::max(from.span.low, to.span.low), high = std::min(from.span.high, to.span.high);
  if (low > high) return false;
  for (const double each : {std::clamp(near, low, high), low, high, (low + high) / 2}) {
    x = each;
    if (is_clear({x, from.y}, {x, to.y})) return true;
  }
  return false;
}

void PocketPath::go(PlanePoint to) {
  if (span_of(tool_, to) < pocket_rounding) return;
  points_.push_back(to);
  tool_ = to;
}

// To the nearer end first.
void PocketPath::cut(Part& part) {
  part.is_cut = true;
  const bool low_first = tool_.first - part.span.low <= part.span.high - tool_.first;
  go({low_first ? part.span.low : part.span.high, part.y});
  go({low_first ? part.span.high : part.span.low, part.y});
}

std::vector<PlanePoint> PocketPath::points() {
  if (!find_parts()) return {};
  const auto is_at_start = [&](const Part& part) {
    return part.y == start_.second && part.span.low - pocket_rounding <= start_.first &&
           start_.first <= part.span.high + pocket_rounding;
  };
  const auto begin = std::ranges::find_if(parts_, is_at_start);
  if (begin == parts_.end()) {
    outcome_ = Outcome::outside;
    return {};
  }
  std::size_t left = parts_.size();
  std::vector<std::size_t> way = {static_cast<std::size_t>(begin - parts_.begin())};
  cut(*begin);
  --left;
  while (left > 0 && !way.empty()) {
    Part& here = parts_[way.back()];
    const auto next = std::ranges::find_if(here.neighbours, [&](std::size_t i) { return !parts_[i].is_cut; });
    const bool goes_on = next != here.neighbours.end();
    if (!goes_on) way.pop_back();
    if (way.empty()) break;
    Part& to = parts_[goes_on ? *next : way.back()];
    double x = 0;
    if (!find_link(here, to, tool_.first, x)) break;
    go({x, here.y});
    go({x, to.y});
    if (!goes_on) continue;
    way.push_back(*next);
    cut(to);
    --left;
  }
  if (left > 0) outcome_ = Outcome::interrupted;
  return left > 0 ? std::vector<PlanePoint>{} : std::move(points_);
}

}  // namespace leadscrew::gcode
