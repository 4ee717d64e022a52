#pragma once
// The sizes of digital integrators as JSON and as a table: what is asked, and the answer.

#include <leadscrew/design/dda_design.hpp>
#include <leadscrew/design/inverse_time.hpp>
#include <leadscrew/json/json.hpp>
#include <leadscrew/results/figures.hpp>
#include <leadscrew/results/style.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace leadscrew::results {

using json::Json;

inline constexpr std::string_view sizing_schema = "leadscrew.design/1";

/// A linear interpolator, and its rates along one line.
struct DdaQuestion {
  struct Line {
    std::vector<double> delta_mm;
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

using SizingQuestion = std::variant<DdaQuestion, TimerQuestion, InverseTimeQuestion>;

/// The same figures twice; the JSON is yet without "diagnostics".
struct Sizing {
  Json json;
  std::string text;
};

/// Why there is no answer; empty where there is one.
Diagnostics problems_of(const SizingQuestion& question);

/// Of a question without problems.
Sizing answer(const SizingQuestion& question, const Style& style);

}  // namespace leadscrew::results
