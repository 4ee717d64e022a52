// The moves of the tool's middle.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <leadscrew/gcode/cutter_compensation.hpp>
#include <leadscrew/gcode/path_length.hpp>
#include <numbers>
#include <utility>

namespace leadscrew::gcode {

namespace {

constexpr std::size_t most_waiting = 1000;  // moves and events that wait for a motion in the plane
constexpr double least_in_plane = 1e-9;     // mm; less is no motion
constexpr double most_entry_radii = 1e6;    // of the arc as programmed

// A block's duration is that of its programmed length (LinuxCNC).
void set_speed(Move& move) {
  const bool stands = move.kind == Move::Kind::line && move.start == move.end;
  if (stands || move.feed.mode != Feed::Mode::per_second) return;
  move.feed = {Feed::Mode::units_per_second, move.feed.value * path_length(move)};
}

bool is_way(const Move& move) {
  return move.kind == Move::Kind::arc || (move.kind == Move::Kind::line && move.start != move.end);
}

// A helix of more than one turn is on many levels.
bool winds(const Move& move) {
  const std::size_t normal = base::index(normal_axis(move.plane));
  return move.kind == Move::Kind::arc && std::abs(move.turns) > 1 && move.start[normal] != move.end[normal];
}

// An arc by which the tool comes to the end of the way beside another, in its direction there (LinuxCNC's arc entry): its
// centre is on the line from there through that of the other, as far from both ends. Nothing where there is none.
std::optional<OffsetPiece> arc_to_end_of(OffsetPiece piece, PlanePoint from, int turns) {
  ContourPiece& way = piece.way;
  const PlanePoint chord{from.first - way.end.first, from.second - way.end.second};
  const PlanePoint inward{way.center.first - way.end.first, way.center.second - way.end.second};
  const double across = 2 * (chord.first * inward.first + chord.second * inward.second);
  const double share = (chord.first * chord.first + chord.second * chord.second) / across;
  if (!(across > 0) || !(share < most_entry_radii)) return std::nullopt;
  way.start = from;
  way.center = {way.end.first + share * inward.first, way.end.second + share * inward.second};
  piece.turned = sweep(way.start, way.end, way.center, way.turn) + (std::abs(turns) - 1) * 2 * std::numbers::pi;
  return piece;
}

}  // namespace

void CutterCompensation::set_in_plane(base::AxisVector& place, PlanePoint point) const {
  place[base::index(first_axis(plane_))] = point.first;
  place[base::index(second_axis(plane_))] = point.second;
}

double CutterCompensation::radius() const {
  return std::fabs(aside_);
}

bool CutterCompensation::is_in_plane(const Move& move) const {
  if (move.kind == Move::Kind::arc) return true;
  return move.kind == Move::Kind::line &&
         span_of(in_plane(move.start, plane_), in_plane(move.end, plane_)) > least_in_plane;
}

bool CutterCompensation::take(Move& move) {
  while (decided_ > 0) {
    move = std::move(kept_.front().move);
    taken_ = std::move(kept_.front().place);
    kept_.pop_front();
    --decided_;
    if (!tool_) return true;
    move.start = *tool_;
    if (move.kind != Move::Kind::line) {
      move.end = *tool_;
      return true;
    }
    tool_.reset();
    if (move.start != move.end) return true;
  }
  return false;
}

void CutterCompensation::add(const Move& move) {
  Kept kept{move, reporter_.place(column_)};
  const bool ends = move.kind == Move::Kind::event && move.event.kind == base::Event::Kind::program_end;
  const bool is_led = is_aside_ || phase_ == Phase::entering || phase_ == Phase::on;
  if (is_led && options_.programmed && is_way(move)) options_.programmed(move);
  const bool is_refused = is_aside_ && !lead_back(kept);
  if (is_led && !is_refused) set_speed(kept.move);
  if (is_refused || phase_ == Phase::passing || phase_ == Phase::off) return decide(std::move(kept));
  if (ends) settle(), end_search();
  if (!is_in_plane(move)) return let_pass(std::move(kept));
  if (phase_ == Phase::entering) return enter(std::move(kept));
  follow(std::move(kept));
}

void CutterCompensation::add(const Move& move, const KeptPlace& place) {
  const AtKeptPlace there(reporter_, place);
  column_ = place.column;
  add(move);
}

void CutterCompensation::decide(Kept kept) {
  kept_.push_back(std::move(kept));
  decided_ = kept_.size();
}

// It happens where the way before it ends, which may not be known yet.
void CutterCompensation::let_pass(Kept kept) {
  if (phase_ == Phase::entering && kept.move.kind == Move::Kind::line && options_.dialect == Dialect::linuxcnc)
    return enter(std::move(kept));
  set_in_plane(kept.move.start, at_);
  set_in_plane(kept.move.end, at_);
  if (!piece_ && kept.move.kind == Move::Kind::line) end_search();
  if (!piece_) return decide(std::move(kept));
  kept_.push_back(std::move(kept));
  if (kept_.size() - decided_ <= most_waiting) return;
  error("cutter-compensation", column_, "more than 1000 moves and events without motion in the plane",
        "G40 before what does not follow the contour");
  abandon();
}

// A thread or a probing move would go aslant.
bool CutterCompensation::leads_back(const Move& move) {
  if (move.kind == Move::Kind::event) return !base::is_in_step(move.event.kind) || move.event.value == 0;
  return move.kind != Move::Kind::arc && move.kind != Move::Kind::nurbs && move.probes == ProbeSearch::nothing;
}

/// The move behind G40; false where it cannot be the one.
bool CutterCompensation::lead_back(const Kept& kept) {
  if (!leads_back(kept.move)) {
    error("cutter-exit", column_, "the first move behind G40 is no line of G0 or G1",
          "such a line, which leads to where the program says");
    forget_tool();
    return false;
  }
  if (kept.move.kind == Move::Kind::line) is_aside_ = modal_.tool_is_aside = false;
  return true;
}

void CutterCompensation::enter(Kept kept) {
  const bool may_be_arc = options_.dialect == Dialect::linuxcnc || options_.dialect == Dialect::leadscrew;
  if (kept.move.kind == Move::Kind::arc && may_be_arc) return enter_by_arc(std::move(kept));
  const double length = span_of(at_, in_plane(kept.move.end, plane_));
  if (kept.move.kind != Move::Kind::line || !(length > radius())) {
    const bool is_line = kept.move.kind == Move::Kind::line;
    error("cutter-entry", column_,
          is_line ? "the first move of cutter compensation is " + text(length) + " mm long, the tool's radius " +
                        text(radius()) + " mm"
                  : std::string("the first move of cutter compensation is an arc"),
          "a line that is longer than the radius, by which the tool comes to the contour");
    return abandon();
  }
  Move as_programmed = kept.move;
  set_in_plane(as_programmed.start, at_);
  begin_contour(std::move(kept), offset_of(as_programmed, aside_));
}

void CutterCompensation::enter_by_arc(Kept kept) {
  std::optional<OffsetPiece> piece = offset_of(kept.move, aside_);
  const PlanePoint from{at_.first - origin_.first, at_.second - origin_.second};
  if (piece) piece = arc_to_end_of(*piece, from, kept.move.turns);
  if (!piece) {
    error("cutter-entry", column_,
          "from where the tool is, no arc leads to beside the end of the first move of cutter compensation",
          "an arc of less than half a turn and of a radius greater than the tool's, or a line");
    return abandon();
  }
  begin_contour(std::move(kept), piece);
}

void CutterCompensation::begin_contour(Kept kept, const std::optional<OffsetPiece>& piece) {
  piece_ = piece;
  is_entry_ = true;
  phase_ = Phase::on;
  kept_.push_back(std::move(kept));
}

// Whether the next motion begins on the level where the last one ends, whatever lies between.
bool CutterCompensation::stays_on_level(const Move& next) const {
  const std::size_t normal = base::index(normal_axis(plane_));
  return kept_[decided_].move.end[normal] == next.start[normal];
}

void CutterCompensation::follow(Kept kept) {
  std::optional<OffsetPiece> next = offset_of(kept.move, aside_);
  if (!next) {
    const PlanePoint center{kept.move.center_first, kept.move.center_second};
    error("cutter-gouge", column_,
          "the tool, of radius " + text(radius()) + " mm, is inside of an arc of radius " +
              text(span_of(in_plane(kept.move.start, plane_), center)) + " mm",
          "a smaller tool or a larger arc");
    return abandon();
  }
  if (!piece_) {  // behind what has been settled
    piece_ = next;
    kept_.push_back(std::move(kept));
    return;
  }
  const bool is_level = stays_on_level(kept.move) && !winds(kept_[decided_].move) && !winds(kept.move) &&
                        !is_left_to_search(kept.move, *next);
  const CornerKind corner = corner_of(*piece_, *next, aside_);
  const bool meets = join(*next, corner);
  if (!meets) end_search(), refuse_corner(kept_[decided_].place, kept.place);
  const bool fits = meets && (is_entry_ || !is_level || keeps_clear(*piece_, next->contour, radius()));
  if (meets && !fits) report_gouge(kept_[decided_].place, kept.place);
  const PlanePoint from = piece_->way.end;
  const std::optional<ContourPiece> contour =
      fits && is_level && !is_entry_ ? std::optional(piece_->contour) : std::nullopt;
  const KeptPlace place = kept_[decided_].place;
  settle();
  contour_ = contour;
  contour_place_ = place;
  if (!meets) search_.forget();
  if (corner == CornerKind::outer && meets) go_round(from, *next, kept, is_level);
  if (!meets) connect(next->way.start, kept);
  piece_ = next;
  kept_.push_back(std::move(kept));
}

// Makes the way that waits end, and the next begin, where they do; false where they do not meet.
bool CutterCompensation::join(OffsetPiece& next, CornerKind corner) {
  if (corner == CornerKind::inner && !cut_inner_corner(*piece_, next)) return false;
  if (corner == CornerKind::none && piece_->way.is_arc()) next.way.start = piece_->way.end;
  if (corner == CornerKind::none && !piece_->way.is_arc()) piece_->way.end = next.way.start;
  return true;
}

// An arc about the corner, at the feed of what follows.
void CutterCompensation::go_round(PlanePoint from, const OffsetPiece& next, const Kept& kept, bool is_level) {
  OffsetPiece corner{next.contour, {from, next.way.start, next.contour.start, aside_ > 0 ? -1 : 1}, 0};
  corner.turned = sweep(from, corner.way.end, corner.way.center, corner.way.turn);
  const auto is_near = [&](const ContourPiece& contour) { return !keeps_clear(corner, contour, radius()); };
  if (is_level && (is_near(next.contour) || (contour_ && is_near(*contour_)))) {
    report_gouge(contour_place_, kept.place);
    contour_.reset();
  }
  Kept round{kept.move, kept.place};
  round.move.kind = Move::Kind::arc;
  round.move.plane = plane_;
  round.move.end = round.move.start;
  put(round, corner);
  search_.add_corner(corner, radius(), round.place);
  decide(std::move(round));
}

// Behind an error.
void CutterCompensation::connect(PlanePoint to, const Kept& kept) {
  Kept line{kept.move, kept.place};
  line.move.kind = Move::Kind::line;
  line.move.end = line.move.start;
  put(line, {{}, {{}, to, {}, 0}, 0});
  decide(std::move(line));
}

// The motion that waits ends where its way does, and all that waits with it happens there.
void CutterCompensation::finish() {
  put(kept_[decided_], *piece_);
  search(kept_[decided_], *piece_);
  for (std::size_t i = decided_ + 1; i < kept_.size(); ++i) {
    set_in_plane(kept_[i].move.start, at_);
    set_in_plane(kept_[i].move.end, at_);
    if (kept_[i].move.kind == Move::Kind::line) end_search();
  }
  const Move& move = kept_[decided_].move;
  const bool stands = move.kind == Move::Kind::line && move.start == move.end;
  if (stands) kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(decided_));
  decided_ = kept_.size();
  piece_.reset();
  is_entry_ = false;
}

