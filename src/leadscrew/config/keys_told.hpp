#pragma once
// What is told while a part of a machine file is read by itself. For machine_file.cpp and those parts alone.

#include <functional>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/config/toml_values.hpp>
#include <string>
#include <string_view>

namespace leadscrew::config {

/// Whom the reader of a part tells.
struct KeysTold {
  /// A problem: code, place, what was found, what would be right.
  std::function<void(std::string_view, toml::source_position, std::string, std::string)> problem;
  /// Where a value stands, or what stands for it.
  std::function<void(const base::Subject&, toml::source_position)> place;
};

}  // namespace leadscrew::config
