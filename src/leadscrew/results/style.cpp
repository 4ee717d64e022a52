#include <leadscrew/results/style.hpp>

namespace leadscrew::results {

namespace {

std::string_view sequence(Tone tone) {
  switch (tone) {
    case Tone::strong:
      return "\033[1m";
    case Tone::error:
      return "\033[1;31m";
    case Tone::warning:
      return "\033[1;35m";
    case Tone::note:
      return "\033[1;36m";
    case Tone::good:
      return "\033[32m";
    case Tone::faint:
      return "\033[2m";
  }
  return "";
}

}  // namespace

std::string Style::operator()(Tone tone, std::string_view text) const {
  if (!colored) return std::string(text);
  return std::string(sequence(tone)).append(text).append("\033[0m");
}

}  // namespace leadscrew::results
