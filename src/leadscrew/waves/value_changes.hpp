#pragma once
// Signals over time as a value-change dump (VCD, IEEE 1364-2005, clause 18), as GTKWave and its like show them.

#include <cstdint>
#include <leadscrew/base/block_sink.hpp>
#include <span>
#include <string>
#include <vector>

namespace leadscrew::waves {

/// A signed number in two's complement.
struct VcdSignal {
  std::string name;                 ///< letters, digits and _
  int width = 1;                    ///< bits, 1 … 64
  std::vector<std::string> also{};  ///< other names of it
};

/// Signals that belong together; names of scopes, too, are letters, digits and _.
struct VcdScope {
  std::string name;
  std::vector<VcdSignal> signals;
};

/// Once the sink has failed, every later call fails with the same diagnostic.
class VcdWriter {
 public:
  /// timescale: such as "1 us". comments: one line each.
  VcdWriter(base::ByteSink sink, const std::string& timescale, const std::vector<std::string>& comments,
            const std::vector<VcdScope>& scopes);

  /// Values of all signals, in the order of the scopes; what has changed is written. Times go up; the first call gives
  /// the initial values.
  base::Result<void> write(std::int64_t time, std::span<const std::int64_t> values);
  /// Writes what is still gathered; the dump ends at this time, so that the last values can be seen.
  base::Result<void> finish(std::int64_t time);

 private:
  struct Known {
    std::string identifier;
    int width = 1;
    std::int64_t value = 0;
  };

  void put_value(const Known& signal);

  base::BlockSink text_;
  std::vector<Known> signals_;
  bool has_begun_ = false;
};

}  // namespace leadscrew::waves
