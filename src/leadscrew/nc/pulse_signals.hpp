#pragma once
// What one interpolator shows at a clock: its registers, what it works out from them to choose the next step, and under
// which names the papers have them.
//
//   "FPGA-based implementation of    coordinates Val_x Val_z, deviation Val_f, its candidates Val_n1 Val_n2 Val_n3,
//   circular interpolation"          remainders Sum_X Sum_Z; its second axis, Z, is Y here: Val_y Sum_Y beside them
//   Koren                            of integrators 1 and 2 the integrand y, the remainder r, the output dz; on a line
//                                    1 moves X and 2 moves Y, on an arc they cross
//
// Arcs by least error have F after each of the three steps that the quadrant allows: n1 after both, n2 after y alone,
// n3 after x alone. The improved method decides by d = 4(d1 − d2), eq. 19: how far beyond the middle of its two
// candidates the circle passes, so that it steps both axes where d ≥ 0 and the short axis grows, where d ≤ 0 and it
// shrinks.

#include <leadscrew/nc/pulse_run.hpp>
#include <vector>

namespace leadscrew::nc {

/// The registers of the run, then n1 n2 n3 and d of the methods that have them; the same ones in the same order at
/// every clock. `curve`: the run's.
Registers signals_of(const PulseRun& run, const PulseCurve& curve);

/// The paper's names of a register, or of the pulse "dx" or "dy"; none where the method's paper has none for it.
std::vector<std::string_view> names_in_paper(std::string_view symbol, PulseMethod method, PulseCurve::Shape shape);

}  // namespace leadscrew::nc
