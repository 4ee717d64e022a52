#include <cmath>
#include <leadscrew/surfaces/hermite.hpp>
#include <leadscrew/surfaces/links.hpp>

namespace leadscrew::surfaces {

std::optional<Pass> link_between(PassLog& log, const PassNode& from, const PassNode& to) {
  double distance = 0;
  for (std::size_t k = 0; k < 3; ++k) distance = std::hypot(distance, to.tip[k][0] - from.tip[k][0]);
  const double length = 2.5 * distance, lift = distance / 2;
  PassNode middle;
  middle.t = length / 2;
  for (std::size_t k = 0; k < 3; ++k) {
    middle.tip[k] = hermite_jet(from.tip[k], to.tip[k], length, 0.5);
    middle.axis[k] = hermite_jet(from.axis[k], to.axis[k], length, 0.5);
  }
  middle.axis = unit_of(middle.axis);
  for (std::size_t k = 0; k < 3; ++k) {
    const double up = lift * middle.axis[k][0];
    middle.tip[k][0] += up;
    middle.tip[k][2] -= 24 * up / (length * length);
  }
  middle.u = (from.u + to.u) / 2;
  middle.v = (from.v + to.v) / 2;
  Pass link;
  link.nodes = {from, middle, to};
  link.nodes.front().t = 0;
  link.nodes.back().t = length;
  link.is_link = true;
  link.number = log.number;
  return link;
}

}  // namespace leadscrew::surfaces
