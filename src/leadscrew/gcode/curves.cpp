#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/curves.hpp>
#include <leadscrew/gcode/nurbs.hpp>
#include <utility>

namespace leadscrew::gcode {

namespace {

constexpr std::uint32_t highest_order = highest_degree + 1;
constexpr std::size_t x = base::index(base::Axis::X);
constexpr std::size_t y = base::index(base::Axis::Y);

std::string in_line(base::Line line) {
  return "the curve of line " + std::to_string(base::number(line));
}

// Knots of the Bézier curve of as many points as there are, whose other axes have been given in proportion.
void make_bezier(NurbsCurve& curve, int degree, const base::AxisVector& start, const base::AxisVector& end) {
  curve.clear();
  curve.degree = degree;
  for (int i = 0; i <= degree; ++i) {
    ControlPoint point{start, 1};
    for (std::size_t k = 0; k < base::axis_count; ++k) point.position[k] += (end[k] - start[k]) * i / degree;
    curve.points.push_back(point);
  }
  curve.points.back().position = end;
  set_uniform_knots(curve);
}

}  // namespace

bool CurveReader::curve_error(std::string_view code, std::uint32_t column, std::string message, std::string hint) {
  if (draft_.spoiled) return reporter_.fail();
  return error(code, column, std::move(message), std::move(hint));
}

void CurveReader::nurbs(const Block& block) {
  if (!open()) begin_curve(block);
  add_to_nurbs(block);
}

// A vector of the program along X and Y, as one of the machine.
bool CurveReader::spline_offset(const Block& block, char first, char second, PlanePoint& offset) {
  const std::pair<char, base::Axis> words[] = {{first, base::Axis::X}, {second, base::Axis::Y}};
  for (const auto& [letter, axis] : words) {
    if (!machine_.has(axis) && block.has(letter)) {
      return error("unknown-axis", block.column_of(letter),
                   std::string(1, letter) + " is a distance along axis " + base::letter(axis) +
                       ", which the machine does not have",
                   "curves of G5 and G5.1 need X and Y");
    }
  }
  offset = {block.value_or(first, 0) * frame_.length_unit, block.value_or(second, 0) * frame_.length_unit};
  if (!frame_.is_separate(base::Axis::Z)) {
    return error("unsupported-rotation", motion_column(block), "G5 and G5.1 where XY is turned out of its plane",
                 "turn about Z only");
  }
  const base::AxisVector turned = frame_.direction_to_machine({offset.first, offset.second});
  offset = in_plane(turned, Plane::XY);
  return true;
}

// From the start to the first control point behind it.
bool CurveReader::first_offset(const Block& block, PlanePoint& offset) {
  const bool any = block.has('I') || block.has('J');
  const bool both = block.has('I') && block.has('J');
  if (modal_.to_do == Code::G5_1) {
    if (block.value_or('I', 0) == 0 && block.value_or('J', 0) == 0) {
      return error("missing-word", motion_column(block), "G5.1 has no control point away from its start",
                   "give I and J, from the start");
    }
  } else if (!any && tangent_ && tangent_at_ == frame_.position) {
    offset = *tangent_;
    return true;
  } else if (!both) {
    return error("missing-word", motion_column(block), any ? "G5 has I or J only" : "the first G5 lacks I and J",
                 any ? "give both, or neither behind another G5" : "give both, from the start");
  }
  return spline_offset(block, 'I', 'J', offset);
}

// LinuxCNC's curves have no other axes (manual, G Codes, "G5" and "G5.1").
bool CurveReader::is_of_dialect(const Block& block) {
  constexpr std::uint32_t others = axis_letter_bits & ~(letter_bit('X') | letter_bit('Y'));
  if (options_.dialect != Dialect::linuxcnc) return true;
  if (block.words & others) {
    return error("unused-word", motion_column(block), name(modal_.to_do) + " stands beside another axis than X and Y",
                 "dialect leadscrew takes it");
  }
  if (modal_.to_do == Code::G5 || block.has('I') == block.has('J')) return true;
  return error("missing-word", motion_column(block), "G5.1 has I or J only", "give both, from the start");
}

void CurveReader::spline(const Block& block) {
  const bool cubic = modal_.to_do == Code::G5;
  const base::AxisVector target = motion_.target_of(block);
  PlanePoint from_start, from_end;
  bool known = modal_.plane == Plane::XY;
  if (!known) {
    error("bad-plane", motion_column(block), name(modal_.to_do) + " stands in G18 or G19",
          "curves of G5 and G5.1 need G17");
  }
  known = known && is_of_dialect(block);
  known &= first_offset(block, from_start);
  if (cubic) {
    if (!block.has('P') || !block.has('Q')) {
      known = error("missing-word", motion_column(block), "G5 lacks P or Q", "give both, from the end");
    } else {
      known &= spline_offset(block, 'P', 'Q', from_end);
    }
    // The next curve goes on as this one ends, also where what follows is only read.
    tangent_ = PlanePoint{-from_end.first, -from_end.second};
    tangent_at_ = target;
  }
  make_bezier(curve_, cubic ? 3 : 2, frame_.position, target);
  base::AxisVector& second = curve_.points[1].position;
  second[x] = frame_.position[x] + from_start.first;
  second[y] = frame_.position[y] + from_start.second;
  if (cubic) {
    base::AxisVector& third = curve_.points[2].position;
    third[x] = target[x] + from_end.first;
    third[y] = target[y] + from_end.second;
  }
  Feed feed;
  motion_.feed_of(block, is_linear_curve(), block.has('F'), feed);
  if (known) {
    follow_curve(block, feed, modal_.line);
  } else {
    frame_.position = target;
  }
}

void CurveReader::begin_curve(const Block& block) {
  draft_ = {.code = modal_.to_do, .errors = draft_.errors, .line = modal_.line, .last_point = frame_.position};
  curve_.clear();
  reporter_.keep(block.first_column);
  // Of G93, F may still come.
  Feed feed;
  if (modal_.feed_mode != FeedMode::inverse_time) motion_.feed_of(block, true, true, feed);
}

void CurveReader::set_order(const Block& block, char letter, int least) {
  const std::optional<int> order = as_integer(block[letter]);
  if (!order || *order < least || *order > static_cast<int>(highest_order)) {
    error("bad-value", block.column_of(letter), "the order of a curve is " + text(block[letter]),
          std::string(1, letter) + " must be an integer from " + std::to_string(least) + " to " +
              std::to_string(highest_order) + ", the degree and one");
    return;
  }
  draft_.order = static_cast<std::uint32_t>(*order);
  curve_.degree = *order - 1;
}

void CurveReader::add_point(const Block& block, const base::AxisVector& position, char weight_letter) {
  ControlPoint point{position, block.value_or(weight_letter, 1)};
  if (!(least_weight <= point.weight && point.weight <= greatest_weight)) {
    error("bad-weight", block.column_of(weight_letter), "the weight of a control point is " + text(point.weight),
          std::string(1, weight_letter) + " must be above 0: from 1e-9 to 1e9");
    point.weight = 1;
  }
  draft_.last_point = position;
  if (curve_.points.size() == most_control_points) {
    curve_error("too-many-points", motion_column(block),
                in_line(draft_.line) + " has more than " + std::to_string(most_control_points) + " control points",
                "make several curves of it");
    return;
  }
  curve_.points.push_back(point);
}

// One block of G5.2. P alone is the weight of the first point, where the tool stands. As LinuxCNC has it, X and Y come
// together, and in G91 all points are seen from the start of the curve.
void CurveReader::add_to_nurbs(const Block& block) {
  if (draft_.order == 0) {
    draft_.order = 3;
    curve_.degree = 2;
  }
  draft_.feed_given |= block.has('F');
  if (block.has('L')) set_order(block, 'L', 3);
  const bool first = curve_.points.empty();
  if (!(block.words & axis_letter_bits)) {
    if (!block.has('P')) return;
    if (first) return add_point(block, frame_.position, 'P');
    error("unused-word", block.column_of('P'), "P stands without a control point", "only the first has P alone");
    return;
  }
  if (block.has('X') != block.has('Y')) {
    error("missing-word", motion_column(block), "a control point has X or Y only", "give both");
  }
  if (first) curve_.points.push_back({frame_.position, 1});
  const bool absolute = modal_.distance == Distance::absolute;
  base::AxisVector position = motion_.target_of(block, absolute ? draft_.last_point : frame_.position);
  for (const base::Axis axis : base::all_axes) {
    if (!block.has(base::letter(axis))) position[base::index(axis)] = draft_.last_point[base::index(axis)];
  }
  add_point(block, position, 'P');
}

void CurveReader::end_nurbs(const Block& block) {
  modal_.motion = Code::G80;
  if (!open()) {
    error("missing-curve", motion_column(block), "G5.3 ends no curve", "G5.2 begins one");
    return;
  }
  draft_.feed_given |= block.has('F');
  for (const base::Axis axis : base::all_axes) {
    if (!block.has(base::letter(axis))) continue;
    error("unused-word", block.column_of(base::letter(axis)), "G5.3 moves no axis",
          "put the point into a block before");
  }
  if (curve_.points.size() < draft_.order) {
    curve_error("too-few-points", motion_column(block),
                in_line(draft_.line) + " has " + std::to_string(curve_.points.size()) + " control points",
                "of order " + std::to_string(draft_.order) + " it needs at least as many, with its start");
  }
  if (draft_.spoiled || reporter_.failed()) {
    reporter_.fail();
    return abandon_curve();
  }
  set_uniform_knots(curve_);
  finish_curve(block);
}

void CurveReader::add_knot(const Block& block, bool all_points) {
  if (draft_.spoiled) return;
  const double knot = block['K'];
  const double before = curve_.knots.empty() ? knot : curve_.knots.back();
  curve_.knots.push_back(knot);
  switch (judge_last_knot(curve_, all_points)) {
    case KnotProblem::none:
      break;
    case KnotProblem::decreases:
      curve_error("knot-order", block.column_of('K'), "the knot " + text(knot) + " follows " + text(before),
                  "knots do not decrease");
      break;
    case KnotProblem::repeats:
      curve_error(
          "knot-multiplicity", block.column_of('K'), "the knot " + text(knot) + " stands too often",
          "of order " + std::to_string(draft_.order) + ", that many times at an end and once less between them");
      break;
  }
}

// The first block of G6.2, or one behind the last knot.
void CurveReader::begin_nurbs_with_knots(const Block& block) {
  begin_curve(block);
  if (!block.has(Group::motion)) {
    curve_error("knot-count", block.first_column, "the curve before has all its points and knots",
                "begin another with G6.2");
  } else if (block.has('P')) {
    set_order(block, 'P', 2);
  } else {
    curve_error("missing-word", motion_column(block), "G6.2 lacks P",
                "give the order of the curve: its degree and one");
  }
}

// Axis words, or a weight, make a control point of G6.2; a knot by itself is one of the last.
void CurveReader::add_to_nurbs_with_knots(const Block& block) {
  const bool begins = block.has(Group::motion);
  const bool point = begins || (block.words & (axis_letter_bits | letter_bit('R')));
  const bool behind = !begins && !open();
  if (begins || behind) begin_nurbs_with_knots(block);
  if (behind) return;
  draft_.feed_given |= block.has('F');
  if (!block.has('K')) {
    curve_error("missing-word", motion_column(block), "a control point lacks its knot", "give K in every block");
  }
  if (point && draft_.last_knots > 0) {
    curve_error("knot-count", motion_column(block), "a control point stands behind the last knots",
                in_line(draft_.line) + " lacks " + std::to_string(draft_.order - draft_.last_knots) + " of them");
    draft_.last_point = motion_.target_of(block, draft_.last_point);
    return;
  }
  if (point) add_point(block, motion_.target_of(block, draft_.last_point), 'R');
  if (!point && draft_.last_knots == 0 && curve_.points.size() < draft_.order) {
    curve_error("too-few-points", motion_column(block),
                in_line(draft_.line) + " has " + std::to_string(curve_.points.size()) + " control points",
                "of order " + std::to_string(draft_.order) + " it needs at least as many");
  }
  if (block.has('K')) add_knot(block, !point);
  // A curve with a problem takes in whatever comes, up to the next motion.
  if (!point && ++draft_.last_knots == draft_.order && !draft_.spoiled && !reporter_.failed()) finish_curve(block);
}

// The first point becomes the place where the tool stands: it may be off by as much as the ends of arcs may.
bool CurveReader::join_start(const Block& block) {
  ControlPoint& first = curve_.points.front();
  const double tolerance = arc_tolerance(frame_.length_unit != 1).absolute;
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    if (std::fabs(first.position[i] - frame_.position[i]) <= tolerance) continue;
    return error("curve-start", motion_column(block),
                 in_line(draft_.line) + " begins at " + base::letter(axis) + text(first.position[i]) +
                     " of the machine, the tool stands at " + base::letter(axis) + text(frame_.position[i]),
                 "it must begin where the block before ends");
  }
  first.position = frame_.position;
  return true;
}

