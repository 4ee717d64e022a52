#pragma once
// What was probably meant: the known word that is nearest to one that is not known.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace leadscrew::base {

/// The known word the fewest insertions, removals, changes and swaps of neighbours (Damerau 1964) away, if that is
/// fewer than half of the word's letters.
std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> known);

/// "; did you mean run?", or nothing where no known word is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> known);

}  // namespace leadscrew::base
