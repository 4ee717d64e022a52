#pragma once
// The tools a machine holds: offsets that G43 adds and the pockets they stand in.

#include <algorithm>
#include <leadscrew/base/axes.hpp>
#include <string>
#include <vector>

namespace leadscrew::machine {

/// One tool.
struct Tool {
  int number = 0;             ///< T; > 0
  int pocket = 0;             ///< P; ≥ 0
  base::AxisVector offset{};  ///< tool length offset of each axis, mm or degrees
  double diameter = 0;        ///< D, mm; ≥ 0
  std::string remark;         ///< for people

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
