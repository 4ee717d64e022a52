#pragma once
// Machine files as texts, and what reading them says.

#include <gtest/gtest.h>

#include <cstdint>
#include <leadscrew/config/machine_file.hpp>
#include <string>
#include <vector>

namespace leadscrew::config::testing {

/// Of one axis; [axis.X] is line 1, travel 2, velocity 3, acceleration 4, jerk 5, blu 6.
inline const std::string one_axis =
    "[axis.X]\ntravel_mm = [-500, 500]\nmax_velocity_mm_s = 200\nmax_acceleration_mm_s2 = 1000\n"
    "max_jerk_mm_s3 = 20000\nblu_mm = 0.001\n";

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

inline std::string repeated(std::string_view part, std::size_t count) {
  std::string text;
  for (std::size_t k = 0; k < count; ++k) text += part;
  return text;
}

/// "line:column code" of each problem.
inline std::vector<std::string> problems_of(std::string_view text) {
  std::vector<std::string> texts;
  const auto read = read_machine(text, "m.toml");
  if (read) return texts;
  for (const base::Diagnostic& problem : read.error()) {
    EXPECT_EQ(problem.place.file, "m.toml");
    texts.push_back(std::to_string(problem.place.line) + ":" + std::to_string(problem.place.column) + " " +
                    std::string(problem.code));
  }
  return texts;
}

}  // namespace leadscrew::config::testing
