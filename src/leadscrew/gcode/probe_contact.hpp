#pragma once
// Where along a line the simulated probe (machine::Probe) comes into contact, or loses it.
//
//     material = (planes ∪ boxes ∪ spheres ∪ cylinders ∪ patches) \ (pockets ∪ bores)
//
//     start ───o──────x━━━━━━━x──────x━━━━━━━━━x───── target      each x: a face of some body, in closed form;
//                     enters  leaves                              between two of them the state is one
//
// Patches have no thickness: between two faces the line is asked where it first meets one (patch_meeting.hpp).
//
// A line that touches a body in one point, or passes less of it than 4e-9 mm, passes by.

#include <leadscrew/base/axes.hpp>
#include <leadscrew/machine/probe.hpp>
#include <optional>
#include <vector>

namespace leadscrew::gcode {

/// Nearer than this to what it touches the probe is in contact, mm: places on planes of a tool with an offset are rounded.
inline constexpr double contact_rounding = 1e-9;

/// The bodies of a probe, for positions of axes with a tool's offset.
class ProbeContact {
 public:
  /// The probe must outlive it. `tool`: the offset in force, mm and degrees.
  ProbeContact(const machine::Probe& probe, const base::AxisVector& tool) : probe_(probe), tool_(tool) {}

  /// Do axes that stand there touch?
  bool touches(const base::AxisVector& position) const;

  /// Where on the line from `start` to `target` the probe first is in contact, or out of it, seen from the other state. Empty
  /// where that is so nowhere. On faces across an axis that axis' coordinate is exact, elsewhere within rounding.
  /// `left`: the way, of any length, by which contact was lost where the line starts; none: it was not. The probe then stands
  /// free on that side of what it left, and meets that only where the line leads back.
  std::optional<base::AxisVector> contact(const base::AxisVector& start, const base::AxisVector& target,
                                          const base::AxisVector& left = {}) const;
  /// The same for its loss; at the target alone it is none.
  std::optional<base::AxisVector> loss(const base::AxisVector& start, const base::AxisVector& target) const;

 private:
  /// A face that the line crosses.
  struct Crossing {
    double share = 0;                     // of the line, 0 … 1
    std::size_t axis = base::axis_count;  // across which it lies, where it is across one
    double coordinate = 0;                // of that axis, machine coordinates
  };
  /// From start to target, X, Y and Z of the controlled point first.
  struct Line {
    base::AxisVector start, target;
  };

  /// How far a point is outside of planes and solid bodies, and inside of what is cut out, mm.
  struct Gap {
    double material = 0, cut = 0;
  };
  Gap gap(const base::AxisVector& position) const;
  std::optional<double> patch_between(const Line& line, double begin, double end) const;
  std::optional<base::AxisVector> change(const Line& line, const Line& beside, bool to_contact) const;
  std::vector<Crossing> crossings(const Line& line) const;
  void cross_plane(const Line& line, std::size_t axis, double plane, std::vector<Crossing>& found) const;
  void cross_body(const Line& line, const machine::ProbeBody& body, std::vector<Crossing>& found) const;
  base::AxisVector at(const Line& line, double share) const;

  const machine::Probe& probe_;
  base::AxisVector tool_;
};

}  // namespace leadscrew::gcode
