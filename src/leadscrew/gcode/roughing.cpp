#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/roughing.hpp>

namespace leadscrew::gcode {

namespace {

constexpr double least_arc = 1e-3;  // a shorter one is not worth a move (LinuxCNC)

// Arcs are cut in two where they are highest or lowest, so that each piece falls or rises.
Contour cut_at_turning_points(const Contour& contour) {
  Contour made;
  for (const ContourPiece& piece : contour) {
    const bool turns = piece.is_arc() && piece.start.first > piece.center.first + contour_tolerance &&
                       piece.end.first < piece.center.first - contour_tolerance;
    if (!turns) {
      made.push_back(piece);
      continue;
    }
    const double radius = span_of(piece.start, piece.center);
    const PlanePoint turning{piece.center.first, piece.center.second + piece.turn * radius};
    made.push_back({piece.start, turning, piece.center, piece.turn});
    made.push_back({turning, piece.end, piece.center, piece.turn});
  }
  return made;
}

}  // namespace

// The contour ends where the tool starts: up to there the material reaches.
Roughing::Roughing(const Contour& contour, double depth, double retract, Pockets pockets, CutOrder order)
    : contour_(cut_at_turning_points(contour)),
      depth_(std::max(depth, 2 * contour_tolerance)),
      retract_(retract),
      pockets_(pockets),
      order_(order),
      tool_(contour.front().start),
      level_(tool_.second),
      start_level_(tool_.second) {
  const PlanePoint last = contour_.back().end;
  if (order == CutOrder::fanuc) level_ -= depth_;
  if (last.second < tool_.second) contour_.push_back({last, {last.first, tool_.second}, {}, 0});
}

void Roughing::line(PlanePoint end, bool rapid) {
  if (span_of(tool_, end) > contour_tolerance) moves_.push_back({rapid, 0, end, {}});
  tool_ = end;
}

// Two arcs of one circle are one.
void Roughing::along(std::size_t i, PlanePoint end, bool rapid) {
  const ContourPiece& piece = contour_[i];
  if (!piece.is_arc()) return line(end, rapid);
  const bool goes_on = piece.turn < 0 && !moves_.empty() && moves_.back().turn == piece.turn &&
                       span_of(moves_.back().center, piece.center) < contour_tolerance;
  if (goes_on) {
    moves_.back().end = end;
  } else {
    moves_.push_back({false, piece.turn, end, piece.center});
  }
  tool_ = end;
}

bool Roughing::falls(std::size_t i) const {
  return contour_[i].start.second > contour_[i].end.second + contour_tolerance;
}

// Where a piece that only rises or only falls is at a level.
bool Roughing::crossing(const ContourPiece& piece, double level, double& z) {
  const auto [low, high] = std::minmax(piece.start.second, piece.end.second);
  if (low > level + contour_tolerance || high < level - contour_tolerance) return false;
  if (piece.is_arc()) {
    const double radius = span_of(piece.start, piece.center), up = level - piece.center.second;
    const double side = piece.start.first + piece.end.first >= 2 * piece.center.first ? 1 : -1;
    z = piece.center.first + side * std::sqrt(std::max(0.0, radius * radius - up * up));
  } else if (high - low < contour_tolerance) {
    z = piece.start.first;
  } else {
    const double share = (level - piece.start.second) / (piece.end.second - piece.start.second);
    z = piece.start.first + share * (piece.end.first - piece.start.first);
  }
  return true;
}

// Down the falling piece to the level, or to its end above it.
void Roughing::descend() {
  const ContourPiece& piece = contour_[at_];
  double z = 0;
  const bool ends_above = level_ < piece.end.second || !crossing(piece, level_, z);
  const PlanePoint target = ends_above ? piece.end : PlanePoint{z, level_};
  if (piece.is_arc() && span_of(tool_, target) <= contour_tolerance) {
    tool_ = target;
    return;
  }
  along(at_, target, at_ == 0);
}

void Roughing::skip_first_fall() {
  for (; at_ < contour_.size() && falls(at_); ++at_) along(at_, contour_[at_].end, at_ == 0);
}

// Levels count from the start; where nothing but pockets is cut, from the top of a pocket.
void Roughing::enter_pocket() {
  if (pockets_ == Pockets::only) {
    if (!in_pocket_ || tool_.second > pocket_level_) pocket_level_ = tool_.second;
    in_pocket_ = true;
  }
  level_ = in_pocket_ ? pocket_level_ : start_level_;
}

// Along the contour until it falls.
void Roughing::follow_to_pocket() {
  for (; at_ < contour_.size(); ++at_) {
    if (falls(at_)) return enter_pocket();
    const PlanePoint end = contour_[at_].end;
    if (contour_[at_].is_arc() && span_of(tool_, end) <= least_arc) {
      tool_ = end;
    } else {
      along(at_, end);
    }
  }
}

// Level across each pocket, and up where the contour rises behind it.
void Roughing::pass_over_pockets() {
  for (; at_ < contour_.size(); ++at_) {
    double z = 0;
    if (falls(at_) || !crossing(contour_[at_], tool_.second, z)) continue;
    line({z, tool_.second});
    if (!contour_[at_].is_arc() || span_of(tool_, contour_[at_].end) > least_arc) along(at_, contour_[at_].end);
    tool_ = contour_[at_].end;
  }
}

// There and, off the cut by R along both axes, back again.
void Roughing::cut_to(PlanePoint end) {
  const PlanePoint start = tool_;
  const double off = std::min(retract_, span_of(start, end) / 2);
  line(end);
  line({end.first + off, end.second + off}, true);
  if (order_ == CutOrder::fanuc && at_ == 0) {
    // The way in is nothing but rapid: the next level is gone to from here.
    line({start.first, start.second + off}, true);
    tool_ = start;
    return;
  }
  line({start.first - off, start.second + off}, true);
  line(start, at_ == 0);
}

// One cut along the level; false where nothing ends it.
bool Roughing::cut() {
  for (std::size_t i = at_ + 1; i < contour_.size(); ++i) {
    PlanePoint end{0, tool_.second};
    if (!crossing(contour_[i], tool_.second, end.first) || end.first - contour_tolerance > tool_.first) continue;
    if (span_of(end, tool_) >= contour_tolerance) {
      cut_to(end);
    } else if (span_of(tool_, contour_[i].start) < contour_tolerance) {
      at_ = i;  // the next piece begins here
      return true;
    }
    level_ -= depth_;
    return true;
  }
  return false;
}

std::vector<LatheMove> Roughing::moves() {
  moves_.push_back({true, 0, tool_, {}});
  if (pockets_ == Pockets::only) skip_first_fall();
  while (at_ < contour_.size()) {
    if (moves_.size() > most_lathe_moves) {
      outcome_ = Outcome::too_many;
      return {};
    }
    if (!falls(at_)) {
      pockets_ == Pockets::pass ? pass_over_pockets() : follow_to_pocket();
      continue;
    }
    if (level_ - contour_tolerance > tool_.second) {
      level_ -= depth_ * std::ceil((level_ - contour_tolerance - tool_.second) / depth_);
    }
    descend();
    if (std::fabs(tool_.second - level_) > contour_tolerance) {
      ++at_;
    } else if (!cut()) {
      outcome_ = Outcome::open;
      return {};
    }
  }
  return std::move(moves_);
}

}  // namespace leadscrew::gcode
