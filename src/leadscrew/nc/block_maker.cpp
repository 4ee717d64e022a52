#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/number.hpp>
#include <leadscrew/geometry/arc.hpp>
#include <leadscrew/nc/block_maker.hpp>
#include <leadscrew/nc/lattice_arc.hpp>
#include <numbers>
#include <string>
#include <utility>

namespace leadscrew::nc {

namespace {

using base::index;
using Planned = std::optional<base::Result<PlannedBlock>>;

constexpr double whole_turn = 2 * std::numbers::pi;

base::Diagnostic problem(const gcode::Move& move, std::string_view code, std::string message, std::string hint) {
  base::Diagnostic problem = base::problem(code, std::move(message), std::move(hint), {.field = pulses_field});
  problem.place.line = base::number(move.line);
  return problem;
}

base::AxisVector between(const base::AxisVector& from, const base::AxisVector& to, double fraction) {
  base::AxisVector result = from;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] += (to[i] - from[i]) * fraction;
  return result;
}

/// By length, 1/mm or 1/degree: at what the chord's error is an eighth of its square by this.
double curvature(const geometry::Nurbs& piece, double s) {
  double square = 0;
  for (const numeric::Jet<>& jet : piece.jets(s)) square += jet.second * jet.second;
  return std::sqrt(square);
}

/// |d²q/ds²| of each axis, the greatest at a chord's ends and in its middle.
base::AxisVector greatest_bend(const geometry::Nurbs& piece, double from, double chord) {
  base::AxisVector bend{};
  for (const double s : {from, from + chord / 2, from + chord}) {
    const auto jets = piece.jets(s);
    for (std::size_t i = 0; i < bend.size(); ++i) bend[i] = std::max(bend[i], std::abs(jets[i].second));
  }
  return bend;
}

/// How far the next chord goes: its error is h²κ/8, for the greater curvature at its ends and in its middle.
double chord_end(const geometry::Nurbs& piece, double from, double error) {
  double chord = piece.length() - from;
  for (int halvings = 0; halvings < 40; ++halvings) {
    const double most =
        std::max({curvature(piece, from), curvature(piece, from + chord / 2), curvature(piece, from + chord)});
    if (chord * chord * most <= 8 * error) break;
    chord = std::max(chord / 4, std::min(chord, std::sqrt(8 * error / most)) * 0.999);
  }
  return from + chord < piece.length() ? from + chord : piece.length();
}

}  // namespace

LatticeVector on_lattice(const base::AxisVector& position, const machine::Machine& machine) {
  LatticeVector at{};
  for (const base::Axis axis : base::all_axes) {
    if (machine.has(axis)) at[index(axis)] = std::llround(position[index(axis)] / machine.limits(axis).blu);
  }
  return at;
}

BlockMaker::BlockMaker(const machine::Machine& machine, const PulseOptions& options, const base::AxisVector& start)
    : machine_(machine), options_(options), at_(on_lattice(start, machine)) {}

void BlockMaker::load(const gcode::Move& move) {
  move_ = move;
  left_ = move.kind != gcode::Move::Kind::event;
  turn_ = 0;
  closing_ = false;
  chords_ = {};
  if (move.kind == gcode::Move::Kind::arc) {
    const std::size_t first = index(gcode::first_axis(move.plane)), second = index(gcode::second_axis(move.plane));
    sweep_ = std::abs(
        geometry::sweep_angle(move.start[first] - move.center_first, move.start[second] - move.center_second,
                              move.end[first] - move.center_first, move.end[second] - move.center_second, move.turns)
            .hi);
  } else if (move.kind == gcode::Move::Kind::nurbs) {
    chords_.pieces = geometry::smooth_pieces(geometry::form_of(move.curve));
  }
}

Planned BlockMaker::next() {
  if (left_ && move_.is_of_tip) return of_tip();
  while (left_) {
    Planned made;
    switch (move_.kind) {
      case gcode::Move::Kind::line:
        left_ = false;
        made = line_or_wait(on_lattice(move_.end, machine_), Part{});
        break;
      case gcode::Move::Kind::arc:
        made = next_turn();
        break;
      case gcode::Move::Kind::nurbs:
        made = next_chord();
        break;
      case gcode::Move::Kind::dwell:
        made = dwell();
        break;
      case gcode::Move::Kind::event:
        left_ = false;
        break;
    }
    if (made) return made;
  }
  return std::nullopt;
}

