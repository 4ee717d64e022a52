#pragma once
// Signals of a model, clock by clock, as a picture that reads on light and on dark pages.
//
//     clk      ┌┐┌┐┌┐          one column a clock
//     Busy   ──┘                a bit: low or high
//     Val_x  ⟨ 5 ⟩⟨4⟩           a value: told where it changes; nothing where it means nothing yet

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::hardware {

struct Signal {
  std::string name;
  bool is_bit = false;
  std::vector<std::optional<std::int64_t>> values{};  ///< of each clock; none: not told
};

/// All signals have as many values, one or more. SVG; the title is not escaped.
std::string waveform_svg(const std::string& title, const std::vector<Signal>& signals);

}  // namespace leadscrew::hardware
