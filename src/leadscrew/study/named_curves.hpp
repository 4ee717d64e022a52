#pragma once
// The curves that the experiments travel, by name: part programs for whoever has no file.

#include <leadscrew/study/curves.hpp>
#include <span>
#include <string_view>

namespace leadscrew::study {

struct NamedCurve {
  std::string_view name;                ///< as the command line takes it
  double feed = 0;                      ///< mm/s, as published
  PartProgram (*program)(double feed);  ///< mm/s, > 0
};

/// All there are, in the order in which they are listed.
std::span<const NamedCurve> named_curves();

}  // namespace leadscrew::study