void CurveReader::finish_curve(const Block& block) {
  if (!knots_are_apart(curve_)) {
    error("knot-order", motion_column(block), in_line(draft_.line) + " has knots with no room between them",
          "neighbours are equal or at least 1e-12 of their range apart");
    return abandon_curve();
  }
  draft_.code = Code::none;
  clamp_ends(curve_);
  const bool joined = join_start(block);
  Feed feed;
  motion_.feed_of(block, is_linear_curve(), draft_.feed_given, feed);
  if (joined) {
    follow_curve(block, feed, draft_.line);
  } else {
    frame_.position = curve_.points.back().position;
  }
}

bool CurveReader::is_linear_curve() const {
  return std::any_of(curve_.points.begin(), curve_.points.end(),
                     [&](const ControlPoint& point) { return motion_.is_linear(point.position); });
}

void CurveReader::follow_curve(const Block& block, const Feed& feed, base::Line line) {
  const base::AxisVector end = curve_.points.back().position;
  // Only a line comes back from outside at once.
  const bool from_outside = travel_.fails_outside(block);
  travel_.end_inside(block, end);
  if (!from_outside) travel_.curve_inside(block, curve_);
  const bool moves = std::any_of(curve_.points.begin(), curve_.points.end(),
                                 [&](const ControlPoint& point) { return point.position != frame_.position; });
  if (moves) {
    Move& move = outbox_.emit(Move::Kind::nurbs);
    move.line = line;
    move.end = end;
    move.feed = feed;
    std::swap(move.curve, curve_);
  }
  frame_.position = end;
}

