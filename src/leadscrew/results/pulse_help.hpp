#pragma once
// Examples of `leadscrew pulse`, and the columns of its table, as people read of them.

#include <string_view>

namespace leadscrew::results {

inline constexpr std::string_view pulse_help =
    "Examples:\n"
    "  leadscrew pulse --arc --start 5,0 --end 0,5 --center 0,0 --ccw --method dda\n"
    "  leadscrew pulse --arc --start 25,0 --end 25,0 --cw --svg circle.svg --vcd circle.vcd\n"
    "  leadscrew pulse --line --end 11,-7 --method dda,bresenham --bits 4 --table\n"
    "  leadscrew pulse --ellipse 12,7 --start 12,0 --end 0,-7 --cw --table\n"
    "\n"
    "Integers are BLU. A full circle ends where it starts. Each method's conventions are by default those with which "
    "it\n"
    "gives its published figures; --json names all that were in force.\n"
    "\n"
    "Columns of --table: x y from the centre or a line's start, F the deviation; n1 n2 n3 what F would be after a "
    "step\n"
    "of both axes, of y, of x; d = 4(d1 - d2) of improved-min-error; Jx Jy integrands, rx ry remainders, nx ny steps\n"
    "left, n clocks left with --free, q the capacity. Of an ellipse r and q are taken so many times that all are "
    "whole.\n"
    "--vcd has them under the papers' names too, and says which is which: rst Val_z Val_f Val_n1\n"
    "Sum_Z and, for koren, y1 r1 dz1.\n";

}  // namespace leadscrew::results
