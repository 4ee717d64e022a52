#pragma once
// Does a program gouge? Off-line: all of its moves, passes, links, ways there and back and any others, against all surfaces that it
// machines.
//
//     first reading    which surfaces there are, where they lie; each pass where the tool touches (local gouging)
//     second reading   every move of a tool whose shape is told, with its holder (global gouging)
//
// Surfaces are what is left when the program has run: a place of any of them that is inside a tool, by whichever move, has been
// cut. One that is machined again elsewhere, in another coordinate system or below a roughing of itself, is another surface, and
// both are taken as what shall be left. Where a program begins with its tool inside a surface, as from machine zero, which is
// none of the program's, rapids count from where the tool is clear first.

#include <functional>
#include <leadscrew/gcode/machined.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/gouging/sweep.hpp>
#include <leadscrew/machine/machine.hpp>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace leadscrew::gouging {

/// Where a move's tool reaches deepest into a surface.
struct Gouge {
  base::Line line{};                                               ///< of the block
  std::optional<std::size_t> pass{};                               ///< number, from 0; of a link, of the pass before it
  gcode::MachinedMove::Part of = gcode::MachinedMove::Part::pass;  ///< where there is a pass
  Part::Kind part = Part::Kind::cutter;                            ///< of the tool
  double depth = 0;                                                ///< mm; < 0: so far away
  int surface = 0;                                                 ///< D of the surface that is met
  double u = 0, v = 0;                                             ///< its place there
  Vector place{};                                                  ///< mm, in the workpiece
  Pose pose;                                                       ///< of the tool
  Vector offset{};                                                 ///< of the tool's length, mm
};

/// Where the tool bends least more than the surface that it touches.
struct LocalClearance {
  base::Line line{};     ///< of the block
  int surface = 0;       ///< D
  std::size_t pass = 0;  ///< number, from 0
  double u = 0, v = 0;   ///< of the contact
  double clearance = 0;  ///< 1/mm; < 0: it gouges beside the contact (surfaces::local_clearance)
  Vector place{};        ///< mm, in the workpiece
  Vector offset{};       ///< of the tool's length, mm
};

/// What has been found.
struct GougeVerdict {
  double tolerance = 0;       ///< mm
  double sag = 0;             ///< of the triangles, mm
  std::size_t surfaces = 0;   ///< that differ
  std::size_t triangles = 0;  ///< of all
  bool fits = true;           ///< false: there are more surfaces, or larger ones, than are kept; nothing was looked at
  std::int64_t moves = 0;     ///< looked at
  std::int64_t moves_unknown = 0;         ///< not looked at, since no shape is told of their tool
  std::optional<Gouge> worst{};           ///< of all moves
  std::optional<LocalClearance> least{};  ///< of all passes
  /// More than the tolerance, by block, and those beside contacts: the first most_blocks, in the order of the text.
  std::map<base::Line, Gouge> gouges{};
  std::map<base::Line, LocalClearance> local{};
  static constexpr std::size_t most_blocks = 1000;
  /// More than the tolerance, by block, part of it and number of the pass: the first most_blocks.
  std::map<std::tuple<base::Line, gcode::MachinedMove::Part, std::size_t>, Gouge> gouges_of_passes{};

  std::vector<std::string> files{};  ///< names of the texts, by the numbers that base::file() gives

  bool gouged() const { return !gouges.empty() || !local.empty(); }
};

/// How a program is checked.
struct GougeOptions {
  double tolerance = 0.01;                 ///< mm; what tools may be inside surfaces
  std::function<bool()> is_interrupted{};  ///< ends early where it says so; may be empty
};

/// No smaller tolerance is held: mm.
inline constexpr double least_tolerance = 1e-4;
/// So many surfaces that differ are kept.
inline constexpr std::size_t most_surfaces = 1000;

/// open: a reader of the program, which has been read whole without error and where gouging is allowed
/// (ReaderOptions::allows_gouging), from its beginning; called twice.
GougeVerdict check_gouging(const std::function<gcode::Reader()>& open, const machine::Machine& machine,
                           const machine::ToolTable& tools, const GougeOptions& options);

/// What the table tells of a tool; none where it tells no shape.
std::optional<Tool> tool_of(const machine::Tool& tool);

}  // namespace leadscrew::gouging