void CutterCompensation::settle() {
  if (!piece_) return;
  if (contour_ && !keeps_clear(*piece_, *contour_, radius())) report_gouge(contour_place_, kept_[decided_].place);
  finish();
}

// A run of the search is at feed and at one level.
bool CutterCompensation::is_searched(const Move& move) const {
  const std::size_t normal = base::index(normal_axis(plane_));
  return move.start[normal] == move.end[normal] && move.feed.mode != Feed::Mode::rapid;
}

// Of the motion that waits and the next: whether both are of one run, and one is a long arc.
bool CutterCompensation::is_left_to_search(const Move& next, const OffsetPiece& piece) const {
  if (is_entry_ || (!is_long_arc(piece_->contour) && !is_long_arc(piece.contour))) return false;
  const auto breaks = [](const Kept& kept) { return kept.move.kind == Move::Kind::line; };
  return is_searched(kept_[decided_].move) && is_searched(next) &&
         std::none_of(kept_.begin() + static_cast<std::ptrdiff_t>(decided_) + 1, kept_.end(), breaks);
}

void CutterCompensation::search(const Kept& kept, const OffsetPiece& piece) {
  if (is_entry_ || !is_searched(kept.move)) return end_search();
  search_.add(piece, radius(), kept.place);
}

void CutterCompensation::end_search() {
  search_.end_run([this](const KeptPlace& one, const KeptPlace& two, GougeSearch::Depth depth) {
    depth == GougeSearch::Depth::slight ? warn_of_slight_gouge(one, two) : report_gouge(one, two);
  });
}

