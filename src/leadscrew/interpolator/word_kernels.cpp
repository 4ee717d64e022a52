#include <algorithm>
#include <cmath>
#include <leadscrew/interpolator/tick_time.hpp>
#include <leadscrew/interpolator/word_kernels.hpp>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace leadscrew::interpolator {

namespace {

constexpr double least_coefficient = 0x1p-200, greatest_coefficient = 0x1p200;
constexpr double least_tau = 0x1p-100, least_s = 0x1p-100, greatest_begin = 0x1p90;

constexpr std::size_t spare_rows = 8;  // behind the last word: a kernel writes whole vectors, twice its lanes at most

/// What one step of a kernel hands to the next, a row for each word.
struct Made {
  /// Of the numbers of the segments; behind the last word, what that has.
  alignas(64) std::array<std::array<double, words_in_block + spare_rows>, Block::number_count> numbers;
  std::array<base::MotionState, words_in_block> state;
  alignas(64) std::array<double, words_in_block> s_hi, s_lo, speed;
  alignas(64) std::array<double, words_in_block> angle, angle_lo, sine, cosine;
};

/// How many coefficients of the segment count, as Interpolator::next() decides it.
int degree_of(const planner::Segment& segment) {
  if (segment.c5 != 0 || segment.c4 != 0) return 5;
  return segment.c3 != 0 || segment.c2 != 0 ? 3 : 1;
}

bool is_moderate(double factor) {
  const double magnitude = std::abs(factor);
  return magnitude == 0 || (least_coefficient <= magnitude && magnitude <= greatest_coefficient);
}

}  // namespace

// One source for all vectors: each kernel is a namespace that says how many lanes it has and how it multiplies exactly.

namespace plain {
namespace {
constexpr std::size_t lanes = 2;
#include <leadscrew/interpolator/word_kernel.inl>
}  // namespace
}  // namespace plain

#if defined(__x86_64__)

#define LEADSCREW_FUSED

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif
namespace avx2 {
namespace {
constexpr std::size_t lanes = 4;
[[gnu::always_inline]] inline __m256d fused(__m256d a, __m256d b, __m256d c) {
  return _mm256_fmadd_pd(a, b, c);
}
#include <leadscrew/interpolator/word_kernel.inl>
}  // namespace
}  // namespace avx2
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#undef LEADSCREW_FUSED
#endif

bool has(Kernel kernel) {
  switch (kernel) {
    case Kernel::plain:
      return true;
#if defined(__x86_64__)
    case Kernel::avx2:
      return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#endif
    default:
      return false;
  }
}

Kernel widest_kernel() {
  return has(Kernel::avx2) ? Kernel::avx2 : Kernel::plain;
}

bool Block::is_in_range() const {
  const geometry::Line* const straight = std::get_if<geometry::Line>(curve);
  const geometry::Arc* const round = std::get_if<geometry::Arc>(curve);
  if (!straight && !round) return false;
  if (!is_moderate(straight ? straight->length() : round->length())) return false;
  if (round) {
    const geometry::Arc::Turn turn = round->turn();
    if (!is_moderate(turn.x.hi.value) || !is_moderate(turn.y.hi.value)) return false;
    if (!is_moderate(turn.rate.hi.value) || turn.rate.hi.value == 0) return false;
  }
  const auto coordinates = (straight ? straight->slopes() : round->slopes()).coordinates();
  return std::all_of(coordinates.begin(), coordinates.end(),
                     [](const auto& slope) { return is_moderate(slope.rate.hi.value); });
}

bool Block::add(const planner::Segment& segment, numeric::DoubleDouble begin, std::size_t words) {
  const bool is_usual = is_moderate(segment.c5) && is_moderate(segment.c4) && is_moderate(segment.c3) &&
                        is_moderate(segment.c2) && is_moderate(segment.v0.hi) && is_moderate(segment.s0.hi) &&
                        std::abs(begin.hi) <= greatest_begin;
  if (!is_usual) return false;
  degree = std::max(degree, degree_of(segment));
  stretches[stretch_count++] = {{-begin.hi, -begin.lo, segment.s0.hi, segment.s0.lo, segment.v0.hi, segment.v0.lo,
                                 segment.c2, segment.c3, segment.c4, segment.c5},
                                words,
                                segment.state};
  count += words;
  return true;
}

bool make_words(Kernel kernel, const Block& block, base::Word* words) {
#if defined(__x86_64__)
  if (kernel == Kernel::avx2) return avx2::make_words(block, words);
#endif
  (void)kernel;
  return plain::make_words(block, words);
}

}  // namespace leadscrew::interpolator
