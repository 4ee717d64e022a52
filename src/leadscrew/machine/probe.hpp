#pragma once
// A simulated touch probe: in contact wherever the controlled point is at or below a plane of an axis, or in or on a body
// that stands on the machine, or on a surface, but for what is cut out of these by pockets and bores.

#include <array>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace leadscrew::machine {

struct Machine;

/// What the probe touches from outside, or what is cut out of all else and touched from inside.
struct ProbeBody {
  /// Its shape. Pockets are boxes and bores cylinders that are cut out.
  enum class Kind : std::uint8_t { box, pocket, sphere, cylinder, bore };

  Kind kind = Kind::box;  ///< its shape
  /// Of boxes and pockets the corner of the least coordinates; of spheres the centre; of cylinders and bores the middle of
  /// one end. X, Y and Z of the controlled point, machine coordinates, mm.
  Vector from{};
  Vector to{};        ///< the corner of the greatest coordinates, the middle of the other end; of spheres nothing
  double radius = 0;  ///< mm; > 0, of boxes and pockets nothing

  friend bool operator==(const ProbeBody&, const ProbeBody&) = default;
};

/// Is it cut out?
constexpr bool is_hollow(ProbeBody::Kind kind) {
  return kind == ProbeBody::Kind::pocket || kind == ProbeBody::Kind::bore;
}

/// What an entry of machine files holds of a body, in order, and what that is; for people.
std::string_view probe_body_form(ProbeBody::Kind kind);

/// A part of a surface without thickness, which the probe touches from either side: a rational Bezier patch (Piegl and Tiller,
/// "The NURBS Book", section 4.4).
struct ProbePatch {
  std::array<int, 2> degree{};  ///< in u and v, 1 … 5
  /// (degree[0] + 1) · (degree[1] + 1) points, u fastest: X, Y, Z of the controlled point, machine coordinates, mm, and weight,
  /// > 0.
  std::vector<std::array<double, 4>> net{};

  friend bool operator==(const ProbePatch&, const ProbePatch&) = default;
};

/// What base::Subject calls patches.
inline constexpr std::string_view probe_patch_field = "probe patches";

/// What base::Subject calls bodies of each kind, in the order of ProbeBody::Kind; entries count within a kind.
inline constexpr std::array<std::string_view, 5> probe_body_fields = {"probe boxes", "probe pockets", "probe spheres",
                                                                      "probe cylinders", "probe bores"};

/// Where it trips. Of several planes, bodies and patches each is enough.
struct Probe {
  /// Coordinates of the machine of the controlled point, which is where the axes stand less the tool's offset (G43); mm.
  /// An axis without a plane touches nothing.
  std::array<std::optional<double>, base::axis_count> planes{};
  std::vector<ProbeBody> bodies{};    ///< in any order
  std::vector<ProbePatch> patches{};  ///< in any order

  friend bool operator==(const Probe&, const Probe&) = default;
};

/// Appends `machine-probe` for each plane and body that is none: a plane is not finite, or its axis is rotary or not there;
/// a body is not finite, or has no extent; a patch has another degree or other points than it says, one that is not finite, or
/// a weight of 0 or less.
void check_probe(const Machine& machine, std::vector<base::Diagnostic>& problems);

}  // namespace leadscrew::machine
