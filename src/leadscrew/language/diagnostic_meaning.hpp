#pragma once
// What a diagnostic means, by its code: docs/diagnostics.md, which is a part of the program.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::language {

/// docs/diagnostics.md, byte by byte.
extern const std::string_view diagnostics_md;

/// Every code that the page has, in its order; those of part programs first.
std::vector<std::string_view> diagnostic_codes();

/// Is it written as the codes of diagnostics are: words of small letters and digits with hyphens between, two at least?
bool looks_like_diagnostic(std::string_view text);

/// What is wrong and what to do, in lines of 100 characters at most, and the example where the page has one. Empty where
/// no diagnostic has this code.
std::optional<std::string> diagnostic_meaning(std::string_view code);

}  // namespace leadscrew::language
