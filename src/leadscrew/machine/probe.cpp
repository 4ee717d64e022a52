#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/machine/fields.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/probe.hpp>
#include <string>

namespace leadscrew::machine {

void check_probe(const Machine& machine, std::vector<base::Diagnostic>& problems) {
  for (const base::Axis axis : base::all_axes) {
    const std::optional<double>& plane = machine.probe->planes[base::index(axis)];
    if (!plane || (machine.has(axis) && !base::is_rotary(axis) && std::isfinite(*plane))) continue;
    const std::string whole = std::string("the probe's plane ") + base::letter(axis) + " = " + base::text(*plane);
    const base::Subject subject{.axis = axis, .field = field::probe_plane};
    if (!machine.has(axis)) {
      problems.push_back(base::problem("machine-probe", whole + ", but there is no such axis",
                                       "give planes for axes of the machine", subject));
    } else {
      problems.push_back(base::problem(
          "machine-probe", whole, "mm in machine coordinates, of a linear axis, such as plane_mm = {Z = -3}", subject));
    }
  }
}

}  // namespace leadscrew::machine
