#include <fmt/format.h>

#include <filesystem>
#include <leadscrew/cli/drive_checks.hpp>
#include <leadscrew/cli/outputs.hpp>
#include <leadscrew/drive/state.hpp>
#include <leadscrew/files/output_file.hpp>
#include <leadscrew/files/word_file.hpp>
#include <vector>

namespace leadscrew::cli {

namespace {

base::Result<void> check_sink(const Job& job) {
  const std::optional<std::string>& sink = job.arguments.drive.sink;
  if (!sink) return {};
  if (files::is_standard_output(*sink)) {
    if (job.arguments.quiet && !job.arguments.json) return {};
    return base::failure(base::problem("usage", fmt::format("--sink {}: is standard output, where results go", *sink),
                                       "with --quiet it is left to the words"));
  }
  std::error_code error;
  const bool holds_words =
      std::filesystem::is_regular_file(*sink, error) && std::filesystem::file_size(*sink, error) > 0;
  if (!job.arguments.drive.resume || !holds_words) return {};
  return base::failure(base::problem("usage", fmt::format("--sink {}: holds words already, which would be lost", *sink),
                                     "name another file for those that follow"));
}

}  // namespace

base::Result<void> check_drive_files(const files::InputFile& program, const Job& job) {
  const drive::Options& arguments = job.arguments.drive;
  std::vector<std::string> written;
  for (const auto& path : {arguments.trace, files::side_of(arguments.trace), arguments.axes,
                           files::side_of(arguments.axes), arguments.events, arguments.state, arguments.sink}) {
    if (path) written.push_back(*path);
  }
  // A state that goes on may be kept in another file or in the same.
  if (arguments.resume && arguments.resume != arguments.state) written.push_back(*arguments.resume);
  if (auto sound = check_written(written, program, job.arguments); !sound) return sound;
  if (arguments.state && arguments.state != arguments.resume) {
    if (auto sound = drive::check_replaceable(*arguments.state); !sound) return sound;
  }
  return check_sink(job);
}

}  // namespace leadscrew::cli