// What follows is read as if the curve had been followed.
void CurveReader::abandon_curve() {
  if (open()) frame_.position = draft_.last_point;
  draft_.code = Code::none;
}

// Between the first block of a curve and the last there is nothing but its points, their feed, and remarks.
void CurveReader::check(const Block& block) {
  if (!open()) return;
  const bool by_itself =
      draft_.code == Code::G5_2 && (block.code(Group::motion) == Code::G5_2 || block.code(Group::motion) == Code::G5_3);
  const bool motion = block.has(Group::motion) && !by_itself;
  const bool other_words = block.words & (letter_bit('S') | letter_bit('T'));
  if (!motion && !other_words && !(block.groups & ~bit(Group::motion))) return;
  curve_error("unfinished-curve", motion ? block.column_of(Group::motion) : block.first_column, unfinished_message(),
              unfinished_hint());
  if (motion || block.has(Group::stop)) abandon_curve();
}

void CurveReader::refuse_modes() {
  curve_error("unfinished-curve", 1, unfinished_message(), unfinished_hint());
}

void CurveReader::end() {
  if (open() && !draft_.spoiled && reporter_.errors() == draft_.errors) {
    reporter_.report(base::Severity::error, "unfinished-curve", {reporter_.file(), base::number(modal_.line), 1},
                     unfinished_message(), unfinished_hint());
  }
  abandon_curve();
}

std::string CurveReader::unfinished_message() const {
  if (draft_.code == Code::G5_2) return in_line(draft_.line) + " has no G5.3";
  return in_line(draft_.line) + " lacks " + std::to_string(draft_.order - draft_.last_knots) + " of its last knots";
}

std::string CurveReader::unfinished_hint() const {
  if (draft_.code == Code::G5_2) return "between G5.2 and G5.3 there are only control points";
  return "behind the last control point, as many blocks of K as the order";
}

}  // namespace leadscrew::gcode
