// The kernel itself, for vectors of so many `lanes`: included by word_kernels.cpp once for each. What it does is what
// Interpolator::next(), geometry::Slopes::add and geometry::Arc::turned do, operation by operation. All functions are of
// this namespace, and inline in one: none that is compiled for a processor that not everybody has may be taken for one of
// another source.

#define LEADSCREW_LANEWISE [[gnu::always_inline]] inline

constexpr std::size_t lanes = LEADSCREW_LANES;

typedef double Vector __attribute__((vector_size(8 * lanes)));
typedef long long Mask __attribute__((vector_size(8 * lanes)));

static_assert(lanes <= most_lanes);

#include <leadscrew/numeric/sine.inl>

struct Pair {
  Vector hi, lo;
};

LEADSCREW_LANEWISE Vector all(double value) {
  return value - Vector{};
}

/// The same, of a number that stands for bits: nothing is computed with it.
LEADSCREW_LANEWISE Vector all_bits(double bits) {
  Vector vector;
  for (std::size_t lane = 0; lane < lanes; ++lane) vector[lane] = bits;
  return vector;
}

LEADSCREW_LANEWISE Vector load(const double* from) {
  Vector vector;
  __builtin_memcpy(&vector, from, sizeof vector);
  return vector;
}

LEADSCREW_LANEWISE void store(double* to, Vector vector) {
  __builtin_memcpy(to, &vector, sizeof vector);
}

