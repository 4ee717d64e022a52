#pragma once
// The same work for each program of the command line, and what it found on standard output.

#include <functional>
#include <leadscrew/cli/console.hpp>
#include <leadscrew/cli/job.hpp>
#include <leadscrew/cli/status.hpp>
#include <leadscrew/json/json.hpp>
#include <memory>
#include <string>
#include <string_view>

namespace leadscrew::cli {

struct ProgramResult {
  Status status = Status::done;
  json::Json json;
  std::string summary;  ///< may be empty
};

using ProgramWork = std::function<ProgramResult(const std::string& program, const Job& job)>;

/// Works on one program after the other, each with its own job (job_of), whatever becomes of those before; only an
/// interruption, or a standard output that cannot be written, ends the row. Returns the greatest status.
Status for_each_program(const Job& job, Console& console, std::string_view schema, const ProgramWork& work);

/// Writes to standard output. Says why if it cannot, but keeps silent where a reader has closed the pipe.
Status write_output(Console& console, std::string_view text);

}  // namespace leadscrew::cli
