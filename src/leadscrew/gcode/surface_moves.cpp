#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/rotary_lift.hpp>
#include <leadscrew/gcode/surface_moves.hpp>
#include <utility>

namespace leadscrew::gcode {

namespace {

constexpr std::size_t z_axis = base::index(base::Axis::Z);
constexpr double level_rounding = 1e-9;  // mm
/// Cosine, of the angle between the tool and the program's Z, below which it lies flat; how far such a tool goes along itself, of its
/// diameter.
constexpr double least_rise = 0.3, flat_way = 2;

surfaces::Vector axis_of_node(const surfaces::PassNode& node) {
  return {node.axis[0][0], node.axis[1][0], node.axis[2][0]};
}

/// The next of these passes, which the source hands out if there is one.
std::optional<surfaces::Pass> next_of(surfaces::Passes& passes, const std::unique_ptr<surfaces::PassSource>& source) {
  return source ? source->next() : passes.next();
}

}  // namespace

void SurfaceMoves::take_passes(surfaces::Passes passes) {
  source_.reset();
  passes_ = std::move(passes);
  if (options_.pass_source) source_ = options_.pass_source(*passes_);
}

std::string SurfaceMoves::where(double u, double v) const {
  return " of surface " + std::to_string(machined_->number) + ", u " + text(u) + ", v " + text(v);
}

bool SurfaceMoves::report(const surfaces::PassFailure& failure) {
  using Kind = surfaces::PassFailure::Kind;
  const std::string place = "pass " + std::to_string(passes_ ? passes_->count() + 1 : 1) + where(failure.u, failure.v);
  const auto problem = [&](std::string_view code, const std::string& message, std::string hint) {
    return error(code, column(), place + ": " + message, std::move(hint));
  };
  switch (failure.kind) {
    case Kind::normal:
      return problem("surface-normal", "the surface has no normal", "a range U V I J that leaves the place out");
    case Kind::gouge:
      return problem("surface-gouge",
                     "the tool gouges beside its contact: the surface bends by " + text(-failure.amount) +
                         " / mm more than the tool",
                     "a smaller tool, or another lead or tilt");
    case Kind::flat_contact:
      return problem("surface-flat-contact", "the tool stands on the surface with all of its bottom",
                     "a lead A, or a ball");
    case Kind::overhang:
      return problem(
          "surface-overhang", "the tool's direction points into the surface",
          "R-1 for the other side, A and B so that the tool follows the surface, or a range without the place");
    case Kind::edge:
      return problem("surface-edge", "the surface has an edge, where the tool would leap",
                     "a surface for each side of it");
    case Kind::cusp:
      return problem("surface-cusp",
                     "the tip stands still while the contact moves: the tool is as round as the surface",
                     "a smaller tool, or another lead or tilt");
    case Kind::too_many:
      return problem("surface-passes",
                     "there would be " + text(failure.amount) + " passes, or more places of one, than there may be",
                     "a greater H or Q");
    case Kind::no_step:
      return problem("surface-step", "no step leaves ridges so low", "a greater H, or a smaller tool");
    case Kind::section:
      return problem("surface-section", "planes of this direction meet the surface in lines that double back",
                     "the other direction L, another pattern S, or a smaller range U V I J");
    case Kind::link:
      return problem("surface-link", "no way was found to the next pass that keeps off the surface",
                     "another pattern S, or a smaller range");
  }
  return false;
}

bool SurfaceMoves::report(const PoseFailure& failure) {
  const std::string place = "pass " + std::to_string(curves_.path().number() + 1) + where(failure.u, failure.v);
  if (failure.kind == PoseFailure::Kind::out_of_reach) {
    return error("pose-out-of-reach", column(),
                 place + ": no angles of the rotary axes hold the tool so, it would have to turn " +
                     text(failure.miss) + " degrees farther",
                 "another lead or tilt, or another clamping of the workpiece");
  }
  return error("surface-pole", column(),
               place + ": the tool passes a pole of the rotary axes so near that none can follow",
               "another lead or tilt, or another clamping of the workpiece");
}

/// The level of the program's Z that the tool approaches at.
void SurfaceMoves::set_clearance() {
  clearance_ = level_of(frame_.position);
  if (!block_.has('Z')) return;
  const double told = block_['Z'] * frame_.length_unit;
  clearance_ = modal_.distance == Distance::incremental ? clearance_ + told : told;
}

double SurfaceMoves::level_of(const base::AxisVector& place) const {
  return frame_.to_program(place)[z_axis];
}

base::AxisVector SurfaceMoves::at_level(const base::AxisVector& place, double level) const {
  base::AxisVector program = frame_.to_program(place);
  program[z_axis] = level;
  const base::AxisVector there = frame_.to_machine(program);
  base::AxisVector result = place;
  for (std::size_t i = 0; i < 3; ++i) result[i] = there[i];
  return result;
}

void SurfaceMoves::begin(const Block& block) {
  abandon();
  block_ = block;
  machined_ = words_.read(block);
  at_contact_ = as_integer(block.value_or('K', 2)) == 1;
  if (block.has('K') && !at_contact_ && as_integer(block['K']) != 2)
    error("bad-value", block.column_of('K'), "K is " + text(block['K']), "1: feed of the contact, 2: of the tip");
  if (modal_.feed_mode == FeedMode::inverse_time)
    error("bad-feed-mode", column(), "G6.5 in G93", "give G94");
  else
    motion_.feed_of(block, true, block.has('F'), feed_);
  if (!machined_ || reporter_.failed()) return;
  set_clearance();
  if (!choose_angles()) return;
  std::optional<surfaces::Pass> first = next_of(*passes_, source_);
  if (!first) {
    if (passes_->failure()) report(*passes_->failure());
    return;
  }
  const surfaces::PassNode node = first->nodes.front();
  if (load(std::move(*first))) plan_approach(node);
}

/// Rotary axes stand, or begin where all of the surface is inside their travel: then there are passes.
bool SurfaceMoves::choose_angles() {
  curves_.path().stand();
  if (machined_->machining.orientation.rule == surfaces::Orientation::Rule::fixed) {
    take_passes(surfaces::Passes(machined_->machining));
    return true;
  }
  const kinematics::Chain& chain = frame_.tip_control()->chain;
  const auto& turns = chain.turns();
  const SurfaceDraftKey key{machined_->machining,
                            chain,
                            kinematics::limits_of(machine_, chain),
                            {frame_.position[base::index(turns[0].axis)], frame_.position[base::index(turns[1].axis)]}};
  std::optional<SurfaceDraft> draft = options_.surface_drafts ? options_.surface_drafts->find(key) : std::nullopt;
  if (!draft) {
    draft = draft_of(key);
    if (!draft) return false;
    if (options_.surface_drafts) options_.surface_drafts->keep(key, *draft);
  }
  curves_.path().follow(chain, draft->choice.side, draft->choice.start);
  take_passes(surfaces::Passes(machined_->machining, draft->lines));
  return true;
}

/// None where it cannot be, which is reported.
std::optional<SurfaceDraft> SurfaceMoves::draft_of(const SurfaceDraftKey& key) {
  RotaryLift lift(key.chain, key.limits, key.before);
  surfaces::Machining machining = key.machining;
  machining.is_draft = true;
  surfaces::Passes passes(std::move(machining));
  std::unique_ptr<surfaces::PassSource> source = options_.pass_source ? options_.pass_source(passes) : nullptr;
  while (const auto pass = next_of(passes, source)) {
    if (!lift.add(*pass)) {
      error("pose-out-of-reach", column(),
            "pass " + std::to_string(pass->number + 1) + where(lift.place()[0], lift.place()[1]) +
                ": no angles of the rotary axes hold the tool so, it would have to turn " + text(lift.miss()) +
                " degrees farther",
            "another lead or tilt, or another clamping of the workpiece");
      return std::nullopt;
    }
  }
  if (passes.failure()) {
    source.reset();
    passes_ = std::move(passes);
    report(*passes_->failure());
    passes_.reset();
    return std::nullopt;
  }
  const auto choice = lift.best();
  if (!choice) {
    error("rotary-travel", column(),
          std::string("axis ") + base::letter(lift.lost_axis()) +
              " would leave its travel on the surface, wherever it begins",
          "another lead or tilt, pattern, or clamping of the workpiece");
    return std::nullopt;
  }
  return SurfaceDraft{*choice, passes.found_lines()};
}

bool SurfaceMoves::load(surfaces::Pass pass) {
  axis_ = axis_of_node(pass.nodes.back());
  const auto failure = curves_.path().load(std::move(pass));
  return !failure || report(*failure);
}

/// From a place of the surface to the clearance: along the tool, and what then is left.
bool SurfaceMoves::plan_rise(const base::AxisVector& place, const surfaces::Vector& axis,
                             std::vector<base::AxisVector>& rise) {
  const double level = level_of(place);
  if (!(level < clearance_ - level_rounding)) {
    return error("surface-clearance", block_.has('Z') ? block_.column_of('Z') : column(),
                 "the clearance is at Z " + text(clearance_) + " mm, and the tool's tip on the surface at " +
                     text(level) + " mm",
                 "Z above the surface");
  }
  base::AxisVector ahead = place;
  for (std::size_t i = 0; i < 3; ++i) ahead[i] += axis[i];
  const double rate = level_of(ahead) - level;
  const bool is_flat = rate < least_rise;
  double way = is_flat ? flat_way * machined_->tool.diameter : (clearance_ - level) / rate;
  if (is_flat && rate > 0) way = std::min(way, (clearance_ - level) / rate);
  for (std::size_t i = 0; i < 3; ++i) ahead[i] = place[i] + way * axis[i];
  rise.push_back(is_flat ? ahead : at_level(ahead, clearance_));
  if (is_flat && level_of(ahead) < clearance_ - level_rounding) rise.push_back(at_level(ahead, clearance_));
  return true;
}

bool SurfaceMoves::plan_approach(const surfaces::PassNode& first) {
  base::AxisVector place = frame_.position;
  for (std::size_t i = 0; i < 3; ++i) place[i] = first.tip[i][0];
  curves_.path().set_angles(place);
  std::vector<base::AxisVector> rise;
  if (!plan_rise(place, axis_of_node(first), rise)) return false;
  legs_.push_back({place, false});
  for (std::size_t k = 0; k + 1 < rise.size(); ++k) legs_.push_back({rise[k], false});
  legs_.push_back({rise.back(), true});
  if (level_of(frame_.position) < clearance_ - level_rounding)
    legs_.push_back({at_level(frame_.position, clearance_), true});
  return true;
}

bool SurfaceMoves::plan_retract() {
  std::vector<base::AxisVector> rise;
  is_retracting_ = true;
  source_.reset();
  passes_.reset();
  if (!plan_rise(frame_.position, axis_, rise)) return false;
  for (std::size_t k = rise.size(); k-- > 0;) legs_.push_back({rise[k], true});
  return true;
}

/// To the next pass or link, or up again.
bool SurfaceMoves::go_on() {
  if (std::optional<surfaces::Pass> pass = next_of(*passes_, source_)) return load(std::move(*pass));
  if (passes_->failure()) return report(*passes_->failure());
  return plan_retract();
}

bool SurfaceMoves::next(Move& move) {
  while (!reporter_.failed()) {
    if (!legs_.empty()) {
      if (take_leg(move)) return true;
    } else if (curves_.path().any()) {
      return take_curve(move) || stop();
    } else if (!passes_ || !go_on()) {
      break;
    }
  }
  return stop();
}

bool SurfaceMoves::stop() {
  if (reporter_.failed()) travel_.note_outside();
  abandon();
  return false;
}

void SurfaceMoves::abandon() {
  source_.reset();
  passes_.reset();
  curves_.path().clear();
  legs_.clear();
  is_retracting_ = false;
  machined_.reset();
  moved_ = {};
}

/// False where it has no length, or leaves travel.
bool SurfaceMoves::take_leg(Move& move) {
  const Leg leg = legs_.back();
  legs_.pop_back();
  if (leg.end == frame_.position || !travel_.inside_travel(block_, leg.end)) return false;
  outbox_.prepare(move, Move::Kind::line, modal_.line);
  if (!leg.is_rapid) move.feed = feed_;
  move.end = frame_.position = leg.end;
  moved_ = {machined_, is_retracting_ ? MachinedMove::Part::retract : MachinedMove::Part::approach,
            curves_.path().number()};
  return true;
}

bool SurfaceMoves::take_curve(Move& move) {
  const PosePath& path = curves_.path();
  moved_ = {machined_, path.is_link() ? MachinedMove::Part::link : MachinedMove::Part::pass, path.number()};
  return curves_.take(block_, modal_.line, feed_, at_contact_, move);
}

}  // namespace leadscrew::gcode
