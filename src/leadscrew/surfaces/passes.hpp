#pragma once
// A surface as passes of a tool: one made at a time, in constant memory, as the machine asks for them (Lin and Koren,
// "tool-path planning").
//
//     along u, zigzag:   v₁ ┌──────────────▶───╮         each pass is a line of the surface, each link a smooth curve off it
//                        vₖ │  ╭───◀───────────╯
//                        v₀ │  ╰───▶──────────╮
//                           u₀               u₁

#include <cstdint>
#include <leadscrew/numeric/jet.hpp>
#include <leadscrew/surfaces/cutter.hpp>
#include <leadscrew/surfaces/surface.hpp>
#include <memory>
#include <optional>
#include <vector>

namespace leadscrew::surfaces {

/// Where passes lie.
enum class Pattern : std::uint8_t {
  zig,          ///< all in one direction
  zigzag,       ///< there and back
  spiral_in,    ///< round the range, from its border inwards
  iso_scallop,  ///< zigzag, each at a constant distance on the surface from the one before
  planar,       ///< zigzag, in parallel vertical planes along X (Direction::u) or Y (Direction::v)
};

/// How a surface is machined.
struct Machining {
  std::shared_ptr<const Surface> surface;  ///< mm, in the coordinates of the tip's path
  Cutter cutter;
  Orientation orientation;
  int side = 1;  ///< 1: the tool is on the side of Su × Sv; −1: on the other
  Pattern pattern = Pattern::zigzag;
  Direction along = Direction::u;  ///< of the passes
  Range u, v;                      ///< within the surface's own; from < to
  int start_corner = 1;            ///< 1: (u0, v0), 2: (u1, v0), 3: (u1, v1), 4: (u0, v1)
  double scallop = 0;              ///< h, mm; 0: the passes are `step` apart
  double step = 0;                 ///< mm on the surface
  double tolerance = 1e-10;        ///< of the curves that passes are made into, mm; > 0
  bool allows_gouging = false;     ///< passes go on where the tool gouges: no PassFailure::Kind::gouge
};

/// A place of a pass or link, with two derivatives by t.
struct PassNode {
  using Jet = numeric::Jet<2>;

  double t = 0;
  VectorOf<Jet> tip;      ///< mm
  VectorOf<Jet> axis;     ///< from the tip to the spindle, a unit vector
  VectorOf<Jet> contact;  ///< mm; of a link: not used
  double u = 0, v = 0;    ///< of the contact
};

/// One pass, or a link between two: the quintic polynomials that have at each node its value and derivatives, which are
/// within the tolerance of the tip's true path.
struct Pass {
  std::vector<PassNode> nodes;  ///< two or more, t ascending
  bool is_link = false;
  std::size_t number = 0;  ///< of the pass, from 0; of a link: of the pass before
};

/// Why passes cannot go on.
struct PassFailure {
  enum class Kind : std::uint8_t {
    normal,        ///< the normal vanishes
    gouge,         ///< the tool gouges where it touches (local_clearance)
    flat_contact,  ///< a flat tool stands on the surface with all of its bottom and no lean
    too_many,      ///< passes, or nodes of one
    no_step,       ///< no step leaves so low a ridge: concave surface, tool too large
    link,          ///< no link was found that keeps off the surface
  };
  Kind kind = Kind::normal;
  double u = 0, v = 0;
  double amount = 0;  ///< of gouge: local clearance, 1/mm, below 0; of too_many: how many there would be
};

}  // namespace leadscrew::surfaces
