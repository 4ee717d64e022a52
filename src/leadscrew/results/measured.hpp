#pragma once
// What a tool has left of the surfaces of a program, as text, as JSON and as files.

#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/result.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/measuring/trace_measurement.hpp>
#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/style.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::results {

inline constexpr std::string_view measure_schema = "leadscrew.measure/1";

/// What is asked on the command line.
struct MeasureQuestion {
  std::optional<std::string> map, picture;  ///< files
  std::optional<double> allowed_cut;        ///< mm; none: the machine's tolerance
  std::optional<double> allowed_ridge;      ///< mm; none: ridges are told, not judged
  std::optional<double> reach;              ///< mm
  std::optional<std::int64_t> places;       ///< of all grids together
};

struct MeasureFigures {
  std::string trace;
  const measuring::TraceMeasurement* measured = nullptr;
  double allowed_cut = 0;               ///< mm
  std::optional<double> allowed_ridge;  ///< mm
  std::vector<std::string> files{};     ///< written

  /// Neither a cut is deeper nor a ridge taller than it may be, by more than a nanometre.
  bool kept() const;
};

/// Those of a finished measurement that were asked for, all or none. Returns their names. Errors: `io-open`, `io-write`.
base::Result<std::vector<std::string>> write_measured(const MeasureQuestion& question, const MeasureFigures& figures,
                                                      const std::string& program);

Json json_of_measure(const std::string& program, const machine::Machine& machine, const MeasureFigures& figures,
                     const Diagnostics& diagnostics);
std::string measure_summary(const std::string& program, const machine::Machine& machine, const MeasureFigures& figures,
                            const Style& style);

}  // namespace leadscrew::results
