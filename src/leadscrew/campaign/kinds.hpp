#pragma once
// What random programs are about.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace leadscrew::campaign {

/// What a program is made of.
enum class Kind : std::uint8_t {
  lines,          ///< G0 and G1, dwells, inverse time, stops and blends
  arcs,           ///< G2 and G3 in all planes, helices, quarters of circles
  nurbs,          ///< G6.2 and G5
  corners,        ///< short lines and corners within tolerances of G64
  five_axes,      ///< tool centre point control, tool vectors and tilted working planes on chains of rotary axes
  surfaces,       ///< G6.5
  interventions,  ///< all but the last two, while the feed is changed and held
};
inline constexpr std::array<std::string_view, 7> kind_names = {"lines",     "arcs",     "nurbs",        "corners",
                                                               "five-axes", "surfaces", "interventions"};

inline std::string_view name(Kind kind) {
  return kind_names[static_cast<std::size_t>(kind)];
}

}  // namespace leadscrew::campaign
