// G70 to G73 of Fanuc's lathes (Fanuc 0i operator's manual, "Multiple Repetitive Cycle"). The contour leads from where the
// tool stands, A, by the block P to A' and on to the end of block Q, B.
//
//      ●────────────▶ C = A + (U/2, W), which is where the levels of G71 and G72 count from; the contour is moved by the
//      A              same. Cuts are roughing.hpp's; at last the tool goes along the contour, and back to A.
//
// G73 goes along the contour R times, first U and W of its first block farther off, at last at U/2 and W of the second.
// G70 goes along the contour itself, at its own feeds; compensated for the tool's nose where G41 or G42 is on before it, or
// stands in the contour's first block, up to G40 of its last block, or to the way back. Roughing is not compensated.

#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/lathe_cycles.hpp>
#include <leadscrew/numeric/functions.hpp>

namespace leadscrew::gcode {

namespace {

constexpr int most_profile_passes = 10'000;

PlanePoint moved(PlanePoint point, PlanePoint by) {
  return {point.first + by.first, point.second + by.second};
}

}  // namespace

void LatheCycles::keep_settings(const Block& block) {
  const Code code = block.code(Group::nonmodal);
  const auto refuse_word = [&](char letter, const char* hint) {
    error("bad-value", block.column_of(letter), name(code) + " has " + letter + text(block[letter]), hint);
  };
  const auto set = [&](char letter, double& length) {
    if (block.has(letter)) length = block[letter] * frame_.length_unit;
  };
  if (code == Code::G73_profile) {
    const std::optional<int> passes = as_integer(block.value_or('R', settings_.passes));
    if (!passes || *passes < 1 || *passes > most_profile_passes) return refuse_word('R', "an integer from 1 to 10000");
    settings_.passes = *passes;
    set('W', settings_.farthest.first);
    set('U', settings_.farthest.second);
    return;
  }
  const char depth = code == Code::G71_profile ? 'U' : 'W', other = code == Code::G71_profile ? 'W' : 'U';
  if (block.has(other)) {
    error("unused-word", block.column_of(other), std::string("nothing in this block takes ") + other,
          code == Code::G71_profile ? "U is the depth of a cut" : "W is the depth of a cut");
    return;
  }
  if (block.has(depth) && !(block[depth] > 0)) return refuse_word(depth, "the depth of a cut must be above 0");
  if (block.value_or('R', 0) < 0) return refuse_word('R', "the distance of the retract must be 0 or more");
  set(depth, settings_.depth);
  set('R', settings_.retract);
}

void LatheCycles::begin_profile(const Block& block) {
  const Code code = block.code(Group::nonmodal);
  for (const base::Axis axis : base::all_axes) {
    const char letter = base::letter(axis);
    if (!block.has(letter) || row(code).words.has(letter)) continue;
    error("unused-word", block.column_of(letter), name(code) + " does not move axis " + letter,
          "move it in a block before");
    return;
  }
  if (!block.has('P') && !block.has('Q') && code != Code::G70_profile) return keep_settings(block);
  const std::uint32_t column = block.column_of(Group::nonmodal);
  if (!block.has('P') || !block.has('Q')) {
    if (code != Code::G70_profile)
      error("missing-word", column, name(code) + " lacks " + (block.has('P') ? 'Q' : 'P'), name(code) + " P100 Q200");
    return;
  }
  if (code != Code::G70_profile && block.has('R')) {
    error("unused-word", block.column_of('R'), "nothing in this block takes R",
          "R stands in the block before, without P and Q");
    return;
  }
  if (!check_turning(block)) return;
  feed_ = {};
  if (code != Code::G70_profile && !motion_.feed_of(block, true, block.has('F'), feed_)) return;
  block_ = block;
  line_ = modal_.line;
  feed_speed_ = modal_.spindle_speed;
  feeds_ = {feed_};
  reporter_.keep(column);
  errors_before_ = reporter_.errors();
  const base::AxisVector start = frame_.to_program(frame_.position);
  const std::size_t x = base::index(base::Axis::X), z = base::index(base::Axis::Z);
  start_ = position_ = {start[z] / frame_.length_unit, start[x] / frame_.length_unit};
  motion_code_ = modal_.motion <= Code::G3 ? modal_.motion : Code::G0;
  contour_.clear();
  corners_.clear();
  moves_.clear();
  places_ = {reporter_.place(column)};
  compensation_.reset();
  compensation_end_.reset();
  compensated_ = all;
  is_open_ = modal_.in_profile = true;
}

// F of the contour is that of G70 alone; what the contour does at rapid is rapid.
void LatheCycles::note_feed(const Block& block, ContourPiece& piece) {
  Feed feed = feed_;
  if (motion_code_ == Code::G0) {
    feed = {};
  } else if (block_.is(Code::G70_profile)) {
    motion_.set_feed(block);
    motion_.feed_of(block, true, block.has('F'), feed);
  }
  if (block_.is(Code::G70_profile)) places_.push_back(reporter_.place(motion_column(block)));
  feeds_.push_back(feed);
  piece.block = static_cast<std::uint32_t>(feeds_.size()) - 1;
}

// A block of G70's contour. Blocks without motion may stand before the first that moves, and behind the last.
void LatheCycles::note_compensation(const Block& block, bool moves) {
  const Code code = block.code(Group::cutter_radius);
  if (compensation_end_ && moves) {
    const AtKeptPlace there(reporter_, compensation_end_->place);
    error("bad-contour", compensation_end_->place.column, "G40 before the last block of the contour of G70",
          "G40 in the last block of the contour, or behind G70");
    compensation_end_.reset();
  }
  if (code == Code::none) return;
  if (code != Code::G40) return begin_compensation(block);
  if (!compensation_ && modal_.cutter_side == Code::G40) return;
  compensation_end_ = {reporter_.place(block.column_of(Group::cutter_radius)),
                       static_cast<std::uint32_t>(feeds_.size())};
}

void LatheCycles::begin_compensation(const Block& block) {
  const std::uint32_t column = block.column_of(Group::cutter_radius);
  const std::string code = name(block.code(Group::cutter_radius));
  if (modal_.cutter_side != Code::G40) {
    error("cutter-compensation", column, code + " while cutter compensation is on",
          "G40 before G70, or no " + code + " in the contour");
  } else if (compensation_ || !contour_.empty()) {
    error("bad-contour", column, code + " behind the first block of the contour of G70",
          code + " in the first block of the contour, or before G70");
  } else {
    compensation_ = {block, reporter_.place(column)};
  }
}

// Where compensation of the contour ends, the moves from there on lead where the program says.
bool LatheCycles::place_profile(const std::vector<LatheMove>& moves) {
  if (!place(moves)) return false;
  if (moves_.empty() || (!compensation_ && !compensation_end_)) return true;
  // Of the moves the way back alone is of no block of the contour.
  const std::uint32_t end = compensation_end_ ? compensation_end_->block : static_cast<std::uint32_t>(feeds_.size());
  const auto is_behind = [&](const Planned& move) { return move.block == 0 || move.block >= end; };
  compensated_ = static_cast<std::size_t>(std::ranges::find_if(moves_, is_behind) - moves_.begin());
  return are_inside_uncompensated();
}

// Travel has been that of the tool's middle when they were placed.
bool LatheCycles::are_inside_uncompensated() {
  const AtKeptPlace there(reporter_, places_.front());
  for (std::size_t i = compensated_; i < moves_.size(); ++i) {
    const Planned& move = moves_[i];
    PlaneBox box{move.end, move.end};
    if (move.turn != 0 && i > 0) box = arc_extent(moves_[i - 1].end, move.end, move.center, move.turn);
    const auto is_inside = [&](base::Axis axis, double low, double high) {
      return travel_.released_inside(axis, low, high, places_.front().column);
    };
    if (!is_inside(base::Axis::Z, box.low.first, box.high.first)) return false;
    if (!is_inside(base::Axis::X, box.low.second, box.high.second)) return false;
  }
  return true;
}

// The direction in which a move from `start` ends; of any length.
PlanePoint LatheCycles::direction_of(const Planned& move, PlanePoint start) {
  if (move.turn == 0) return {move.end.first - start.first, move.end.second - start.second};
  return {move.turn * (move.center.second - move.end.second), move.turn * (move.end.first - move.center.first)};
}

// At an inner corner that turns by the angle a the nose touches both pieces radius · tan(a / 2) ahead of the corner. Up to a
// right angle that is the corner of any face that the tool leaves at a right angle.
void LatheCycles::check_way_back(double aside) {
  const bool goes_back = block_.is(Code::G70_profile) && moves_.size() > 2 && moves_.back().block == 0;
  if (!goes_back || will_end_compensation()) return;
  const Planned& before = moves_[moves_.size() - 3];
  const Planned& last = moves_[moves_.size() - 2];
  const PlanePoint along = direction_of(last, before.end), back = direction_of(moves_.back(), last.end);
  const double ahead = along.first * back.first + along.second * back.second;
  const double to_left = along.first * back.second - along.second * back.first;
  const double lengths = numeric::hypot(along.first, along.second) * numeric::hypot(back.first, back.second);
  constexpr double rounding = 1e-9;  // of the cosine of a right angle
  if (last.rapid || !(to_left * aside > 0) || ahead > -rounding * lengths) return;
  const double missing = std::fabs(aside) * (lengths - ahead) / std::fabs(to_left);
  const double shown = std::round(missing * 1e3) / 1e3;
  const bool is_face = std::fabs(along.second) > std::fabs(along.first);
  const std::string beyond = along.second > 0 ? "above" : "below";
  const KeptPlace& place = places_[last.block];
  const AtKeptPlace there(reporter_, place);
  reporter_.warning("cutter-return", place.column,
                    "the nose leaves the contour " + text(shown) +
                        " mm before its end: there the way back of G70 turns back on the side of the tool",
                    is_face ? "start the cycle at or " + beyond + " the last X of the contour, or G40 in its last block"
                            : "G40 in the last block of the contour, or a last block that leads off the work");
}

const KeptPlace* LatheCycles::place_of(const Move& move) const {
  const bool is_of_it = next_ > 0 && next_ <= moves_.size() && block_.is(Code::G70_profile) && move.line == line_;
  return is_of_it ? &places_[moves_[next_ - 1].block] : nullptr;
}

std::vector<LatheMove> LatheCycles::plan_profile() {
  std::vector<LatheMove> moves;
  const bool cuts = block_.is(Code::G71_profile) || block_.is(Code::G72_profile);
  if (!(cuts ? plan_profile_roughing(moves) : plan_profile_passes(moves))) return {};
  moves.push_back({true, 0, start_, {}});
  return moves;
}

bool LatheCycles::plan_profile_roughing(std::vector<LatheMove>& moves) {
  const PlanePoint allowance{block_.value_or('W', 0), block_.value_or('U', 0) / 2};
  for (ContourPiece& piece : contour_) {
    piece.start = moved(piece.start, allowance);
    piece.end = moved(piece.end, allowance);
    piece.center = moved(piece.center, allowance);
    piece.block = 0;
  }
  Attitude attitude;
  Contour contour;
  const bool is_along_x = block_.is(Code::G72_profile);
  if (!prepare(attitude, is_along_x, contour)) {
    return refuse("bad-contour", std::string("the contour goes back along ") + (is_along_x ? "X" : "Z"),
                  "or a corner does not fit");
  }
  const double unit = frame_.length_unit;
  Roughing roughing(contour, settings_.depth / unit, settings_.retract / unit, Pockets::cut, CutOrder::fanuc);
  moves = roughing.moves();
  if (roughing.outcome() == Roughing::Outcome::too_many) {
    return refuse("too-many-passes", "the cycle takes more than 200000 moves", "deeper cuts");
  }
  if (roughing.outcome() == Roughing::Outcome::open) {
    return refuse("bad-contour", "the contour does not reach up to where a cut begins",
                  "start the cycle farther off the contour");
  }
  for (LatheMove& move : moves) {
    move.end = attitude.out(move.end);
    move.center = attitude.out(move.center);
    move.turn = attitude.turn_out(move.turn);
  }
  return true;
}

bool LatheCycles::plan_profile_passes(std::vector<LatheMove>& moves) {
  Contour contour = contour_;
  if (!round_corners(contour, corners_))
    return refuse("bad-contour", "a corner of the contour does not fit", "a smaller one");
  const bool repeats = block_.is(Code::G73_profile);
  const int passes = repeats ? settings_.passes : 1;
  if (static_cast<std::size_t>(passes) * (contour.size() + 1) > most_lathe_moves) {
    return refuse("too-many-passes", "the cycle takes more than 200000 moves", "fewer passes");
  }
  for (int pass = 0; pass < passes; ++pass) {
    PlanePoint off;
    if (repeats) {
      const double part = passes > 1 ? 1 - static_cast<double>(pass) / (passes - 1) : 0;
      off = {block_.value_or('W', 0) + part * settings_.farthest.first / frame_.length_unit,
             block_.value_or('U', 0) / 2 + part * settings_.farthest.second / frame_.length_unit};
      moves.push_back({true, 0, moved(start_, off), {}});
    }
    for (const ContourPiece& piece : contour) {
      const bool rapid = feeds_[piece.block].mode == Feed::Mode::rapid;
      moves.push_back({rapid, piece.turn, moved(piece.end, off), moved(piece.center, off), piece.block});
    }
  }
  return true;
}

}  // namespace leadscrew::gcode
