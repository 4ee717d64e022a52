#pragma once
// The keys of [axis.X.drive] as people read of them.

#include <string_view>

namespace leadscrew::config {

inline constexpr std::string_view drive_help =
    "Drives are told in the machine file; what is left out has the value in brackets, deg stands for mm in rotary "
    "axes:\n"
    "  [axis.X.drive]\n"
    "  controller = \"cascade\"          # position and velocity loop around a motor fed with a current, or \"pid\": "
    "one\n"
    "                                  # loop around a drive with a velocity loop of its own [cascade]\n"
    "  velocity_gain_per_s = 200       # cascade: mm/s2 for each mm/s that is missing [200, at most 0.3/period]\n"
    "  position_gain_per_s = 40        # Kv [a fifth of the velocity gain]\n"
    "  velocity_integral_per_s2 = 0    # [0]\n"
    "  max_acceleration_mm_s2 = 2000   # that its torque gives [twice the axis' own]\n"
    "  damping_per_s = 0               # viscous friction over inertia [0]\n"
    "  gain_mm_s = 10                  # pid: speed for one unit of command [10]\n"
    "  time_constant_ms = 20           # of the drive [20]\n"
    "  proportional_per_mm = 1.25      # P, I, D of u = P e + I T sum(e) + D (e - last e) [1/(4 gain time constant), "
    "0, 0]\n"
    "  integral_per_mm_s = 0\n"
    "  derivative_per_mm = 0\n"
    "  command_limit = 24              # units [none]\n"
    "  velocity_forward = 1            # both: share of velocity fed forward, 0 ... 1 [1]\n"
    "  acceleration_forward = 1        # and of acceleration [1]\n"
    "  friction_mm_s2 = 0              # Coulomb's, as the acceleration it takes [0]\n"
    "  breakaway_mm_s2 = 0             # to move what stands [as friction]\n"
    "  encoder_counts_per_mm = 1000    # [one a BLU]\n"
    "  encoder = \"screw\"               # or \"slide\" [screw]\n"
    "The play between screw and slide is backlash_mm of [axis.X].\n";

}  // namespace leadscrew::config