/// Blocks lead the axes themselves along lines and arcs, and the tip's are none of theirs. Said once: it would be said of
/// every move.
Planned BlockMaker::of_tip() {
  if (std::exchange(told_of_tip_, true)) {
    left_ = false;
    return std::nullopt;
  }
  return give_up(problem(move_, "pulse-tip-control",
                         "pulses: a method of the papers under tool centre point control, where axes go neither "
                         "straight nor in circles",
                         "let steps follow the words: --pulses without --pulse-method; or give G49 before it"));
}

Planned BlockMaker::dwell() {
  left_ = false;
  return wait(move_.dwell_seconds);
}

Planned BlockMaker::wait(double seconds) const {
  PlannedBlock planned;
  planned.block.kind = Block::Kind::dwell;
  planned.block.line = move_.line;
  planned.block.dwell_clocks = std::llround(seconds * static_cast<double>(options_.clock_pps));
  planned.stops = true;
  if (planned.block.dwell_clocks == 0) return std::nullopt;
  return planned;
}

Planned BlockMaker::line_to(const LatticeVector& end, const Part& part) {
  Block block;
  for (std::size_t i = 0; i < end.size(); ++i) block.delta[i] = end[i] - at_[i];
  if (block.delta == LatticeVector{}) return std::nullopt;
  return plan(block, part);
}

/// A line too short for a step takes its time all the same, where that is what is programmed.
Planned BlockMaker::line_or_wait(const LatticeVector& end, const Part& part) {
  const bool is_timed = move_.feed.mode == gcode::Feed::Mode::per_second;
  Planned made = line_to(end, part);
  if (!made && is_timed) made = wait(part.share / move_.feed.value);
  return made;
}

Planned BlockMaker::next_turn() {
  if (closing_) {
    left_ = false;
    return line_to(on_lattice(move_.end, machine_), Part{});
  }
  if (turn_ == 0) {
    if (std::optional<base::Diagnostic> found = arc_problem()) return give_up(std::move(*found));
  }
  const double from = whole_turn * turn_;
  ++turn_;
  const bool is_last = turn_ >= std::abs(move_.turns);
  if (is_last) return turn_to(on_lattice(move_.end, machine_), sweep_ - from);
  LatticeVector end = on_lattice(between(move_.start, move_.end, whole_turn * turn_ / sweep_), machine_);
  for (const base::Axis axis : {gcode::first_axis(move_.plane), gcode::second_axis(move_.plane)}) {
    end[index(axis)] = at_[index(axis)];
  }
  return turn_to(end, whole_turn);
}

Planned BlockMaker::turn_to(const LatticeVector& end, double angle) {
  Block block;
  block.kind = Block::Kind::arc;
  block.first_axis = index(gcode::first_axis(move_.plane));
  block.second_axis = index(gcode::second_axis(move_.plane));
  const double blu = machine_.limits(gcode::first_axis(move_.plane)).blu;
  const double x = move_.start[block.first_axis] - move_.center_first;
  const double y = move_.start[block.second_axis] - move_.center_second;
  const TrueArc arc{move_.center_first / blu, move_.center_second / blu, std::hypot(x, y) / blu, angle,
                    move_.turns > 0 ? pulse::Direction::counterclockwise : pulse::Direction::clockwise};
  const pulse::Point start{at_[block.first_axis], at_[block.second_axis]};
  pulse::Point target{end[block.first_axis], end[block.second_axis]};
  const bool is_last = turn_ >= std::abs(move_.turns);
  if (is_last) left_ = false;
  std::optional<pulse::Arc> placed = on_lattice(arc, start, target);
  if (!placed && is_last && angle > whole_turn / 2) {
    // The ends have changed places: all around, and then to the end.
    TrueArc whole = arc;
    whole.sweep = whole_turn;
    target = start;
    placed = on_lattice(whole, start, start);
    closing_ = left_ = placed.has_value();
  }
  if (!placed) return line_or_wait(end, Part{angle / sweep_});
  for (std::size_t i = 0; i < end.size(); ++i) block.delta[i] = end[i] - at_[i];
  block.delta[block.first_axis] = block.delta[block.second_axis] = 0;
  block.arc = *placed;
  const double share = angle / sweep_;
  const std::size_t normal = index(gcode::normal_axis(move_.plane));
  return plan(block, {share, std::hypot(std::hypot(x, y) * angle, (move_.end[normal] - move_.start[normal]) * share)});
}

