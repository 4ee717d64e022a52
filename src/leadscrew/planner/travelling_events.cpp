#include <cmath>
#include <leadscrew/planner/travelling_events.hpp>
#include <limits>
#include <utility>

namespace leadscrew::planner {

namespace {

constexpr double nearly_all = 1e-9;  // in the units of path length: so far from a piece's end is its end

/// Where a part of a chunk ends.
struct PartEnd {
  std::uint32_t piece = 0;
  double s = 0;

  bool is_behind(std::uint32_t other, double place) const { return other < piece || (other == piece && place < s); }
};

PartEnd end_of(const Chunk& chunk, const Segment& last, numeric::DoubleDouble time) {
  const double s = evaluate(last, (time - last.begin).value()).s, length = chunk.pieces[last.piece].axes().length();
  return {last.piece, s > length - nearly_all ? std::numeric_limits<double>::infinity() : s};
}

PlacedEvent placed(const base::Event& event, std::uint32_t piece, double s, double path_length) {
  PlacedEvent placed;
  static_cast<base::Event&>(placed) = event;
  placed.piece = piece;
  placed.s = s;
  placed.path_length = path_length;
  return placed;
}

}  // namespace

void TravellingEvents::enter(toolpath::Piece& piece) {
  if (piece.events) {
    auto events = std::make_shared<std::vector<toolpath::EventMark>>(*piece.events);
    for (toolpath::EventMark& mark : *events) {
      mark.number = numbered_++;
      mark.path_length = entered_ + mark.s;
    }
    piece.events = std::move(events);
  }
  entered_ += piece.axes().length();
}

void TravellingEvents::begin_at(double path_length, std::int64_t number) {
  next_ = rest_ = rest_before_ = {path_length, number, next_.overrides, next_.speed_of_feed};
}

void TravellingEvents::place(Chunk& chunk, const std::vector<base::Event>& before) {
  for (const base::Event& event : before)
    chunk.events.push_back(placed(event, 0, -std::numeric_limits<double>::infinity(), next_.path_length));
  rest_before_ = rest_;
  next_.path_length += chunk.length;
  // At the end of all that has been entered: the same bits, wherever chunks are cut.
  if (std::abs(next_.path_length - entered_) <= nearly_all) next_.path_length = entered_;
  rest_ = {next_.path_length + chunk.tail_length, next_.number, next_.overrides, next_.speed_of_feed};
  if (chunk.pieces.empty()) return;
  const PartEnd end = end_of(chunk, chunk.segments.back(), chunk.end());
  PartEnd rest = end;
  if (!chunk.stop_tail.empty()) {
    const Segment& last = chunk.stop_tail.back();
    rest = end_of(chunk, last, last.begin + last.duration);
  }
  for (std::uint32_t piece = 0; piece <= rest.piece; ++piece) {
    if (!chunk.pieces[piece].events) continue;
    for (const toolpath::EventMark& mark : *chunk.pieces[piece].events) {
      if (mark.number < next_.number || !rest.is_behind(piece, mark.s)) continue;
      const bool is_committed = end.is_behind(piece, mark.s);
      (is_committed ? chunk.events : chunk.tail_events).push_back(placed(mark.event, piece, mark.s, mark.path_length));
      rest_.number = mark.number + 1;
      rest_.pass(mark.event);
      if (!is_committed) continue;
      next_.number = mark.number + 1;
      next_.pass(mark.event);
    }
  }
}

void TravellingEvents::refuse() {
  next_ = rest_ = rest_before_;
}

void TravellingEvents::forget_rest() {
  next_ = rest_before_ = rest_;
  entered_ = rest_.path_length;
  numbered_ = rest_.number;
}

}  // namespace leadscrew::planner