// From where the tool's middle is along the way of a piece.
void CutterCompensation::put(Kept& kept, const OffsetPiece& piece) {
  Move& move = kept.move;
  set_in_plane(move.start, at_);
  at_ = moved(piece.way.end);
  set_in_plane(move.end, at_);
  if (piece.way.is_arc()) {
    const PlanePoint center = moved(piece.way.center);
    move.center_first = center.first;
    move.center_second = center.second;
    move.turns = turns_of(piece);
    if (move.turns == 0) move.kind = Move::Kind::line;
  }
  check_travel(kept);
}

void CutterCompensation::check_travel(const Kept& kept) {
  const Move& move = kept.move;
  PlaneBox box{in_plane(move.end, plane_), in_plane(move.end, plane_)};
  if (move.kind == Move::Kind::arc)
    box = arc_extent(in_plane(move.start, plane_), box.high, {move.center_first, move.center_second}, move.turns);
  const AtKeptPlace there(reporter_, kept.place);
  travel_.released_inside(first_axis(plane_), box.low.first, box.high.first, kept.place.column);
  travel_.released_inside(second_axis(plane_), box.low.second, box.high.second, kept.place.column);
}

std::string CutterCompensation::gouge_between(const KeptPlace& one, const KeptPlace& two) const {
  return "the tool, of radius " + text(radius()) + " mm, does not fit between the contour of line " + named(one, two) +
         " and that of line " + std::to_string(base::number(two.line));
}

