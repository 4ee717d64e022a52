// Words per second along lines, arcs and cubic rational NURBS curves, and along curves of the tip with two rotary axes, by the plain interpolator and by the controller:
// one item is one call of the cycle.

#include <benchmark/benchmark.h>
#include <sys/mman.h>

#include <cstdlib>
#include <leadscrew/interpolator/controller.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <memory>
#include <motion.hpp>
#include <percentiles.hpp>
#include <span>
#include <string>
#include <trunnion.hpp>

namespace {

using namespace leadscrew;
using testing_support::arc_piece;
using testing_support::line_piece;

std::vector<toolpath::Element> lines() {
  std::vector<toolpath::Element> path;
  geometry::Point at{};
  for (int k = 1; k <= 100; ++k) {
    const geometry::Point next = {k * 1.7, (k % 7) * 13.0, (k % 5) * -2.25};
    path.push_back(line_piece(at, next, 60));
    at = next;
  }
  return path;
}

std::vector<toolpath::Element> arcs() {
  std::vector<toolpath::Element> path;
  geometry::Point at{};
  for (int k = 1; k <= 100; ++k) {
    const toolpath::Piece arc = arc_piece(at, at[0] + 9 + k % 5, at[1] + k % 3, k % 2 ? 5.0 : -4.0, 60);
    at = geometry::end(arc.curve);
    path.push_back(arc);
  }
  return path;
}

std::vector<toolpath::Element> mixed() {
  auto path = lines();
  geometry::Point at = geometry::end(std::get<toolpath::Piece>(path.back()).curve);
  for (int k = 0; k < 100; ++k) {
    const geometry::Point next = {at[0] + 20, at[1], at[2] + 1};
    path.push_back(line_piece(at, next, 60));
    const toolpath::Piece arc = arc_piece(next, next[0], next[1] + 8, 3.0, 60);
    path.push_back(arc);
    at = geometry::end(arc.curve);
  }
  return path;
}

std::vector<toolpath::Element> curves() {
  std::vector<toolpath::Element> path;
  geometry::Point at{};
  for (int k = 1; k <= 20; ++k) {
    geometry::NurbsForm form{3, {0, 0, 0, 0}, {at}, {1}};
    for (int i = 1; i <= 12; ++i) {
      at[0] += 4;
      at[1] += (i * 7 + k) % 5 - 2;
      at[2] += (i + k) % 3 - 1;
      form.points.push_back(at);
      form.weights.push_back(1 + i % 3 * 0.5);
      if (i < 10) form.knots.push_back(i);
    }
    form.knots.insert(form.knots.end(), 4, 10);
    for (const geometry::Nurbs& piece : geometry::smooth_pieces(form))
      path.push_back(toolpath::Piece{piece, 60, base::Line{k}});
  }
  return path;
}

/// Cubic curves of the tip and of A and C, under tool centre point control.
std::vector<toolpath::Element> curves_of_the_tip() {
  const auto trunnion = std::make_shared<const kinematics::Transformation>(
      kinematics::chain_of(testing_support::trunnion()), kinematics::Vector{0, 0, 80});
  std::vector<toolpath::Element> path;
  geometry::Point at{};
  for (int k = 1; k <= 20; ++k) {
    geometry::NurbsForm form{3, {0, 0, 0, 0}, {at}, {1}};
    for (int i = 1; i <= 12; ++i) {
      at[0] += k % 2 == 0 ? 4 : -4;
      at[1] += (i * 7 + k) % 5 - 2;
      at[2] += (i + k) % 3 - 1;
      at[3] += (i * 3 + k) % 4 - 1.5;
      at[5] += 3 + (i + k) % 2;
      form.points.push_back(at);
      form.weights.push_back(1);
      if (i < 10) form.knots.push_back(i);
    }
    form.knots.insert(form.knots.end(), 4, 10);
    for (const geometry::Nurbs& curve : toolpath::fitted_pieces(form)) {
      toolpath::Piece piece{curve, 60, base::Line{k}};
      piece.feed_axes = toolpath::FeedAxes::xyz;
      piece.transformation = trunnion;
      path.push_back(piece);
    }
  }
  return path;
}

machine::Machine machine_of(const std::vector<toolpath::Element>& path) {
  const bool is_of_tip = std::get<toolpath::Piece>(path.front()).transformation != nullptr;
  return is_of_tip ? testing_support::trunnion() : machine::mill3();
}

void words(benchmark::State& state, std::vector<toolpath::Element> (*make)()) {
  const auto path = make();
  const auto chunks = testing_support::plan(path, machine_of(path));
  const base::Period period{1'000'000};
  for (auto _ : state) {
    interpolator::Interpolator interpolator(period, {});
    for (const auto& chunk : chunks) {
      interpolator.load(chunk);
      while (!interpolator.wants_chunk()) benchmark::DoNotOptimize(interpolator.next());
    }
    state.SetItemsProcessed(state.items_processed() + base::count(interpolator.tick()));
  }
}

/// Where words go: 512 stay in the processor's cache, a million go through memory. With pages of 4 KiB the processor looks
/// one up for every 34 words; huge ones are asked for as numpy does for its arrays.
struct Place {
  const char* name;
  std::size_t size;
  bool has_huge_pages;
};
constexpr Place places[] = {
    {"cache", 512, false}, {"memory", 1'000'000, false}, {"memory-of-huge-pages", 1'000'000, true}};

class Memory {
 public:
  explicit Memory(const Place& place) : size_(place.size) {
    constexpr std::size_t huge_page = std::size_t{2} << 20;
    const std::size_t bytes = (size_ * sizeof(base::Word) + huge_page - 1) / huge_page * huge_page;
    memory_.reset(std::aligned_alloc(huge_page, bytes));
    if (place.has_huge_pages) madvise(memory_.get(), bytes, MADV_HUGEPAGE);
    std::uninitialized_default_construct_n(static_cast<base::Word*>(memory_.get()), size_);
  }
  std::span<base::Word> words() { return {static_cast<base::Word*>(memory_.get()), size_}; }

