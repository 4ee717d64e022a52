#include <algorithm>
#include <leadscrew/toolpath/allowance.hpp>
#include <leadscrew/toolpath/builder.hpp>
#include <limits>

namespace leadscrew::toolpath {

namespace {

double feed_of(const gcode::Move& move) {
  switch (move.feed.mode) {
    case gcode::Feed::Mode::units_per_second:
      return move.feed.value;
    case gcode::Feed::Mode::per_second:
      return move.feed.value * feed_length(move);
    case gcode::Feed::Mode::rapid:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

void Builder::push(const gcode::Move& move) {
  switch (move.kind) {
    case gcode::Move::Kind::dwell:
      flush();
      settled_.emplace_back(Dwell{move.start, move.dwell_seconds, move.line});
      return;
    case gcode::Move::Kind::event:
      flush();
      settled_.emplace_back(move.event);
      return;
    default:
      move_along(move);
  }
}

void Builder::move_along(const gcode::Move& move) {
  std::vector<Piece> pieces = pieces_of(move);
  const double feed = pieces.empty() ? 0 : feed_of(move);
  for (Piece& piece : pieces) piece.feed = feed;
  const bool blends = move.path_mode == gcode::PathMode::blend && move.tolerance >= least_tolerance;
  if (!blends) flush();
  if (!blends || pieces.empty()) {
    for (Piece& piece : pieces) settled_.emplace_back(std::move(piece));
  } else {
    if (smoother_ &&
        (smoother_->tolerance() != move.tolerance || smoother_->cam_tolerance() != move.naive_cam_tolerance)) {
      flush();
    }
    if (!smoother_) smoother_.emplace(move.tolerance, move.naive_cam_tolerance);
    for (Piece& piece : pieces) smoother_->push(Leg{std::move(piece.curve), feed, move.line, {}, 0, piece.feed_axes});
  }
  if (move.path_mode != gcode::PathMode::exact_stop || pieces.empty()) return;
  std::get<Piece>(settled_.back()).stop = true;
}

/// What follows cannot change what was pushed so far.
void Builder::flush() {
  if (!smoother_) return;
  smoother_->finish();
  while (std::optional<Piece> piece = smoother_->pop()) settled_.emplace_back(std::move(*piece));
  smoother_.reset();
}

std::optional<Element> Builder::pop() {
  if (settled_.empty() && smoother_) {
    if (std::optional<Piece> piece = smoother_->pop()) settled_.emplace_back(std::move(*piece));
  }
  std::optional<Element> element;
  if (settled_.empty()) return element;
  element.emplace(std::move(settled_.front()));
  settled_.pop_front();
  return element;
}

}  // namespace leadscrew::toolpath
