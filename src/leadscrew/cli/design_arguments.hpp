#pragma once
// What the command line asks `leadscrew design` for.

#include <leadscrew/design/dda_design.hpp>
#include <leadscrew/design/inverse_time.hpp>
#include <optional>
#include <variant>
#include <vector>

namespace leadscrew::cli {

/// A linear interpolator, and its rates along one line.
struct DdaQuestion {
  struct Line {
    std::vector<double> way_mm;
    double feed_mm_min = 0;
  };
  design::DdaRange range;
  std::optional<Line> line;
};

struct TimerQuestion {
  double clock_pps = 0;
  std::vector<double> delays;  ///< s
};

/// Koren's feed words, and those of one block.
struct InverseTimeQuestion {
  struct Block {
    double distance = 0;
    bool is_radius = false;
    double feed = 0;
  };
  design::InverseTimeRange range;
  std::optional<Block> block;
};

using DesignArguments = std::variant<DdaQuestion, TimerQuestion, InverseTimeQuestion>;

struct Arguments;
class Command;

/// The options of design, which put their values into the arguments.
void describe_design(Command& command, Arguments& arguments);

}  // namespace leadscrew::cli