Planned BlockMaker::next_chord() {
  if (chords_.piece == chords_.pieces.size()) {
    left_ = false;
    return line_to(on_lattice(move_.end, machine_), Part{});  // nothing, but for a curve of no length
  }
  const geometry::Nurbs& piece = chords_.pieces[chords_.piece];
  const double from = chords_.at;
  chords_.at = chord_end(piece, from, machine_.chord_error);
  const LatticeVector end = on_lattice(piece.evaluate(numeric::DoubleDouble(chords_.at)), machine_);
  const double chord = chords_.at - from;
  if (chords_.at >= piece.length()) {
    ++chords_.piece;
    chords_.at = 0;
  }
  double whole = 0;
  for (const geometry::Nurbs& each : chords_.pieces) whole += each.length();
  Planned planned = line_to(end, {chord / whole, chord, greatest_bend(piece, from, chord)});
  if (planned && *planned) (*planned)->goes_on = chords_.goes_on;
  // A chord without a step leaves the block before where it is.
  chords_.goes_on = chords_.at > 0 && (planned || chords_.goes_on);
  return planned;
}

Planned BlockMaker::plan(Block block, const Part& part) {
  block.line = move_.line;
  if (std::optional<base::Diagnostic> found = register_problem(block)) return give_up(std::move(*found));
  count_commands(block, options_.method, options_.interpolation, tape_);
  base::Result<PlannedBlock> planned = with_words(block, move_, part, machine_, options_);
  if (!planned) return give_up(std::move(planned.error()));
  const LatticeVector delta = whole_delta(block);
  for (std::size_t i = 0; i < delta.size(); ++i) at_[i] += delta[i];
  planned->stops = (move_.is_probing() || move_.path_mode == gcode::PathMode::exact_stop) && !left_;
  planned->from_rest = move_.is_probing();
  return planned;
}

Planned BlockMaker::give_up(base::Diagnostic found) {
  left_ = false;
  at_ = on_lattice(move_.end, machine_);
  return base::failure(std::move(found));
}

std::optional<base::Diagnostic> BlockMaker::arc_problem() const {
  const base::Axis first = gcode::first_axis(move_.plane), second = gcode::second_axis(move_.plane);
  const double first_blu = machine_.limits(first).blu, second_blu = machine_.limits(second).blu;
  if (first_blu == second_blu) return std::nullopt;
  return problem(move_, "pulse-arc-units",
                 std::string("pulses: an arc in ") + base::letter(first) + base::letter(second) +
                     ", whose basic length units are " + gcode::text(first_blu) + " and " + gcode::text(second_blu) +
                     " mm",
                 "give both axes the same unit, or write the arc as lines");
}

std::optional<base::Diagnostic> BlockMaker::register_problem(const Block& block) const {
  const auto beyond = [&](std::int64_t value, std::size_t axis, const char* what) {
    return problem(move_, "pulse-register",
                   std::string("pulses: ") + what + " of " + base::letter(base::all_axes[axis]) + " is " +
                       gcode::text(static_cast<double>(value)) + " basic length units",
                   "registers hold up to 2^30 = 1073741824");
  };
  for (std::size_t i = 0; i < block.delta.size(); ++i) {
    if (pulse::absolute(block.delta[i]) > pulse::greatest_coordinate) return beyond(block.delta[i], i, "the travel");
  }
  if (block.kind != Block::Kind::arc) return std::nullopt;
  for (const pulse::Point at : {block.arc.start, block.arc.end}) {
    if (pulse::absolute(at.x) > pulse::greatest_coordinate) return beyond(at.x, block.first_axis, "the radius");
    if (pulse::absolute(at.y) > pulse::greatest_coordinate) return beyond(at.y, block.second_axis, "the radius");
  }
  return std::nullopt;
}

}  // namespace leadscrew::nc
