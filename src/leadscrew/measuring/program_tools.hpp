#pragma once
// What a program tells those who measure: the surfaces it machines, and which tool its blocks are moved with.

#include <array>
#include <cstdint>
#include <leadscrew/base/line.hpp>
#include <leadscrew/gcode/machined.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <leadscrew/measuring/swept_tool.hpp>
#include <leadscrew/measuring/target.hpp>
#include <memory>
#include <optional>
#include <vector>

namespace leadscrew::measuring {

/// The tool of some blocks.
struct BlockTool {
  std::optional<ToolBody> body;    ///< none: its table says nothing of its shape
  std::array<double, 3> offset{};  ///< X, Y and Z from its tip to where the axes are, mm

  friend bool operator==(const BlockTool&, const BlockTool&) = default;
};

/// A surface, once however often and by however many tools it is machined.
struct ProgramSurface {
  std::shared_ptr<const gcode::Machined> machined;  ///< of the block that leaves the lowest ridges
  std::size_t passes = 0;                           ///< of it
  std::array<double, 3>
      offset{};  ///< by which its coordinates are off the tip's, mm: the tool's without tool centre point control
};

class ProgramTools {
 public:
  static constexpr std::size_t most_surfaces = 16;  ///< those beyond are not measured

  explicit ProgramTools(const machine::ToolTable& tools) : tools_(&tools) {}

  /// Each move, with the reader that has handed it out last.
  void see(const gcode::Move& move, const gcode::Reader& reader);

  const std::vector<ProgramSurface>& surfaces() const { return surfaces_; }
  /// How many have been left out.
  std::size_t left_out() const { return left_out_; }
  /// Of the words whose blocks stand in this line, as blocks come in the order of the program. Words without a line: of any
  /// block; none where blocks differ.
  const BlockTool* tool_of(std::optional<std::int64_t> line);
  /// A trace is read again.
  void begin_again() { at_ = 0; }

 private:
  struct Run {
    std::int64_t first = 0, last = 0;  // numbers of lines
    BlockTool tool;
  };
  void see_surface(const gcode::MachinedMove& move, const std::array<double, 3>& offset);

  const machine::ToolTable* tools_;
  std::vector<Run> runs_;  // of blocks that follow each other
  std::size_t at_ = 0;     // of them, that of the word before
  std::vector<ProgramSurface> surfaces_;
  std::weak_ptr<const gcode::Machined> last_;
  std::size_t last_index_ = 0, left_out_ = 0;
};

/// How finely a surface is to be looked at. `reach`: mm; none: 1 mm, or four times what is to be left.
Target target_of(const ProgramSurface& surface, std::optional<double> reach, std::size_t most_places);

}  // namespace leadscrew::measuring
