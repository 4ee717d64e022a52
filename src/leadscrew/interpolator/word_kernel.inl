// The kernel itself, for vectors of so many `lanes`: included by word_kernels.cpp once for each. What it does is what
// Interpolator::next(), geometry::Slopes::add and geometry::Arc::turned do, operation by operation. All functions are of
// this namespace, and inline in one: none that is compiled for a processor that not everybody has may be taken for one of
// another source.

#define LEADSCREW_LANEWISE [[gnu::always_inline]] inline

typedef double Vector __attribute__((vector_size(8 * lanes)));
typedef long long Mask __attribute__((vector_size(8 * lanes)));

static_assert(2 * lanes <= spare_rows);

struct Pair {
  Vector hi, lo;
};

LEADSCREW_LANEWISE Vector all(double value) {
  return value - Vector{};
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

/// The numbers of the segments, a column for each and a row for each word.
LEADSCREW_LANEWISE void spread(const Block& block, Made& made) {
  const std::size_t columns = block.degree == 5 ? Block::number_count : Block::c4;
  std::size_t begin = 0;
  for (std::size_t k = 0; k < block.stretch_count; ++k) {
    const Block::Stretch& stretch = block.stretches[k];
    // A few rows too many: what comes next is written over them, and lanes behind the last word have its numbers.
    const std::size_t end = begin + stretch.words + (k + 1 == block.stretch_count ? lanes - 1 : 0);
    for (std::size_t column = 0; column < columns; ++column) {
      const Vector number = all(stretch.numbers[column]);
      for (std::size_t i = begin; i < end; i += lanes) store(&made.numbers[column][i], number);
    }
    for (std::size_t i = begin; i < begin + stretch.words; ++i) made.state[i] = stretch.state;
    begin += stretch.words;
  }
}

/// Since their segments began, of the words from the `first`; of the last, for lanes behind it.
LEADSCREW_LANEWISE Pair tau_of(const Block& block, const Made& made, std::size_t first) {
  const double last = static_cast<double>(block.count - 1);
  Vector number = all(static_cast<double>(first));
  for (std::size_t lane = 0; lane < lanes; ++lane) number[lane] += static_cast<double>(lane);
  number = number < last ? number : all(last);
  const Vector nanoseconds = block.nanoseconds + block.period * number;
  const Pair product = two_product(all(nanosecond.hi), nanoseconds);
  const Pair now = quick_two_sum(product.hi, product.lo + nanosecond.lo * nanoseconds);
  return sum_of(now, {load(&made.numbers[Block::begin_hi][first]), load(&made.numbers[Block::begin_lo][first])});
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

/// s and speed; false if the bits of one could differ.
LEADSCREW_LANEWISE bool go_along(const Block& block, double length, int degree, Made& made) {
  Mask is_good = all(least_s) < all(length);
  for (std::size_t i = 0; i < block.count; i += lanes) {
    const Pair tau = tau_of(block, made, i);
    Horner sum{};
    Mask is_whole = is_good | ~is_good;
    if (degree == 5) {
      sum.value = load(&made.numbers[Block::c5][i]);
      step(sum, tau.hi, load(&made.numbers[Block::c4][i]));
      step(sum, tau.hi, load(&made.numbers[Block::c3][i]));
      is_whole =
          (sum.value != 0.0) | (load(&made.numbers[Block::c2][i]) != 0.0) | ((sum.speed == 0.0) & (sum.error == 0.0));
    } else if (degree == 3) {
      sum.value = load(&made.numbers[Block::c3][i]);
    }
    if (degree >= 3) {
      step(sum, tau.hi, load(&made.numbers[Block::c2][i]));
      step(sum, tau.hi, load(&made.numbers[Block::v0_hi][i]));
    } else {
      sum.value = load(&made.numbers[Block::v0_hi][i]);
    }
    sum.error += load(&made.numbers[Block::v0_lo][i]);
    step(sum, tau.hi, load(&made.numbers[Block::s0_hi][i]));
    sum.error += load(&made.numbers[Block::s0_lo][i]);
    const Pair s = two_sum(sum.value, sum.error + tau.lo * sum.speed);
    is_good &= is_whole & (tau.hi >= least_tau) & (s.hi >= least_s) & (s.hi < length);
    store(&made.s_hi[i], s.hi);
    store(&made.s_lo[i], s.lo);
    store(&made.speed[i], sum.speed);
  }
  bool are_good = true;
  for (std::size_t lane = 0; lane < lanes; ++lane) are_good = are_good && is_good[lane] != 0;
  return are_good;
}

/// All but the coordinates that move.
LEADSCREW_LANEWISE void write(const Block& block, const geometry::Point& start, const Made& made, base::Word* words) {
  base::Word common;
  common.position = start;
  common.line = block.line;
  std::array<double, sizeof common / sizeof(double)> bytes;
  __builtin_memcpy(bytes.data(), &common, sizeof common);
  const std::int64_t tick = base::count(block.tick);
  for (std::size_t i = 0; i < block.count; ++i) {
    base::Word& word = words[i];
    double* const to = reinterpret_cast<double*>(&word);
    for (std::size_t k = 0; k + lanes <= bytes.size(); k += lanes) store(to + k, load(&bytes[k]));
    store(to + (bytes.size() - lanes), load(&bytes[bytes.size() - lanes]));
    word.tick = base::Tick{tick + static_cast<std::int64_t>(i)};
    word.path_length = block.length_before + (made.s_hi[i] + made.s_lo[i]);
    word.speed = made.speed[i];
    word.feed = made.speed[i] * block.feed_rate;
    word.state = made.state[i];
  }
}

LEADSCREW_LANEWISE void go_straight(const geometry::Slopes& slopes, const geometry::Point& start, const Made& made,
                                    std::size_t count, base::Word* words) {
  for (const auto& slope : slopes.coordinates()) {
    alignas(64) std::array<double, words_in_block> moved;
    for (std::size_t i = 0; i < count; i += lanes) {
      const Pair product = times(slope.rate, {load(&made.s_hi[i]), load(&made.s_lo[i])});
      const Pair sum = two_sum(all(start[slope.coordinate]), product.hi);
      store(&moved[i], sum.hi + (sum.lo + product.lo));
    }
    for (std::size_t i = 0; i < count; ++i) words[i].position[slope.coordinate] = moved[i];
  }
}

LEADSCREW_LANEWISE Vector turned(Vector origin, Pair a, Pair b, Vector small) {
  const Pair sum = two_sum(a.hi, b.hi);
  const Pair absolute = two_sum(origin, sum.hi);
  return absolute.hi + (absolute.lo + (sum.lo + (a.lo + b.lo + small)));
}

LEADSCREW_LANEWISE void go_round(const geometry::Arc& arc, Made& made, std::size_t count, base::Word* words) {
  const geometry::Arc::Turn turn = arc.turn();
  for (std::size_t i = 0; i < count; i += lanes) {
    const Pair angle = times(turn.rate, {load(&made.s_hi[i]), load(&made.s_lo[i])});
    store(&made.angle[i], angle.hi);
    store(&made.angle_lo[i], angle.lo);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const geometry::Arc::Sines sines = geometry::Arc::sines(made.angle[i]);
    made.sine[i] = sines.sine;
    made.cosine[i] = sines.cosine;
  }
  for (std::size_t i = count; i % lanes != 0; ++i) made.sine[i] = made.cosine[i] = 0;
  alignas(64) std::array<double, words_in_block> first, second;
  const double x = turn.x.hi.value, y = turn.y.hi.value;
  for (std::size_t i = 0; i < count; i += lanes) {
    const Vector angle = load(&made.angle[i]), angle_lo = load(&made.angle_lo[i]), s = load(&made.s_hi[i]);
    const Vector sine = load(&made.sine[i]), cosine = load(&made.cosine[i]);
    const Mask is_small = (angle < geometry::Arc::small_angle) & (angle > -geometry::Arc::small_angle);
    const Pair x_cosine = two_product(all(x), cosine), x_sine = two_product(all(x), sine);
    const Pair y_cosine = two_product(all(y), cosine), y_sine = two_product(all(y), sine);
    const Vector whole_cosine = is_small ? 1 + cosine : cosine;
    const Vector small_first = turn.x.lo * cosine - turn.y.lo * sine - angle_lo * (x_sine.hi + y * whole_cosine);
    const Vector small_second = turn.x.lo * sine + turn.y.lo * cosine + angle_lo * (x * whole_cosine - y_sine.hi);
    const Vector origin_first = is_small ? all(turn.start_first) : all(turn.center_first);
    const Vector origin_second = is_small ? all(turn.start_second) : all(turn.center_second);
    store(&first[i], turned(origin_first, x_cosine, {-y_sine.hi, -y_sine.lo}, small_first + turn.defect_first * s));
    store(&second[i], turned(origin_second, x_sine, y_cosine, small_second + turn.defect_second * s));
  }
  for (std::size_t i = 0; i < count; ++i) {
    words[i].position[arc.first()] = first[i];
    words[i].position[arc.second()] = second[i];
  }
}

LEADSCREW_LANEWISE bool go_along(const Block& block, double length, Made& made) {
  if (block.degree == 5) return go_along(block, length, 5, made);
  if (block.degree == 3) return go_along(block, length, 3, made);
  return go_along(block, length, 1, made);
}

[[gnu::noinline]] bool make_words(const Block& block, base::Word* words) {
  Made made;
  spread(block, made);
  if (const auto* line = std::get_if<geometry::Line>(block.curve)) {
    if (!go_along(block, line->length(), made)) return false;
    write(block, line->start(), made, words);
    go_straight(line->slopes(), line->start(), made, block.count, words);
    return true;
  }
  const auto& arc = *std::get_if<geometry::Arc>(block.curve);
  if (!go_along(block, arc.length(), made)) return false;
  write(block, arc.start(), made, words);
  go_straight(arc.slopes(), arc.start(), made, block.count, words);
  go_round(arc, made, block.count, words);
  return true;
}

#undef LEADSCREW_LANEWISE
