#pragma once
// LinuxCNC's tool-table format: one tool a line, letters with numbers (`T1 P1 D3.175 Z+0.511 ;remark`), and letters that it
// leaves free for the shapes of tools that machine surfaces: R, L, H and K (`T2 P2 D10 R5 L40 H32 K50 ;ball in its holder`).

#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <string_view>
#include <vector>

namespace leadscrew::gcode {

/// What a text holds.
struct ToolTableText {
  machine::ToolTable table;                   ///< its tools
  std::vector<base::Diagnostic> diagnostics;  ///< every problem of the text; errors make the table unusable
};

/// Reads a tool table. T is required, > 0 and unique; P, D, and an offset for each of the nine axes are optional, mm or
/// degrees. So are R, the radius of the tool's edge, 0 … D/2; L, its length from the tip to the holder; H and K, diameter and
/// length of the holder: each > 0, H and K together and with L. What follows ';' is a remark. Unknown letters are errors, and so is a table without a tool
/// (empty-tool-table), which a file that was not written to its end may be.
ToolTableText read_tool_table(std::string_view text, std::string_view file);

}  // namespace leadscrew::gcode
