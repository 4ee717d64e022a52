#pragma once
// What the command line asks `leadscrew design` for.

#include <leadscrew/cli/quantity.hpp>
#include <leadscrew/design/dda_design.hpp>
#include <leadscrew/design/inverse_time.hpp>
#include <optional>
#include <string>
#include <string_view>
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

/// Options as text, before their values are looked at.
struct DesignTexts {
  bool timer = false, inverse_time = false;
  std::optional<std::string> travel, blu, max_feed, min_distance, from, to, feed;
  std::optional<std::string> clock, delays;
  std::optional<std::string> distance, radius, resolution, digits;
};

/// Says in whole sentences what is wrong.
Parsed<DesignArguments> parse_design(const DesignTexts& texts);

inline constexpr std::string_view design_examples =
    "Examples:\n"
    "  leadscrew design --travel 600 --blu 0.01 --max-feed 12000 --min-distance 50 \\\n"
    "      --from 20,10 --to 120,60 --feed 3000\n"
    "  leadscrew design --timer --clock 1024 --delays 2,4,8\n"
    "  leadscrew design --inverse-time --travel 12 --blu 0.0001 --max-feed 30 --distance 2 --feed 10\n"
    "\n"
    "Millimetres and mm/min; of --inverse-time any unit of length, and that unit a minute: the example's is the "
    "inch.\n";

}  // namespace leadscrew::cli
