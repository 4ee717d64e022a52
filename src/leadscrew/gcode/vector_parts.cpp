// The moves that a line of tool vectors becomes, once the angles of its parts are known.

#include <cmath>
#include <leadscrew/gcode/curve_through.hpp>
#include <leadscrew/gcode/vector_moves.hpp>
#include <leadscrew/kinematics/transformation.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <utility>

namespace leadscrew::gcode {

namespace {

constexpr double least_part = 1e-9;  // of a curve, between two of the places that it goes through

}  // namespace

bool VectorMoves::take(Move& move) {
  for (;;) {
    if (!is_in_line_ && !events_.empty() && events_.front().before == taken_lines_) {
      move = std::move(events_.front().move);
      move.start = move.end = at_;
      events_.pop_front();
      return true;
    }
    if (taken_lines_ == decided_lines_) return false;
    if (!is_in_line_ && !begin_line()) continue;
    const bool has_length = make_move(move);
    if (parts_left_ == 0) end_line();
    if (has_length) return true;
  }
}

/// False, and the line is left out, where axes would leave their travel.
bool VectorMoves::begin_line() {
  parts_left_ = 0;
  while (parts_left_ < parts_.size() && parts_[parts_left_].line == taken_lines_) ++parts_left_;
  line_begin_ = at_;
  share_ = 0;
  taken_ = lines_.front().place;
  is_in_line_ = true;
  set_shares();
  if (parts_left_ > 0 && is_inside()) return true;
  if (parts_left_ > 0) at_ = place_at(parts_[parts_left_ - 1]);
  parts_.erase(parts_.begin(), parts_.begin() + static_cast<std::ptrdiff_t>(parts_left_));
  end_line();
  return false;
}

void VectorMoves::end_line() {
  lines_.pop_front();
  ++taken_lines_;
  is_in_line_ = false;
}

/// Of the line: of the tip's travel; of that of the rotary axes where the tip stands.
void VectorMoves::set_shares() {
  const kinematics::Vector begin{line_begin_[0], line_begin_[1], line_begin_[2]};
  const auto travel = [&](std::size_t k) { return numeric::norm(numeric::difference(parts_[k].vertex.tip, begin)); };
  const double whole = parts_left_ > 0 ? travel(parts_left_ - 1) : 0;
  double turned = 0;
  kinematics::Angles<double> angles = angles_at(at_);
  for (std::size_t k = 0; k < parts_left_; ++k) {
    turned += numeric::norm(numeric::difference(parts_[k].vertex.angles, angles));
    angles = parts_[k].vertex.angles;
    parts_[k].share = whole > 0 ? travel(k) / whole : turned;
  }
  for (std::size_t k = 0; whole == 0 && turned > 0 && k < parts_left_; ++k) parts_[k].share /= turned;
  if (parts_left_ > 0) parts_[parts_left_ - 1].share = 1;
}

/// Machine coordinates of the linear axes that are not the tip's go in proportion.
base::AxisVector VectorMoves::place_at(const LinePart& part) const {
  base::AxisVector place = lines_.front().end;
  for (std::size_t i = 0; part.share < 1 && i < place.size(); ++i)
    place[i] = line_begin_[i] + (place[i] - line_begin_[i]) * part.share;
  for (std::size_t i = 0; i < 3; ++i) place[i] = part.vertex.tip[i];
  const auto& turns = frame_.tip_control()->chain.turns();
  for (std::size_t i = 0; i < 2; ++i) place[base::index(turns[i].axis)] = part.vertex.angles[i];
  return place;
}

bool VectorMoves::is_inside() {
  const KeptPlace& place = lines_.front().place;
  const AtKeptPlace there(reporter_, place);
  Block block;
  block.first_column = place.column;
  base::AxisVector from = at_;
  bool inside = true;
  for (std::size_t k = 0; k < parts_left_; ++k) {
    const base::AxisVector to = place_at(parts_[k]);
    inside &= travel_.tip_inside(block, from, to);
    from = to;
  }
  return inside;
}

/// How many parts one smooth curve takes from here on; less than two where there is none. Under G64 lines are rounded
/// together with those of other blocks.
std::size_t VectorMoves::parts_of_curve() const {
  if (blends() && !lines_.front().stops) return 0;
  std::size_t count = 0;
  for (double share = share_; count < parts_left_ && count + 1 < most_control_points; ++count) {
    const LinePart& part = parts_[count];
    if (part.vertex.is_pole_turn || !(part.share - share > least_part)) break;
    share = part.share;
  }
  return count;
}

/// Of the next part, or of several; false where it has no length.
bool VectorMoves::make_move(Move& move) {
  const KeptLine& line = lines_.front();
  const std::size_t of_curve = parts_of_curve(), count = std::max<std::size_t>(of_curve, 1);
  const LinePart& last = parts_[count - 1];
  outbox_.prepare(move, of_curve > 1 ? Move::Kind::nurbs : Move::Kind::line, line.place.line);
  if (line.stops) {
    move.path_mode = PathMode::exact_stop;
    move.tolerance = move.naive_cam_tolerance = move.orientation_tolerance = 0;
  }
  move.start = at_;
  move.end = place_at(last);
  move.feed = last.vertex.is_pole_turn ? Feed{} : line.feed;
  if (last.vertex.is_pole_turn) tell_of_pole_turn();
  if (move.feed.mode == Feed::Mode::per_second && last.share > share_) move.feed.value /= last.share - share_;
  if (last.vertex.tolerance > 0)
    move.orientation_tolerance = std::min(move.orientation_tolerance, last.vertex.tolerance);
  if (of_curve > 1) make_curve(move, count);
  const bool has_length = move.end != move.start;
  at_ = move.end;
  share_ = last.share;
  parts_.erase(parts_.begin(), parts_.begin() + static_cast<std::ptrdiff_t>(count));
  parts_left_ -= count;
  return has_length;
}

void VectorMoves::make_curve(Move& move, std::size_t count) const {
  std::vector<double> parameters{0};
  std::vector<base::AxisVector> places{move.start};
  const double whole = parts_[count - 1].share - share_;
  for (std::size_t k = 0; k < count; ++k) {
    parameters.push_back((parts_[k].share - share_) / whole);
    places.push_back(place_at(parts_[k]));
  }
  parameters.back() = 1;
  make_curve_through(move.curve, parameters, places);
}

void VectorMoves::tell_of_pole_turn() {
  const KeptPlace& place = lines_.front().place;
  const AtKeptPlace there(reporter_, place);
  const base::Axis axis = frame_.tip_control()->chain.turns()[0].axis;
  reporter_.note(
      "pole-turn", place.column,
      std::string("the tool stands parallel to axis ") + base::letter(axis) +
          " here, which turns by itself while the tip stands",
      "G64 leads through poles within the pole cone and E; where a path begins at one, a rapid with the I J K of its "
      "next line turns the axis before");
}

}  // namespace leadscrew::gcode
