#pragma once
// Words along one line or arc, several ticks at once, by the vectors that the processor has. The bits are
// those of Interpolator::next(): each lane does the same operations in the same order. They differ in one thing only, the
// exact product of two doubles: the word by word path splits the factors (Dekker), a kernel with fused multiply-add takes
// a·b − fl(a·b) in one. Both are exact, and so the same, as long as no part of a product falls below the smallest double:
// a·b = 0 or |a·b| ≥ 2⁻⁹⁶⁹ (the last bit of each part then counts at least 2⁻¹⁰⁷⁴). That holds
//
//   if every coefficient is 0 or within 2^±200 in magnitude, and τ within 2^±100: by Horner's rule a value that is not 0
//   after a sum is at least the last bit of the lesser summand, so each of at most five steps costs it at most 2⁻¹⁵³,
//   and no product falls below 2⁻²⁰⁰⁻¹⁰⁰⁻⁴·¹⁵³ = 2⁻⁹¹²;
//   if s ≥ 2⁻¹⁰⁰, rates and radii within 2^±200: no angle is below 2⁻³⁰⁰ then, no 1 − cos below 2⁻⁶⁰², no product below
//   2⁻⁸⁰².
//
// Block::add() and is_in_range() ask for what words share, the kernels for τ and s in each word; whoever gets a no makes
// the words one by one. Nothing overflows: no value exceeds 2⁷⁰⁰.
//
// Where Interpolator::next() leaves out steps along a segment, because what they begin with has become 0, a kernel says no.
//
// A kernel calls nothing through a pointer, so that what it reaches can be read from its machine code.

#include <array>
#include <cstddef>
#include <cstdint>
#include <leadscrew/base/time.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/geometry/curve.hpp>
#include <leadscrew/planner/motion.hpp>
#include <span>

namespace leadscrew::interpolator {

/// What makes words together.
enum class Kernel : std::uint8_t {
  plain,  ///< two lanes of what every processor has
  avx2,   ///< four, x86-64 with AVX2 and FMA; eight of AVX-512 were no faster
  neon,   ///< two, with the fused multiply-add of every AArch64
};

inline constexpr std::array<Kernel, 3> all_kernels = {Kernel::plain, Kernel::avx2, Kernel::neon};

/// Can this processor run it?
bool has(Kernel kernel);
/// The widest that it can.
Kernel widest_kernel();

/// The most words that a kernel makes in one call.
inline constexpr std::size_t words_in_block = 64;

/// Consecutive words along one piece, a line or an arc.
struct Block {
  const geometry::Curve* curve = nullptr;
  base::Tick tick{};         ///< of the first word
  double nanoseconds = 0;    ///< time of the first word; with those of the others below 2⁵³
  double period = 0;         ///< ns
  double length_before = 0;  ///< of the path, before the piece
  double feed_rate = 1;      ///< feed by speed along the path
  base::Line line{};
  std::size_t count = 0;  ///< of words

  // What each of the segments is made of, in the order of the words.
  enum Number : std::uint8_t { begin_hi, begin_lo, s0_hi, s0_lo, v0_hi, v0_lo, c2, c3, c4, c5, number_count };
  struct Stretch {
    std::array<double, number_count> numbers;  ///< begin with its sign changed
    std::size_t words;
    int degree;  ///< of the segment: 1, 3 or 5
    base::MotionState state;
  };
  std::size_t stretch_count = 0;
  std::array<Stretch, words_in_block> stretches;

  /// Is the curve within the bounds above?
  bool is_in_range() const;
  /// Adds so many words along a segment that begins then; false, and does not, if it is not within the bounds.
  bool add(const planner::Segment& segment, numeric::DoubleDouble begin, std::size_t words);
};

/// Makes the words of a block, which stand first in `words`; false if one of them lies where its bits could differ: then
/// they hold nothing of use. The memory of those behind is fetched meanwhile, as they are made next. The kernel must be had,
/// the curve in range, count ≥ 1 and ≤ words.size().
bool make_words(Kernel kernel, const Block& block, std::span<base::Word> words);

}  // namespace leadscrew::interpolator
