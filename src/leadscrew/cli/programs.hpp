#pragma once
// The same work for each program of the command line, and what it found on standard output.

#include <functional>
#include <leadscrew/cli/job.hpp>
#include <leadscrew/cli/options.hpp>
#include <leadscrew/console/console.hpp>
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

/// As results name it: "<stdin>" for "-".
std::string shown_name(const std::string& program);
/// Of what got no further than its diagnostics.
ProgramResult rejected(std::string_view schema, const std::string& name, const Job& job, const DiagnosticLog& log);

/// What it finds wrong goes to its console. Threads work on several programs at a time.
using ProgramWork = std::function<ProgramResult(const std::string& program, const Job& job, Console& console)>;

/// Works on each program with a job of its own (job_of), on --threads of them at a time, whatever becomes of the
/// others; what came of them is told in their order. Only an interruption, or a standard output that cannot be written,
/// ends the row. Returns the greatest status.
Status for_each_program(const Job& job, Console& console, const ProgramWork& work);

}  // namespace leadscrew::cli