LEADSCREW_LANEWISE Pair two_sum(Vector a, Vector b) {
  const Vector sum = a + b;
  const Vector b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

LEADSCREW_LANEWISE Pair quick_two_sum(Vector a, Vector b) {
  const Vector sum = a + b;
  return {sum, b - (sum - a)};
}

LEADSCREW_LANEWISE Pair two_product(Vector a, Vector b) {
  const Vector product = a * b;
#ifdef LEADSCREW_FUSED
  return {product, fused(a, b, -product)};
#else
  const Vector a_scaled = 134217729.0 * a, b_scaled = 134217729.0 * b;
  const Vector a_high = a_scaled - (a_scaled - a), b_high = b_scaled - (b_scaled - b);
  const Vector a_low = a - a_high, b_low = b - b_high;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
#endif
}

LEADSCREW_LANEWISE Pair sum_of(Pair a, Pair b) {
  Pair sum = two_sum(a.hi, b.hi);
  const Pair low = two_sum(a.lo, b.lo);
  sum = quick_two_sum(sum.hi, sum.lo + low.hi);
  return quick_two_sum(sum.hi, sum.lo + low.lo);
}

/// rate · s.
LEADSCREW_LANEWISE Pair times(const geometry::Rate& rate, Pair s) {
  const Pair product = two_product(all(rate.hi.value), s.hi);
  return {product.hi, product.lo + (rate.hi.value * s.lo + rate.lo * s.hi)};
}

/// Prefetches the memory of the words that will be made next, a few cache lines in every step: a processor can have only so
/// many outstanding at once, and stalls beyond that. Into the second-level cache, as it can have more on the way to that.
/// One line behind the words may be prefetched, too.
class Fetcher {
 public:
  LEADSCREW_LANEWISE explicit Fetcher(std::span<const base::Word> words)
      : next_(reinterpret_cast<const char*>(words.data())), end_(next_ + words.size_bytes()) {}
  LEADSCREW_LANEWISE void fetch(std::size_t lines) {
    if (next_ >= end_) return;
    for (std::size_t k = 0; k < lines; ++k) __builtin_prefetch(next_ + k * line, 0, 2);
    next_ += lines * line;
  }

 private:
  static constexpr std::size_t line = 64;  // bytes that are fetched together
  const char* next_;
  const char* end_;
};

/// Cache lines prefetched in each step for as many words as there are lanes: about what these words take, after four steps.
constexpr std::size_t lines_in_step = lanes / 2;

/// τ since each segment began, of all words; lanes behind the end of a segment have that of its last word. A loop of its
/// own: its chain of dependent operations is shorter than with the polynomial behind it, so that more vectors overlap.
LEADSCREW_LANEWISE void make_tau(const Block& block, Made& made, Fetcher& fetcher) {
  std::size_t begin = 0, row = 0;
  for (std::size_t k = 0; k < block.stretch_count; ++k) {
    const Block::Stretch& stretch = block.stretches[k];
    const Pair minus_begin = {all(stretch.numbers[Block::begin_hi]), all(stretch.numbers[Block::begin_lo])};
    const std::size_t end = begin + stretch.words;
    const Vector last = all(static_cast<double>(static_cast<int>(end - 1)));
    Vector number = all(static_cast<double>(static_cast<int>(begin)));
    for (std::size_t lane = 0; lane < lanes; ++lane) number[lane] += static_cast<double>(lane);
    for (std::size_t i = begin; i < end; i += lanes, row += lanes, number += static_cast<double>(lanes)) {
      fetcher.fetch(lines_in_step);
      const Vector nanoseconds = block.nanoseconds + block.period * (number < last ? number : last);
      const Pair product = two_product(all(nanosecond.hi), nanoseconds);
      const Pair now = quick_two_sum(product.hi, product.lo + nanosecond.lo * nanoseconds);
      const Pair tau = sum_of(now, minus_begin);
      store(&made.tau_hi[row], tau.hi);
      store(&made.tau_lo[row], tau.lo);
    }
    begin = end;
  }
}

struct Horner {
  Vector value, error, speed;
};

LEADSCREW_LANEWISE void step(Horner& sum, Vector tau, Vector coefficient) {
  const Pair product = two_product(sum.value, tau);
  const Pair value = two_sum(product.hi, coefficient);
  sum.speed = sum.speed * tau + sum.value;
  sum.error = sum.error * tau + (product.lo + value.lo);
  sum.value = value.hi;
}

/// s, path length, speed and feed of the words of a segment, of this degree, from `begin` to `end`, whose τ begin at `row`,
/// which moves on behind them; clears the lanes of `is_good` in which bits could differ. What lies behind the end, to fill a
/// vector, is good for nothing: the next segment's is written over it.
LEADSCREW_LANEWISE void go_along(const Block& block, const Block::Stretch& stretch, std::size_t begin, std::size_t& row,
                                 double length, int degree, Made& made, Mask& is_good, Fetcher& fetcher) {
  const auto number = [&](Block::Number which) { return all(stretch.numbers[which]); };
  const Vector state = all_bits(__builtin_bit_cast(double, static_cast<std::int64_t>(stretch.state)));
  const std::size_t end = begin + stretch.words;
  for (std::size_t i = begin; i < end; i += lanes, row += lanes) {
    fetcher.fetch(lines_in_step);
    const Pair tau = {load(&made.tau_hi[row]), load(&made.tau_lo[row])};
    Horner sum{};
    if (degree == 5) {
      sum.value = number(Block::c5);
      step(sum, tau.hi, number(Block::c4));
      step(sum, tau.hi, number(Block::c3));
      is_good &= (sum.value != 0.0) | (number(Block::c2) != 0.0);
    } else if (degree == 3) {
      sum.value = number(Block::c3);
    }
    if (degree >= 3) {
      step(sum, tau.hi, number(Block::c2));
      step(sum, tau.hi, number(Block::v0_hi));
    } else {
      sum.value = number(Block::v0_hi);
    }
    sum.error += number(Block::v0_lo);
    step(sum, tau.hi, number(Block::s0_hi));
    sum.error += number(Block::s0_lo);
    const Pair s = two_sum(sum.value, sum.error + tau.lo * sum.speed);
    is_good &= (tau.hi >= least_tau) & (s.hi >= least_s) & (s.hi < length);
    store(&made.s_hi[i], s.hi);
    store(&made.s_lo[i], s.lo);
    store(&made.columns[slot_of_path_length][i], block.length_before + (s.hi + s.lo));
    store(&made.columns[slot_of_speed][i], sum.speed);
    store(&made.columns[slot_of_feed][i], sum.speed * block.feed_rate);
    store(&made.columns[slot_of_state][i], state);
  }
}

/// False if the bits of a word could differ.
LEADSCREW_LANEWISE bool go_along(const Block& block, double length, Made& made, Fetcher& fetcher) {
  Mask is_good = all(least_s) < all(length);
  for (const std::size_t slot : {slot_of_path_length, slot_of_speed, slot_of_feed, slot_of_state}) made.vary(slot);
  std::size_t begin = 0, row = 0;
  for (std::size_t k = 0; k < block.stretch_count; ++k) {
    const Block::Stretch& stretch = block.stretches[k];
    if (stretch.degree == 5) {
      go_along(block, stretch, begin, row, length, 5, made, is_good, fetcher);
    } else if (stretch.degree == 3) {
      go_along(block, stretch, begin, row, length, 3, made, is_good, fetcher);
    } else {
      go_along(block, stretch, begin, row, length, 1, made, is_good, fetcher);
    }
    begin += stretch.words;
  }
  bool are_good = true;
  for (std::size_t lane = 0; lane < lanes; ++lane) are_good = are_good && is_good[lane] != 0;
  return are_good;
}

LEADSCREW_LANEWISE void count_ticks(const Block& block, Made& made) {
  double* const ticks = made.vary(slot_of_tick);
  Mask tick = base::count(block.tick) - Mask{};
  for (std::size_t lane = 0; lane < lanes; ++lane) tick[lane] += static_cast<std::int64_t>(lane);
  for (std::size_t i = 0; i < block.count; i += lanes) {
    __builtin_memcpy(&ticks[i], &tick, sizeof tick);
    tick += static_cast<std::int64_t>(lanes) - Mask{};
  }
}

/// As many slots as there are lanes, from this on, of as many words: columns become rows.
LEADSCREW_LANEWISE void write_square(const Made& made, std::size_t slot, std::size_t word, double* to) {
  const auto column = [&](std::size_t k) { return load(&made.columns[slot + k][word]); };
  const Vector first = column(0), second = column(1);
#if LEADSCREW_LANES == 4
  const Vector third = column(2), fourth = column(3);
  const Vector even = __builtin_shufflevector(first, second, 0, 4, 2, 6);
  const Vector odd = __builtin_shufflevector(first, second, 1, 5, 3, 7);
  const Vector next_even = __builtin_shufflevector(third, fourth, 0, 4, 2, 6);
  const Vector next_odd = __builtin_shufflevector(third, fourth, 1, 5, 3, 7);
  store(to, __builtin_shufflevector(even, next_even, 0, 1, 4, 5));
  store(to + slot_count, __builtin_shufflevector(odd, next_odd, 0, 1, 4, 5));
  store(to + 2 * slot_count, __builtin_shufflevector(even, next_even, 2, 3, 6, 7));
  store(to + 3 * slot_count, __builtin_shufflevector(odd, next_odd, 2, 3, 6, 7));
#else
  store(to, __builtin_shufflevector(first, second, 0, 2));
  store(to + slot_count, __builtin_shufflevector(first, second, 1, 3));
#endif
}

/// The slots of a word make so many squares; the last overlaps the one before.
constexpr std::size_t square_count = (slot_count + lanes - 1) / lanes;
constexpr std::size_t first_slot(std::size_t square) {
  return std::min(square * lanes, slot_count - lanes);
}

/// Has the square a slot that varies? Then what its other slots have fills columns, too.
using Varying = std::array<bool, square_count>;

LEADSCREW_LANEWISE Varying fill(Made& made, std::size_t count) {
  Varying varying{};
  for (std::size_t square = 0; square < square_count; ++square) {
    const std::size_t begin = first_slot(square), end = begin + lanes;
    for (std::size_t slot = begin; slot < end; ++slot) varying[square] = varying[square] || made.varies[slot];
    for (std::size_t slot = begin; varying[square] && slot < end; ++slot) {
      if (made.varies[slot]) continue;
      for (std::size_t i = 0; i < count; i += lanes) store(&made.columns[slot][i], all_bits(made.common[slot]));
    }
  }
  return varying;
}

/// As many words as there are lanes.
LEADSCREW_LANEWISE void write_rows(const Made& made, const Varying& varying, std::size_t word, base::Word* words) {
#pragma GCC unroll 8
  for (std::size_t square = 0; square < square_count; ++square) {
    const std::size_t slot = first_slot(square);
    double* const to = reinterpret_cast<double*>(words) + slot;
    if (varying[square]) {
      write_square(made, slot, word, to);
    } else {
      for (std::size_t lane = 0; lane < lanes; ++lane) store(to + lane * slot_count, load(&made.common[slot]));
    }
  }
}

LEADSCREW_LANEWISE void write(Made& made, std::size_t count, base::Word* words, Fetcher& fetcher) {
  const Varying varying = fill(made, count);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    fetcher.fetch(lines_in_step);
    write_rows(made, varying, i, words + i);
  }
  if (i == count) return;
  std::array<base::Word, lanes> last;
  write_rows(made, varying, i, last.data());
  std::copy_n(last.begin(), count - i, words + i);
}

