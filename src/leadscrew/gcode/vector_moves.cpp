#include <algorithm>
#include <bit>
#include <cmath>
#include <leadscrew/gcode/polar.hpp>
#include <leadscrew/gcode/vector_moves.hpp>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/kinematics/solutions.hpp>
#include <leadscrew/kinematics/transformation.hpp>
#include <utility>

namespace leadscrew::gcode {

namespace {

constexpr std::uint32_t vector_letters = letter_bit('I') | letter_bit('J') | letter_bit('K');
constexpr std::size_t most_kept_events = 4096;
constexpr double least_orientation_tolerance =
    1e-5;  // degrees: within less no path is rounded, nor subdivided more finely

std::uint32_t column_of_vector(const Block& block) {
  const std::uint32_t letters = block.words & vector_letters;
  return letters ? block.column[static_cast<unsigned>(std::countr_zero(letters))] : motion_column(block);
}

kinematics::Vector tip_of(const base::AxisVector& place) {
  return {place[0], place[1], place[2]};
}

}  // namespace

/// In the workpiece; of length 1. Vectors are turned and mirrored as coordinates are, and not scaled. Letters that are not
/// given beside others are 0, without all three the direction stays (Fanuc).
std::optional<VectorMoves::Vector> VectorMoves::direction_of(const Block& block) {
  if (!(block.words & vector_letters)) return direction();
  base::AxisVector along{};
  double greatest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    along[i] = block.value_or(static_cast<char>('I' + i), 0);
    greatest = std::max(greatest, std::fabs(along[i]));
  }
  if (greatest == 0) {
    error("tool-vector", column_of_vector(block), "I, J and K are all 0, which is no direction",
          "the vector from the tool's tip to the spindle, of any length");
    return std::nullopt;
  }
  for (std::size_t i = 0; i < 3; ++i) along[i] /= greatest * std::fabs(frame_.transform().scale[i]);
  return kinematics::unit_vector(tip_of(frame_.direction_to_machine(along)));
}

/// Of the last line.
VectorMoves::Vector VectorMoves::direction() {
  if (!direction_) direction_ = kinematics::direction_of(frame_.tip_control()->chain, angles_at(frame_.position));
  return *direction_;
}

kinematics::Angles<double> VectorMoves::angles_at(const base::AxisVector& place) const {
  const auto& turns = frame_.tip_control()->chain.turns();
  return {place[base::index(turns[0].axis)], place[base::index(turns[1].axis)]};
}

void VectorMoves::begin(const Block& block) {
  direction_.reset();
  if (block.value_or('Q', 0) != 0) {
    error("unsupported-word", block.column_of('Q'),
          "Q of G43.5, by which the tool leans ahead of I J K along its way, is known and not done",
          "vectors that lean so themselves; Q0 is no lean");
  }
  if (frame_.tip_control() && modal_.to_do == Code::none) direction_ = direction_of(block);
}

/// All axes but those that the tool's direction is held by.
void VectorMoves::set_position(const base::AxisVector& place) {
  const kinematics::Angles<double> angles = angles_at(frame_.position);
  frame_.position = place;
  set_angles(angles);
}

void VectorMoves::line(const Block& block) {
  const base::AxisVector target = motion_.target_of(block);
  Feed feed;
  if (modal_.to_do == Code::G1) motion_.feed_of(block, motion_.is_linear(target), block.has('F'), feed);
  const Vector before = direction();
  const Vector direction = direction_of(block).value_or(before);
  const bool turns = direction != before;
  const bool moves = turns || target != frame_.position;
  if (reporter_.failed() || !moves) return set_position(target);
  direction_ = direction;
  const bool is_free = turns && modal_.to_do == Code::G0;
  if (is_free) settle();
  if (!any()) at_ = frame_.position;
  while (outbox_.take(event_)) keep(event_);
  const KeptPlace place = reporter_.place(column_of_vector(block));
  if (!is_open()) {
    run_begin_ = next_number();
    run_begin_line_ = place.line;
  }
  lines_.push_back({target, feed, block.is(Code::G9), place});
  lead(direction, target, is_free);
  set_position(target);
}

/// E of G64, or the machine's.
double VectorMoves::orientation_tolerance() const {
  const bool is_told = modal_.effective_mode == PathMode::blend && modal_.orientation_tolerance > 0;
  return is_told ? modal_.orientation_tolerance : machine_.rotary_chain->orientation_tolerance;
}

/// May lines be rounded together with those of other blocks?
bool VectorMoves::blends() const {
  return modal_.effective_mode == PathMode::blend && modal_.effective_tolerance >= least_rounded &&
         orientation_tolerance() >= least_orientation_tolerance;
}