/// The line of the one: with its file, where that is another than the other's.
std::string CutterCompensation::named(const KeptPlace& one, const KeptPlace& two) const {
  const std::string line = std::to_string(base::number(one.line));
  return base::file(one.line) == base::file(two.line) ? line : line + " of " + reporter_.file_of(one.line);
}

void CutterCompensation::refuse_corner(const KeptPlace& one, const KeptPlace& two) {
  const AtKeptPlace there(reporter_, two);
  error("cutter-gouge", two.column, gouge_between(one, two), "a smaller tool, or a contour that it fits");
}

void CutterCompensation::warn_of_slight_gouge(const KeptPlace& one, const KeptPlace& two) {
  const AtKeptPlace there(reporter_, two);
  reporter_.warning("cutter-gouge", two.column,
                    "the tool, of radius " + text(radius()) + " mm, cuts by up to 0.01 mm into the contour of line " +
                        named(one, two) + " or line " + std::to_string(base::number(two.line)) +
                        ", where the contour closes",
                    "begin and end it along a straight piece");
}

void CutterCompensation::report_gouge(const KeptPlace& one, const KeptPlace& two) {
  const AtKeptPlace there(reporter_, two);
  if (options_.dialect == Dialect::linuxcnc || options_.allows_gouging) {
    reporter_.warning("cutter-gouge", two.column, gouge_between(one, two), "a smaller tool, or a contour that it fits");
    return;
  }
  error("cutter-gouge", two.column, gouge_between(one, two),
        "a smaller tool, or a contour that it fits; or allow gouging, where this is no edge of the part");
}

}  // namespace leadscrew::gcode