LEADSCREW_LANEWISE void go_straight(const geometry::Slopes& slopes, const geometry::Point& start, std::size_t count,
                                    Made& made, Fetcher& fetcher) {
  for (const auto& slope : slopes.coordinates()) {
    double* const moved = made.vary(slot_of_position + slope.coordinate);
    for (std::size_t i = 0; i < count; i += lanes) {
      fetcher.fetch(1);
      const Pair product = times(slope.rate, {load(&made.s_hi[i]), load(&made.s_lo[i])});
      const Pair sum = two_sum(all(start[slope.coordinate]), product.hi);
      store(&moved[i], sum.hi + (sum.lo + product.lo));
    }
  }
}

LEADSCREW_LANEWISE Vector turned(Vector origin, Pair a, Pair b, Vector small) {
  const Pair sum = two_sum(a.hi, b.hi);
  const Pair absolute = two_sum(origin, sum.hi);
  return absolute.hi + (absolute.lo + (sum.lo + (a.lo + b.lo + small)));
}

LEADSCREW_LANEWISE void go_round(const geometry::Arc& arc, std::size_t count, Made& made, Fetcher& fetcher) {
  const geometry::Arc::Turn turn = arc.turn();
  double* const first = made.vary(slot_of_position + arc.first());
  double* const second = made.vary(slot_of_position + arc.second());
  const double x = turn.x.hi.value, y = turn.y.hi.value;
  for (std::size_t i = 0; i < count; i += lanes) {
    fetcher.fetch(lines_in_step);
    const Vector s = load(&made.s_hi[i]);
    const Pair angle = times(turn.rate, {s, load(&made.s_lo[i])});
    const VectorSines sines = sines_of(reduce(angle.hi, angle.lo));
    const Mask is_small = (angle.hi < geometry::Arc::small_angle) & (angle.hi > -geometry::Arc::small_angle);
    const Vector sine = sines.sine, cosine = is_small ? sines.cosine_less_one : sines.cosine;
    const Pair x_cosine = two_product(all(x), cosine), x_sine = two_product(all(x), sine);
    const Pair y_cosine = two_product(all(y), cosine), y_sine = two_product(all(y), sine);
    const Vector small_first = turn.x.lo * cosine - turn.y.lo * sine;
    const Vector small_second = turn.x.lo * sine + turn.y.lo * cosine;
    const Vector origin_first = is_small ? all(turn.start_first) : all(turn.center_first);
    const Vector origin_second = is_small ? all(turn.start_second) : all(turn.center_second);
    store(&first[i], turned(origin_first, x_cosine, {-y_sine.hi, -y_sine.lo}, small_first + turn.defect_first * s));
    store(&second[i], turned(origin_second, x_sine, y_cosine, small_second + turn.defect_second * s));
  }
}

[[gnu::noinline]] bool make_words(const Block& block, std::span<base::Word> words) {
  Made made;
  const auto* const line = std::get_if<geometry::Line>(block.curve);
  const auto* const arc = std::get_if<geometry::Arc>(block.curve);
  if (arc && !(std::abs(arc->angle_rate()) * arc->length() < numeric::greatest_near_angle)) return false;
  const std::span<const base::Word> next = words.subspan(block.count);
  Fetcher fetcher(next.first(std::min(next.size(), words_in_block)));
  make_tau(block, made, fetcher);
  if (!go_along(block, line ? line->length() : arc->length(), made, fetcher)) return false;
  count_ticks(block, made);
  const geometry::Point& start = line ? line->start() : arc->start();
  made.take_common(start, block.line);
  go_straight(line ? line->slopes() : arc->slopes(), start, block.count, made, fetcher);
  if (arc) go_round(*arc, block.count, made, fetcher);
  write(made, block.count, words.data(), fetcher);
  return true;
}

#undef LEADSCREW_LANEWISE
