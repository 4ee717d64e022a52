#include <algorithm>
#include <bit>
#include <cmath>
#include <leadscrew/gcode/curve_through.hpp>
#include <leadscrew/gcode/directed_curve.hpp>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/kinematics/solutions.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/surfaces/touch.hpp>
#include <utility>

namespace leadscrew::gcode {

namespace {

using PathJet = surfaces::PassNode::Jet;

constexpr int most_places_of_path = 1000;
constexpr double least_distance_of_places = 1e-6;  // mm
constexpr std::uint32_t direction_letters = letter_bit('I') | letter_bit('J') | letter_bit('K');
constexpr std::uint32_t place_letters = letter_bit('X') | letter_bit('Y') | letter_bit('Z');

/// By de Boor's algorithm on jets (Piegl and Tiller, eq. 5.15): the first six coordinates, with two derivatives.
std::array<PathJet, 6> jets_at(const NurbsCurve& curve, double u) {
  const auto p = static_cast<std::size_t>(curve.degree);
  const auto begin = curve.knots.begin() + static_cast<std::ptrdiff_t>(p) + 1,
             end = curve.knots.begin() + static_cast<std::ptrdiff_t>(curve.points.size());
  const auto span = static_cast<std::size_t>(std::upper_bound(begin, end, u) - curve.knots.begin()) - 1;
  std::array<std::array<PathJet, 6>, highest_degree + 1> row;
  for (std::size_t k = 0; k <= p; ++k) {
    for (std::size_t q = 0; q < 6; ++q) row[k][q] = curve.points[span - p + k].position[q];
  }
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t k = p; k >= r; --k) {
      const std::size_t i = span - p + k;
      const double from = curve.knots[i], width = curve.knots[i + p - r + 1] - from;
      const PathJet alpha = (PathJet::parameter(u) - PathJet(from)) / PathJet(width);
      for (std::size_t q = 0; q < 6; ++q) row[k][q] = row[k - 1][q] + alpha * (row[k][q] - row[k - 1][q]);
    }
  }
  return row[p];
}

double distance_of(const base::AxisVector& a, const base::AxisVector& b) {
  return numeric::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

bool DirectedCurve::problem(std::string_view code, std::uint32_t column, std::string message, std::string hint) {
  if (std::exchange(draft_->spoiled, true)) return reporter_.fail();
  return error(code, column, std::move(message), std::move(hint));
}

void DirectedCurve::begin(const Block& block) {
  draft_ = Draft();
  draft_->block = block;
  draft_->place = reporter_.place(block.column_of(Group::nonmodal));
  const std::optional<int> count = as_integer(block.value_or('P', 0));
  if (count && 1 <= *count && *count <= most_places_of_path) {
    draft_->count = static_cast<std::size_t>(*count);
  } else if (block.has('P')) {
    error("surface-counts", block.column_of('P'), "the curve has P" + text(block['P']) + " places",
          "an integer from 1 to " + std::to_string(most_places_of_path) + ": as many blocks of places follow");
  }
  if (modal_.feed_mode == FeedMode::inverse_time) {
    error("bad-feed-mode", block.column_of(Group::nonmodal), "G6.6 in G93", "give G94");
  } else {
    motion_.feed_of(block, true, block.has('F'), feed_);
  }
  reporter_.keep(block.column_of(Group::nonmodal));
  draft_->spoiled = reporter_.failed();
  draft_->places.push_back(frame_.position);
  surfaces::Vector direction{0, 0, 1};
  if (const auto* const control = frame_.tip_control()) {
    const auto angles = kinematics::angles_of(control->chain, kinematics::Coordinates<double>(frame_.position));
    direction = kinematics::direction_of(control->chain, angles);
  }
  draft_->directions.push_back(direction);
  modal_.is_plain = false;
}

bool DirectedCurve::add(const Block& block) {
  constexpr std::uint32_t number = letter_bit('N');
  if (reporter_.failed()) draft_->spoiled = true;
  const bool is_place = block.groups == 0 && (block.words & (place_letters | direction_letters)) &&
                        !(block.words & ~(place_letters | direction_letters | number));
  if (!is_place && block.groups == 0 && !(block.words & ~number)) return true;
  if (!is_place) {
    const Draft draft = *std::exchange(draft_, std::nullopt);
    if (draft.spoiled) return false;
    error("unfinished-curve", block.first_column,
          "the curve of line " + std::to_string(base::number(draft.place.line)) + " has " +
              std::to_string(draft.blocks) + " of its " + std::to_string(draft.count) + " places",
          "between G6.6 and its last place there are only places: X Y Z, and I J K");
    return false;
  }
  ++draft_->blocks;
  if (!draft_->spoiled) add_place(block);
  if (reporter_.failed()) draft_->spoiled = true;
  if (draft_->count > 0 && draft_->blocks == draft_->count) finish();
  return true;
}

/// As the frame turns it; none where it is no direction.
std::optional<surfaces::Vector> DirectedCurve::direction_of(const Block& block) {
  base::AxisVector along{};
  double greatest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    along[i] = block.value_or(static_cast<char>('I' + i), 0);
    greatest = std::max(greatest, std::fabs(along[i]));
  }
  const std::uint32_t column = block.column[static_cast<unsigned>(std::countr_zero(block.words & direction_letters))];
  if (!frame_.tip_control()) {
    problem("surface-needs-tip-control", column, "a direction of the tool while tool centre point control is off",
            "G43.4 before it, on a machine with two rotary axes; without I, J and K the tool keeps its direction");
    return std::nullopt;
  }
  if (greatest == 0) {
    problem("tool-vector", column, "I, J and K are all 0, which is no direction",
            "the vector from the tool's tip to the spindle, of any length");
    return std::nullopt;
  }
  for (std::size_t i = 0; i < 3; ++i) along[i] /= greatest * std::fabs(frame_.transform().scale[i]);
  const base::AxisVector turned = frame_.direction_to_machine(along);
  return kinematics::unit_vector({turned[0], turned[1], turned[2]});
}

