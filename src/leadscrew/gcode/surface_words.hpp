#pragma once
// What a block says of how a surface is machined.
//
//     G6.5 D1 T3 H0.01 L1 S2 P1 A3 F3000
//
//     D  number of the surface, of G6.4                     U V I J  range: u from U to V, v from I to J; all of it
//     T  tool whose shape it is; the one in the spindle     A B      lead and tilt, degrees; A0 B0: along the normal. Neither:
//     H  height of ridges, or                                        the tool keeps the direction it has
//     Q  distance between passes on the surface             R        1: the tool is on the side of Su × Sv; −1: on the other
//     L  passes along 1 u, 2 v                              Z        clearance; where the tool stands
//     S  1 zig, 2 zigzag, 3 spiral in, 4 iso-scallop,       K        feed is that of 1 the place of contact, 2 the tip
//        5 planar                                           C        how near curves are to passes
//     P  corner where passes begin: 1 to 4
//
// Without them L1 S2 P1 R1 K2. The surface lies where the frame in force puts it.

#include <leadscrew/gcode/machined.hpp>
#include <leadscrew/gcode/surface_blocks.hpp>

namespace leadscrew::gcode {

class SurfaceWords : Part {
 public:
  SurfaceWords(const Context& context, const SurfaceBlocks& surfaces) : Part(context), surfaces_(surfaces) {}

  /// None where the block has an error, which is reported: `missing-word`, `ambiguous-word`, `bad-value`, `surface-unknown`,
  /// `surface-tool`, `unknown-tool`, `surface-range`, `surface-needs-tip-control`, `surface-counts`.
  [[gnu::cold]] std::shared_ptr<const Machined> read(const Block& block);

 private:
  int choice_of(const Block& block, char letter, int otherwise, int most);
  bool read_surface(const Block& block, Machined& machined);
  bool read_tool(const Block& block, Machined& machined);
  bool read_steps(const Block& block, surfaces::Machining& machining);
  bool read_pattern(const Block& block, surfaces::Machining& machining);
  bool read_range(const Block& block, surfaces::Machining& machining);
  bool read_orientation(const Block& block, surfaces::Machining& machining);
  bool place(const surfaces::SurfaceForm& form, surfaces::Machining& machining);

  const SurfaceBlocks& surfaces_;
};

}  // namespace leadscrew::gcode
