#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <leadscrew/interpolator/tick_time.hpp>
#include <leadscrew/interpolator/word_kernels.hpp>
#include <leadscrew/numeric/sine.hpp>
#include <type_traits>

#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

namespace leadscrew::interpolator {

namespace {

constexpr double least_coefficient = 0x1p-200, greatest_coefficient = 0x1p200;
constexpr double least_tau = 0x1p-100, least_s = 0x1p-100, greatest_begin = 0x1p90;

constexpr std::size_t most_lanes = 4;

// A word as slots of eight bytes, in its order.
constexpr std::size_t slot_count = sizeof(base::Word) / sizeof(double);
static_assert(sizeof(base::Word) == slot_count * sizeof(double) && std::is_trivially_copyable_v<base::Word>);
constexpr std::size_t slot_of_tick = offsetof(base::Word, tick) / 8,
                      slot_of_position = offsetof(base::Word, position) / 8,
                      slot_of_path_length = offsetof(base::Word, path_length) / 8,
                      slot_of_speed = offsetof(base::Word, speed) / 8, slot_of_feed = offsetof(base::Word, feed) / 8,
                      slot_of_state = offsetof(base::Word, state) / 8;
static_assert(std::endian::native == std::endian::little && sizeof(base::MotionState) == 1);  // a state in its slot

/// What one step of a kernel hands to the next, a column for each number of the words; some of it stands for bits.
struct Made {
  alignas(64) std::array<double, words_in_block * most_lanes> tau_hi, tau_lo;  ///< each segment's are whole vectors
  // Segment by segment, whole vectors: behind the last word there is room for what fills one.
  using Column = std::array<double, words_in_block + most_lanes>;
  alignas(64) Column s_hi, s_lo;
  alignas(64) std::array<Column, slot_count> columns;  ///< of the slots that vary from word to word
  std::array<bool, slot_count> varies{};
  std::array<double, slot_count> common;  ///< of the others

  /// Says that the slot varies; its column.
  double* vary(std::size_t slot) {
    varies[slot] = true;
    return columns[slot].data();
  }
  void take_common(const geometry::Point& start, base::Line line) {
    base::Word word;
    word.position = start;
    word.line = line;
    __builtin_memcpy(common.data(), &word, sizeof word);
  }
};

/// How many coefficients of the segment count, as Interpolator::next() decides it.
int degree_of(const planner::Segment& segment) {
  if (segment.c5 != 0 || segment.c4 != 0) return 5;
  return segment.c3 != 0 || segment.c2 != 0 ? 3 : 1;
}

/// Without branches, which would cost more.
bool is_moderate(double factor) {
  const double magnitude = std::abs(factor);
  return (magnitude == 0) | ((least_coefficient <= magnitude) & (magnitude <= greatest_coefficient));
}

}  // namespace

// One source for all vectors: each kernel is a namespace that says how many lanes it has and how it multiplies exactly.

namespace plain {
namespace {
#define LEADSCREW_LANES 2
#include <leadscrew/interpolator/word_kernel.inl>
#undef LEADSCREW_LANES
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
#define LEADSCREW_LANES 4
[[gnu::always_inline]] inline __m256d fused(__m256d a, __m256d b, __m256d c) {
  return _mm256_fmadd_pd(a, b, c);
}
#include <leadscrew/interpolator/word_kernel.inl>
#undef LEADSCREW_LANES
}  // namespace
}  // namespace avx2
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#undef LEADSCREW_FUSED

#elif defined(__aarch64__)

#define LEADSCREW_FUSED
namespace neon {
namespace {
#define LEADSCREW_LANES 2
[[gnu::always_inline]] inline float64x2_t fused(float64x2_t a, float64x2_t b, float64x2_t c) {
  return vfmaq_f64(c, a, b);
}
#include <leadscrew/interpolator/word_kernel.inl>
#undef LEADSCREW_LANES
}  // namespace
}  // namespace neon
#undef LEADSCREW_FUSED

#endif

bool has(Kernel kernel) {
  switch (kernel) {
    case Kernel::plain:
      return true;
#if defined(__x86_64__)
    case Kernel::avx2:
      return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#elif defined(__aarch64__)
    case Kernel::neon:
      return true;
#endif
    default:
      return false;
  }
}

Kernel widest_kernel() {
  if (has(Kernel::avx2)) return Kernel::avx2;
  return has(Kernel::neon) ? Kernel::neon : Kernel::plain;
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
  bool is_usual = std::abs(begin.hi) <= greatest_begin;
  for (const double factor : {segment.s0.hi, segment.v0.hi, segment.c2, segment.c3, segment.c4, segment.c5})
    is_usual &= is_moderate(factor);
  if (!is_usual) return false;
  stretches[stretch_count++] = {{-begin.hi, -begin.lo, segment.s0.hi, segment.s0.lo, segment.v0.hi, segment.v0.lo,
                                 segment.c2, segment.c3, segment.c4, segment.c5},
                                words,
                                degree_of(segment),
                                segment.state};
  count += words;
  return true;
}

bool make_words(Kernel kernel, const Block& block, std::span<base::Word> words) {
#if defined(__x86_64__)
  if (kernel == Kernel::avx2) return avx2::make_words(block, words);
#elif defined(__aarch64__)
  if (kernel == Kernel::neon) return neon::make_words(block, words);
#endif
  (void)kernel;
  return plain::make_words(block, words);
}

}  // namespace leadscrew::interpolator