void DirectedCurve::add_place(const Block& block) {
  Draft& draft = *draft_;
  const base::AxisVector before = draft.places.back();
  Block in_axes = block;
  if (modal_.diameters && block.has('X')) in_axes.value['X' - 'A'] /= 2;
  const base::AxisVector place = motion_.target_of(in_axes, before);
  surfaces::Vector direction = draft.directions.back();
  if (block.words & direction_letters) {
    const auto told = direction_of(block);
    if (!told) return;
    const double cosine = surfaces::dot_of(*told, direction);
    if (cosine < -0.5) {
      problem("tool-vector", block.first_column, "the tool turns by more than 120 degrees from place to place",
              "a place between them");
      return;
    }
    direction = *told;
    draft.turns = true;
  }
  if (distance_of(place, before) < least_distance_of_places) {
    problem("curve-place", block.first_column, "this place of the curve is the one before", "the tip goes on");
    return;
  }
  draft.places.push_back(place);
  draft.directions.push_back(direction);
}

/// Nodes at the places.
surfaces::Pass DirectedCurve::nodes_of(const Draft& draft) const {
  std::vector<double> parameters{0};
  std::vector<base::AxisVector> places;
  for (std::size_t k = 0; k < draft.places.size(); ++k) {
    if (k > 0) parameters.push_back(parameters.back() + distance_of(draft.places[k - 1], draft.places[k]));
    base::AxisVector& place = places.emplace_back(draft.places[k]);
    for (std::size_t i = 0; i < 3; ++i) place[3 + i] = draft.directions[k][i];
  }
  NurbsCurve through;
  make_curve_through(through, parameters, places);
  surfaces::Pass pass;
  for (const double t : parameters) {
    const std::array<PathJet, 6> jets = jets_at(through, t);
    surfaces::PassNode& node = pass.nodes.emplace_back();
    node.t = t;
    node.tip = {jets[0], jets[1], jets[2]};
    node.axis = surfaces::unit_of(surfaces::VectorOf<PathJet>{jets[3], jets[4], jets[5]});
  }
  return pass;
}

/// From the angles that the rotary axes have, on the side that is theirs.
void DirectedCurve::hold_tool() {
  const kinematics::Chain& chain = frame_.tip_control()->chain;
  const auto angles = kinematics::angles_of(chain, kinematics::Coordinates<double>(frame_.position));
  const auto found = kinematics::solutions(chain, kinematics::direction_of(chain, angles));
  const auto apart = [&](std::size_t side) {
    return std::abs(std::remainder(found.angles[side][0] - angles[0], 360)) +
           std::abs(std::remainder(found.angles[side][1] - angles[1], 360));
  };
  curves_.path().follow(chain, found.count == 2 && apart(1) < apart(0) ? 1 : 0, angles);
}

void DirectedCurve::finish() {
  const Draft draft = *std::exchange(draft_, std::nullopt);
  if (draft.spoiled || reporter_.failed()) {
    frame_.position = draft.places.back();
    reporter_.fail();
    return;
  }
  block_ = draft.block;
  place_ = draft.place;
  curves_.path().stand();
  if (draft.turns) hold_tool();
  if (const auto failure = curves_.path().load(nodes_of(draft))) {
    const AtKeptPlace there(reporter_, draft.place);
    if (failure->kind == PoseFailure::Kind::out_of_reach) {
      error("pose-out-of-reach", draft.place.column,
            "no angles of the rotary axes hold the tool along the curve: it would have to turn " + text(failure->miss) +
                " degrees farther",
            "other directions, or another clamping of the workpiece");
    } else {
      error("surface-pole", draft.place.column,
            "the tool passes a pole of the rotary axes so near that none can follow", "other directions");
    }
  }
}

bool DirectedCurve::next(Move& move) {
  const AtKeptPlace there(reporter_, place_);
  if (curves_.path().any() && curves_.take(block_, place_.line, feed_, false, move)) return true;
  abandon();
  return false;
}

void DirectedCurve::end() {
  if (!draft_) return;
  const Draft draft = *std::exchange(draft_, std::nullopt);
  if (draft.spoiled) return;
  const AtKeptPlace there(reporter_, draft.place);
  error("unfinished-curve", draft.place.column, "the text ends before the curve has all of its places",
        "as many blocks of X Y Z, and I J K, as P");
}

}  // namespace leadscrew::gcode
