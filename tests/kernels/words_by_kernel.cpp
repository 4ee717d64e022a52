// Makes words along lines and arcs, one by one and many together by each kernel of the processor, and prints a hash of them
// for each path. Fails where a kernel's differ. What stands on standard output is the same on every processor: nothing but
// sums, products, sines and cosines goes into it.

#include <array>
#include <cstdint>
#include <cstdio>
#include <leadscrew/base/hash.hpp>
#include <leadscrew/interpolator/interpolator.hpp>
#include <leadscrew/planner/motion.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace {

using namespace leadscrew;
using interpolator::Interpolator;
using interpolator::Kernel;

constexpr std::array<std::string_view, interpolator::all_kernels.size()> kernel_names = {"plain", "avx2", "neon"};
constexpr base::Period periods[] = {{1'000'000}, {250'000}, {37'000}};

/// Numbers as if at random, −1 … 1. Two are never drawn in one call: compilers differ in which is drawn first.
class Numbers {
 public:
  double next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(static_cast<std::int64_t>(state_) >> 11) / 4503599627370496.0;
  }

 private:
  std::uint64_t state_ = 1;
};

/// Along one piece, segments of every degree that a plan has, each from where the one before ends.
planner::Chunk motion_along(const geometry::Curve& curve, Numbers& numbers) {
  planner::Chunk chunk;
  chunk.pieces.push_back({curve, 60, base::Line{7}});
  double s = 0, begin = 0;
  for (int k = 0; k < 40; ++k) {
    planner::Segment segment;
    segment.begin = begin;
    segment.duration = 0.02 + 0.015 * numbers.next();
    segment.s0 = numeric::DoubleDouble(s, s * 1e-17 * numbers.next());
    segment.v0 = numeric::DoubleDouble{20 + 5 * numbers.next(), 1e-17 * numbers.next()};
    segment.state = k % 3 == 0 ? base::MotionState::constant : base::MotionState::changing;
    if (k % 3 > 0) segment.c2 = 50 * numbers.next(), segment.c3 = 400 * numbers.next();
    if (k % 3 > 1) segment.c4 = 1000 * numbers.next(), segment.c5 = 5000 * numbers.next();
    s = planner::evaluate(segment, segment.duration.value()).s;
    begin += segment.duration.value();
    chunk.segments.push_back(segment);
  }
  chunk.duration = begin;
  chunk.rest = geometry::end(curve);
  return chunk;
}

void add(base::Hash& hash, const base::Word& word) {
  std::array<double, base::axis_count + 3> numbers;
  std::copy(word.position.begin(), word.position.end(), numbers.begin());
  numbers[base::axis_count] = word.path_length;
  numbers[base::axis_count + 1] = word.speed;
  numbers[base::axis_count + 2] = word.feed;
  hash.add({reinterpret_cast<const char*>(numbers.data()), sizeof numbers});
  const std::array<std::int64_t, 3> whole = {base::count(word.tick), base::number(word.line),
                                             static_cast<std::int64_t>(word.state)};
  hash.add({reinterpret_cast<const char*>(whole.data()), sizeof whole});
}

/// By a kernel, or one by one.
std::uint64_t hash_of(const std::vector<planner::Chunk>& chunks, std::optional<Kernel> kernel) {
  base::Hash hash;
  std::array<base::Word, 200> words;
  for (const base::Period period : periods) {
    Interpolator interpolator(period, {});
    if (kernel) interpolator.use(*kernel);
    for (const planner::Chunk& chunk : chunks) {
      interpolator.load(chunk);
      while (!interpolator.wants_chunk()) {
        std::size_t count = 1;
        if (kernel) {
          count = interpolator.next(words);
        } else {
          words[0] = interpolator.next();
        }
        for (const base::Word& word : std::span(words).first(count)) add(hash, word);
      }
    }
  }
  return hash.value();
}

std::vector<planner::Chunk> lines(Numbers& numbers) {
  std::vector<planner::Chunk> chunks;
  for (int k = 0; k < 60; ++k) {
    geometry::Point start{}, end{};
    for (std::size_t i = 0; i < (k % 4 == 0 ? start.size() : 3); ++i) {
      start[i] = 300 * numbers.next();
      end[i] = k % 5 == 0 && i == 1 ? start[i] : 300 * numbers.next();
    }
    chunks.push_back(motion_along(geometry::Line(start, end, 120 + 20 * numbers.next()), numbers));
  }
  return chunks;
}

/// And helices, from small angles to some turns.
std::vector<planner::Chunk> arcs(Numbers& numbers) {
  std::vector<planner::Chunk> chunks;
  for (int k = 0; k < 60; ++k) {
    geometry::Point start{}, end{};
    for (std::size_t i = 0; i < 3; ++i) start[i] = end[i] = 100 * numbers.next();
    if (k % 2 == 0) end[2] += 5 * numbers.next();
    const double sweep = (k % 3 == 0 ? 0.6 : 9.0) * numbers.next();
    const double first = start[0] + 40 * numbers.next(), second = start[1] + 30 * numbers.next();
    const geometry::Arc arc(start, end, 0, 1, first, second, numeric::DoubleDouble(sweep, 1e-18), 130);
    chunks.push_back(motion_along(arc, numbers));
  }
  return chunks;
}

bool tell(const char* name, const std::vector<planner::Chunk>& chunks) {
  const std::uint64_t expected = hash_of(chunks, std::nullopt);
  std::printf("%s %016llx\n", name, static_cast<unsigned long long>(expected));
  bool are_same = true;
  for (const Kernel kernel : interpolator::all_kernels) {
    if (!interpolator::has(kernel)) continue;
    const bool is_same = hash_of(chunks, kernel) == expected;
    std::fprintf(stderr, "%s by %s: %s\n", name, kernel_names[static_cast<std::size_t>(kernel)].data(),
                 is_same ? "the same" : "NOT THE SAME");
    are_same = are_same && is_same;
  }
  return are_same;
}

}  // namespace

int main() {
  Numbers numbers;
  const bool of_lines = tell("lines", lines(numbers)), of_arcs = tell("arcs", arcs(numbers));
  return of_lines && of_arcs ? 0 : 1;
}
