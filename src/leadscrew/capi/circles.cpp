// The calls of leadscrew.h for places of a circle by integration, a step a period.

#include <cmath>
#include <leadscrew/nc/circle_steps.hpp>

#include "calls.hpp"

using namespace leadscrew;
using namespace leadscrew::capi;

int leadscrew_circle_places(int rule, double angle, const double* start, double* places, size_t count,
                            leadscrew_error* error) {
  if (start == nullptr || places == nullptr || count == 0) return misuse(error, "the start or the places are NULL");
  if (rule < 0 || rule > LEADSCREW_STATE_TRANSITION) return misuse(error, "no rule of circles has this number");
  if (!std::isfinite(angle)) return misuse(error, "the angle is no number");
  nc::CirclePoint<double> at{start[0], start[1]};
  for (size_t i = 0; i < count; ++i) {
    places[2 * i] = at.x;
    places[2 * i + 1] = at.y;
    at = nc::step_by(nc::all_circle_rules[static_cast<size_t>(rule)], at, angle);
  }
  return LEADSCREW_OK;
}
