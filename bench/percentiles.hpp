#pragma once
// Percentiles over repetitions, beside Google Benchmark's own mean and median.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

namespace leadscrew::bench {

inline double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

inline benchmark::internal::Benchmark* with_percentiles(benchmark::internal::Benchmark* bench) {
  return bench->Repetitions(21)
      ->ReportAggregatesOnly()
      ->ComputeStatistics("p10", [](const std::vector<double>& v) { return percentile(v, 0.1); })
      ->ComputeStatistics("p90", [](const std::vector<double>& v) { return percentile(v, 0.9); })
      ->ComputeStatistics("max", [](const std::vector<double>& v) { return percentile(v, 1); });
}

}  // namespace leadscrew::bench
