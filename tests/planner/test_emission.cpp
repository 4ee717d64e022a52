#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <leadscrew/planner/emission.hpp>
#include <leadscrew/planner/limit_ratios.hpp>
#include <leadscrew/planner/proof.hpp>
#include <memory>
#include <random_numbers.hpp>
#include <trunnion.hpp>

#include "random_section.hpp"

// The proof that a motion keeps its limits, against every thousandth of it.

namespace test_emission {

using namespace leadscrew;
using testing_support::any;
using testing_support::logarithmic;

/// A cubic B-spline of so many coordinates: its third derivative jumps at every knot.
planner::Section cubic_spline(std::size_t coordinates = 3) {
  geometry::NurbsForm form;
  form.degree = 3;
  const int points = any(6, 12);
  for (int k = 0; k < points; ++k) {
    geometry::Point point{};
    point[0] = 5 * k;
    for (std::size_t i = 1; i < coordinates; ++i) point[i] = any(-500, 501) / 100.0;
    form.points.push_back(point);
    form.weights.push_back(1);
  }
  for (int k = 0; k < points + 4; ++k) form.knots.push_back(std::clamp(k - 3, 0, points - 3));
  planner::Section section;
  for (const geometry::Nurbs& piece : geometry::smooth_pieces(form)) section.append({piece, 100, {}});
  return section;
}

/// A transformation of a table that tilts and turns, or none.
std::shared_ptr<const kinematics::Transformation> any_transformation() {
  if (any(0, 2) == 0) return nullptr;
  const kinematics::Vector tool = {any(-20, 21) / 10.0, 0, any(0, 1000) / 10.0};
  return std::make_shared<const kinematics::Transformation>(kinematics::chain_of(testing_support::trunnion()), tool);
}

/// Two places seen at once are what each is alone, to the last bit, on either side of a knot.
RC_GTEST_PROP(SeenPlaces, AreTwoPlaces, ()) {
  toolpath::Piece piece = cubic_spline(any(3, 6)).piece(0);
  piece.transformation = any_transformation();
  if (piece.transformation && any(0, 2) == 0) piece.feed_axes = toolpath::FeedAxes::xyz;
  const std::span<const double> breaks = piece.axes().breaks();
  const double first = breaks.empty() ? 0 : breaks[0], second = piece.axes().length() * any(0, 1001) / 1000.0;
  for (const planner::Side side : {planner::Side::left, planner::Side::right}) {
    const planner::SeenPlaces both = planner::seen_places(piece, first, side, second, planner::Side::left);
    const planner::SeenPlace alone[] = {planner::seen_place_without_chords(piece, first, side),
                                        planner::seen_place_without_chords(piece, second, planner::Side::left)};
    for (const std::size_t lane : {0, 1}) {
      RC_ASSERT(both.speed[lane] == alone[lane].speed);
      RC_ASSERT((planner::turns(both.jet)[lane] != 0) == planner::turns(alone[lane].jet));
      for (std::size_t i = 0; i < both.jet.size(); ++i) {
        for (const std::size_t order : {0, 1, 2, 3}) RC_ASSERT(both.jet[i][order][lane] == alone[lane].jet[i][order]);
      }
    }
  }
}

/// A stop may pass knots at which the third derivative jumps, anywhere between the places that the proof looks at.
RC_GTEST_PROP(Proof, SeesJumpsOfTheThirdDerivative, ()) {
  const planner::Section section = cubic_spline();
  machine::Machine machine = testing_support::random_machine();
  const constraints::Constraints constraints(machine);
  planner::PathState from;
  from.s = section.length() * any(0, 800) / 1000.0;
  from.speed = logarithmic(1, 100);
  const double longest = 2 * (section.length() - from.s) / from.speed;
  const planner::Segment stop = planner::stop_within(from, longest * any(100, 950) / 1000.0);
  constraints::LimitRatios seen;
  constexpr int parts = 1000;
  for (int k = 0; k <= parts; ++k) {
    const planner::PathState at = planner::evaluate(stop, stop.duration.value() * k / parts);
    for (const planner::Side side : {planner::Side::left, planner::Side::right})
      constraints.raise({section.jets(at.s, side), 1e300}, planner::rates(at), seen);
  }
  // On a machine whose limits it just reaches, where what lies between samples counts.
  const machine::Derivatives greatest = seen.by_derivative();
  const double ratio = std::max(greatest.acceleration, greatest.jerk);
  for (auto& limits : machine.axes) {
    if (limits) limits->acceleration *= ratio, limits->jerk *= ratio;
  }
  const planner::Ratios proven =
      planner::greatest_ratios(stop, section, constraints::Constraints(machine), 1e300, planner::stop_looks);
  RC_ASSERT(proven.rows >= 1 - 1e-3);
}

}  // namespace test_emission
