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
  bool equal_steps = false;        ///< all alike, by the place that needs the least; else each as its own places allow
  /// Only to see where passes and links lead the tool, to about 0.01 mm and a thousandth of a radian, in a fraction of the time:
  /// links are not held against the surface.
  bool is_draft = false;

  /// Of the same surface, if only of the same object.
  friend bool operator==(const Machining&, const Machining&) = default;
};

/// Where the surface's third derivatives have a step, at its knots, the tip's curvature has one: a pass keeps its curvature
/// continuous there and is this far, mm, from the true one at most.
inline constexpr double knot_tolerance = 1e-6;
inline constexpr std::size_t most_passes = 100000;  ///< over one surface
inline constexpr std::size_t most_nodes = 1365;     ///< of one Pass: 4096 control points
inline constexpr std::size_t most_nodes_in_all = 1 << 23;

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
///
/// t is near to the tip's length: 1 mm of it per mm at nodes. Where a pass has a corner, or more nodes than fit, it is told as
/// several of the same number that follow each other without a link.
struct Pass {
  std::vector<PassNode> nodes;  ///< two or more, t ascending
  bool is_link = false;
  std::size_t number = 0;  ///< of the pass, from 0; of a link: of the pass before
  double across = 0;       ///< the parameter across the pass where it begins: v of passes along u
};

/// Why passes cannot go on.
struct PassFailure {
  enum class Kind : std::uint8_t {
    normal,        ///< the normal vanishes
    gouge,         ///< the tool gouges where it touches (local_clearance)
    flat_contact,  ///< a flat tool stands on the surface with all of its bottom and no lean
    overhang,      ///< the tool's axis points into the surface
    edge,          ///< the normal turns by a step inside the range, so that the tip would leap
    cusp,          ///< the tip stands still while the contact moves
    too_many,      ///< passes, or nodes of one
    no_step,       ///< no step leaves so low a ridge: concave surface, tool too large
    section,       ///< planes of the pattern meet the surface in lines that double back in its parameters
    link,          ///< no link was found that keeps off the surface
  };
  Kind kind = Kind::normal;
  double u = 0, v = 0;
  double amount = 0;  ///< of gouge: local clearance, 1/mm, below 0; of too_many: how many there would be
};

/// The lines that all passes of a machining follow, as a draft has found them, so that nobody need find them again. Does not change:
/// any thread may use it.
class FoundLines;
/// Of the machining that they are of, what they take of memory, the surface not counted.
const Machining& machining_of(const FoundLines& found);
std::size_t bytes_of(const FoundLines& found);
/// The same in all but is_draft, of surfaces of the same form: then passes follow the same lines.
bool has_same_lines(const Machining& a, const Machining& b);

/// All passes and links of a machining, in order: pass, link, pass, … ; the last is a pass.
class Passes {
 public:
  /// The surface's form has no fault; ranges lie within the surface's; either scallop or step > 0.
  explicit Passes(Machining machining);
  /// The same. Lines of a machining that has_same_lines() are not found anew; others, or none, change nothing.
  Passes(Machining machining, const std::shared_ptr<const FoundLines>& found);
  ~Passes();
  Passes(Passes&&) noexcept;
  Passes& operator=(Passes&&) noexcept;

  /// None at the end and after a failure. Bounded work and memory: one pass is made ahead.
  std::optional<Pass> next();
  /// Set as soon as next() has come to it: what came before is right.
  const std::optional<PassFailure>& failure() const;

  const Machining& machining() const;
  /// Of a draft that has told all without a failure, while they fit into a mebibyte; else none.
  std::shared_ptr<const FoundLines> found_lines() const;
  /// Passes told so far.
  std::size_t count() const;
  /// Where the tool bends least more than the surface, of all places of passes and between them that were looked at so far.
  struct Least {
    double clearance = 0;  ///< 1/mm, as local_clearance
    double u = 0, v = 0;
    std::size_t number = 0;  ///< of the pass
  };
  const std::optional<Least>& least_clearance() const;

 private:
  class Maker;
  std::unique_ptr<Maker> maker_;
};

/// Hands out passes that something else makes, perhaps ahead of who asks. They outlive it, and nothing else asks them meanwhile.
class PassSource {
 public:
  virtual ~PassSource() = default;
  /// As Passes::next(): the same passes in the same order. Once there is none, nobody uses the Passes that they come from.
  virtual std::optional<Pass> next() = 0;
};

}  // namespace leadscrew::surfaces
