#pragma once
// The referee's constants that were found by trial. None of them decides what is objected to: they bound its memory and its
// work, and say how finely it looks before it objects. Held by tests/referee, of which LongFrechet compares with the exact
// Fréchet distance, on one side; by the time and memory of `verify` on the other.

#include <cstddef>

namespace leadscrew::referee::tuning {

/// Where in the program a word may be.
namespace candidates {
inline constexpr double slack = 0.25;  // of the tolerance: candidates that much beyond it are kept
}

/// How far ahead in the program words are looked for.
namespace matching {
inline constexpr std::size_t most_pieces = 16384;         // looked ahead while the trace follows the program
inline constexpr std::size_t most_pieces_departed = 256;  // and while it does not
inline constexpr double search_factor = 16;               // of the least cost, while it does not
}  // namespace matching

/// The last words judged again, on finer pieces. Finer: a deviation is known more exactly. Coarser: less work.
namespace rematch {
inline constexpr double step = 1. / 16;           // of the tolerance: deviations larger by more are rematched
inline constexpr double fineness = 16;            // parts for a length of the tolerance
inline constexpr int most_parts_at_end = 64;      // of a piece: 4 tolerances
inline constexpr double far = 3;                  // tolerances; between marks, and from where a rematch began
inline constexpr std::size_t most_words = 4096;   // after a mark
inline constexpr std::size_t most_cut = 512;      // parts; where as many are held already, pieces stay whole
inline constexpr std::size_t most_parts = 16896;  // looked ahead
}  // namespace rematch

/// Path length of words, and what of it chords may hide.
namespace travel {
inline constexpr double greatest_stretch = 4. / 3;  // of a chord; an arc's of 2½ radians
inline constexpr double hidden_share = 1e-4;        // of the length; a tenth of what is objected to
inline constexpr std::size_t most_places = 64;      // of a word; where there are more, the chord counts
inline constexpr double widest_turn = 2.5;          // radians; beyond, a chord says too little about its arc
}  // namespace travel

}  // namespace leadscrew::referee::tuning