/// The run goes on to there, or begins.
void VectorMoves::lead(const Vector& direction, const base::AxisVector& target, bool is_free) {
  bool leads = true;
  if (!run_) {
    const kinematics::Chain& chain = frame_.tip_control()->chain;
    kinematics::VectorRunSettings settings;
    settings.blends = blends();
    settings.orientation_tolerance = std::max(orientation_tolerance(), least_orientation_tolerance);
    settings.pole_cone = machine_.rotary_chain->pole_cone;
    run_.emplace(chain, kinematics::limits_of(machine_, chain), settings);
    first_segment_ = next_number() - (is_free ? 0 : 1);
    is_start_open_ = is_free;
    if (is_free) {
      leads = run_->begin_free(tip_of(target), direction, angles_at(frame_.position));
    } else {
      run_->begin_at(tip_of(frame_.position), angles_at(frame_.position));
    }
  }
  if (!is_free) leads = run_->add(tip_of(target), direction);
  if (!leads) return fail();
  collect(false);
}

/// What the run has decided so far.
void VectorMoves::collect(bool is_finished) {
  const std::vector<kinematics::RunVertex> vertices = run_->take();
  if (is_start_open_ && (is_finished || !vertices.empty())) {
    is_start_open_ = false;
    const KeptLine& first = lines_[run_begin_ - taken_lines_];
    parts_.push_back({run_begin_, {tip_of(first.end), run_->start_angles(), 0, 0, false}});
  }
  for (const kinematics::RunVertex& vertex : vertices) parts_.push_back({first_segment_ + vertex.segment, vertex});
  decided_lines_ = is_finished ? next_number() : parts_.empty() ? decided_lines_ : parts_.back().line;
}

void VectorMoves::settle() {
  if (!run_) return;
  if (!run_->finish()) return fail();
  collect(true);
  if (!parts_.empty()) set_angles(parts_.back().vertex.angles);
  run_.reset();
}

/// Nothing comes of the run. What follows begins with angles that hold the tool as the program says, if there are any.
void VectorMoves::fail() {
  const kinematics::VectorRunFailure failure = *run_->failure();
  const std::size_t number =
      std::clamp(first_segment_ + failure.segment, std::max(run_begin_, taken_lines_), next_number() - 1);
  report(failure, lines_[number - taken_lines_].place);
  run_.reset();
  while (next_number() > std::max(run_begin_, taken_lines_)) lines_.pop_back();
  while (!parts_.empty() && parts_.back().line >= run_begin_) parts_.pop_back();
  decided_lines_ = next_number();
  for (KeptEvent& event : events_) event.before = std::min(event.before, decided_lines_);
  const auto found = kinematics::solutions(frame_.tip_control()->chain, *direction_);
  if (found.count > 0) set_angles(found.angles[0]);
}

void VectorMoves::set_angles(const kinematics::Angles<double>& angles) {
  const auto& turns = frame_.tip_control()->chain.turns();
  for (std::size_t i = 0; i < 2; ++i) frame_.position[base::index(turns[i].axis)] = angles[i];
}

void VectorMoves::report(const kinematics::VectorRunFailure& failure, const KeptPlace& place) {
  using Kind = kinematics::VectorRunFailure::Kind;
  const AtKeptPlace there(reporter_, place);
  const std::string from = "the lines from line " + std::to_string(base::number(run_begin_line_));
  switch (failure.kind) {
    case Kind::out_of_reach:
      error("pose-out-of-reach", place.column,
            "no angles of the rotary axes hold the tool so: it would have to turn " + text(failure.miss) +
                " degrees farther",
            "another direction, or another clamping of the workpiece");
      break;
    case Kind::travel:
      error("rotary-travel", place.column,
            std::string("axis ") + base::letter(failure.axis) + " would leave its travel here, whichever way " + from +
                " on are gone",
            "a rapid away from the work to another direction before it, or another clamping of the workpiece");
      break;
    case Kind::pole_too_sharp:
      error("pole-too-sharp", place.column,
            "the line would take more than " + std::to_string(kinematics::VectorRun::most_parts) +
                " parts to keep the tool's direction",
            "a greater E of G64, or lines that pass the pole of the rotary axes farther off");
      break;
    case Kind::opposite:
      error("tool-vector", place.column,
            "the tool is to turn to the opposite direction, and nothing says about which axis",
            "a line to a direction between before it");
      break;
  }
}

void VectorMoves::keep(Move& event) {
  events_.push_back({next_number(), std::move(event)});
  if (events_.size() > most_kept_events) settle();
}

/// Those of which rotary axes have no part in anything, and that leave the modes as they are which moves carry along.
bool VectorMoves::goes_on(const Block& block) const {
  constexpr std::uint32_t groups = bit(Group::motion) | bit(Group::output) | bit(Group::spindle) | bit(Group::coolant) |
                                   bit(Group::overrides) | bit(Group::distance) | bit(Group::call);
  const Code motion = block.has(Group::motion) ? block.code(Group::motion) : modal_.motion;
  return !reporter_.failed() && modal_.is_plain && !modal_.polar && !(block.words & polar_bits) && is_line(motion) &&
         !(block.groups & ~groups) && !block.is(Code::M66) && modal_.feed_mode != FeedMode::per_revolution;
}

}  // namespace leadscrew::gcode
