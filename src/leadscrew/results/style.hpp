#pragma once
// Colours of text on a terminal.

#include <string>
#include <string_view>

namespace leadscrew::results {

enum class Tone { strong, error, warning, note, good, faint };

/// Gives text a colour, or leaves it alone where colour is off.
struct Style {
  bool colored = false;
  std::string operator()(Tone tone, std::string_view text) const;
};

}  // namespace leadscrew::results
