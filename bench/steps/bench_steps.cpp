// Steps a second from words: circles in two axes and with a third axis beside them, at several feeds, and a line along
// one axis. One item is one step; words are made beforehand.

#include <benchmark/benchmark.h>

#include <cmath>
#include <leadscrew/steps/step_generator.hpp>
#include <vector>

namespace {

using namespace leadscrew;

/// A second of motion at this feed, mm/s, a word each millisecond: a circle of 40 mm radius in the first two axes.
std::vector<base::Word> words_of(std::size_t axes, double feed) {
  std::vector<base::Word> words;
  for (int k = 0; k <= 1000; ++k) {
    base::Word word;
    word.tick = base::Tick{k};
    const double travel = feed * k / 1000;
    const double angle = travel / 40;
    if (axes == 1) word.position[0] = travel;
    if (axes > 1) word.position = {40 * std::cos(angle), 40 * std::sin(angle)};
    if (axes > 2) word.position[2] = 0.3 * travel;
    words.push_back(word);
  }
  return words;
}

void steps(benchmark::State& state, std::size_t axes, double feed, std::int64_t clock_hz) {
  const auto words = words_of(axes, feed);
  std::int64_t count = 0, sum = 0;
  for (auto _ : state) {
    auto generator = steps::StepGenerator::create(machine::mill3(), clock_hz);
    const auto sink = [&](std::span<const steps::StepEvent> events) {
      count += static_cast<std::int64_t>(events.size());
      for (const steps::StepEvent event : events) sum += event.direction();
    };
    for (const base::Word& word : words) generator->follow(word, sink);
    generator->finish(sink);
  }
  benchmark::DoNotOptimize(sum);
  state.SetItemsProcessed(count);
}

const bool added = [] {
  for (const std::int64_t clock_hz : {1'000'000, 10'000'000}) {
    for (const std::size_t axes : {1u, 2u, 3u}) {
      for (const double feed : {20.0, 200.0}) {
        const std::string name = "steps/" + std::to_string(axes) + "-axes/" + std::to_string(static_cast<int>(feed)) +
                                 "mm_s/" + std::to_string(clock_hz / 1000) + "kHz";
        benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
          steps(state, axes, feed, clock_hz);
        })->Unit(benchmark::kMicrosecond);
      }
    }
  }
  return true;
}();

}  // namespace
