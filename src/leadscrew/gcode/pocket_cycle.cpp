#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/pocket_cycle.hpp>
#include <limits>

namespace leadscrew::gcode {

namespace {

constexpr double closing_gap = 0.01;  // mm; by which a contour may fail to close
constexpr double least_aside = 1e-3;  // mm; what the tool's middle keeps off the contour where its radius is 0
constexpr double most_levels_deep = 10'000;

}  // namespace

bool PocketCycle::refuse(std::string message, std::string hint) {
  return reporter_.error_where_kept("bad-contour", "G150: " + std::move(message), std::move(hint));
}

bool PocketCycle::check_place(const Block& block) {
  const std::uint32_t column = block.column_of(Group::nonmodal);
  if (modal_.plane != Plane::XY)
    return error("bad-plane", column, "G150 outside the plane of X and Y", "give G17 before");
  if (modal_.feed_mode == FeedMode::inverse_time) return error("bad-feed-mode", column, "G150 in G93", "give G94");
  if (!frame_.is_separate(base::Axis::Z)) {
    return error("unsupported-rotation", column, "a pocket that is turned off the axis Z",
                 "turns take it in the plane XY only");
  }
  for (const base::Axis axis : base::all_axes) {
    const bool linear = axis == base::Axis::X || axis == base::Axis::Y || axis == base::Axis::Z;
    if (linear || !block.has(base::letter(axis))) continue;
    return error("unused-word", block.column_of(base::letter(axis)),
                 std::string("G150 does not move axis ") + base::letter(axis), "move it in a block before");
  }
  for (const char letter : {'P', 'R', 'Z'}) {
    if (letter == 'P' && !block.has('P')) return reporter_.fail();
    if (block.has(letter)) continue;
    return error("missing-word", column, std::string("G150 lacks ") + letter,
                 "G150 P1000 X0. Y0. Z-5. R1. Q2. J3. K0.2 D1 F200.");
  }
  if (block.has('I') == block.has('J')) {
    return error(block.has('I') ? "ambiguous-word" : "missing-word", column,
                 block.has('I') ? "G150 has steps along X and along Y" : "G150 has no step", "give I or J");
  }
  return true;
}

bool PocketCycle::plan(const Block& block) {
  const double unit = frame_.length_unit;
  const auto is_above = [&](char letter, bool itself) {
    if (!block.has(letter) || block[letter] > 0 || (itself && block[letter] == 0)) return true;
    return error("bad-value", block.column_of(letter), std::string("G150 has ") + letter + text(block[letter]),
                 std::string(1, letter) + (itself ? " must be 0 or more" : " must be above 0"));
  };
  if (!is_above('I', false) || !is_above('J', false) || !is_above('K', true) || !is_above('Q', false)) return false;
  const std::optional<double> cutter = cutter_.of(block);
  if (!cutter) return false;
  plan_.cutter = *cutter;
  plan_.steps_along_x = block.has('I');
  plan_.step = block[plan_.steps_along_x ? 'I' : 'J'] * unit;
  plan_.allowance = block.value_or('K', 0) * unit;
  return plan_levels(block);
}

bool PocketCycle::plan_levels(const Block& block) {
  const double unit = frame_.length_unit;
  const base::AxisVector target = frame_.to_program(motion_.target_of(block));
  const base::AxisVector stands = frame_.to_program(frame_.position);
  plan_.hole = {target[0], target[1]};
  const bool absolute = modal_.distance == Distance::absolute;
  plan_.top = block['R'] * unit + (absolute ? 0 : stands[2]);
  plan_.bottom = absolute ? target[2] : plan_.top + block['Z'] * unit;
  plan_.depth = block.value_or('Q', 0) * unit;
  if (plan_.bottom > plan_.top) {
    return error("cycle-levels", block.column_of('Z'),
                 "the bottom at " + text(plan_.bottom) + " mm is above R at " + text(plan_.top) + " mm",
                 "the bottom of the pocket must not be above R");
  }
  if (plan_.depth == 0 || (plan_.top - plan_.bottom) / plan_.depth <= most_levels_deep) return true;
  return error("too-many-passes", block.column_of('Q'), "the pocket takes more than 10000 levels", "a greater Q");
}

void PocketCycle::begin(const Block& block) {
  if (!check_place(block) || !plan(block) || !motion_.feed_of(block, true, block.has('F'), feed_)) return;
  block_ = block;
  line_ = modal_.line;
  reporter_.keep(block.column_of(Group::nonmodal));
  errors_before_ = reporter_.errors();
  motion_code_ = Code::G1;
  distance_ = modal_.distance;
  position_ = plan_.hole;
  contour_.clear();
  is_open_ = true;
  modal_.is_plain = false;
}

bool PocketCycle::add_arc(const Block& block, ContourPiece& piece) {
  const int turn = motion_code_ == Code::G3 ? 1 : -1;
  const double unit = frame_.length_unit;
  const ArcTolerance tolerance = arc_tolerance(unit != 1);
  const bool centred = block.has('I') || block.has('J');
  if (block.has('R') == centred) {
    return error(centred ? "ambiguous-word" : "missing-word", motion_column(block),
                 centred ? "the arc has a radius and a centre" : "the arc has neither a centre nor a radius",
                 "give I and J, or R");
  }
  const PlanePoint center{piece.start.first + block.value_or('I', 0) * unit,
                          piece.start.second + block.value_or('J', 0) * unit};
  const ArcCircle circle = block.has('R') ? circle_by_radius(piece.start, piece.end, block['R'] * unit, turn, tolerance)
                                          : circle_by_center(piece.start, piece.end, center, turn, 1, tolerance);
  if (circle.problem != ArcCircle::Problem::none) {
    return error("arc-radius", motion_column(block), "no arc of this centre or radius leads to its end",
                 "the centre must be as far from the start as from the end");
  }
  piece.center = circle.center;
  piece.turn = turn;
  return true;
}

void PocketCycle::add(const Block& block) {
  tell_idle_in_contour(block, bit(Group::motion) | bit(Group::distance));
  if (block.has(Group::motion)) motion_code_ = block.code(Group::motion);
  if (block.has(Group::distance))
    distance_ = block.code(Group::distance) == Code::G90 ? Distance::absolute : Distance::incremental;
  const double unit = frame_.length_unit;
  PlanePoint target = position_;
  const bool absolute = distance_ == Distance::absolute;
  if (block.has('X')) target.first = block['X'] * unit + (absolute ? 0 : target.first);
  if (block.has('Y')) target.second = block['Y'] * unit + (absolute ? 0 : target.second);
  const bool is_round = is_arc(motion_code_) && (block.has('I') || block.has('J'));
  if (span_of(target, position_) < contour_tolerance && !is_round) return;
  if (motion_code_ > Code::G3 || motion_code_ == Code::G0 || block.has('Z')) {
    error("bad-contour", motion_column(block),
          block.has('Z') ? "the contour moves Z" : "a contour moves by " + name(motion_code_),
          "G1, G2 and G3 in X and Y");
    return;
  }
  if (contour_.size() == most_pieces) {
    if (errors_before_ == reporter_.errors()) refuse("the contour has more than 1000 pieces", "divide it");
    return;
  }
  ContourPiece piece{position_, target, {}, 0};
  position_ = target;
  if (is_arc(motion_code_) && !add_arc(block, piece)) return;
  contour_.push_back(piece);
}

// The first piece leads to the contour.
bool PocketCycle::close_contour() {
  if (contour_.size() < 2) return refuse("there is no contour", "the subprogram goes to the contour, and along it");
  const bool starts_on_it = span_of(contour_.front().start, contour_.back().end) < closing_gap;
  if (!starts_on_it) contour_.erase(contour_.begin());
  const double gap = span_of(contour_.front().start, contour_.back().end);
  if (starts_on_it || gap > closing_gap) {
    return refuse(starts_on_it ? "the contour ends at the hole"
                               : "the contour is not closed: its ends are " + text(gap) + " mm apart",
                  "end it where the first move led to, and not at the hole");
  }
  contour_.back().end = contour_.front().start;
  if (crosses_itself(contour_)) return refuse("the contour meets itself", "islands and bridges are not read: one loop");
  constexpr int left = 41, right = 42;
  const bool turns_left = is_counterclockwise(contour_);
  if (block_.user_code == (turns_left ? right : left)) {
    return refuse(std::string("the tool would be outside of a contour that is programmed ") +
                      (turns_left ? "counterclockwise" : "clockwise"),
                  turns_left ? "give G41" : "give G42");
  }
  return true;
}

bool PocketCycle::offset_contours() {
  const std::string tool = "the tool of radius " + text(plan_.cutter * cutter_.scale()) + " mm";
  const std::optional<Contour> finish = inside_of(contour_, plan_.cutter);
  if (!finish) {
    return refuse(tool + " does not get everywhere along the contour", "a smaller tool, or greater corners");
  }
  finish_ = *finish;
  outline_ = inside_of(contour_, plan_.cutter + plan_.allowance).value_or(Contour());
  return true;
}

// Lines along X; where they are along Y, of the contour with X and Y exchanged.
bool PocketCycle::find_path(double aside, std::vector<PlanePoint>& path) {
  const auto exchanged = [&](PlanePoint point) {
    return plan_.steps_along_x ? PlanePoint{point.second, point.first} : point;
  };
  Contour contour = contour_;
  for (ContourPiece& piece : contour) {
    piece = {exchanged(piece.start), exchanged(piece.end), exchanged(piece.center),
             plan_.steps_along_x ? -piece.turn : piece.turn};
  }
  PocketPath lines(contour, std::max(aside, least_aside), exchanged(plan_.hole), plan_.step);
  path = lines.points();
  for (PlanePoint& point : path) point = exchanged(point);
  switch (lines.outcome()) {
    case PocketPath::Outcome::planned:
      return true;
    case PocketPath::Outcome::outside:
      return refuse("the hole is not inside the pocket, off its contour by the tool's radius and K",
                    "X and Y of the hole");
    case PocketPath::Outcome::interrupted:
      return refuse("the tool does not get to all parts of the pocket", "a smaller tool, a smaller K, or two pockets");
    case PocketPath::Outcome::too_many:
      return reporter_.error_where_kept("too-many-passes", "G150: there are too many lines, or pieces of the contour",
                                        "a greater step, or fewer pieces");
  }
  return false;
}

void PocketCycle::cut(const ContourPiece& piece, PlanePoint to) {
  piece.is_arc() ? cycle_.arc(to, piece.center, piece.turn, feed_) : cycle_.line(to, feed_);
}

// To the nearest place of a contour from which nothing of the work is; false where there is none.
bool PocketCycle::go_to(const Contour& contour, std::size_t& piece) {
  const PlanePoint tool = cycle_.place();
  double least = std::numeric_limits<double>::infinity();
  PlanePoint best;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const PlanePoint near = nearest(tool, contour[i]);
    const double away = span_of(tool, near);
    if (away >= least || distance(ContourPiece{tool, near, {}, 0}, contour_) < plan_.cutter - pocket_rounding) continue;
    least = away;
    best = near;
    piece = i;
  }
  if (std::isinf(least)) return false;
  if (least > pocket_rounding) cycle_.line(best, feed_);
  return true;
}

