#pragma once
// What a block means, in words, from the table of codes; and what a diagnostic does, from docs/diagnostics.md.

#include <leadscrew/base/result.hpp>
#include <leadscrew/gcode/dialect.hpp>
#include <string>
#include <string_view>

namespace leadscrew::language {

/// A block as it may stand in a program of the dialect, or a code by itself: "G41.1 D3 L2", "G64". What each code does,
/// what its words say, where it is defined, which dialects have it; of a code alone the words it takes and an example.
/// Or a diagnostic's code, "arc-radius": what is wrong, what to do, and an example of it.
/// Errors: `unknown-code` where there is nothing that is known.
base::Result<std::string> explanation(std::string_view block, gcode::Dialect dialect);

}  // namespace leadscrew::language
