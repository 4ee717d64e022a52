#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <leadscrew/cli/drive_checks.hpp>
#include <leadscrew/cli/drive_link.hpp>
#include <leadscrew/cli/drive_state.hpp>
#include <leadscrew/cli/output_file.hpp>
#include <leadscrew/cli/outputs.hpp>
#include <leadscrew/cli/quantity.hpp>
#include <vector>

namespace leadscrew::cli {

namespace {

constexpr std::int64_t least_period = 50'000;  // ns: below, two processes cannot wake each other up in time

base::Result<void> check_sink(const Job& job) {
  const std::optional<std::string>& sink = job.arguments.drive.sink;
  if (!sink) return {};
  if (is_standard_output(*sink)) {
    if (job.arguments.quiet && !job.arguments.json) return {};
    return base::failure(base::problem("usage", fmt::format("--sink {}: is standard output, where results go", *sink),
                                       "with --quiet it is left to the words"));
  }
  if (auto ending = check_ending("--sink", sink, {".csv"}); !ending) return ending;
  std::error_code error;
  const bool holds_words =
      std::filesystem::is_regular_file(*sink, error) && std::filesystem::file_size(*sink, error) > 0;
  if (!job.arguments.drive.resume || !holds_words) return {};
  return base::failure(base::problem("usage", fmt::format("--sink {}: holds words already, which would be lost", *sink),
                                     "name another file for those that follow"));
}

base::Result<void> check_files(const InputFile& program, const Job& job) {
  const DriveArguments& arguments = job.arguments.drive;
  std::vector<std::string> written;
  for (const auto& path : {arguments.trace, arguments.axes, arguments.state, arguments.sink}) {
    if (path) written.push_back(*path);
  }
  // A state that goes on may be kept in another file or in the same.
  if (arguments.resume && arguments.resume != arguments.state) written.push_back(*arguments.resume);
  if (auto sound = check_written(written, program, job.arguments); !sound) return sound;
  if (arguments.state && arguments.state != arguments.resume) {
    if (auto sound = check_replaceable(*arguments.state); !sound) return sound;
  }
  if (auto trace = check_ending("--trace", arguments.trace, trace::endings()); !trace) return trace;
  if (auto sink = check_sink(job); !sink) return sink;
  return check_ending("--axes", arguments.axes, trace::endings());
}

/// A stop along a line takes max v/a + max a/J at most. Where no early stop is known, ways to rest go on to the end
/// of a window of the planner's, some such stops long: what is longer still ends motion when it comes (why_tripped).
base::Result<void> check_stops(const Job& job) {
  constexpr double on_curves = 4;
  double brake = 0, release = 0;
  for (const auto& limits : job.machine.axes) {
    if (!limits) continue;
    brake = std::max(brake, limits->velocity / limits->acceleration);
    release = std::max(release, limits->acceleration / limits->jerk);
  }
  const double periods = (on_curves * (brake + release) + 2 * drive_slice) / job.machine.period.seconds();
  if (periods <= DriveLink::longest_way) return {};
  return base::failure(base::problem(
      "stop-too-long",
      fmt::format("the machine may need {:.0f} periods to stop, drives hold {}", periods, DriveLink::longest_way),
      fmt::format("a --period of {:.0f}us or more", std::ceil(job.machine.period.seconds() * 1e6 * periods /
                                                              static_cast<double>(DriveLink::longest_way)))));
}

base::Result<void> check_period(const Job& job) {
  if (job.machine.period.nanoseconds >= least_period) return {};
  return base::failure(
      base::problem("period-too-short",
                    fmt::format("a period of {} is too short for words to be on time", period_text(job.machine.period)),
                    "a --period of 50us or more; run and simulate take shorter ones"));
}

}  // namespace

base::Result<void> check_drive(const InputFile& program, const Job& job) {
  if (auto sound = check_files(program, job); !sound) return sound;
  if (auto sound = check_period(job); !sound) return sound;
  return check_stops(job);
}

}  // namespace leadscrew::cli
