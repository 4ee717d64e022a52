#pragma once
// A diagnostic as people read it:
//
//     part.ngc:12:7: error: arc radius differs by 0.31 mm at its ends [arc-radius]
//         G2 X10 Y0 I5
//            ^
//         hint: …

#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/results/style.hpp>
#include <string>
#include <string_view>

namespace leadscrew::results {

std::string diagnostic_text(const base::Diagnostic& diagnostic, const Style& style);

/// Bytes that a terminal would obey instead of show, and what is not UTF-8, become '?'; tabs stay.
std::string printable(std::string_view text);

}  // namespace leadscrew::results
