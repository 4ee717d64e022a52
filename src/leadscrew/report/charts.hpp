#pragma once
// Quantities over time, as pictures side by side on the same scale of values.

#include <leadscrew/base/sink.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::report {

struct Chart {
  std::string title;               ///< what, and under which circumstances
  std::vector<double> values;      ///< from time 0 on
  double interval = 1;             ///< s, between two of them
  std::optional<double> wanted{};  ///< what they should be
};

/// Two charts a row, time in s across; `unit` of the values.
base::Result<void> write_charts(const std::string& title, const std::string& unit, const std::vector<Chart>& charts,
                                const base::ByteSink& sink);

}  // namespace leadscrew::report
