#pragma once
// `leadscrew pulse`: one line or arc, of a circle or an ellipse, by interpolators of reference pulses, clock by clock.

#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/options.hpp>
#include <leadscrew/console/console.hpp>

namespace leadscrew::cli {

/// Figures as text or JSON, registers as a table or a dump, steps as a picture. `rejected` where the curve is one that
/// no interpolator could make.
Status pulse(const Arguments& arguments, Console& console);

}  // namespace leadscrew::cli
