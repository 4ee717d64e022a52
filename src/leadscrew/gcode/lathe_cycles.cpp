#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/lathe_cycles.hpp>

namespace leadscrew::gcode {

namespace {

constexpr std::size_t x_of_lathe = base::index(base::Axis::X), z_of_lathe = base::index(base::Axis::Z);

}  // namespace

bool LatheCycles::refuse(std::string_view code, std::string message, std::string hint) {
  return reporter_.error_where_kept(code, name(block_.code(Group::nonmodal)) + ": " + std::move(message),
                                    std::move(hint));
}

bool LatheCycles::is_along_x() const {
  return block_.is(Code::G72) || block_.is(Code::G72_1) || block_.is(Code::G72_2);
}

Pockets LatheCycles::pockets() const {
  if (block_.is(Code::G71_1) || block_.is(Code::G72_1)) return Pockets::pass;
  return block_.is(Code::G71_2) || block_.is(Code::G72_2) ? Pockets::only : Pockets::cut;
}

// Where any of the cycles may stand.
bool LatheCycles::check_turning(const Block& block) {
  const std::uint32_t column = block.column_of(Group::nonmodal);
  const std::string code = name(block.code(Group::nonmodal));
  if (modal_.plane != Plane::ZX) {
    return error("bad-plane", column, code + " outside the plane of Z and X", "give G18 before");
  }
  if (!frame_.is_offset_only()) {
    return error("unsupported-rotation", column, code + " in turned, scaled or mirrored coordinates",
                 "the lathe cycles take offsets only");
  }
  return modal_.feed_mode != FeedMode::inverse_time || error("bad-feed-mode", column, code + " in G93", "give G94");
}

bool LatheCycles::check_words(const Block& block) {
  const std::string code = name(block.code(Group::nonmodal));
  if (!block.has('Q')) return reporter_.fail();
  if (!check_turning(block)) return false;
  const auto check = [&](char letter, double least, bool itself, const char* hint) {
    const double value = block.value_or(letter, least + 1);
    return value > least || (itself && value == least) ||
           error("bad-value", block.column_of(letter), code + " has " + letter + text(value), hint);
  };
  constexpr int most_passes = 10'000;
  const std::optional<int> passes = as_integer(block.value_or('P', 1));
  if (!passes || *passes < 0 || *passes > most_passes) {
    return error("bad-value", block.column_of('P'), code + " has P" + text(block['P']), "an integer from 0 to 10000");
  }
  return check('I', 0, false, "the depth of a cut must be above 0") &&
         check('R', 0, true, "the distance of the retract must be 0 or more");
}

void LatheCycles::begin(const Block& block) {
  block_ = block;
  line_ = modal_.line;
  const base::AxisVector target = motion_.target_of(block);
  const bool is_sound = check_words(block);
  motion_.feed_of(block, true, block.has('F'), feed_);
  motion_.line_to(block, target, {});
  modal_.motion = Code::G0;
  frame_.position = target;
  if (!is_sound) return;
  reporter_.keep(block.column_of(Group::nonmodal));
  errors_before_ = reporter_.errors();
  const base::AxisVector start = frame_.to_program(target);
  start_ = position_ = {start[z_of_lathe] / frame_.length_unit, start[x_of_lathe] / frame_.length_unit};
  motion_code_ = Code::G0;
  feeds_ = {feed_};
  contour_.clear();
  corners_.clear();
  is_open_ = true;
  modal_.is_plain = false;
}

// X and Z, or by how much they change, U and W.
PlanePoint LatheCycles::target_of(const Block& block) {
  const bool absolute = modal_.distance == Distance::absolute;
  PlanePoint target = position_;
  const auto set = [&](char along, char by, double factor, double& value) {
    const double from = absolute ? 0 : value;
    if (block.has(along) && block.has(by)) {
      error("ambiguous-word", block.column_of(by), std::string("the contour has ") + along + " and " + by,
            "give one of them");
    } else if (block.has(by) && !absolute) {
      error("unused-word", block.column_of(by), std::string("the contour has ") + by + " in G91", "give G90");
    } else if (block.has(along)) {
      value = from + block[along];
    } else if (block.has(by)) {
      value += block[by] * factor;
    }
  };
  set('X', 'U', modal_.diameters ? 0.5 : 1, target.second);
  set('Z', 'W', 1, target.first);
  return target;
}

bool LatheCycles::add_arc(const Block& block, ContourPiece& piece) {
  const int turn = motion_code_ == Code::G3 ? 1 : -1;
  const ArcTolerance tolerance = arc_tolerance(frame_.length_unit != 1);
  const double unit = frame_.length_unit;
  const auto in_mm = [&](PlanePoint point) { return PlanePoint{point.first * unit, point.second * unit}; };
  const bool centred = block.has('I') || block.has('K');
  if (block.has('R') == centred) {
    return error(centred ? "ambiguous-word" : "missing-word", motion_column(block),
                 centred ? "the arc has a radius and a centre" : "the arc has neither a centre nor a radius",
                 "give I and K, or R");
  }
  ArcCircle circle;
  if (block.has('R')) {
    circle = circle_by_radius(in_mm(piece.start), in_mm(piece.end), block['R'] * unit, turn, tolerance);
  } else {
    PlanePoint center{block.value_or('K', 0), block.value_or('I', 0)};
    if (modal_.arc_distance == Distance::incremental) {
      center = {center.first + piece.start.first, center.second + piece.start.second};
    }
    circle = circle_by_center(in_mm(piece.start), in_mm(piece.end), in_mm(center), turn, 1, tolerance);
  }
  if (circle.problem != ArcCircle::Problem::none) {
    return error("arc-radius", motion_column(block), "no arc of this centre or radius leads to its end",
                 "the centre must be as far from the start as from the end");
  }
  piece.center = {circle.center.first / unit, circle.center.second / unit};
  piece.turn = turn;
  return true;
}

void LatheCycles::add_corner(const Block& block) {
  if (block.has('A') && block.has('C')) {
    error("ambiguous-word", block.column_of('C'), "the contour has a fillet and a chamfer at one corner",
          "give A or C");
  }
  const bool is_chamfer = block.has('C');
  const char fillet = is_profile() && !is_arc(motion_code_) ? 'R' : 'A';
  const char letter = is_chamfer ? 'C' : fillet;
  const double size = block.value_or(letter, 0);
  if (size < 0) {
    error("bad-value", block.column_of(letter), "the corner is " + text(size), "A and C must be 0 or more");
  }
  corners_.push_back({std::max(size, 0.0), is_chamfer});
}

void LatheCycles::add(const Block& block) {
  const std::uint32_t of_profile = bit(Group::feed_mode) | bit(Group::cutter_radius);
  tell_idle_in_contour(block, bit(Group::motion) | (is_profile() ? of_profile : 0));
  if (block.has(Group::motion)) motion_code_ = block.code(Group::motion);
  const PlanePoint target = target_of(block);
  const bool moves = target.first != position_.first || target.second != position_.second;
  if (block_.is(Code::G70_profile)) note_compensation(block, moves);
  if (!moves) return;
  if (motion_code_ > Code::G3) {
    error("bad-contour", motion_column(block), "a contour moves by " + name(motion_code_), "G0, G1, G2 and G3");
    return;
  }
  ContourPiece piece{position_, target, {}, 0};
  if (is_profile()) note_feed(block, piece);
  position_ = target;
  if (is_arc(motion_code_) && !add_arc(block, piece)) return;
  if (contour_.size() == most_pieces) {
    if (errors_before_ == reporter_.errors()) {
      refuse("bad-contour", "the contour has more than " + std::to_string(most_pieces) + " pieces", "divide it");
    }
    return;
  }
  contour_.push_back(piece);
  add_corner(block);
}

void LatheCycles::end() {
  is_open_ = modal_.in_profile = false;
  modal_.line = line_;
  if (reporter_.errors() != errors_before_) return;
  // A start and nothing to cut.
  if (contour_.size() < 2) return;
  if (contour_.front().is_arc()) {
    refuse("bad-contour", "the contour begins with an arc", "begin with G0 or G1 to its first point");
    return;
  }
  const std::vector<LatheMove> moves = is_profile() ? plan_profile() : plan();
  next_ = 0;
  if (is_profile()) {
    if (!place_profile(moves)) moves_.clear(), compensated_ = all;
    return;
  }
  // The motion in force behind a cycle is that of its last move (LinuxCNC).
  if (!moves.empty()) {
    const LatheMove& last = moves.back();
    modal_.motion = last.rapid ? Code::G0 : last.turn == 0 ? Code::G1 : last.turn > 0 ? Code::G3 : Code::G2;
  }
  if (moves.empty() || !place(moves)) moves_.clear();
}

// The contour in the attitude in which it is cut, with its corners. The start is not behind its first point.
bool LatheCycles::prepare(Attitude& attitude, bool turned, Contour& contour) const {
  if (turned) attitude.turn();
  attitude.face(attitude.in(contour_.front().end), attitude.in(contour_.back().end));
  contour.clear();
  for (const ContourPiece& piece : contour_) contour.push_back(attitude.in(piece));
  if (!round_corners(contour, corners_)) return false;
  ContourPiece& approach = contour.front();
  approach.start.first = std::max(approach.start.first, approach.end.first);
  return contour.size() > 1 && std::ranges::all_of(contour, goes_one_way);
}

// Moves the contour, but for the way to it, towards where the tool starts.
bool LatheCycles::offset_to_start(Contour& contour, PlanePoint start, double aside) {
  const ContourPiece approach = contour.front();
  const PlanePoint last = contour.back().start, end = contour.back().end;
  const auto along = [&](PlanePoint to) {
    return PlanePoint{to.first - approach.start.first, to.second - approach.start.second};
  };
  const PlanePoint to_first = along(approach.end), to_last = along(last);
  double side = to_last.first * to_first.second - to_last.second * to_first.first;
  // From the last piece itself nothing is seen; the tool stood at one side of the chord of the whole.
  if (std::fabs(side) < contour_tolerance) {
    const PlanePoint tool{start.first - approach.end.first, start.second - approach.end.second};
    const PlanePoint chord{end.first - approach.end.first, end.second - approach.end.second};
    side = tool.first * chord.second - tool.second * chord.first;
  }
  const bool is_right = side >= 0;
  contour.erase(contour.begin());
  if (!offset(contour, is_right ? aside : -aside)) return false;
  contour.insert(contour.begin(), {approach.start, contour.front().start, {}, 0});
  return true;
}

std::vector<LatheMove> LatheCycles::plan_roughing(Attitude& attitude) {
  Contour contour;
  if (!prepare(attitude, is_along_x(), contour)) {
    refuse("bad-contour", std::string("the contour goes back along ") + (is_along_x() ? "X" : "Z"),
           "or a fillet does not fit");
    return {};
  }
  if (!offset_to_start(contour, attitude.in(start_), block_.value_or('D', 0))) {
    refuse("bad-contour", "the contour is too narrow for the distance D", "a smaller D");
    return {};
  }
  Roughing roughing(contour, block_.value_or('I', 1), block_.value_or('R', 0.5), pockets());
  std::vector<LatheMove> moves = roughing.moves();
  if (roughing.outcome() == Roughing::Outcome::too_many) {
    refuse("too-many-passes", "the cycle takes more than 200000 moves", "a greater I");
  } else if (roughing.outcome() == Roughing::Outcome::open) {
    refuse("bad-contour", "the contour does not reach up to where a cut begins",
           "start the cycle farther off the contour");
  }
  return moves;
}

// Whether Z changes one way only, as seen from the end of the first piece to that of the last (LinuxCNC).
bool LatheCycles::goes_along_z() const {
  Attitude attitude;
  attitude.face(contour_[1].end, contour_.back().end);
  return std::all_of(contour_.begin() + 1, contour_.end(),
                     [&](const ContourPiece& piece) { return goes_one_way(attitude.in(piece)); });
}

// Pass by pass, from D to E off the contour; each begins at the start.
std::vector<LatheMove> LatheCycles::plan_finishing(Attitude& attitude) {
  Contour contour;
  if (!prepare(attitude, !goes_along_z(), contour)) {
    refuse("bad-contour", "the contour goes back along Z and along X", "or a fillet does not fit");
    return {};
  }
  const int passes = as_integer(block_.value_or('P', 1)).value_or(1);
  const double first = block_.value_or('D', 0), last = block_.value_or('E', 0);
  std::vector<LatheMove> moves;
  for (int pass = passes; pass > 0; --pass) {
    Contour of_pass = contour;
    if (!offset_to_start(of_pass, attitude.in(start_), (pass - 1) * (first - last) / passes + last)) {
      refuse("bad-contour", "the contour is too narrow for the distances D and E", "smaller ones");
      return {};
    }
    moves.push_back({true, 0, of_pass.front().start, {}});
    moves.push_back({true, 0, of_pass.front().end, {}});
    for (std::size_t i = 1; i < of_pass.size(); ++i) {
      moves.push_back({false, of_pass[i].turn, of_pass[i].end, of_pass[i].center});
    }
    if (moves.size() > most_lathe_moves) {
      refuse("too-many-passes", "the cycle takes more than 200000 moves", "a smaller P");
      return {};
    }
  }
  return moves;
}

std::vector<LatheMove> LatheCycles::plan() {
  Attitude attitude;
  std::vector<LatheMove> moves = is_finishing() ? plan_finishing(attitude) : plan_roughing(attitude);
  for (LatheMove& move : moves) {
    move.end = attitude.out(move.end);
    move.center = attitude.out(move.center);
    move.turn = attitude.turn_out(move.turn);
  }
  return moves;
}

// In machine coordinates, and inside travel.
bool LatheCycles::place(const std::vector<LatheMove>& moves) {
  const double unit = frame_.length_unit;
  const base::AxisVector& zero = frame_.offset();
  const auto placed = [&](PlanePoint point) {
    return PlanePoint{point.first * unit + zero[z_of_lathe], point.second * unit + zero[x_of_lathe]};
  };
  moves_.clear();
  PlanePoint start = in_plane(frame_.position, Plane::ZX);
  for (const LatheMove& move : moves) {
    Planned planned{move.rapid, move.turn, placed(move.end), placed(move.center), move.block};
    if (span_of(start, planned.end) < contour_tolerance * unit) continue;
    if (planned.turn != 0) {
      const ArcCircle circle =
          circle_by_center(start, planned.end, planned.center, planned.turn, 1, arc_tolerance(frame_.length_unit != 1));
      if (circle.problem != ArcCircle::Problem::none) {
        return refuse("bad-contour", "an arc of the contour has been offset out of shape", "a smaller D");
      }
      planned.center = circle.center;
      planned.end = circle.end;
    }
    if (!is_inside(planned, start)) return false;
    start = planned.end;
    moves_.push_back(planned);
  }
  return true;
}

bool LatheCycles::is_inside(const Planned& move, PlanePoint start) {
  PlaneBox box{move.end, move.end};
  if (move.turn != 0) box = arc_extent(start, move.end, move.center, move.turn);
  const auto check = [&](base::Axis axis, double low, double high) {
    const std::size_t i = base::index(axis);
    const bool is_below = low < travel_.low()[i];
    if (!is_below && high <= travel_.high()[i]) return true;
    return refuse("travel",
                  std::string("axis ") + base::letter(axis) + " would be at " + text(is_below ? low : high) +
                      " mm, outside its travel",
                  "from " + text(travel_.low()[i]) + " to " + text(travel_.high()[i]) + " mm in machine coordinates");
  };
  return check(base::Axis::Z, box.low.first, box.high.first) && check(base::Axis::X, box.low.second, box.high.second);
}

bool LatheCycles::take(Move& move, const Outbox& outbox) {
  const Planned& planned = moves_[next_++];
  outbox.prepare(move, planned.turn != 0 ? Move::Kind::arc : Move::Kind::line, modal_.line);
  move.plane = Plane::ZX;
  move.end[z_of_lathe] = planned.end.first;
  move.end[x_of_lathe] = planned.end.second;
  move.center_first = planned.center.first;
  move.center_second = planned.center.second;
  move.turns = planned.turn;
  if (!planned.rapid) move.feed = feeds_[planned.block];
  const bool follows_spindle = is_profile() && modal_.feed_mode == FeedMode::per_revolution;
  if (follows_spindle && move.feed.mode != Feed::Mode::rapid) move.feed.value *= modal_.spindle_speed / feed_speed_;
  frame_.position = move.end;
  return true;
}

void LatheCycles::abandon() {
  if (next_ < moves_.size()) {
    frame_.position[z_of_lathe] = moves_.back().end.first;
    frame_.position[x_of_lathe] = moves_.back().end.second;
  }
  moves_.clear();
  next_ = 0;
  compensated_ = all;
  is_open_ = modal_.in_profile = false;
}

}  // namespace leadscrew::gcode
