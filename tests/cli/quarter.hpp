#pragma once
// The arc of the papers, as words of a command line.

#include <string>
#include <vector>

#include "command.hpp"

namespace leadscrew::cli::testing {

using Words = std::vector<std::string>;

/// Koren's and the FPGA paper's quarter of a circle of 5 BLU, and what follows it.
inline Words quarter(const Words& more) {
  Words words = {"pulse", "--arc", "--start", "5,0", "--end", "0,5", "--center", "0,0", "--ccw"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace leadscrew::cli::testing
