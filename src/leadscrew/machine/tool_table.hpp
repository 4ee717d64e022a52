#pragma once
// The tools a machine holds: offsets that G43 adds, the pockets they stand in, and their shapes.
//
//         |<-- H -->|
//      ┌──┴─────────┴──┐ ─┬─
//      │    holder     │  K
//      └───┬───────┬───┘ ─┴─ ─┬─
//          │  tool │          L
//          ╰r─────r╯         ─┴─  tip
//          |<- D ->|

#include <algorithm>
#include <leadscrew/base/axes.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::machine {

/// One tool.
struct Tool {
  int number = 0;             ///< T; > 0
  int pocket = 0;             ///< P; ≥ 0
  base::AxisVector offset{};  ///< tool length offset of each axis, mm or degrees
  /// D, mm. Negative as LinuxCNC has it: cutter compensation is on the other side, for a program of the path of a larger tool.
  double diameter = 0;
  std::string remark{};  ///< for people
  /// R, mm, of its round edge: 0 flat, D/2 a ball, between them a bull nose. None: nothing is said of its shape.
  std::optional<double> corner_radius{};
  double length = 0;           ///< L, from the tip to the holder, mm; > 0, or 0 where it is not told
  double holder_diameter = 0;  ///< H, mm; > 0, or 0 where there is none
  double holder_length = 0;    ///< K, mm; > 0 where there is a holder
  double front_angle = 0;      ///< I, of a lathe tool, degrees
  double back_angle = 0;       ///< J, of a lathe tool, degrees
  int orientation = 0;  ///< Q, of a lathe tool: 1 … 8, 0 and 9 its middle (LinuxCNC manual, "Lathe tool orientation")
  // Wear, which G10 of Fanuc's and Haas' dialects sets and no table holds.
  base::AxisVector wear{};  ///< of the offset, mm
  double radius_wear = 0;   ///< of half the diameter, mm

  /// Offset and wear.
  base::AxisVector worn_offset() const {
    base::AxisVector sum = offset;
    for (std::size_t i = 0; i < base::axis_count; ++i) sum[i] += wear[i];
    return sum;
  }
  /// Half the diameter and its wear, mm; negative as the diameter is.
  double worn_radius() const { return diameter / 2 + radius_wear; }

  friend bool operator==(const Tool&, const Tool&) = default;
};

/// All there are, in the order of the table.
class ToolTable {
 public:
  ToolTable() = default;
  /// Of tools with different numbers.
  explicit ToolTable(std::vector<Tool> tools) : tools_(std::move(tools)) {}

  /// The tool of this number, or nullptr.
  const Tool* find(int number) const {
    const auto tool = std::find_if(tools_.begin(), tools_.end(), [&](const Tool& t) { return t.number == number; });
    return tool == tools_.end() ? nullptr : &*tool;
  }
  /// Adds a tool, or puts it in the place of the one of its number.
  void set(Tool tool) {
    const auto found =
        std::find_if(tools_.begin(), tools_.end(), [&](const Tool& t) { return t.number == tool.number; });
    if (found == tools_.end()) {
      tools_.push_back(std::move(tool));
    } else {
      *found = std::move(tool);
    }
  }
  /// All of them.
  const std::vector<Tool>& tools() const { return tools_; }

 private:
  std::vector<Tool> tools_;
};

}  // namespace leadscrew::machine