void PocketCycle::go_round(const Contour& contour, std::size_t piece) {
  const PlanePoint begin = cycle_.place();
  if (contour.size() == 1) return cut(contour[0], begin);
  cut(contour[piece], contour[piece].end);
  for (std::size_t i = 1; i < contour.size(); ++i) {
    const ContourPiece& next = contour[(piece + i) % contour.size()];
    cut(next, next.end);
  }
  cut(contour[piece], begin);
}

void PocketCycle::mill(const std::vector<PlanePoint>& path) {
  const double initial = cycle_.position()[2];
  const auto follow = [&](const Contour& contour) {
    if (contour.empty()) return;
    std::size_t piece = 0;
    if (!go_to(contour, piece)) {
      const double down = cycle_.position()[2];
      cycle_.level(plan_.top, Feed{});
      cycle_.line(contour.front().start, Feed{});
      cycle_.level(down, feed_);
    }
    go_round(contour, piece);
  };
  if (initial < plan_.top) cycle_.level(plan_.top, Feed{});
  double level = plan_.top;
  do {
    level = plan_.depth == 0 ? plan_.bottom : std::max(plan_.bottom, level - plan_.depth);
    cycle_.line(plan_.hole, Feed{});
    if (cycle_.position()[2] > plan_.top) cycle_.level(plan_.top, Feed{});
    cycle_.level(level, feed_);
    for (const PlanePoint& point : path) cycle_.line(point, feed_);
    if (!outline_.empty()) follow(outline_);
    if (level == plan_.bottom && plan_.allowance > 0) follow(finish_);
    const bool is_last = level == plan_.bottom;
    const double up = is_last && modal_.retract == Retract::initial_level ? std::max(initial, plan_.top) : plan_.top;
    cycle_.level(up, Feed{});
  } while (level > plan_.bottom && !cycle_.failed());
}

void PocketCycle::end() {
  is_open_ = false;
  modal_.line = line_;
  if (reporter_.errors() != errors_before_) return;
  std::vector<PlanePoint> path;
  if (!close_contour() || !offset_contours() || !find_path(plan_.cutter + plan_.allowance, path)) return;
  cycle_.begin_kept(block_);
  mill(path);
  if (cycle_.failed()) cycle_.abandon();
}

}  // namespace leadscrew::gcode