 private:
  struct Free {
    void operator()(void* memory) const { std::free(memory); }
  };
  std::size_t size_;
  std::unique_ptr<void, Free> memory_;
};

/// Many in one call, into one place.
void many_words(benchmark::State& state, std::vector<toolpath::Element> (*make)(), Place where,
                interpolator::Kernel kernel) {
  const auto chunks = testing_support::plan(make(), machine::mill3());
  Memory memory(where);
  const std::span<base::Word> place = memory.words();
  std::size_t used = 0;
  for (auto _ : state) {
    interpolator::Interpolator interpolator(base::Period{1'000'000}, {});
    interpolator.use(kernel);
    for (const auto& chunk : chunks) {
      interpolator.load(chunk);
      while (!interpolator.wants_chunk()) {
        if (used == place.size()) used = 0;
        used += interpolator.next(place.subspan(used));
        benchmark::ClobberMemory();
      }
    }
    state.SetItemsProcessed(state.items_processed() + base::count(interpolator.tick()));
  }
}

/// What no way of making words can beat: equal words into the same place.
void same_words(benchmark::State& state, Place where) {
  Memory memory(where);
  const base::Word word;
  for (auto _ : state) {
    for (base::Word& to : memory.words()) to = word;
    benchmark::ClobberMemory();
    state.SetItemsProcessed(state.items_processed() + static_cast<std::int64_t>(where.size));
  }
}

/// mill3 with travel for every path here: a controller refuses what leaves it.
machine::Machine wide_mill() {
  machine::Machine machine = machine::mill3();
  for (auto& axis : machine.axes) {
    if (axis) axis->travel_min = -1e4, axis->travel_max = 1e4;
  }
  return machine;
}

/// All chunks are there before the first word: what is measured is the cycle alone.
void controlled(benchmark::State& state, std::vector<toolpath::Element> (*make)()) {
  const auto chunks = testing_support::plan(make(), wide_mill());
  for (auto _ : state) {
    state.PauseTiming();
    interpolator::Controller controller(base::Period{1'000'000}, {}, chunks.size() + 1);
    for (planner::Chunk chunk : chunks) {
      if (controller.offer(chunk) != interpolator::Controller::Offer::accepted)
        return state.SkipWithError("a chunk was not accepted");
    }
    std::int64_t count = 0;
    state.ResumeTiming();
    for (; !controller.idle(); ++count) benchmark::DoNotOptimize(controller.next());
    state.SetItemsProcessed(state.items_processed() + count);
  }
}

auto* const along_lines = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("words/lines", words, lines)->Unit(benchmark::kMillisecond));
auto* const along_arcs = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("words/arcs", words, arcs)->Unit(benchmark::kMillisecond));
auto* const along_both = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("words/lines-and-arcs", words, mixed)->Unit(benchmark::kMillisecond));
auto* const along_curves = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("words/nurbs", words, curves)->Unit(benchmark::kMillisecond));
auto* const along_curves_of_the_tip = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("words/nurbs-of-the-tip", words, curves_of_the_tip)->Unit(benchmark::kMillisecond));

bool register_many() {
  const std::pair<const char*, std::vector<toolpath::Element> (*)()> paths[] = {
      {"lines", lines}, {"arcs", arcs}, {"lines-and-arcs", mixed}, {"nurbs", curves}};
  const std::pair<const char*, interpolator::Kernel> kernels[] = {{"plain", interpolator::Kernel::plain},
                                                                  {"avx2", interpolator::Kernel::avx2},
                                                                  {"neon", interpolator::Kernel::neon}};
  for (const Place& place : places) {
    leadscrew::bench::with_percentiles(
        benchmark::RegisterBenchmark((std::string("many-words/equal/") + place.name).c_str(), same_words, place)
            ->Unit(benchmark::kMillisecond));
    for (const auto& [path, make] : paths) {
      for (const auto& [name, kernel] : kernels) {
        if (!interpolator::has(kernel)) continue;
        const std::string title = std::string("many-words/") + path + "/" + name + "/" + place.name;
        leadscrew::bench::with_percentiles(benchmark::RegisterBenchmark(title.c_str(), many_words, make, place, kernel)
                                               ->Unit(benchmark::kMillisecond));
      }
    }
  }
  return true;
}
const bool many_are_registered = register_many();

auto* const controlled_lines = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("controller/lines", controlled, lines)->Unit(benchmark::kMillisecond));
auto* const controlled_arcs = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("controller/arcs", controlled, arcs)->Unit(benchmark::kMillisecond));
auto* const controlled_curves = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("controller/nurbs", controlled, curves)->Unit(benchmark::kMillisecond));

}  // namespace
